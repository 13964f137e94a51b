# Several files of a target compiled as one ("unity build"): what they all read is parsed and instantiated once, so a build
# from nothing takes a third of the time. dev, release and asan-ubsan do so; clang, tsan and fuzz compile each file by itself
# and so find what it forgot to include.
set(DRIPFEED_TOGETHER OFF CACHE BOOL "compile several files as one")

# Files that name something as a neighbour of theirs does. When a new name collides, rename it or list its file here.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/apart.txt)
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/apart.txt DRIPFEED_APART REGEX "^[^#]")
foreach(name IN LISTS DRIPFEED_APART)
  if(NOT EXISTS ${CMAKE_SOURCE_DIR}/${name})
    message(FATAL_ERROR "cmake/apart.txt names ${name}, which does not exist")
  endif()
endforeach()

# dripfeed_together(TARGET): to be called in the folder that made TARGET.
function(dripfeed_together target)
  if(NOT DRIPFEED_TOGETHER)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 10)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source OUTPUT_VARIABLE path)
    cmake_path(RELATIVE_PATH path BASE_DIRECTORY ${CMAKE_SOURCE_DIR} OUTPUT_VARIABLE name)
    if(name IN_LIST DRIPFEED_APART)
      set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
endfunction()
