# SPDX-License-Identifier: GPL-3.0-or-later
# find_package(brash): the targets brash::geometry and brash::failure with the rooms that they are made of.
# find_package(brash COMPONENTS geometry): the polygon kernel alone, which does not need Eigen.
include(CMakeFindDependencyMacro)
if(NOT "${brash_FIND_COMPONENTS}" STREQUAL "geometry")
  find_dependency(Eigen3 NO_MODULE)  # CGAL brings a module of that name without the target
endif()
foreach(dependency CGAL tl-expected fmt nlohmann_json PkgConfig Threads)
  find_dependency(${dependency})
endforeach()
pkg_check_modules(nettle REQUIRED IMPORTED_TARGET nettle)
include(${CMAKE_CURRENT_LIST_DIR}/brash-targets.cmake)
foreach(component ${brash_FIND_COMPONENTS})
  if(NOT TARGET brash::${component})
    set(brash_FOUND FALSE)
    set(brash_NOT_FOUND_MESSAGE "brash has no component ${component}")
  endif()
endforeach()
