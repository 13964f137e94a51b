// From bound family to program: the macro form that any control can be raised to, in core IR only (assignments, while,
// if, blocks, messages, program end). The explicit form is what interpreting this program gives.
#pragma once

#include "dialects/family/bind.h"
#include "dialects/ir/program.h"

namespace dripfeed::family {

// The program starts with the safe state (unit, plane, distance, feed mode, compensation off), then assigns the
// parameters, so that they can be edited at the control, then computes the lets; variables are of bank `named`.
// Statement::line is the line of the family's text. The name is the family's `program` name in upper case.
ir::Program build(const BoundFamily& bound);

}  // namespace dripfeed::family
