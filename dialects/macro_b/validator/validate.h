// The checks of a program on a '#'-variable control, each over one program of the text or over all of it. Which of
// them a control needs is its own choice. None of them runs the program: what depends on values is the interpreter's.
#pragma once

#include <cstdint>
#include <functional>

#include "dialects/facts/resolved.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/ir/stage.h"
#include "dialects/macro_b/tables/grammar.h"
#include "dialects/macro_b/validator/findings.h"

namespace dripfeed::macro_b {

// Loops: DO and END by number, crossing, nesting, and loops without an exit.
void check_loops(const ir::Program& program, const ir::Control& control, const Section& section, Findings& findings);
void check_condition_blocks(const ir::Program& program, Findings& findings);
// Jumps: targets that are missing, stand twice or lie inside a loop; blocks that nothing leads to.
void check_jumps(const ir::Program& program, const Section& section, Findings& findings);

// Variables that the control does not have or that cannot be written.
void check_variables(const ir::Program& program, const ir::Control& control, Findings& findings);
// Words: decimal points missing or not allowed, addresses that are unknown or stand twice, codes of one group.
void check_words(const ir::Program& program, const ir::Control& control, Findings& findings);
// Values that are refused wherever they stand, and M functions that the machine's list does not have.
void check_values(const ir::Program& program, const ir::Control& control, Findings& findings);

// Checks that ask what is in effect. They are called for each statement of a section in turn, one after the other, so
// that facts walks over the text once for all of them. What they are made from must outlive them.
using StatementCheck = std::move_only_function<void(std::uint32_t statement)>;
// What a program must state before it relies on it: unit, distance, plane and feed mode, motion code, feed.
StatementCheck modes_check(const ir::Program& program, const ir::Control& control, const facts::Resolved& facts,
                           const Section& section, Findings& findings);
// What depends on the blocks before: compensation, drilling cycles and modal calls that are in effect.
StatementCheck order_check(const ir::Program& program, const ir::Control& control, const facts::Resolved& facts,
                           const Section& section, Findings& findings);
// How many axes a block moves, and which of them a plane, an arc or a code by number may have.
StatementCheck axes_check(const ir::Program& program, const ir::Control& control, const facts::Resolved& facts,
                          Findings& findings);
// Drilling and turning cycles: pecks, taps, and the shapes that they name.
StatementCheck cycles_check(const ir::Program& program, const ir::Control& control, const facts::Resolved& facts,
                            const Section& section, Findings& findings);
// Moves that a signal ends: measuring a tool, and skipping.
StatementCheck measuring_check(const ir::Program& program, const ir::Control& control, const facts::Resolved& facts,
                               const Section& section, Findings& findings);

// Tape marks, program number, program end, block length.
void check_frame(const ir::Program& program, const ir::Control& control, const std::vector<Section>& sections,
                 Findings& findings);
// What a control does not take while it is fed.
void check_drip(const ir::Program& program, const ir::Control& control, const Grammar& grammar, Findings& findings);
// Codes and blocks that are not interpreted here, each name once.
void check_not_interpreted(const ir::Program& program, const ir::Control& control, Findings& findings);

}  // namespace dripfeed::macro_b
