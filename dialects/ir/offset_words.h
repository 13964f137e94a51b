// G54 P3 of a control that reads it as G54.1 P3: which codes of the same block take the P for themselves.
#pragma once

#include "dialects/ir/statement.h"

namespace dripfeed::ir {

constexpr bool takes_p(Function function) {
  return function == Function::dwell || function == Function::data_input || function == Function::drill ||
         function == Function::repetitive_cycle || function == Function::hole_pattern || function == Function::scale ||
         function == Function::reference_return || function == Function::skip_move ||
         function == Function::not_modelled || function == Function::machine_function;
}

inline constexpr double kLastExtendedOffset = 300.0;  // P of G54.1, with the largest option
inline constexpr std::int16_t kFirstWorkOffset = 1;   // G54

}  // namespace dripfeed::ir
