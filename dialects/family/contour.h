// Contours of a body that are checked, with the family's values, before its program runs.
#pragma once

#include <cstdint>
#include <vector>

#include "dialects/ir/program.h"
#include "dialects/text/span.h"

namespace dripfeed::family {

// The contour of a `rough`: what is checked of it before the program runs. x as the family has it.
struct RoughContour {
  // A let of the contour (target), or a point that a line or an arc leads to.
  struct Item {
    ir::SymbolId target = ir::SymbolId::none;
    ir::ExpressionId value = ir::ExpressionId::none;  // of the let
    ir::ExpressionId x = ir::ExpressionId::none;
    ir::ExpressionId z = ir::ExpressionId::none;
    bool is_arc = false;
    bool clockwise = false;
    ir::ExpressionId i = ir::ExpressionId::none;  // none: 0
    ir::ExpressionId k = ir::ExpressionId::none;
    ir::ExpressionId radius = ir::ExpressionId::none;
    ir::ExpressionId when = ir::ExpressionId::none;  // decided when the family gets its values; none: always
    text::Span span;
  };
  bool is_facing = false;  // passes along x
  bool is_inside = false;
  ir::ExpressionId x = ir::ExpressionId::none;  // where it begins
  ir::ExpressionId z = ir::ExpressionId::none;
  ir::ExpressionId depth = ir::ExpressionId::none;
  ir::ExpressionId retract = ir::ExpressionId::none;
  ir::ExpressionId allowance_x = ir::ExpressionId::none;  // none: 0
  ir::ExpressionId allowance_z = ir::ExpressionId::none;
  std::vector<Item> items;
  text::Span span;
};

// The contour of an `offset`. What it is at its corners is found with the family's values: each has a symbol that takes
// a Corner, and stands in the program as a number.
enum class Corner : std::uint8_t {
  straight,    // on the offsets of both tangents: between lines, and where two elements meet smoothly
  minus_root,  // where the offsets meet: of their two intersections the one with this sign
  plus_root,
  outer,  // by an arc around the corner
  open,   // between the end and the start of a contour that is not closed
};
struct OffsetContour {
  // A let of the contour (target), or a point that a line or an arc leads to. Values as the family has them: on lathes
  // x may be a diameter.
  struct Item {
    ir::SymbolId target = ir::SymbolId::none;
    ir::ExpressionId value = ir::ExpressionId::none;  // of the let
    ir::ExpressionId u = ir::ExpressionId::none;      // first axis of the plane
    ir::ExpressionId v = ir::ExpressionId::none;
    bool is_arc = false;
    bool clockwise = false;
    ir::ExpressionId i = ir::ExpressionId::none;  // along u; none: 0
    ir::ExpressionId j = ir::ExpressionId::none;
    ir::ExpressionId radius = ir::ExpressionId::none;
    ir::SymbolId corner = ir::SymbolId::none;     // at this point, to the next one; of the start: to the last one
    ir::SymbolId direction = ir::SymbolId::none;  // of a line along one axis: 1 or -1
    text::Span span;
  };
  bool is_left = false;  // as the contour leads
  bool doubles_u = false;
  bool doubles_v = false;
  ir::ExpressionId distance = ir::ExpressionId::none;
  std::vector<Item> items;
  text::Span span;
};

}  // namespace dripfeed::family
