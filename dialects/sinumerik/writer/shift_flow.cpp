// Forward over the edges of the program. A called program may shift and turn as it likes.
#include "dialects/sinumerik/writer/shift_flow.h"

#include <algorithm>
#include <deque>

#include "dialects/facts/flow_graph.h"
#include "dialects/ir/frame_use.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Address;
using ir::Function;
using ir::StatementKind;

constexpr std::array kAxes = {Address::x, Address::y, Address::z};

bool is_frame(Function f) { return f == Function::rotate || f == Function::scale || f == Function::mirror; }

}  // namespace

void ShiftFlow::State::forget() {
  for (Fact<double>& one : shift) one.forget();
  turned.forget();
}

bool ShiftFlow::State::meet(const State& other) {
  bool less = turned.meet(other.turned);
  for (std::size_t axis = 0; axis < shift.size(); ++axis) less |= shift[axis].meet(other.shift[axis]);
  return less;
}

ShiftFlow::ShiftFlow(const ir::Program& program, const ir::Control& from)
    : program_(program), from_(from), before_(program.statements.size() + 1) {
  facts::FlowGraph graph(program);
  std::deque<std::uint32_t> work;
  const std::vector<std::uint32_t> entries = graph.entries();
  for (const std::uint32_t entry : entries) {
    before_[entry] = State();
    if (entry != entries.front()) before_[entry]->forget();
    work.push_back(entry);
  }
  while (!work.empty()) {
    const std::uint32_t i = work.front();
    work.pop_front();
    if (i >= program.statements.size()) continue;
    State out = after(*before_[i], program.statements[i]);
    if (program.statements[i].skip_level != 0) out.meet(*before_[i]);
    for (const std::uint32_t next : graph.after(i)) {
      const bool is_new = !before_[next].has_value();
      if (is_new) before_[next] = out;
      if (is_new || before_[next]->meet(out)) work.push_back(next);
    }
  }
}

ShiftFlow::State ShiftFlow::after(State state, const ir::Statement& s) const {
  const bool elsewhere = s.kind == StatementKind::call || s.kind == StatementKind::modal_call ||
                         s.kind == StatementKind::native || s.kind == StatementKind::repeat_section ||
                         s.kind == StatementKind::execute_text;
  if (elsewhere) state.forget();
  if (s.kind != StatementKind::block) return state;
  const ir::Block& block = program_.blocks[s.payload];
  for (const ir::Code& c : program_.codes_of(block)) {
    if (c.number != ir::ExpressionId::none && c.letter == 'G') state.forget();
    if (c.group == ir::ModalGroup::unit)
      for (Fact<double>& one : state.shift)
        if (!one.is(0.0)) one.forget();
    if (is_frame(c.function)) state.turned.set(c.argument != ir::kFrameEnds);
    if (c.function != Function::local_shift) continue;
    for (const ir::Word& w : program_.words_of(block)) {
      const auto axis = std::ranges::find(kAxes, w.address);
      if (axis == kAxes.end()) continue;
      Fact<double>& shift = state.shift[static_cast<std::size_t>(axis - kAxes.begin())];
      const ir::Expression& e = program_.at(w.value);
      const bool whole = e.has_point || e.value == 0.0 || from_.semantics.decimal_mode == ir::DecimalMode::calculator;
      e.op == ir::Operator::constant&& whole ? shift.set(e.value) : shift.forget();
    }
  }
  return state;
}

std::optional<std::array<double, 3>> ShiftFlow::shift_at(std::uint32_t statement) const {
  const std::optional<State>& state = before_[statement];
  if (!state) return std::array<double, 3>{};
  std::array<double, 3> out{};
  for (std::size_t axis = 0; axis < out.size(); ++axis) {
    if (!state->shift[axis].known) return std::nullopt;
    out[axis] = state->shift[axis].value;
  }
  return out;
}

std::optional<bool> ShiftFlow::turned_at(std::uint32_t statement) const {
  const std::optional<State>& state = before_[statement];
  if (!state) return false;
  return state->turned.known ? std::optional(state->turned.value) : std::nullopt;
}

}  // namespace dripfeed::sinumerik
