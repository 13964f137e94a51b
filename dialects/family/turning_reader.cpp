// Verbs of lathes that stand for many moves: grooves by plunges, and threads with all their passes. Each becomes steps
// of the language itself, so that every control makes the same moves of it.
#include <fmt/format.h>

#include "dialects/family/body_reader.h"

namespace dripfeed::family {

namespace {

using ir::Address;
using ir::ExpressionId;
using ir::Operator;

constexpr double kChipBreak_mm = 0.5;  // back after a peck, on the radius

}  // namespace

// A name that is not given here.
std::string BodyReader::unused_name(std::string_view stem) const {
  std::string name(stem);
  for (int i = 2; scope_.find(name) != nullptr; ++i) name = fmt::format("{}{}", stem, i);
  return name;
}

// A loop that the text does not show.
Step BodyReader::hidden_loop(std::string_view stem, Dimension dimension) {
  Step out = step(StepKind::for_begin);
  scope_.open();
  out.target = scope_.define(family_.arena, unused_name(stem), dimension, verb_);
  return out;
}

void BodyReader::end_hidden_loop() {
  scope_.close();
  add(step(StepKind::for_end));
}

ExpressionId BodyReader::name_of(const Step& step) { return name_of(step.target); }

// Or of a number of a list.
ExpressionId BodyReader::name_of(ir::SymbolId symbol, ExpressionId index) {
  ir::Variable variable;
  variable.bank = ir::Bank::named;
  variable.symbol = symbol;
  variable.index = index;
  variable.span = verb_;
  return family_.arena.add_variable(variable);
}

// A hidden loop over whole numbers, which gives its counter.
ExpressionId BodyReader::count_hidden(std::string_view stem, double first, ExpressionId last) {
  Step loop = hidden_loop(stem, kRatio);
  loop.values[0] = family_.arena.add_constant(first, verb_);
  loop.values[1] = last;
  loop.values[2] = family_.arena.add_constant(1.0, verb_);
  const ExpressionId counter = name_of(loop);
  add(std::move(loop));
  return counter;
}

ExpressionId BodyReader::calculated(Operator op, ExpressionId a, ExpressionId b) {
  return family_.arena.add_operator(op, a, b, verb_);
}

// A length on the radius, as x has it.
ExpressionId BodyReader::in_x(ExpressionId on_radius) {
  return family_.x_is_diameter ? calculated(Operator::multiply, family_.arena.add_constant(2.0, verb_), on_radius)
                               : on_radius;
}

void BodyReader::move_to(StepKind kind, Address axis, ExpressionId value) {
  Step out = step(kind);
  word(out, axis, {.id = value});
  add(std::move(out));
}

// groove [inside] from X to X z Z [["down"] "to" Z "step" LENGTH] [peck LENGTH] [dwell TIME]
void BodyReader::groove() {
  if (family_.machine == ir::MachineKind::mill)
    return cursor_.syntax(verb_,
                          "'groove' plunges a tool into a turning part: on a mill a groove is cut along its path");
  if (!may_cut()) return;
  if (compensation_waits_)
    return cursor_.syntax(verb_, "compensation begins and ends with a straight move: rapid or cut before this groove");
  Groove read{.inside = cursor_.accept_word("inside")};
  const auto length = [&](std::string_view name, ExpressionId& out) {
    if (!cursor_.line_failed() && cursor_.expect_word(name)) out = expressions_.value_of(kLength).id;
  };
  length("from", read.from);
  length("to", read.to);
  length("z", read.z);
  if (!cursor_.line_failed() && (cursor_.at_word("down") || cursor_.at_word("to"))) {
    read.down = cursor_.accept_word("down");
    length("to", read.last_z);
    length("step", read.step);
  }
  if (!cursor_.line_failed() && cursor_.accept_word("peck")) read.peck = expressions_.value_of(kLength).id;
  if (!cursor_.line_failed() && cursor_.accept_word("dwell")) read.dwell = expressions_.value_of(kTime).id;
  if (cursor_.line_failed()) return;
  move_to(StepKind::rapid, Address::z, read.z);
  move_to(StepKind::rapid, Address::x, read.from);
  if (read.last_z == ExpressionId::none) return plunge(read);
  Step loop = hidden_loop("plunge_z", kLength);
  loop.down = read.down;
  loop.values[0] = read.z;
  loop.values[1] = read.last_z;
  loop.values[2] = read.step;
  const ExpressionId place = name_of(loop);
  add(std::move(loop));
  move_to(StepKind::rapid, Address::z, place);
  plunge(read);
  end_hidden_loop();
}

// From where the feed begins, in and out again.
void BodyReader::plunge(const Groove& groove) {
  if (groove.peck != ExpressionId::none) {
    const ExpressionId peck = in_x(groove.peck);
    const ExpressionId first = calculated(groove.inside ? Operator::add : Operator::subtract, groove.from, peck);
    Step loop = hidden_loop("peck_x", kLength);
    loop.down = !groove.inside;
    loop.values[0] = calculated(groove.inside ? Operator::minimum : Operator::maximum, first, groove.to);
    loop.values[1] = groove.to;
    loop.values[2] = peck;
    const ExpressionId depth = name_of(loop);
    add(std::move(loop));
    move_to(StepKind::cut, Address::x, depth);
    const ExpressionId back = in_x(family_.arena.add_constant(kChipBreak_mm, verb_));
    move_to(StepKind::rapid, Address::x, calculated(groove.inside ? Operator::subtract : Operator::add, depth, back));
    end_hidden_loop();
  }
  move_to(StepKind::cut, Address::x, groove.to);
  if (groove.dwell != ExpressionId::none) {
    Step out = step(StepKind::dwell);
    out.values[0] = groove.dwell;
    add(std::move(out));
  }
  move_to(StepKind::rapid, Address::x, groove.from);
}

// The rest of "thread x X z Z pitch LENGTH": "depth LENGTH passes COUNT from Z return X [spring COUNT] [inside]".
void BodyReader::thread_passes(const Step& one, ExpressionId pitch) {
  const auto value = [&](std::string_view name, Dimension dimension) {
    if (cursor_.line_failed() || !cursor_.expect_word(name)) return ExpressionId::none;
    return expressions_.value_of(dimension).id;
  };
  const auto given = [&](Address axis) {
    for (std::uint32_t i = 0; i < one.word_count; ++i)
      if (family_.words[one.first_word + i].address == axis) return family_.words[one.first_word + i].value;
    cursor_.syntax(verb_, "a thread with all its passes has x, its diameter before it is cut, and z, its end");
    return ExpressionId::none;
  };
  const ExpressionId x = given(Address::x);
  const ExpressionId z = given(Address::z);
  const ExpressionId depth = value("depth", kLength);
  const ExpressionId passes = value("passes", kRatio);
  const ExpressionId from = value("from", kLength);
  const ExpressionId clear = value("return", kLength);
  const bool springs = !cursor_.line_failed() && cursor_.at_word("spring");
  const ExpressionId spring = springs ? value("spring", kRatio) : ExpressionId::none;
  const bool inside = !cursor_.line_failed() && cursor_.accept_word("inside");
  if (cursor_.line_failed()) return;
  const auto at_depth = [&](ExpressionId on_radius) {
    return calculated(inside ? Operator::add : Operator::subtract, x, in_x(on_radius));
  };
  const auto pass = [&](ExpressionId diameter) {
    move_to(StepKind::rapid, Address::x, diameter);
    Step cut = step(StepKind::thread);
    word(cut, Address::z, {.id = z});
    word(cut, Address::f, {.id = pitch});
    add(std::move(cut));
    move_to(StepKind::rapid, Address::x, clear);
    move_to(StepKind::rapid, Address::z, from);
  };
  move_to(StepKind::rapid, Address::x, clear);
  move_to(StepKind::rapid, Address::z, from);
  // Each pass takes a chip of the same area.
  const ExpressionId number = count_hidden("thread_pass", 1.0, passes);
  const ExpressionId share =
      calculated(Operator::sqrt, calculated(Operator::divide, number, passes), ExpressionId::none);
  pass(at_depth(calculated(Operator::multiply, depth, share)));
  end_hidden_loop();
  if (!springs) return;
  count_hidden("spring_pass", 1.0, spring);
  pass(at_depth(depth));
  end_hidden_loop();
}

}  // namespace dripfeed::family
