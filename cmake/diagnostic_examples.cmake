# Writes the examples of `dripfeed explain` as a table in C++: of each diagnostic a golden program that triggers it and the near miss
# beside it, the shortest that need no option.
#   cmake -D GOLDEN=tests/golden -D OUT=FILE -P diagnostic_examples.cmake
# A later folder takes the place of an earlier one.
set(dialects mitsubishi mazak sinumerik fanuc run)
set(kMostBytes 700)

# Of the programs of a diagnostic the text and file of the first that starts with `stem`; empty without one.
function(read_example folder stem text file)
  file(GLOB found RELATIVE ${folder} ${folder}/${stem}*)
  list(SORT found)
  foreach(name IN LISTS found)
    if(NOT name MATCHES "^[a-z_]+[.](nc|mpf|spf)$")  # .expected, and options as .drip
      continue()
    endif()
    file(READ ${folder}/${name} content)
    # What the goldens cite for themselves.
    string(REGEX REPLACE " ?[(]ORACLE:[^)\n]*[)]" "" content "${content}")
    string(REGEX REPLACE ", ORACLE:[^)\n]*" "" content "${content}")
    string(REGEX REPLACE ";? *oracle:[^\n]*\n" "" content "${content}")
    string(LENGTH "${content}" length)
    if(length LESS kMostBytes)
      set(${text} "${content}" PARENT_SCOPE)
      set(${file} ${name} PARENT_SCOPE)
      return()
    endif()
  endforeach()
  set(${text} "" PARENT_SCOPE)
endfunction()

file(GLOB names RELATIVE ${GOLDEN} ${GOLDEN}/*/*)
set(ids "")
foreach(name IN LISTS names)
  get_filename_component(id ${name} NAME)
  if(IS_DIRECTORY ${GOLDEN}/${name})
    list(APPEND ids ${id})
  endif()
endforeach()
list(REMOVE_DUPLICATES ids)
list(SORT ids)

set(rows "")
foreach(id IN LISTS ids)
  set(row "")
  foreach(dialect IN LISTS dialects)
    set(folder ${GOLDEN}/${dialect}/${id})
    if(NOT IS_DIRECTORY ${folder})
      continue()
    endif()
    read_example(${folder} trigger trigger file)
    read_example(${folder} near_miss near_miss ignored)
    if(NOT trigger STREQUAL "")
      if(dialect STREQUAL run AND file MATCHES "nc$")
        set(dialect fanuc)
      elseif(dialect STREQUAL run OR dialect STREQUAL sinumerik)
        set(dialect sinumerik-840d)
      elseif(dialect STREQUAL mitsubishi)
        set(dialect mitsubishi-m80)
      endif()
      set(row "    {\"${id}\", \"${dialect}\", R\"~~(${trigger})~~\", R\"~~(${near_miss})~~\"},\n")
    endif()
  endforeach()
  string(APPEND rows "${row}")
endforeach()
file(WRITE ${OUT} "// Written by cmake/diagnostic_examples.cmake from the goldens.
#include \"server/cli/diagnostic_examples.h\"

namespace dripfeed::cli {

namespace {

constexpr DiagnosticExample kExamples[] = {
${rows}};

}  // namespace

std::span<const DiagnosticExample> diagnostic_examples() { return kExamples; }

}  // namespace dripfeed::cli
")
