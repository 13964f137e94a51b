// One walk through the text with what is in effect at each place.
#include "dialects/compile/translate/without_counterpart.h"

#include <algorithm>
#include <utility>

#include "dialects/compile/dialect/motion_codes.h"
#include "dialects/compile/translate/own_pecks.h"
#include "dialects/facts/axis_words.h"
#include "dialects/ir/called_cycle.h"
#include "dialects/passes/rigid_taps.h"

namespace dripfeed::compile {

namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;
using ir::StatementKind;

// A call that drills and whose counterpart is a modal cycle of mills.
bool drills(const ir::Call& call) {
  return ir::is_called(call, ir::CalledSort::hole) && call.cycle->hole != ir::DrillCycle::tap_right;
}

bool moves(const ir::Word& w) {
  return ir::is_axis(w.address) || w.address == Address::polar_angle || w.address == Address::polar_radius ||
         w.address == Address::named_axis;
}

class Walk {
 public:
  Walk(const ir::Program& program, const ir::Control& from, const ir::Control& to)
      : program_(program), from_(from), to_(to) {}

  std::vector<WithoutCounterpart> run() {
    std::vector<WithoutCounterpart> out;
    out.reserve(program_.statements.size());
    for (const ir::Statement& s : program_.statements) out.push_back(of(s));
    return out;
  }

 private:
  WithoutCounterpart of(const ir::Statement& s) {
    switch (s.kind) {
      case StatementKind::call: return of_call(program_.calls[s.payload]);
      case StatementKind::modal_call: {
        const ir::Call& call = program_.calls[s.payload];
        makes_pecks_ = pecks(call);
        return makes_pecks_ ? WithoutCounterpart::pecks : WithoutCounterpart::no;
      }
      case StatementKind::modal_call_end:
        return std::exchange(makes_pecks_, false) ? WithoutCounterpart::pecks : WithoutCounterpart::no;
      case StatementKind::block: return of_block(program_.blocks[s.payload]);
      default: return WithoutCounterpart::no;
    }
  }

  [[nodiscard]] bool pecks(const ir::Call& call) const {
    return from_.dialect != to_.dialect && from_.kind == ir::MachineKind::mill &&
           call.computed == ir::ExpressionId::none && drills(call) && has_own_pecks(program_, call, to_);
  }
  // A position, or several, where a modal call drills.
  [[nodiscard]] bool is_position(const ir::Block& block) const {
    return makes_pecks_ && !facts::has_own_words(program_, block) &&
           std::ranges::any_of(program_.words_of(block), moves);
  }

  [[nodiscard]] WithoutCounterpart of_call(const ir::Call& call) const {
    const bool calls_too = from_.dialect == to_.dialect;
    if (calls_too || call.computed != ir::ExpressionId::none) return WithoutCounterpart::no;
    if (ir::is_called(call, ir::CalledSort::removal) || ir::is_called(call, ir::CalledSort::milling))
      return WithoutCounterpart::removal;
    const bool positions = ir::is_called(call, ir::CalledSort::holes_in_row) ||
                           ir::is_called(call, ir::CalledSort::holes_on_circle) ||
                           ir::is_called(call, ir::CalledSort::holes_anywhere);
    if (pecks(call) || (makes_pecks_ && positions)) return WithoutCounterpart::pecks;
    return drills(call) && from_.kind != ir::MachineKind::mill ? WithoutCounterpart::drilling : WithoutCounterpart::no;
  }

  WithoutCounterpart of_block(const ir::Block& block) {
    bool names = false;
    for (const ir::Code& c : program_.codes_of(block)) {
      if (ir::follows_shape(c))
        return has_row(to_, c.function, c.argument) ? WithoutCounterpart::no : WithoutCounterpart::removal;
      if (c.function == Function::hole_pattern && !has_row(to_, c.function, c.argument))
        return WithoutCounterpart::drilling;
      if (!sets_motion(c)) continue;
      motion_ = motion_of(c);
      names = motion_ != WithoutCounterpart::no;
    }
    if (is_position(block)) return WithoutCounterpart::pecks;
    const auto words = program_.words_of(block);
    return motion_ != WithoutCounterpart::no && (names || std::ranges::any_of(words, moves)) ? motion_
                                                                                             : WithoutCounterpart::no;
  }

  static bool sets_motion(const ir::Code& c) {
    return c.group == ModalGroup::motion || c.group == ModalGroup::cycle || c.function == Function::cycle_off;
  }

  [[nodiscard]] WithoutCounterpart motion_of(const ir::Code& c) const {
    const bool arc = c.function == Function::arc_via || c.function == Function::arc_tangent;
    if (arc && !has_row(to_, c.function, c.argument)) return WithoutCounterpart::arc;
    const bool lathe = c.function == Function::drill && c.argument >= ir::kDrillAlongZ && !passes::is_tap(c);
    return lathe && !has_row(to_, c.function, c.argument) ? WithoutCounterpart::drilling : WithoutCounterpart::no;
  }

  const ir::Program& program_;
  const ir::Control& from_;
  const ir::Control& to_;
  WithoutCounterpart motion_ = WithoutCounterpart::no;  // in effect
  bool makes_pecks_ = false;                            // a modal call in effect does
};

}  // namespace

std::vector<WithoutCounterpart> without_counterpart(const ir::Program& program, const ir::Control& from,
                                                    const ir::Control& to) {
  return Walk(program, from, to).run();
}

std::string name_of(WithoutCounterpart kind, const ir::Program& program, const ir::Statement& statement) {
  if (statement.kind == StatementKind::call || statement.kind == StatementKind::modal_call)
    return std::string(program.strings.at(program.calls[statement.payload].name));
  if (statement.kind == StatementKind::modal_call_end) return "the end of a modal call";
  for (const ir::Code& c : program.codes_of(program.blocks[statement.payload])) {
    const bool meant =
        c.function == Function::repetitive_cycle || c.function == Function::drill || c.function == Function::arc_via ||
        c.function == Function::arc_tangent || c.function == Function::hole_pattern || c.function == Function::tap ||
        c.function == Function::tap_retract || (c.function == Function::linear && c.group == ModalGroup::non_modal);
    if (meant && !c.span.empty()) return std::string(c.span.in(program.source.text()));
  }
  switch (kind) {
    case WithoutCounterpart::arc: return "an arc";
    case WithoutCounterpart::drilling: return "a drilling cycle of a lathe";
    case WithoutCounterpart::pecks: return "a deep hole";
    case WithoutCounterpart::removal: return "stock removal";
    case WithoutCounterpart::tap:
    case WithoutCounterpart::tap_part: return "a tap";
    case WithoutCounterpart::no: break;
  }
  return {};
}

}  // namespace dripfeed::compile
