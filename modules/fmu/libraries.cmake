# SPDX-License-Identifier: GPL-3.0-or-later
# Copies the shared libraries that `library` needs into `folder`, under the names by which it asks for them. A system with
# the C library and the C++ library of GCC has the rest.
file(GET_RUNTIME_DEPENDENCIES LIBRARIES ${library} RESOLVED_DEPENDENCIES_VAR found UNRESOLVED_DEPENDENCIES_VAR missing
  PRE_EXCLUDE_REGEXES "^lib(c|m|stdc\\+\\+|gcc_s)\\.so" "^ld-linux")
if(missing)
  message(FATAL_ERROR "${library} needs ${missing}")
endif()
file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder})
foreach(path ${found})
  get_filename_component(name ${path} NAME)
  file(REAL_PATH ${path} real)
  file(COPY_FILE ${real} ${folder}/${name})
endforeach()
