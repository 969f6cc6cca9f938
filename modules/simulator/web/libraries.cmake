# SPDX-License-Identifier: GPL-3.0-or-later
# Debian's libraries for WebAssembly: headers from the machine's packages, and what has to be compiled from the sources
# of the same packages. The targets have the names that the rooms link.

# The folder holds the headers of these libraries alone: the machine's C library is another one.
set(headers ${CMAKE_BINARY_DIR}/include)
foreach(library boost CGAL eigen3 fmt gsl nettle nlohmann polyclipping bullet tl toml++)
  find_path(found_${library} NAMES ${library} PATHS /usr/include /usr/include/${CMAKE_LIBRARY_ARCHITECTURE} /usr/include/x86_64-linux-gnu
    /usr/include/aarch64-linux-gnu NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  file(MAKE_DIRECTORY ${headers})
  file(CREATE_LINK ${found_${library}}/${library} ${headers}/${library} SYMBOLIC)
endforeach()

function(header_library target)
  add_library(${target} INTERFACE IMPORTED)
  target_include_directories(${target} INTERFACE ${headers} ${ARGN})
endfunction()
function(compiled_library name target)
  cmake_parse_arguments(PARSE_ARGV 2 library "" "" "SOURCES;INCLUDES;DEFINITIONS")
  add_library(${name} STATIC ${library_SOURCES})
  add_library(${target} ALIAS ${name})
  target_compile_options(${name} PRIVATE -w)
  target_include_directories(${name} PRIVATE ${library_INCLUDES} PUBLIC ${headers})
  target_compile_definitions(${name} PRIVATE ${library_DEFINITIONS})
endfunction()

# WebAssembly rounds to nearest alone: CGAL's intervals are widened by a unit in the last place instead. Without GMP its
# exact numbers are those of Boost.Multiprecision.
header_library(CGAL::CGAL)
target_compile_definitions(CGAL::CGAL INTERFACE CGAL_ALWAYS_ROUND_TO_NEAREST CGAL_DISABLE_ROUNDING_MATH_CHECK)
add_library(gmp INTERFACE)
header_library(Eigen3::Eigen ${headers}/eigen3)
header_library(fmt::fmt)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
header_library(nlohmann_json::nlohmann_json)
header_library(tl::expected)
header_library(PkgConfig::tomlplusplus)

set(bullet ${BRASH_WEB_SOURCES}/bullet/src)
compiled_library(bullet PkgConfig::bullet
  SOURCES ${bullet}/btLinearMathAll.cpp ${bullet}/btBulletCollisionAll.cpp ${bullet}/btBulletDynamicsAll.cpp
  INCLUDES ${bullet})
target_compile_definitions(bullet PUBLIC BT_USE_DOUBLE_PRECISION)
target_include_directories(bullet PUBLIC ${headers}/bullet)

set(gsl ${BRASH_WEB_SOURCES}/gsl)
foreach(part err sys rng cdf specfunc)
  file(READ ${gsl}/${part}/Makefile.am list)
  string(REGEX MATCH "_la_SOURCES *=([^\n]*)" ignored "${list}")
  string(REGEX MATCHALL "[A-Za-z0-9_]+\\.c" names "${CMAKE_MATCH_1}")
  list(TRANSFORM names PREPEND ${gsl}/${part}/ OUTPUT_VARIABLE sources)
  list(APPEND gsl_sources ${sources})
endforeach()
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/gsl/config.h CONTENT [[
#define HAVE_DECL_FINITE 1
#define HAVE_DECL_ISFINITE 1
#define HAVE_DECL_ISINF 1
#define HAVE_DECL_ISNAN 1
#define HAVE_COMPLEX_H 1
#define HAVE_IEEE_COMPARISONS 1
#define HAVE_IEEE_DENORMALS 1
#define HAVE_INLINE 1
#define HAVE_C99_INLINE 1
#define RELEASED 1
#define GSL_COERCE_DBL(x) (x)
#define GSL_DISABLE_DEPRECATED 1
#define RETURN_IF_NULL(x) if (!x) { return ; }
]])
compiled_library(gsl GSL::gsl SOURCES ${gsl_sources} INCLUDES ${CMAKE_BINARY_DIR}/gsl ${gsl})

set(nettle ${BRASH_WEB_SOURCES}/nettle)
compiled_library(nettle PkgConfig::nettle SOURCES ${nettle}/sha256.c ${nettle}/sha256-compress.c ${nettle}/write-be32.c
  INCLUDES ${nettle})

set(clipper ${BRASH_WEB_SOURCES}/libpolyclipping/cpp)
compiled_library(polyclipping PkgConfig::polyclipping SOURCES ${clipper}/clipper.cpp INCLUDES ${clipper})
target_include_directories(polyclipping PUBLIC ${headers}/polyclipping)

# What a page has no use for: the sources that need these are left out.
foreach(target brash::netcdf PkgConfig::netcdf PkgConfig::udunits ZLIB::ZLIB)
  add_library(${target} INTERFACE IMPORTED)
endforeach()
