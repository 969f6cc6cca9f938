# SPDX-License-Identifier: GPL-3.0-or-later
# find_package(brash): the targets brash::geometry and brash::failure with the rooms that they are made of.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 NO_MODULE)  # CGAL brings a module of that name without the target
foreach(dependency CGAL GSL tl-expected fmt nlohmann_json PkgConfig Threads)
  find_dependency(${dependency})
endforeach()
pkg_check_modules(nettle REQUIRED IMPORTED_TARGET nettle)
include(${CMAKE_CURRENT_LIST_DIR}/brash-targets.cmake)
