# Build rules that every folder shares: one library a folder, one unit test a folder.

set(CMAKE_CXX_STANDARD 23)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})
# A third-party target that one folder finds is known wherever that folder's library is linked.
set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON)

find_program(DRIPFEED_CCACHE ccache)
if(DRIPFEED_CCACHE)
  # It keeps nothing that reads precompiled headers unless it is told that their time and macros are no matter.
  set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_SLOPPINESS=pch_defines,time_macros ${DRIPFEED_CCACHE})
endif()

find_package(fmt REQUIRED)
find_package(Threads REQUIRED)
if(DRIPFEED_SERVER)
  # Here, because pkg_check_modules wants its variables in every folder that calls it, and several folders link server/io.
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(modbus_lib REQUIRED IMPORTED_TARGET libmodbus)
  pkg_check_modules(mosquitto_lib REQUIRED IMPORTED_TARGET libmosquitto)
endif()

# Flags of every target. No contraction: a fused multiply-add would make the same plan differ between compilers.
add_library(dripfeed_flags INTERFACE)
target_include_directories(dripfeed_flags INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_options(dripfeed_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast -Wnon-virtual-dtor
  -Woverloaded-virtual -Wnull-dereference -Wimplicit-fallthrough -ffp-contract=off)
if(DRIPFEED_WERROR)
  target_compile_options(dripfeed_flags INTERFACE -Werror)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 sees null and out-of-range accesses inside its own std::string and std::vector when it inlines them
  # (GCC bugs 105329, 105651, 107852); clang-19 checks the same code with these warnings on.
  target_compile_options(dripfeed_flags INTERFACE
    -Wno-null-dereference -Wno-restrict -Wno-stringop-overflow -Wno-array-bounds -Wno-stringop-overread)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  # libstdc++ 12's own stable_sort calls its own deprecated get_temporary_buffer.
  target_compile_options(dripfeed_flags INTERFACE -Wno-deprecated-declarations)
endif()
if(DRIPFEED_SANITIZE)
  target_compile_options(dripfeed_flags INTERFACE -fsanitize=${DRIPFEED_SANITIZE} -fno-omit-frame-pointer
    -fno-sanitize-recover=all)
  target_link_options(dripfeed_flags INTERFACE -fsanitize=${DRIPFEED_SANITIZE})
  if(DRIPFEED_SANITIZE MATCHES "thread")
    target_compile_definitions(dripfeed_flags INTERFACE BOOST_ASIO_DISABLE_FENCED_BLOCK)
  endif()
endif()

if(DRIPFEED_FUZZ)
  target_compile_options(dripfeed_flags INTERFACE -fsanitize=fuzzer-no-link)
  add_custom_target(fuzz_targets)
endif()

include(precompiled)
include(together)

# dripfeed_library(NAME [ROOMS a b] [DEPENDS a b] [SYSTEM lib...]): the folder it is called in, as target dripfeed_NAME.
# ROOMS are folders in it that belong to the library; DEPENDS names other folders by their short names; SYSTEM names
# third-party targets.
function(dripfeed_library name)
  cmake_parse_arguments(ARG "" "" "ROOMS;DEPENDS;SYSTEM" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  foreach(room IN LISTS ARG_ROOMS)
    file(GLOB in_room CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${room}/*.cpp)
    list(APPEND sources ${in_room})
  endforeach()
  list(FILTER sources EXCLUDE REGEX "/main[.]cpp$")  # of an executable beside the library
  if(sources)
    add_library(dripfeed_${name} STATIC ${sources})
    set(scope PUBLIC)
    dripfeed_use_precompiled(dripfeed_${name} dripfeed_headers)
    dripfeed_together(dripfeed_${name})
    # The lint of symbols asks for the archives of a top folder.
    cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${CMAKE_SOURCE_DIR} OUTPUT_VARIABLE folder)
    string(REGEX REPLACE "/.*" "" top ${folder})
    set_property(GLOBAL APPEND PROPERTY DRIPFEED_LIBRARIES_${top} dripfeed_${name})
  else()
    add_library(dripfeed_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_link_libraries(dripfeed_${name} ${scope} dripfeed_flags fmt::fmt)
  foreach(dependency IN LISTS ARG_DEPENDS)
    target_link_libraries(dripfeed_${name} ${scope} dripfeed_${dependency})
  endforeach()
  target_link_libraries(dripfeed_${name} ${scope} ${ARG_SYSTEM})
endfunction()

# dripfeed_patience(SECONDS): with sanitizers a test is slow, and runs at the lowest priority while others run (deploy/test).
function(dripfeed_patience seconds)
  if(DRIPFEED_SANITIZE)
    math(EXPR longer "10 * ${${seconds}}")
    set(${seconds} ${longer} PARENT_SCOPE)
  endif()
endfunction()

# dripfeed_test(NAME SOURCES... LINKS a b [SYSTEM lib...] [LABELS l...] [SERIAL] [UNIT]): one GoogleTest binary, one ctest entry.
# LINKS are short folder names; a unit test links only what its folder may name, so the layering is tested by the linker.
function(dripfeed_test name)
  cmake_parse_arguments(ARG "SERIAL;UNIT" "TIMEOUT" "SOURCES;LINKS;SYSTEM;LABELS" ${ARGN})
  foreach(link IN LISTS ARG_LINKS)
    if(NOT TARGET dripfeed_${link})
      if(DRIPFEED_SERVER)
        message(FATAL_ERROR "the test ${name} links ${link}, which is no library")
      endif()
      return()  # a test of the server, in a build without it
    endif()
  endforeach()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE dripfeed_flags GTest::gtest GTest::gmock GTest::gtest_main Threads::Threads ${ARG_SYSTEM})
  foreach(link IN LISTS ARG_LINKS)
    target_link_libraries(${name} PRIVATE dripfeed_${link})
  endforeach()
  target_compile_definitions(${name} PRIVATE DRIPFEED_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  if(ARG_UNIT)
    # What is tested lies in the libraries; the tests' own code need not be fast, and compiles a third faster like this.
    target_compile_options(${name} PRIVATE -O0)
    dripfeed_use_precompiled(${name} dripfeed_headers_unit_test)
  else()
    dripfeed_use_precompiled(${name} dripfeed_headers_test)
  endif()
  dripfeed_together(${name})
  add_test(NAME ${name} COMMAND ${name})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  dripfeed_patience(ARG_TIMEOUT)
  set_tests_properties(${name} PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS "${ARG_LABELS}")
  if(ARG_SERIAL)
    set_tests_properties(${name} PROPERTIES RUN_SERIAL TRUE)
  endif()
endfunction()

# dripfeed_unit_test(FOLDER LINKS a b [SERIAL]): tests/unit/FOLDER/*.cpp becomes the test unit_<FOLDER with _> that links LINKS only.
# Its labels are unit and the top folder.
function(dripfeed_unit_test folder)
  cmake_parse_arguments(ARG "SERIAL" "" "LINKS;SYSTEM" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/unit/${folder}/*.cpp)
  if(NOT sources)
    return()
  endif()
  string(REPLACE "/" "_" flat ${folder})
  string(REGEX REPLACE "/.*" "" top ${folder})
  set(serial "")
  if(ARG_SERIAL)
    set(serial SERIAL)
  endif()
  dripfeed_test(unit_${flat} SOURCES ${sources} LINKS ${ARG_LINKS} SYSTEM ${ARG_SYSTEM} LABELS unit ${top} UNIT ${serial})
endfunction()

# dripfeed_fuzz(NAME SOURCES... LINKS a b CORPUS folders... [DEFINITIONS d...]): a source with LLVMFuzzerTestOneInput. With
# DRIPFEED_FUZZ it is the libFuzzer binary fuzz_NAME (all of them: the target fuzz_targets); else the same source with a
# small main is a test that replays the seeds of tests/fuzz/corpus/FOLDER and what is made from them.
function(dripfeed_fuzz name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;CORPUS;DEFINITIONS" ${ARGN})
  set(target fuzz_${name})
  add_executable(${target} ${ARG_SOURCES} target.cpp)
  target_link_libraries(${target} PRIVATE dripfeed_flags fmt::fmt)
  dripfeed_use_precompiled(${target} dripfeed_headers)
  foreach(link IN LISTS ARG_LINKS)
    target_link_libraries(${target} PRIVATE dripfeed_${link})
  endforeach()
  target_compile_definitions(${target} PRIVATE ${ARG_DEFINITIONS})
  list(TRANSFORM ARG_CORPUS PREPEND ${CMAKE_SOURCE_DIR}/tests/fuzz/corpus/)
  if(DRIPFEED_FUZZ)
    target_link_options(${target} PRIVATE -fsanitize=fuzzer)
    add_dependencies(fuzz_targets ${target})
  else()
    target_sources(${target} PRIVATE replay.cpp)
    add_test(NAME ${target} COMMAND ${target} ${ARG_CORPUS})
    set(patience 300)
    dripfeed_patience(patience)
    set_tests_properties(${target} PROPERTIES TIMEOUT ${patience} LABELS fuzz)
  endif()
endfunction()

# dripfeed_slots([names...]): how many tests of the folder it is called in go beside each other. deploy/test gives ctest two slots a core. A test takes
# two of them; those that are named wait for a line, a clock or a peer for most of their time and take one, so four of them go beside each other on two cores.
function(dripfeed_slots)
  get_property(tests DIRECTORY PROPERTY TESTS)
  if(tests)  # libFuzzer's build has none of them
    set_tests_properties(${tests} PROPERTIES PROCESSORS 2)
  endif()
  if(ARGN)
    set_tests_properties(${ARGN} PROPERTIES PROCESSORS 1)
  endif()
endfunction()
