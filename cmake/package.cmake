# SPDX-License-Identifier: GPL-3.0-or-later
# Debian packages by CPack, made by `./dev package`: brash (command, Python module, models, documents) and libbrash-dev.

# All that is installed, and no test or benchmark: what a package needs to have built.
add_custom_target(installed DEPENDS brash brash_fmu_library brash_python brash_core brash_geometry brash_plate brash_meta_model brash_failure)

find_package(Python REQUIRED COMPONENTS Interpreter)
# A manual page of the program's own help, and the changelogs; Debian wants all three compressed.
set(BRASH_MAINTAINER "The brash authors <brash@localhost>" CACHE STRING "Name and address of who answers for the packages")
set(documents ${PROJECT_BINARY_DIR}/debian)
set(writer ${CMAKE_CURRENT_LIST_DIR}/debian/documents.py)
add_custom_command(OUTPUT ${documents}/brash.1.gz ${documents}/changelog.gz ${documents}/changelog.Debian.gz
  COMMAND ${Python_EXECUTABLE} -B ${writer} $<TARGET_FILE:brash> ${PROJECT_SOURCE_DIR} ${documents} ${BRASH_MAINTAINER}
  DEPENDS brash ${writer} ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_SOURCE_DIR}/CITATION.cff
  COMMENT "Writing the manual page and the changelogs" VERBATIM)
add_custom_target(debian_documents ALL DEPENDS ${documents}/brash.1.gz)
add_dependencies(installed debian_documents)
install(FILES ${documents}/brash.1.gz DESTINATION share/man/man1)
foreach(of program.brash development.libbrash-dev)
  string(REGEX MATCH "(.*)\\.(.*)" ignored ${of})
  install(FILES ${CMAKE_CURRENT_LIST_DIR}/debian/copyright ${documents}/changelog.gz ${documents}/changelog.Debian.gz
    DESTINATION share/doc/${CMAKE_MATCH_2} COMPONENT ${CMAKE_MATCH_1})
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT ${BRASH_MAINTAINER})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "simulates how a structure breaks floating ice")
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME brash)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "\
An exact polygon kernel cuts the ice sheet, a model trained on solutions of
the floating plate says when the ice fails, and rigid floes carry the loads.
The command, the Python module brash, the trained models, the schema of case
files, examples and the documents.")
# The module fits one minor version of Python, as any module of C++ does.
set(python ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR})
math(EXPR next "${Python_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS
  "python3 (>= ${python}), python3 (<< ${Python_VERSION_MAJOR}.${next}), python3-numpy")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS
  "bash-completion, librsvg2-bin, slurm-client, paraview, python3-matplotlib, python3-netcdf4, python3-pandas, python3-scipy, \
python3-xarray, libbrash-dev")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_CONTROL_EXTRA
  ${CMAKE_CURRENT_LIST_DIR}/debian/postinst ${CMAKE_CURRENT_LIST_DIR}/debian/prerm)

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libbrash-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "\
Headers, static libraries and the CMake package of the rooms that know
nothing of cases and runs: the exact polygon kernel and the failure model.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "libcgal-dev, libeigen3-dev, libexpected-dev, libfmt-dev, nettle-dev, nlohmann-json3-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS brash)
include(CPack)
