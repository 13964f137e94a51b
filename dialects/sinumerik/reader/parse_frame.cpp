// Frames as values: CTRANS, CROT, CSCALE, CMIRROR with their axes, and chains of frames.
#include <algorithm>
#include <functional>
#include <vector>

#include "dialects/sinumerik/reader/parse.h"
#include "dialects/sinumerik/tables/system_variables.h"

namespace dripfeed::sinumerik {

using ir::Operator;
using text::DiagnosticId;

// ':' chains frames, from left to right.
ir::ExpressionId Parser::frame_chain(ir::ExpressionId first) {
  ir::ExpressionId value = first;
  while (cursor_.is_symbol(':')) {
    operator_ = cursor_.span();
    if (++operators_ > kMostOperators) {
      give_up(DiagnosticId::syntax_error, operator_, {"a chain of too many frames"});
      return value;
    }
    cursor_.advance();
    const ir::ExpressionId next = binary(kWeakestRank);
    value = program_.add_operator(Operator::frame_chain, value, next,
                                  join(program_.at(value).span, program_.at(next).span));
  }
  return value;
}

bool Parser::is_frame_of_axes(Operator op) {
  return op == Operator::frame_mirror || (op >= Operator::frame_shift && op <= Operator::frame_scale);
}

// CTRANS(X,10,Y,20), CMIRROR(X): a chain of one frame for each axis. CROT turns about Z first, then Y, then X, in
// whatever order they stand; the others may be exchanged. Without arguments: the frame that does nothing.
ir::ExpressionId Parser::frame_of_axes(const Keyword& keyword, text::Span name) {
  struct Part {
    ir::ExpressionId axis = ir::ExpressionId::none;
    ir::ExpressionId value = ir::ExpressionId::none;
    double place = 0.0;
  };
  if (nesting_ >= kDeepestNesting) return missing_operand();
  std::vector<Part> parts;
  const bool has_values = keyword.op != Operator::frame_mirror;
  const text::Span before = operator_;
  operator_ = name;
  expect('(');
  ++brackets_;
  ++nesting_;
  while (!cursor_.is_symbol(')') && !cursor_.at_block_end()) {
    Part part;
    operator_ = name;
    part.axis = system_index();
    if (part.axis == ir::ExpressionId::none) part.axis = binary(kWeakestRank);
    const ir::Expression& letter = program_.at(part.axis);
    part.place = letter.op == Operator::constant ? letter.value : 0.0;
    if (has_values && !cursor_.take(',')) {
      report(DiagnosticId::missing_operand, name, {std::string(keyword.name)});
      part.value = constant(0.0, name);
    } else if (has_values) {
      part.value = binary(kWeakestRank);
    }
    parts.push_back(part);
    if (!cursor_.take(',')) break;
  }
  --nesting_;
  --brackets_;
  expect(')');
  operator_ = before;
  in_parentheses_ = false;
  const text::Span span = to_here(name);
  if (parts.empty())
    return program_.add_operator(Operator::frame_shift, constant(0.0, span), constant(0.0, span), span);
  if (keyword.op == Operator::frame_turn) std::ranges::stable_sort(parts, std::ranges::greater(), &Part::place);
  ir::ExpressionId value = ir::ExpressionId::none;
  for (const Part& part : parts) {
    const ir::ExpressionId one = program_.add_operator(keyword.op, part.axis, part.value, span);
    value = value == ir::ExpressionId::none ? one : program_.add_operator(Operator::frame_chain, value, one, span);
  }
  return value;
}

// CRPL(1,30) turns about Z, 2 about Y, 3 about X, 0 about the axis that stands on the active plane, which is 3 less the
// number of its code in G group 6. (FB1, K2, "CRPL - Constant Rotation Plane".)
ir::ExpressionId Parser::frame_in_plane(const Keyword& keyword, text::Span name) {
  const ir::ExpressionId made = function_call(keyword, name);
  const ir::Expression turn = program_.at(made);
  if (turn.op != Operator::frame_turn) return made;
  const ir::Expression plane = program_.at(turn.a);
  const bool is_constant = plane.op == Operator::constant;
  if (is_constant && !(plane.value >= 0.0 && plane.value <= 3.0)) {
    report(DiagnosticId::argument_out_of_domain, name, {"CRPL", "its plane, which must be 0 to 3"});
    return made;
  }
  ir::ExpressionId number = turn.a;
  if (!is_constant || plane.value == 0.0) {
    ir::Variable group;
    group.bank = ir::Bank::system;
    group.number = find_system_variable("$P_GG");
    group.name = program_.strings.add("$P_GG");
    group.index = constant(6.0, name);
    group.span = name;
    const ir::ExpressionId active = program_.add_variable(group);
    const ir::ExpressionId is_active = program_.add_operator(Operator::equal, number, constant(0.0, name), name);
    const ir::ExpressionId added = program_.add_operator(Operator::multiply, is_active, active, name);
    number = is_constant ? active : program_.add_operator(Operator::add, number, added, name);
  }
  const ir::ExpressionId axis = program_.add_operator(Operator::subtract, constant(3.0, name), number, name);
  return program_.add_operator(Operator::frame_turn, axis, turn.b, turn.span);
}

// System frames, and base frames but the first of the channel, move the zero that positions count from, and are not
// chained here: where the axes are is not known after them. (PGA, "Base frames".)
void Parser::frame_elsewhere(ir::VariableId target, text::Span span) {
  static constexpr std::string_view kFrames[] = {"$P_CHBFRAME", "$P_NCBFRAME",  "$P_CHBFR",     "$P_NCBFR",
                                                 "$P_SETFRAME", "$P_PARTFRAME", "$P_TOOLFRAME", "$P_WPFRAME",
                                                 "$P_CYCFRAME", "$P_TRAFRAME"};
  const ir::Variable& v = program_.at(target);
  if (v.bank != ir::Bank::system || v.name == ir::StringId::none) return;
  if (std::ranges::find(kFrames, program_.strings.at(v.name)) == std::end(kFrames)) return;
  const ir::Code code{
      .function = ir::Function::not_modelled, .group = ir::ModalGroup::non_modal, .name = v.name, .span = span};
  for (const ir::Address address : {ir::Address::x, ir::Address::y, ir::Address::z}) {
    ir::Word word;
    word.address = address;
    word.value = constant(0.0, span);
    word.span = span;
    lower_.add_aside(code, word);
  }
}

}  // namespace dripfeed::sinumerik
