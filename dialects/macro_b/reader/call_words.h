// Codes that make their whole block a call or data: its other words are arguments, a program's number or parameters,
// not moves. One table for the reader and for the scanner of plain blocks.
#pragma once

#include <cstdint>

#include "dialects/ir/control.h"

namespace dripfeed::macro_b {

enum class CallWord : std::uint8_t {
  none,
  subprogram,        // M98
  local,             // M97 of a Haas: P is a block of the same program
  external,          // M198
  macro,             // G65
  modal,             // G66
  modal_each_block,  // G66.1
  modal_end,         // G67
  data_input,        // G10
  data_end,          // G11
  by_code            // a code that the machine makes a call of
};

// `number10` is ten times the written number, negative for a computed one.
CallWord call_word(const ir::Control& control, char letter, std::int32_t number10);
// What the machine's parameters make of a code; nullptr when they leave it alone.
const ir::CodeCall* code_call(const ir::Control& control, char letter, std::int32_t number10);

}  // namespace dripfeed::macro_b
