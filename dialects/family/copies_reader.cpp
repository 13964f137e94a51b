// mirror and repeat: the moves up to `end`, on the other side of a line, or again and again, shifted or turned. The
// words of the moves are changed when the block ends; moves of called subprograms get words of their own.
#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>

#include "dialects/family/body_reader.h"
#include "dialects/ir/motion.h"

namespace dripfeed::family {

using ir::Address;
using ir::ExpressionId;
using ir::Operator;

namespace {

struct CopiedAxis {
  std::string_view word;
  Address address;
  Address center;
};
constexpr auto kCopiedAxes = std::to_array<CopiedAxis>({
    {"x", Address::x, Address::i},
    {"y", Address::y, Address::j},
    {"z", Address::z, Address::k},
});

constexpr auto kPlacing =
    std::to_array<StepKind>({StepKind::rapid, StepKind::cut, StepKind::arc_cw, StepKind::arc_ccw, StepKind::hole});
constexpr auto kNotCopied = std::to_array<StepKind>(
    {StepKind::engrave, StepKind::native, StepKind::plane, StepKind::work_offset, StepKind::thread, StepKind::contour});

StepWord* find_word(std::vector<StepWord>& words, Address address) {
  const auto word = std::ranges::find(words, address, &StepWord::address);
  return word == words.end() ? nullptr : &*word;
}

// Whether climb and conventional milling differ there.
bool has_direction(const Step& step) {
  return step.begins_pocket ||
         (step.kind == StepKind::compensate && step.number != static_cast<int>(ir::CompSide::off));
}

}  // namespace

bool BodyReader::may_copy() {
  if (family_.machine == ir::MachineKind::lathe)
    cursor_.syntax(verb_, "only moves of a mill are mirrored and repeated as a block: a lathe has 'for' and 'sub'");
  else if (other_plane_)
    cursor_.syntax(verb_, "moves are mirrored and repeated in the plane of x and y: plane xy before it");
  else if (compensation_waits_ || compensated_)
    cursor_.syntax(
        verb_, "compensation begins and ends inside of the block, or outside: compensate off, and a move, before it");
  return !cursor_.line_failed();
}

// mirror (x | y) [at VALUE]
void BodyReader::mirror() {
  Copies copies;
  const bool may = may_copy();
  if (may && !cursor_.at_word("x") && !cursor_.at_word("y")) cursor_.expected("x or y");
  copies.address = cursor_.at_word("x") ? Address::x : Address::y;
  if (!cursor_.line_failed()) cursor_.advance();
  if (!cursor_.line_failed() && cursor_.accept_word("at")) copies.x = expressions_.value_of(kLength).id;
  copies.first_step = steps_.size();
  open_.push_back({.kind = StepKind::let, .span = verb_, .line = line_});
  open_.back().copies = copies;
  scope_.open();
}

// repeat COUNT by AXIS VALUE ... | repeat COUNT turn ANGLE at x VALUE y VALUE
void BodyReader::repeat() {
  Copies copies{.is_repeat = true};
  const bool may = may_copy();
  const ExpressionId count = may ? expressions_.value_of(kRatio).id : ExpressionId::none;
  const auto axis = [&](const CopiedAxis& one, ExpressionId& value) {
    if (cursor_.line_failed() || !cursor_.accept_word(one.word)) return false;
    value = expressions_.value_of(kLength).id;
    return true;
  };
  if (!cursor_.line_failed() && cursor_.accept_word("turn")) {
    copies.angle = expressions_.value_of(kAngle).id;
    if (!cursor_.line_failed() && cursor_.expect_word("at") &&
        !(axis(kCopiedAxes[0], copies.x) && axis(kCopiedAxes[1], copies.y)))
      cursor_.expected("x and y of the center");
  } else if (!cursor_.line_failed() && cursor_.expect_word("by")) {
    const bool by_x = axis(kCopiedAxes[0], copies.x);
    const bool by_y = axis(kCopiedAxes[1], copies.y);
    const bool by_z = axis(kCopiedAxes[2], copies.z);
    if (!by_x && !by_y && !by_z) cursor_.expected("x, y or z");
  }
  if (cursor_.line_failed()) {
    open_.push_back({.kind = StepKind::for_begin, .span = verb_, .line = line_});
    return scope_.open();
  }
  const ExpressionId copy = count_hidden("copy", 0.0, calculated(Operator::subtract, count, number(1.0)));
  const auto gone = [&](ExpressionId step) {
    return step == ExpressionId::none ? step : calculated(Operator::multiply, copy, step);
  };
  if (copies.angle != ExpressionId::none) {
    copies.angle = kept("turned", gone(copies.angle), kAngle);
    copies.cosine = kept("turned_cos", family_.arena.add_operator(Operator::cos, copies.angle, {}, verb_), kRatio);
    copies.sine = kept("turned_sin", family_.arena.add_operator(Operator::sin, copies.angle, {}, verb_), kRatio);
  } else {
    copies.x = gone(copies.x);
    copies.y = gone(copies.y);
    copies.z = gone(copies.z);
  }
  copies.first_step = steps_.size();
  open_.push_back({.kind = StepKind::for_begin, .span = verb_, .line = line_});
  open_.back().copies = copies;
}

// Of all steps since its line.
void BodyReader::end_copies(const Copies& copies, text::Span head) {
  for (std::size_t i = copies.first_step; i < steps_.size(); ++i) {
    Step& one = steps_[i];
    if (std::ranges::find(kNotCopied, one.kind) != kNotCopied.end())
      return cursor_.syntax(
          head, "this block has a verb that is not mirrored or repeated: engrave, native, plane or work offset");
    if (one.kind == StepKind::drill_begin && copies.z != ExpressionId::none)
      return cursor_.syntax(head, "levels of holes are not repeated along z");
    if (copies.mirrors() && has_direction(one)) one.mirrored_by = one.mirrored_by.empty() ? head : text::Span{};
    if (one.kind == StepKind::compensate && copies.mirrors() && one.number != static_cast<int>(ir::CompSide::off)) {
      constexpr auto kLeft = static_cast<int>(ir::CompSide::left);
      one.number = one.number == kLeft ? static_cast<int>(ir::CompSide::right) : kLeft;
    }
    if (std::ranges::find(kPlacing, one.kind) == kPlacing.end()) continue;
    const auto first = family_.words.begin() + one.first_word;
    std::vector<StepWord> words(first, first + one.word_count);
    const bool is_fine = copies.mirrors()                      ? mirror_words(copies, one, words)
                         : copies.cosine != ExpressionId::none ? turn_words(copies, words)
                                                               : shift_words(copies, words);
    if (!is_fine)
      return cursor_.syntax(
          head, "a move of one axis cannot be turned: each move in this block names both x and y, or neither");
    one.first_word = static_cast<std::uint32_t>(family_.words.size());
    one.word_count = static_cast<std::uint32_t>(words.size());
    family_.words.insert(family_.words.end(), words.begin(), words.end());
  }
}

// Of the whole program, once a block. What is mirrored twice is milled as it is written.
void BodyReader::warn_of_reversed_milling() {
  std::vector<std::uint32_t> seen;
  for (const Step& one : steps_) {
    if (one.mirrored_by.empty() || std::ranges::find(seen, one.mirrored_by.begin) != seen.end()) continue;
    seen.push_back(one.mirrored_by.begin);
    cursor_.diagnostics.push_back(
        text::make_diagnostic(text::DiagnosticId::family_milling_reversed, one.mirrored_by,
                              {one.begins_pocket ? "a pocket" : "a contour with compensation"}));
  }
}

// at + (at - value), and arcs in the other direction.
bool BodyReader::mirror_words(const Copies& copies, Step& step, std::vector<StepWord>& words) {
  const bool by_x = copies.address == Address::x;
  const auto negated = [&](ExpressionId value) {
    return family_.arena.add_operator(Operator::negate, value, {}, verb_);
  };
  for (StepWord& word : words) {
    if (word.address == (by_x ? Address::i : Address::j) ||
        (word.address == copies.address && (word.is_step || copies.x == ExpressionId::none)))
      word.value = negated(word.value);
    else if (word.address == copies.address)
      word.value = calculated(Operator::subtract, calculated(Operator::multiply, number(2.0), copies.x), word.value);
  }
  if (step.kind == StepKind::arc_cw || step.kind == StepKind::arc_ccw)
    step.kind = step.kind == StepKind::arc_cw ? StepKind::arc_ccw : StepKind::arc_cw;
  return true;
}

bool BodyReader::shift_words(const Copies& copies, std::vector<StepWord>& words) {
  const std::array<ExpressionId, 3> by = {copies.x, copies.y, copies.z};
  for (StepWord& word : words)
    for (std::size_t i = 0; i < by.size(); ++i)
      if (word.address == kCopiedAxes[i].address && !word.is_step && by[i] != ExpressionId::none)
        word.value = calculated(Operator::add, word.value, by[i]);
  return true;
}

// x' = at_x + (x - at_x)*cos - (y - at_y)*sin,  y' = at_y + (x - at_x)*sin + (y - at_y)*cos; steps and centers likewise
// around 0.
bool BodyReader::turn_words(const Copies& copies, std::vector<StepWord>& words) {
  const auto turn = [&](ExpressionId x, ExpressionId y, bool is_place) {
    const auto from = [&](ExpressionId value, ExpressionId at) {
      return is_place ? calculated(Operator::subtract, value, at) : value;
    };
    const auto to = [&](ExpressionId value, ExpressionId at) {
      return is_place ? calculated(Operator::add, at, value) : value;
    };
    const auto times = [&](ExpressionId a, ExpressionId b) { return calculated(Operator::multiply, a, b); };
    const ExpressionId dx = from(x, copies.x);
    const ExpressionId dy = from(y, copies.y);
    return std::pair(to(calculated(Operator::subtract, times(dx, copies.cosine), times(dy, copies.sine)), copies.x),
                     to(calculated(Operator::add, times(dx, copies.sine), times(dy, copies.cosine)), copies.y));
  };
  const auto pair_of = [&](Address first, Address second, bool is_center) {
    StepWord* x = find_word(words, first);
    StepWord* y = find_word(words, second);
    if (x == nullptr && y == nullptr) return true;
    if (is_center && (x == nullptr || y == nullptr)) {
      words.push_back({x == nullptr ? first : second, number(0.0), false});
      x = find_word(words, first);
      y = find_word(words, second);
    }
    if (x == nullptr || y == nullptr || x->is_step != y->is_step) return false;
    std::tie(x->value, y->value) = turn(x->value, y->value, !is_center && !x->is_step);
    return true;
  };
  return pair_of(Address::x, Address::y, false) && pair_of(Address::i, Address::j, true);
}

}  // namespace dripfeed::family
