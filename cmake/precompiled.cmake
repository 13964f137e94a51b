# Headers that nearly every file reads, parsed once for each set of flags: of three unit tests each compiled 40 to 50 %
# faster, of the libraries' files each half a second.
# dev and release have this for all files, asan-ubsan for its tests.
set(DRIPFEED_PRECOMPILED OFF CACHE STRING "parse standard, fmt and GoogleTest headers once: ON, TESTS or OFF")

set(dripfeed_common_headers
  <algorithm> <array> <chrono> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional> <random> <ranges> <set>
  <span> <string> <string_view> <vector> <fmt/format.h>)

# dripfeed_precompile(NAME HEADERS... LINKS targets... [OPTIONS flags...]): the headers as targets with just these flags see them.
function(dripfeed_precompile name)
  cmake_parse_arguments(ARG "" "" "HEADERS;LINKS;OPTIONS" ${ARGN})
  set(nothing ${CMAKE_BINARY_DIR}/precompiled/${name}.cpp)
  file(CONFIGURE OUTPUT ${nothing} CONTENT "")
  add_library(${name} OBJECT ${nothing})
  target_link_libraries(${name} PRIVATE dripfeed_flags fmt::fmt ${ARG_LINKS})
  target_compile_options(${name} PRIVATE ${ARG_OPTIONS})
  target_precompile_headers(${name} PRIVATE ${ARG_HEADERS})
endfunction()

set(DRIPFEED_PRECOMPILES FALSE)
if(DRIPFEED_PRECOMPILED OR DRIPFEED_PRECOMPILED STREQUAL "TESTS")
  set(DRIPFEED_PRECOMPILES TRUE)
endif()
if(DRIPFEED_PRECOMPILES)
  target_compile_options(dripfeed_flags INTERFACE -fpch-preprocess)  # so that ccache sees which headers a file has read
  dripfeed_precompile(dripfeed_headers HEADERS ${dripfeed_common_headers})
  if(DRIPFEED_TESTS)
    find_package(GTest REQUIRED)
    set(headers ${dripfeed_common_headers} <gtest/gtest.h>)
    dripfeed_precompile(dripfeed_headers_test HEADERS ${headers} LINKS GTest::gtest)
    dripfeed_precompile(dripfeed_headers_unit_test HEADERS ${headers} LINKS GTest::gtest OPTIONS -O0)
  endif()
endif()

# dripfeed_use_precompiled(TARGET PRECOMPILED): TARGET's files find the headers parsed. Its flags must be those of PRECOMPILED.
function(dripfeed_use_precompiled target precompiled)
  set(is_test FALSE)
  if(precompiled MATCHES "test")
    set(is_test TRUE)
  endif()
  if(DRIPFEED_PRECOMPILES AND (is_test OR NOT DRIPFEED_PRECOMPILED STREQUAL "TESTS"))
    target_precompile_headers(${target} REUSE_FROM ${precompiled})
  endif()
endfunction()
