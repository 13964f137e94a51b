// validate: rules that look at more than one block, one file a subject. Each check walks the program once and reports
// in any order; validate() sorts. What a fault is called and which alarm it has stands in the tables.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/facts/resolved.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/ir/stage.h"
#include "dialects/sinumerik/reader/data_file.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::sinumerik {

struct Check {
  const ir::Program& program;
  const ir::Control& control;
  ir::Delivery delivery;
  std::vector<text::Diagnostic>& out;

  text::Diagnostic& report(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments = {}) const;
  // An error where a named machine is meant, a warning where only the usual control is known.
  void report_if_machine(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments = {}) const;
  [[nodiscard]] std::string_view text_of(text::Span span) const { return span.in(program.source.text()); }
  [[nodiscard]] const ir::Block& block_of(const ir::Statement& s) const { return program.blocks[s.payload]; }
  [[nodiscard]] std::string_view native_name(const ir::Statement& s) const {
    return program.strings.at(program.natives[s.payload].name);
  }
};

// Somewhere in the text.
bool has_code(const ir::Program& program, ir::Function function);
// A subprogram takes its modal state and its R parameters from who calls it: it has a PROC head, or nothing in it ends
// a program.
bool may_have_caller(const ir::Program& program);

void check_structures(const Check& check);  // validate_structures.cpp
void check_labels(const Check& check);      // validate_flow.cpp
void check_reachability(const Check& check);
void check_delivery(const Check& check);     // validate_delivery.cpp
void check_names(const Check& check);        // validate_names.cpp
void check_values(const Check& check);       // validate_values.cpp
void check_blocks(const Check& check);       // validate_blocks.cpp
void check_limits(const Check& check);       // validate_limits.cpp
void check_calls(const Check& check);        // validate_calls.cpp
void check_ranges(const Check& check);       // validate_ranges.cpp
void check_definitions(const Check& check);  // validate_definitions.cpp
void check_symbols(const Check& check);      // validate_symbols.cpp
void check_cycles(const Check& check);       // validate_cycles.cpp
void check_words(const Check& check);        // validate_words.cpp
void check_interpreted(const Check& check);  // validate_interpreted.cpp

// M functions that the machine's list does not have.
void check_machine_functions(const Check& check);  // validate_modes.cpp

// Checks that ask what is in effect. They are called for each statement in turn, one after the other, so that facts
// walks over the text once for all of them. What they are made from must outlive them.
using StatementCheck = std::move_only_function<void(std::uint32_t statement)>;
StatementCheck modal_state_check(const Check& check, const facts::Resolved& facts);   // validate_state.cpp
StatementCheck tools_check(const Check& check, const facts::Resolved& facts);         // validate_tools.cpp
StatementCheck compensation_check(const Check& check, const facts::Resolved& facts);  // validate_modes.cpp
StatementCheck leftovers_check(const Check& check, const facts::Resolved& facts);     // validate_leftovers.cpp

}  // namespace dripfeed::sinumerik
