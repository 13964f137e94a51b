// Rotation, scaling and mirroring about a point of their own (G68, G51, G51.1) as a chain of frames:
//
//   G68 X10. Y5. R30.     TRANS / ATRANS X10 Y5 / AROT RPL=30 / ATRANS X-10 Y-5
//   G69                   TRANS
//
// TRANS takes the whole programmable frame away, so this is the same only where a program uses one of them alone: two
// kinds at once are reported as errors, as is one together with a G52 whose numbers are not known there. Where they
// are, TRANS says them. About the zero point ROT alone says it.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dialects/facts/resolved.h"
#include "dialects/ir/frame_use.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/rewrite.h"
#include "dialects/sinumerik/writer/raise.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Address;
using ir::ExpressionId;
using ir::Function;
using ir::Operator;
using ir::StatementKind;

constexpr std::array kNone = {ExpressionId::none, ExpressionId::none, ExpressionId::none};
constexpr std::array kLengths = {Address::x, Address::y, Address::z};
constexpr std::array kFactors = {Address::i, Address::j, Address::k};

bool is_frame(Function f) { return f == Function::rotate || f == Function::scale || f == Function::mirror; }
bool begins(const ir::Code& c) { return is_frame(c.function) && c.argument == ir::kFrameAboutPoint; }
bool ends(const ir::Code& c) { return is_frame(c.function) && c.argument == ir::kFrameEnds; }

class FrameRaiser {
 public:
  explicit FrameRaiser(const Raising& raising)
      : raising_(raising),
        program_(raising.program),
        out_(program_),
        known_(program_, raising.from),
        plane_(raising.from.semantics.power_on_plane) {
    for (const ir::Code& c : program_.codes) {
      shifts_ |= c.function == Function::local_shift;
      if (!begins(c)) continue;
      if (std::ranges::find(kinds_, c.function) == kinds_.end()) kinds_.push_back(c.function);
    }
  }

  void run() {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      out_.at(i);
      index_ = i;
      statement_ = program_.statements[i];
      const bool joins = statement_.is_label ||
                         (statement_.kind >= StatementKind::if_begin && statement_.kind <= StatementKind::loop_end);
      if (joins || statement_.kind == StatementKind::call) mirrored_ = kNone;
      if (joins || statement_.kind == StatementKind::call) mirror_known_ = false;
      if (statement_.kind == StatementKind::block)
        block(program_.blocks[statement_.payload]);
      else
        out_.keep();
    }
    out_.finish();
  }

 private:
  // By value: the arenas grow.
  void block(const ir::Block block) {
    const auto codes = program_.codes_of(block);
    for (const ir::Code& c : codes)
      if (c.group == ir::ModalGroup::plane) plane_ = c.function;
    const auto begin = std::ranges::find_if(codes, begins);
    const auto end = std::ranges::find_if(codes, ends);
    if (shifts_ && begin == codes.end() && moves_zero(codes)) return shift_again();
    // G69 in the safe head of a program that turns nothing has nothing to end.
    if (begin == codes.end() && (end == codes.end() || kinds_.empty())) return out_.keep();
    if (block.rest_level != 0) return cannot(passes::at_switch("block skip inside a block"));
    std::vector<ir::Code> others;
    std::ranges::copy_if(codes, std::back_inserter(others), [](const ir::Code& c) { return !begins(c) && !ends(c); });
    const std::vector<ir::Word> words(program_.words_of(block).begin(), program_.words_of(block).end());
    if (shifts_ && !shift_here())
      return cannot(passes::not_known("G68, G51 or G51.1 together with a G52 that is not known here"));
    if (begin == codes.end()) {
      out_.emit_block({code(Function::local_shift, 1)}, local_shift());
      mirrored_ = kNone;
      mirror_known_ = true;
      if (!others.empty() || !words.empty())
        out_.emit_block(others, end->function == Function::mirror ? others_of(words) : words);
      return;
    }
    const Function kind = begin->function;
    if (kinds_.size() > 1) return cannot(passes::together("two of G68, G51 and G51.1 in one program"));
    if (!others.empty()) out_.emit_block(others, {});
    if (kind == Function::rotate) return rotate(words);
    if (kind == Function::scale) return scale(words);
    mirror(words);
  }

  static bool moves_zero(std::span<const ir::Code> codes) {
    return std::ranges::find(codes, Function::local_shift, &ir::Code::function) != codes.end();
  }

  using Shift = std::array<double, 3>;  // of X, Y and Z, in units of the program

  // What G52 has set before the block; nothing where that is not known. A caller outside of the text is taken to have
  // set none.
  [[nodiscard]] std::optional<Shift> shift_here() const {
    const facts::Facts* facts = known_.before(index_);
    Shift shift{};
    if (facts == nullptr) return shift;
    constexpr std::array kNumbers = {facts::Number::shift_x, facts::Number::shift_y, facts::Number::shift_z};
    for (std::size_t axis = 0; axis < kNumbers.size(); ++axis) {
      const facts::Known<double>& number = (*facts)[kNumbers[axis]];
      if (is_untouched(number)) continue;
      if (number.certain() == nullptr) return std::nullopt;
      shift[axis] = *number.certain();
    }
    return shift;
  }

  // Whether G68, G51 or G51.1 is in effect before the block.
  [[nodiscard]] std::optional<bool> turned_here() const {
    const facts::Facts* facts = known_.before(index_);
    if (facts == nullptr) return false;
    const facts::Known<facts::Setting>& frame = (*facts)[facts::Mode::frame];
    if (is_untouched(frame)) return false;
    const facts::Setting* setting = frame.certain();
    return setting == nullptr ? std::nullopt : std::optional(setting->function != Function::none);
  }

  template <class T>
  static bool is_untouched(const facts::Known<T>& fact) {
    return fact.origin == facts::kNoStatement && fact.inherited && fact.changer == facts::kNoStatement;
  }

  // G52 replaces the shifts that it names and leaves what turns: TRANS takes all away.
  void shift_again() {
    const std::optional<bool> turned = turned_here();
    if (!turned) return cannot(passes::together("G52 where G68, G51 or G51.1 may be in effect"));
    if (*turned) return cannot(passes::together("G52 while G68, G51 or G51.1 is in effect"));
    out_.keep();
  }

  // What G52 has set, in full; nothing where it has set nothing.
  std::vector<ir::Word> local_shift() {
    std::vector<ir::Word> words;
    if (!shifts_) return words;
    const Shift shift = *shift_here();
    for (std::size_t axis = 0; axis < kLengths.size(); ++axis)
      if (shift[axis] != 0.0) words.push_back(word(kLengths[axis], program_.add_constant(shift[axis])));
    return words;
  }

  static std::vector<ir::Word> others_of(const std::vector<ir::Word>& words) {
    std::vector<ir::Word> out;
    std::ranges::copy_if(words, std::back_inserter(out),
                         [](const ir::Word& w) { return std::ranges::find(kLengths, w.address) == kLengths.end(); });
    return out;
  }

  void rotate(const std::vector<ir::Word>& words) {
    const ir::Word* angle = find(words, Address::r);
    if (angle == nullptr) return cannot(passes::by_parameter("a rotation whose angle is left to a parameter"));
    if (std::ranges::any_of(words,
                            [](const ir::Word& w) { return std::ranges::find(kFactors, w.address) != kFactors.end(); }))
      return cannot("a rotation about an axis of its own");
    const std::optional<std::vector<ir::Word>> center = center_of(words, plane_axes());
    if (!center) return;
    ir::Word turn = *angle;
    turn.address = Address::frame_angle;
    turn.value = in_degrees(angle->value);
    about(*center, code(Function::rotate, ir::kFrameAdds), {turn});
  }

  void scale(const std::vector<ir::Word>& words) {
    const ir::Semantics& from = raising_.from.semantics;
    std::vector<ir::Word> factors;
    const ir::Word* all = find(words, Address::p);
    for (std::size_t axis = 0; axis < kLengths.size(); ++axis) {
      const ir::Word* own = find(words, kFactors[axis]);
      const ir::Word* factor = own != nullptr ? own : all;
      if (factor == nullptr) continue;
      const ir::Expression e = program_.at(factor->value);
      const bool counted =
          e.op == Operator::constant && !e.has_point && from.decimal_mode == ir::DecimalMode::least_increment;
      if (counted && !from.scale_unit_known)
        return cannot(passes::by_parameter("a factor without a point, whose unit a parameter decides"));
      ir::Word w = *factor;
      w.address = kLengths[axis];
      w.value = counted ? program_.add_constant(e.value * from.scale_unit) : factor->value;
      ir::Expression& value = program_.expressions[static_cast<std::uint32_t>(w.value)];
      if (value.op == Operator::constant) value.has_point = true;  // a factor is no length
      factors.push_back(w);
    }
    if (factors.empty()) return cannot(passes::by_parameter("a scaling factor that is left to a parameter"));
    const std::optional<std::vector<ir::Word>> center = center_of(words, kLengths);
    if (center) about(*center, code(Function::scale, ir::kFrameAdds), factors);
  }

  // Each named axis at its place; one that is mirrored already stays so.
  void mirror(const std::vector<ir::Word>& words) {
    if (!mirror_known_)
      return cannot(passes::not_known("G51.1 where control-flow paths join that may have mirrored already"));
    for (std::size_t axis = 0; axis < kLengths.size(); ++axis)
      if (const ir::Word* w = find(words, kLengths[axis])) mirrored_[axis] = w->value;
    out_.emit_block({code(Function::local_shift, 1)}, local_shift());
    for (std::size_t axis = 0; axis < kLengths.size(); ++axis) {
      if (mirrored_[axis] == ExpressionId::none) continue;
      const std::vector<ir::Word> center = {word(kLengths[axis], mirrored_[axis])};
      around(center, code(Function::mirror, ir::kFrameAdds), {word(kLengths[axis], program_.add_constant(0.0))});
    }
  }

  // --- parts

  [[nodiscard]] std::array<Address, 2> plane_axes() const {
    if (plane_ == Function::plane_zx) return {Address::z, Address::x};
    if (plane_ == Function::plane_yz) return {Address::y, Address::z};
    return {Address::x, Address::y};
  }

  // All coordinates of the centre; where one is left out, the tool's place counts, which no number stands for.
  template <std::size_t kCount>
  std::optional<std::vector<ir::Word>> center_of(const std::vector<ir::Word>& words,
                                                 const std::array<Address, kCount>& axes) {
    std::vector<ir::Word> center;
    for (const Address axis : axes) {
      const ir::Word* w = find(words, axis);
      if (w == nullptr) {
        cannot(passes::not_known("a centre that is where the tool stands"));
        return std::nullopt;
      }
      center.push_back(*w);
    }
    return center;
  }

  void about(const std::vector<ir::Word>& center, const ir::Code& change, const std::vector<ir::Word>& words) {
    out_.emit_block({code(Function::local_shift, 1)}, local_shift());
    around(center, change, words);
  }

  void around(const std::vector<ir::Word>& center, const ir::Code& change, const std::vector<ir::Word>& words) {
    const bool at_zero = std::ranges::all_of(center, [&](const ir::Word& w) {
      const ir::Expression& e = program_.at(w.value);
      return e.op == Operator::constant && e.value == 0.0;
    });
    std::vector<ir::Word> there = center;
    std::vector<ir::Word> back = center;
    for (ir::Word& w : there) w.mode = ir::WordMode::as_modal;
    for (ir::Word& w : back) {
      w.mode = ir::WordMode::as_modal;
      const ir::Expression e = program_.at(w.value);
      w.value = e.op == Operator::constant ? program_.add_constant(-e.value, e.span, e.has_point)
                                           : program_.add_operator(Operator::negate, w.value);
    }
    if (!at_zero) out_.emit_block({code(Function::local_shift_add)}, there);
    out_.emit_block({change}, words);
    if (!at_zero) out_.emit_block({code(Function::local_shift_add)}, back);
  }

  ExpressionId in_degrees(ExpressionId value) {
    const ir::Semantics& from = raising_.from.semantics;
    const ir::Expression e = program_.at(value);
    const bool counted =
        e.op == Operator::constant && !e.has_point && from.decimal_mode == ir::DecimalMode::least_increment;
    return counted ? program_.add_constant(e.value * from.least_increment_deg, e.span) : value;
  }

  static const ir::Word* find(const std::vector<ir::Word>& words, Address address) {
    const auto found = std::ranges::find(words, address, &ir::Word::address);
    return found == words.end() ? nullptr : &*found;
  }
  static ir::Code code(Function function, std::int16_t argument = 0) {
    ir::Code c;
    c.function = function;
    c.argument = argument;
    c.group = ir::ModalGroup::frame;
    return c;
  }

  void cannot(passes::Refusal what) const { raising_.cannot(std::move(what), statement_.span); }

  const Raising& raising_;
  ir::Program& program_;
  passes::Rewrite out_;
  facts::Resolved known_;
  std::uint32_t index_ = 0;
  ir::Statement statement_;
  std::vector<Function> kinds_;  // that the program begins
  bool shifts_ = false;
  Function plane_;                                // in the order of the text
  std::array<ExpressionId, 3> mirrored_ = kNone;  // places of the mirrors in effect
  bool mirror_known_ = true;
};

struct LocalShift {
  text::Span span;
  std::uint64_t named = 0;
};

// G52 leaves the axes that it does not name as they were shifted; TRANS takes their shift away. Both are the same where
// every G52 names all axes that any of them shifts.
void check_shifts(const Raising& raising) {
  const ir::Program& program = raising.program;
  std::vector<LocalShift> found;
  std::uint64_t shifted = 0;
  for (const ir::Statement& s : program.statements) {
    if (s.kind != StatementKind::block) continue;
    const ir::Block& block = program.blocks[s.payload];
    const auto codes = program.codes_of(block);
    const auto shift = std::ranges::find(codes, Function::local_shift, &ir::Code::function);
    if (shift == codes.end() || shift->argument != 0) continue;
    found.push_back({.span = s.span});
    for (const ir::Word& w : program.words_of(block)) {
      const std::uint64_t bit = std::uint64_t{1} << static_cast<unsigned>(w.address);
      found.back().named |= bit;
      const ir::Expression& e = program.at(w.value);
      if (e.op != Operator::constant || e.value != 0.0) shifted |= bit;
    }
  }
  for (const LocalShift& shift : found)
    if ((shifted & ~shift.named) != 0) raising.cannot("G52 that leaves the shift of another axis", shift.span);
}

}  // namespace

void raise_frames(const Raising& raising) {
  const bool any = std::ranges::any_of(raising.program.codes, begins);
  if (any) FrameRaiser(raising).run();
  check_shifts(raising);
}

}  // namespace dripfeed::sinumerik
