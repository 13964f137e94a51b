// Where the holes lie, in the plane's two axes p and q, from the place that the plane's letters name (the centre of a
// circle or an arc, the first hole of the others):
//
//   G34 I J K     circle  I radius, J angle of the first hole, K holes all around: counterclockwise, below 0 clockwise
//   G35 I J K     line    I from hole to hole, J its angle, K holes
//   G36 I J P K   arc     I radius, J angle of the first hole, P from hole to hole, K holes
//   G37.1 I P J K grid    I along p, P columns, J along q, K rows; there and back from row to row
//
// G34 is as the M700V/M70V programming manual has it (13.2, "Special fixed cycle": G00 between the holes, the tool ends
// over the last one, other addresses are P32); the other three are from memory of the M800/M80 manual, same section,
// and of Mazak's hole machining patterns. What these leave open is done as usual and reported by a note.
#include "dialects/interpreter/cycles/hole_pattern.h"

#include <array>
#include <cmath>

#include "dialects/interpreter/arithmetic/arithmetic.h"
#include "dialects/interpreter/cycles/drilling.h"
#include "dialects/interpreter/motion/move.h"
#include "dialects/interpreter/motion/polar.h"
#include "dialects/interpreter/state/axis_words.h"
#include "dialects/ir/alarm_details.h"
#include "dialects/ir/hole_pattern.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;

constexpr double kHolesAtMost = 1'000'000.0;
constexpr std::uint64_t kMotionsAtMost = 4'000'000;  // of one figure
constexpr double kMostCount = 9999.0;                // of K, of P of a grid

// What the letters say: lengths in mm, angles in degrees.
struct FigureWords {
  double i = 0.0;
  double j = 0.0;
  double p = 0.0;
  double count = 0.0;  // K without its sign
  double turn = 1.0;   // its sign
};
struct Offset {
  double p = 0.0;
  double q = 0.0;
};

Offset at_angle(double radius, double angle_deg) {
  return {radius * cosine_deg(angle_deg), radius * sine_deg(angle_deg)};
}
Offset on_circle(const FigureWords& w, double n) { return at_angle(w.i, w.j + w.turn * 360.0 * n / w.count); }
Offset on_line(const FigureWords& w, double n) { return at_angle(w.i * n, w.j); }
Offset on_arc(const FigureWords& w, double n) { return at_angle(w.i, w.j + w.p * n); }
Offset on_grid(const FigureWords& w, double n) {
  const double row = std::floor(n / w.p);
  const double column = n - row * w.p;
  const bool back = std::fmod(row, 2.0) == 1.0;
  return {w.i * (back ? w.p - 1.0 - column : column), w.j * row};
}

struct FigureRow {
  Offset (*place)(const FigureWords&, double);
  bool signed_count;  // K below 0 turns the order
  bool has_radius;    // I
  bool j_is_length;
  bool p_is_angle;
  bool p_is_count;
};
// In the order of ir/hole_pattern.h.
constexpr auto kFigures = std::to_array<FigureRow>({
    {on_circle, true, true, false, false, false},
    {on_line, false, false, false, false, false},
    {on_arc, false, true, false, true, false},
    {on_grid, false, false, true, false, true},
});
static_assert(kFigures.size() == ir::kHolesOnGrid + 1);

class PatternDriller {
 public:
  PatternDriller(const PlainBlock& block, const BlockRules& rules, std::int16_t figure, ModalState& state,
                 MotionBuffer& out, BlockResult& result)
      : block_(block),
        rules_(rules),
        state_(state),
        out_(out),
        result_(result),
        row_(kFigures[static_cast<std::size_t>(figure)]),
        plane_(axes_of(state.modes.plane)) {}

  void run() {
    if (!takes_words() || !take_words() || !take_base()) return;
    const double holes = row_.p_is_count ? words_.p * words_.count : words_.count;
    if (holes > kHolesAtMost) return fail(text::DiagnosticId::limit_reached);
    if (!state_.drilling.active) result_.notes |= kNotePatternWithoutCycle;
    const std::uint64_t begun = out_.count();
    for (std::uint32_t n = 0; n < holes && result_.fault == text::DiagnosticId::count_; ++n) {
      if (out_.count() - begun > kMotionsAtMost) return fail(text::DiagnosticId::limit_reached);
      hole(row_.place(words_, n));
    }
  }

 private:
  static constexpr std::array kLetters = {Address::x, Address::y, Address::z};
  static constexpr std::uint64_t kFigureWords =
      bit_of(Address::i) | bit_of(Address::j) | bit_of(Address::k) | bit_of(Address::p);

  [[nodiscard]] std::uint64_t plane_words() const { return bit_of(kLetters[plane_.p]) | bit_of(kLetters[plane_.q]); }

  // --- words

  // No word but the figure's own; each of them known, in coordinates that are straight.
  bool takes_words() {
    const std::uint64_t foreign = bit_of(kLetters[plane_.normal]) | bit_of(Address::q) | bit_of(Address::r) |
                                  bit_of(Address::l) | bit_of(Address::d) | bit_of(Address::t);
    if (((block_.present | block_.unknown) & foreign) != 0) {
      refuse("a word that it does not take", ir::kForeignWord);
      return false;
    }
    const bool known = (block_.unknown & (kFigureWords | plane_words())) == 0;
    const bool straight = !state_.modes.polar_words && state_.transformation.shape == Transformation::Shape::none;
    return (known && straight) || give_up(kNotePatternWords);
  }

  bool take_words() {
    words_.turn = block_.has(Address::k) && block_.at(Address::k) < 0.0 ? -1.0 : 1.0;
    words_.count = count_of(Address::k);
    if (row_.p_is_count) words_.p = count_of(Address::p);
    if (words_.count == 0.0 || (row_.p_is_count && words_.p == 0.0)) return refuse("no number of holes", ir::kNoHoles);
    if (words_.count > kMostCount || (row_.p_is_count && words_.p > kMostCount))
      return refuse("more than 9999 holes", ir::AlarmDetail::none);
    if (row_.p_is_angle) words_.p = angle_of(Address::p);
    if (row_.p_is_angle && words_.p == 0.0) return refuse("no angle between the holes", ir::kNoSpacing);
    if (row_.p_is_angle && (block_.in_increments & bit_of(Address::p)) != 0) result_.notes |= kNotePatternWords;
    if (!block_.has(Address::i) || (row_.j_is_length && !block_.has(Address::j))) return give_up(kNotePatternWords);
    words_.i = rules_.length_mm(block_, Address::i, state_.modes.inch);
    if (row_.has_radius && words_.i < 0.0) {
      words_.i = -words_.i;
      result_.notes |= kNotePatternWords;
    }
    if (row_.j_is_length) {
      words_.j = rules_.length_mm(block_, Address::j, state_.modes.inch);
    } else if (block_.has(Address::j)) {
      words_.j = angle_of(Address::j);
    }
    return true;
  }

  // Whole and above 0: what else it says is not certain.
  double count_of(Address address) {
    if (!block_.has(address)) return 0.0;
    const double value = block_.at(address);
    const bool may_be_negative = row_.signed_count && address == Address::k;
    if (std::floor(value) != value || (value < 0.0 && !may_be_negative)) result_.notes |= kNotePatternWords;
    return std::floor(std::abs(value));
  }

  // Degrees; without a point the control's increment, where its lengths count so, too.
  [[nodiscard]] double angle_of(Address address) const {
    if (!block_.has(address)) return 0.0;
    const bool counts = rules_.semantics.decimal_mode == ir::DecimalMode::least_increment;
    return counts ? rules_.angle_deg(block_, address) : block_.at(address);
  }

  // The place that the figure is counted from, in programmed coordinates: where the tool stands, but for the words.
  bool take_base() {
    base_ = programmed_position(rules_, state_);
    std::uint32_t named = 0;
    for_each_axis_word(block_, rules_, state_.modes, !state_.modes.absolute,
                       [&](std::size_t axis, double value, bool incremental) {
                         if (axis != plane_.p && axis != plane_.q) return;
                         base_[axis] = incremental ? base_[axis] + value : value;
                         if (!incremental) named |= 1U << axis;
                       });
    if ((block_.present & plane_words()) != plane_words()) result_.notes |= kNotePatternWords;
    const std::uint32_t needed = state_.modes.has_matrix ? 7U : 1U << plane_.p | 1U << plane_.q;
    const bool known = (state_.unknown & needed & ~named) == 0 || named == (1U << plane_.p | 1U << plane_.q);
    return known || give_up(kNoteIncrementalFromUnknown);
  }

  // --- holes

  void hole(const Offset& at) {
    PlainBlock made;
    put_coordinate(made, rules_, state_, plane_.p, base_[plane_.p] + at.p);
    put_coordinate(made, rules_, state_, plane_.q, base_[plane_.q] + at.q);
    if (state_.drilling.active) return drill_holes(made, rules_, state_, out_, result_);
    emit_move(ir::MotionKind::rapid, find_any_target(made, rules_, state_, false), 0.0, {}, state_, out_, result_);
  }

  bool refuse(std::string_view reason, ir::AlarmDetail detail) {
    result_.fault = text::DiagnosticId::hole_pattern_invalid;
    result_.reason = reason;
    result_.detail = detail;
    return false;
  }
  void fail(text::DiagnosticId id) { result_.fault = id; }
  // Nothing is made of it: where the tool is afterwards is not known.
  bool give_up(std::uint32_t note) {
    result_.notes |= note;
    state_.unknown |= static_cast<std::uint16_t>(1U << plane_.p | 1U << plane_.q);
    return false;
  }

  const PlainBlock& block_;
  const BlockRules& rules_;
  ModalState& state_;
  MotionBuffer& out_;
  BlockResult& result_;
  const FigureRow& row_;
  PlaneAxes plane_;
  FigureWords words_;
  Vector base_{};
};

}  // namespace

void drill_pattern(const PlainBlock& block, const BlockRules& rules, std::int16_t figure, ModalState& state,
                   MotionBuffer& out, BlockResult& result) {
  PatternDriller(block, rules, figure, state, out, result).run();
}

}  // namespace dripfeed::interpreter
