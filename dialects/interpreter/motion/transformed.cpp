// Into the plane and out of it again: words, positions, what is known.
#include "dialects/interpreter/motion/transformed.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "dialects/interpreter/motion/mover.h"
#include "dialects/interpreter/motion/transformed_pieces.h"
#include "dialects/interpreter/state/frame.h"
#include "dialects/ir/transformation_use.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;
using Shape = Transformation::Shape;

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr std::size_t kX = 0;
constexpr std::size_t kY = 1;
constexpr std::uint8_t kFirstRotary = 3;
constexpr std::array kLetters = {Address::x, Address::y, Address::z};
constexpr std::uint64_t kCorners =
    bit_of(Address::chamfer) | bit_of(Address::chamfer_length) | bit_of(Address::rounding);

constexpr std::uint64_t kCornerLetters = bit_of(Address::r) | bit_of(Address::i) | bit_of(Address::k);

constexpr std::uint16_t bit(std::size_t axis) { return static_cast<std::uint16_t>(1U << axis); }

// The first rotary axis that the block names; C when it names none.
std::pair<std::uint8_t, double> rotary_word(const PlainBlock& block, const BlockRules& rules, bool inch) {
  for (std::uint64_t rest = block.present & rules.axis_addresses; rest != 0; rest &= rest - 1) {
    const auto address = static_cast<Address>(std::countr_zero(rest));
    const AxisWord& word = rules.axis_words[interpreter::index_of(address)];
    if (word.rotary) return {static_cast<std::uint8_t>(index_of(word.axis)), rules.length_mm(block, address, inch)};
  }
  return {static_cast<std::uint8_t>(index_of(ir::Axis::c)), 0.0};
}

bool is_arc(const ir::Motion& motion) {
  return motion.kind == ir::MotionKind::arc_cw || motion.kind == ir::MotionKind::arc_ccw;
}

}  // namespace

// Where the turning axis stands counts as 0 with G12.1 (0i-F B-64604EN-1, "Polar coordinate interpolation"), on its own
// scale with TRANSMIT.
void begin_transformation(const PlainBlock& block, const BlockRules& rules, std::int16_t argument, ModalState& state) {
  Transformation made;
  const bool face = argument == ir::kFaceByRotary || argument == ir::kFaceByY;
  made.shape = face ? Shape::face : Shape::cylinder;
  made.by_rotary = argument == ir::kFaceByRotary || argument == ir::kCylinderByRotary;
  const auto [rotary, radius] = rotary_word(block, rules, state.modes.inch);
  made.rotary = argument == ir::kCylinderByRotary ? rotary : static_cast<std::uint8_t>(index_of(ir::Axis::c));
  const double angle = state.position[made.rotary];
  made.rotary_known = (state.unknown & bit(made.rotary)) == 0;
  const double x = rules.x_is_diameter ? state.position[kX] / 2.0 : state.position[kX];
  const bool x_known = (state.unknown & bit(kX)) == 0;
  state.transformation = {};
  if (!face) {
    made.radius_mm = std::abs(made.by_rotary ? radius : rules.length_mm(block, Address::r, state.modes.inch) / 2.0);
    if (made.radius_mm <= 0.0) return;  // G07.1 C0.
    made.across_mm = angle / kDegrees * made.radius_mm;
    made.across_known = made.rotary_known;
    made.rotary_known = true;  // with the coordinate
  } else if (made.by_rotary) {
    made.along_mm = x;
    made.along_known = x_known;
    made.across_known = true;
    made.zero_deg = x < 0.0 ? angle - 180.0 : angle;
  } else {
    made.along_mm = x * std::cos(angle / kDegrees);
    made.across_mm = x * std::sin(angle / kDegrees);
    made.along_known = made.across_known = x_known && made.rotary_known;
    made.rotary_known = true;
  }
  state.transformation = made;
}

TransformedBlock::TransformedBlock(const PlainBlock& block, const BlockRules& rules, ModalState& state,
                                   MotionBuffer& out, BlockResult& result)
    : rules_(rules), block_(block), state_(state), out_(out), result_(result), outer_(out.captured()) {
  choose_slot();
  take_rotary_words();
  enter_plane();
  // Corners are made when the plane's moves are there; the mover would look for them among the machine's.
  const MoveOptions usual;
  std::tie(wanted_, wanted_mm_) = Mover(block, rules, usual, state, out, result).wanted_corner();
  if (rules_.corner_letters && state.modes.motion == ir::Function::linear) block_.present &= ~kCornerLetters;
  block_.present &= ~kCorners;
  modal_rounding_mm_ = std::exchange(state_.modal_rounding_mm, 0.0);
  // A corner from before the mode has no move after it that it could be cut with.
  if (std::exchange(state_.corner, {}).kind != 0) {
    result_.notes |= kNoteCornerNotComputed;
    out_.hold(false);
  }
  out_.capture(&kept_);
}

// A cylinder's circumference stands for the axis that the plane has besides the one along the cylinder.
void TransformedBlock::choose_slot() {
  const Transformation& t = state_.transformation;
  slot_ = kY;
  if (t.shape == Shape::face || !t.by_rotary) return;
  const std::size_t along = t.rotary - kFirstRotary;
  const PlaneAxes plane = axes_of(state_.modes.plane);
  slot_fits_plane_ = plane.p == along || plane.q == along;
  slot_ = slot_fits_plane_ ? (plane.p == along ? plane.q : plane.p) : (along + 1) % 3;
  // That axis itself may be named in a straight block: then another place does.
  if (((block_.present | block_.unknown) & bit_of(kLetters[slot_])) != 0) {
    slot_ = 3 - along - slot_;
    slot_fits_plane_ = false;
  }
}

void TransformedBlock::take_rotary_words() {
  const Transformation& t = state_.transformation;
  const Address letter = kLetters[slot_];
  if (t.by_rotary) {
    for (std::uint64_t rest = (block_.present | block_.unknown) & rules_.axis_addresses; rest != 0; rest &= rest - 1) {
      const auto address = static_cast<Address>(std::countr_zero(rest));
      const AxisWord& word = rules_.axis_words[interpreter::index_of(address)];
      if (index_of(word.axis) != t.rotary) continue;
      const std::uint64_t from = bit_of(address);
      const std::uint64_t to = bit_of(letter);
      double value = 0.0;
      if (t.shape == Shape::face) {
        value = rules_.length_mm(block_, address, false);
      } else {
        value = rules_.angle_deg(block_, address) / kDegrees * t.radius_mm;
        if (state_.modes.inch) value /= 25.4;
      }
      if ((block_.unknown & from) != 0)
        block_.unknown |= to;
      else
        block_.set(letter, value);
      if ((block_.absolute & from) != 0) block_.absolute |= to;
      if ((block_.incremental & from) != 0 || word.incremental) block_.incremental |= to;
      block_.present &= ~from;
      block_.unknown &= ~from;
    }
  }
  rules_.axis_addresses |= bit_of(letter);
  rules_.axis_words[interpreter::index_of(letter)] = {static_cast<ir::Axis>(slot_), false, false};
}

void TransformedBlock::enter_plane() {
  Transformation& t = state_.transformation;
  // A block in machine coordinates or another work offset came between.
  const bool face = t.shape == Shape::face;
  const auto axes = static_cast<std::uint16_t>((face ? bit(kX) : 0U) | (t.rotary_known ? bit(t.rotary) : 0U));
  if (t.across_known && (!face || t.along_known) && (state_.unknown & axes) != 0)
    t.along_known = t.across_known = false;
  before_ = {state_.position,           state_.unknown,
             state_.modes.plane,        state_.modes.diameter,
             state_.modes.shift[slot_], state_.coordinate_shift[slot_]};
  const auto place = [&](std::size_t axis, double value, bool known) {
    state_.position[axis] = value;
    state_.unknown = static_cast<std::uint16_t>(known ? state_.unknown & ~bit(axis) : state_.unknown | bit(axis));
  };
  if (t.shape == Shape::face) {
    place(kX, rules_.x_is_diameter ? t.along_mm * 2.0 : t.along_mm, t.along_known);
    if (t.by_rotary) state_.modes.plane = ir::Plane::xy;
  }
  place(slot_, t.across_mm, t.across_known);
  // Shifts of the axis whose place is taken; of Y they are those of the plane.
  if (t.by_rotary) state_.modes.shift[slot_] = state_.coordinate_shift[slot_] = 0.0;
  if (slot_ == kX) {
    rules_.x_is_diameter = false;
    state_.modes.diameter = ir::DiameterMode::radius;
  }
}

void TransformedBlock::leave_plane(bool any_move) {
  Transformation& t = state_.transformation;
  t.across_mm = state_.position[slot_];
  t.across_known = (state_.unknown & bit(slot_)) == 0;
  if (t.shape == Shape::face) {
    t.along_mm = rules_.x_is_diameter ? state_.position[kX] / 2.0 : state_.position[kX];
    t.along_known = (state_.unknown & bit(kX)) == 0;
  }
  const bool known = t.across_known && (t.shape == Shape::cylinder || t.along_known);
  const auto restore = [&](std::size_t axis) {
    state_.position[axis] = before_.position[axis];
    state_.unknown = static_cast<std::uint16_t>((state_.unknown & ~bit(axis)) | (before_.unknown & bit(axis)));
  };
  restore(slot_);
  if (t.shape == Shape::face) restore(kX);
  const std::uint16_t turned = static_cast<std::uint16_t>(bit(t.rotary) | (t.shape == Shape::face ? bit(kX) : 0));
  if (any_move) state_.unknown = static_cast<std::uint16_t>(known ? state_.unknown & ~turned : state_.unknown | turned);
  if (!t.rotary_known) state_.unknown |= bit(t.rotary);
  state_.modes.plane = before_.plane;
  if (slot_ == kX) state_.modes.diameter = before_.diameter;
  if (t.by_rotary) {
    state_.modes.shift[slot_] = before_.shift;
    state_.coordinate_shift[slot_] = before_.coordinate_shift;
  }
}

void TransformedBlock::finish() {
  out_.capture(outer_);
  state_.modal_rounding_mm = modal_rounding_mm_;
  const bool failed = result_.fault != text::DiagnosticId::count_;
  if (!failed) close_corner();
  leave_plane(std::ranges::any_of(kept_, [](const ir::Motion& m) { return ir::is_move(m.kind); }));
  if (!failed) bring_kept();
}

// In the plane still: what the corner takes off the move before it and off the first one of this block.
void TransformedBlock::close_corner() {
  const PlaneCorner& waits = state_.plane_corner;
  const auto after = std::ranges::find_if(kept_, [](const ir::Motion& m) { return ir::is_move(m.kind); });
  if (waits.kind == 0 || after == kept_.end()) return;
  bool fits = after->kind == ir::MotionKind::linear || is_arc(*after);
  for (std::size_t i = waits.motion + waits.pieces; i < out_.used(); ++i) fits = fits && !ir::is_move(out_.at(i).kind);
  ir::Motion before = waits.before;
  ir::Motion between = *after;
  const MoveOptions usual;
  const Mover mover(block_, rules_, usual, state_, out_, result_);
  fits = fits && mover.cut_corner(before, between, *after, static_cast<CornerKind>(waits.kind), waits.size_mm);
  if (!fits) return drop_plane_corner(state_, out_, result_);
  trimmed_ = before;
  kept_.insert(after, between);
}

bool TransformedBlock::opens_corner(const ir::Motion& motion) const {
  if (wanted_ == CornerKind::none || outer_ != nullptr) return false;
  return motion.kind == ir::MotionKind::linear || is_arc(motion);
}

void TransformedBlock::bring_kept() {
  AxisValues real = before_.position;
  std::uint16_t unknown = before_.unknown;
  std::vector<ir::Motion> taken;
  if (trimmed_.has_value()) {
    real = state_.plane_corner.real;
    unknown = state_.plane_corner.unknown;
    taken = out_.take_back(state_.plane_corner.motion);
  }
  TransformedPieces pieces({state_.transformation, slot_, rules_.x_is_diameter, real, unknown}, state_, out_);
  if (trimmed_.has_value()) bring_trimmed(pieces, taken);
  const auto last =
      std::ranges::find_if(kept_.rbegin(), kept_.rend(), [](const ir::Motion& m) { return ir::is_move(m.kind); });
  for (const ir::Motion& motion : kept_) {
    const bool opens = last != kept_.rend() && &motion == &*last && opens_corner(motion);
    if (opens) {
      out_.hold_plane(true);
      state_.plane_corner = {.kind = static_cast<std::uint8_t>(wanted_),
                             .size_mm = wanted_mm_,
                             .before = motion,
                             .motion = out_.used(),
                             .real = state_.position,
                             .unknown = unknown};
    }
    if ((is_arc(motion) && !slot_fits_plane_) || !pieces.bring(motion)) result_.notes |= kNoteTransformed;
    if (opens) state_.plane_corner.pieces = out_.used() - state_.plane_corner.motion;
  }
  state_.tangent_known = false;
}

// Its pieces are those of the block that it stands in; events that came since stay after them.
void TransformedBlock::bring_trimmed(TransformedPieces& pieces, const std::vector<ir::Motion>& taken) {
  const ir::Place place = std::exchange(out_.place, trimmed_->place);
  const Work work = std::exchange(out_.work, {});
  const std::size_t first = out_.used();
  pieces.bring(*trimmed_);
  if (out_.used() > first && !taken.empty()) out_.at(first).compute = taken.front().compute;
  for (std::size_t i = state_.plane_corner.pieces; i < taken.size(); ++i) out_.add(taken[i].kind) = taken[i];
  out_.place = place;
  out_.work = work;
  state_.plane_corner = {};
  out_.hold_plane(false);
}

void drop_plane_corner(ModalState& state, MotionBuffer& out, BlockResult& result) {
  if (state.modal_rounding_mm == 0.0) result.notes |= kNoteCornerNotComputed;
  state.plane_corner = {};
  out.hold_plane(false);
}

}  // namespace dripfeed::interpreter
