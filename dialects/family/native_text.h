// A family that keeps a program as a control takes it: which language it is in, where its bytes begin, and which of its
// constants take the family's values. The text itself is read by whoever knows the language.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "dialects/family/unit.h"
#include "dialects/ir/expression.h"
#include "dialects/text/span.h"

namespace dripfeed::family {

// `… is #100`: the value of a parameter or a let goes into the program there.
struct Binding {
  ir::SymbolId symbol = ir::SymbolId::none;
  Dimension dimension;
  const Unit* unit = nullptr;  // as the default was written; nullptr for lets and plain numbers
  std::string target;          // in upper case: "#100", "R10", "DIA", "TURNING_CYCLE.EXTD"
  text::Span span;             // of the target
};

struct NativeText {
  std::string dialect;      // "fanuc"
  text::Span dialect_span;  // of its word
  text::Span text;          // of the program, to the end of the family's text
};

// Where the program begins after its `native` line; the length of the text when there is no such line.
std::uint32_t native_begin(std::string_view text);

// Whether the bytes after `is` may be a target: a '#' with its number, names, and two of them joined by a point.
// Gives its length, 0 for none.
std::size_t target_length(std::string_view text);

}  // namespace dripfeed::family
