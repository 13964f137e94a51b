// What is not known of a frame makes the whole frame unknown, and an unknown frame the position.
#include "dialects/interpreter/machine/frame_access.h"

#include <cmath>
#include <utility>

#include "dialects/interpreter/arithmetic/unknown.h"
#include "dialects/interpreter/block/frame_change.h"

namespace dripfeed::interpreter {

namespace {

using ir::SystemValue;

constexpr std::string_view kUnknownFrame = "a frame that is not known";
constexpr double kMostFrames = 1000.0;

// Nothing that is no small whole number.
std::optional<std::size_t> small_number(double value) {
  const double whole = std::round(value);
  if (!(whole >= 0.0 && whole < kMostFrames)) return std::nullopt;
  return static_cast<std::size_t>(whole);
}

bool turns(const FrameValue& frame) { return frame.matrix != kIdentity; }

}  // namespace

bool FrameAccess::execute(const Instruction& i) {
  if (i.op == Opcode::frame_make) return make(i);
  if (i.op == Opcode::load_frame) return load(i);
  if (i.op == Opcode::store_frame) return store(i);
  if (i.op == Opcode::frame_chain) {
    const FrameValue* a = values_.find(storage_.reg(i.b));
    const FrameValue* b = values_.find(storage_.reg(i.c));
    if (a != nullptr && b != nullptr) return give(i, chain(*a, *b));
    lose(i, std::string(kUnknownFrame));
    return true;
  }
  const std::uint32_t row = i.op == Opcode::frame_part ? i.c : i.b;
  const FrameValue* frame = values_.find(storage_.reg(i.op == Opcode::frame_part ? i.b : i.a));
  const auto axis = small_number(storage_.reg(row));
  const auto part = small_number(storage_.reg(next_register(row)));
  const bool known = frame != nullptr && axis.has_value() && part.has_value() && *part < kFrameParts;
  if (i.op == Opcode::frame_part) {
    const auto value = known ? part_of(*frame, *axis, static_cast<FramePart>(*part)) : std::nullopt;
    if (!value.has_value()) report_.count({.name = "a part of a frame that is not known"});
    storage_.reg(i.a) = value.value_or(kVacant);
    return true;
  }
  const double value = storage_.reg(i.c);
  if (known && !is_vacant(value)) {
    FrameValue changed = *frame;
    if (set_part(changed, *axis, static_cast<FramePart>(*part), value)) return give(i, changed);
  }
  lose(i, std::string(kUnknownFrame));
  return true;
}

// CTRANS(axis, value) and its like.
bool FrameAccess::make(const Instruction& i) {
  const auto axis = small_number(storage_.reg(i.b));
  const double value = storage_.reg(i.c);
  FrameValue made;
  if (axis.has_value() && *axis < made.shift.size() && !is_vacant(value)) {
    const auto op = static_cast<ir::Operator>(i.extra);
    const FramePart part = op == ir::Operator::frame_shift    ? FramePart::translation
                           : op == ir::Operator::frame_turn   ? FramePart::rotation
                           : op == ir::Operator::frame_mirror ? FramePart::mirror
                                                              : FramePart::scale;
    if (set_part(made, *axis, part, value)) return give(i, made);
  }
  lose(i, "a frame from a value or of an axis that is not known");
  return true;
}

bool FrameAccess::give(const Instruction& i, const FrameValue& value) {
  storage_.reg(i.a) = values_.add(value);
  return !is_vacant(storage_.reg(i.a)) || report_.fail_limit(i, "frames");
}

void FrameAccess::lose(const Instruction& i, std::string what) {
  report_.count({.name = std::move(what)});
  storage_.reg(i.a) = kVacant;
}

bool FrameAccess::load(const Instruction& i) {
  const auto kind = static_cast<SystemValue>(i.extra);
  if (kind == SystemValue::programmable_frame) return give(i, programmable());
  if (kind == SystemValue::base_frame || kind == SystemValue::base_frame_in_data) {
    const auto& base = kind == SystemValue::base_frame ? base_ : base_in_data_;
    if (base.has_value()) return give(i, *base);
    report_.count({.name = "base frame", .function = ir::Function::not_modelled, .is_input = true});
    storage_.reg(i.a) = kVacant;
    return true;
  }
  if (kind == SystemValue::settable_frame) {
    const auto number = small_number(storage_.reg(i.b));
    const auto known = number.has_value() ? settable_.find(static_cast<std::uint32_t>(*number)) : settable_.end();
    if (known != settable_.end()) return give(i, known->second);
  } else if (state_.modes.settable_known) {
    return give(
        i, kind == SystemValue::active_frame ? state_.modes.settable : chain(state_.modes.settable, programmable()));
  }
  report_.count({.name = "settable frame", .function = ir::Function::not_modelled, .is_input = true});
  storage_.reg(i.a) = kVacant;
  return true;
}

bool FrameAccess::store(const Instruction& i) {
  const auto kind = static_cast<SystemValue>(i.extra);
  const FrameValue* value = values_.find(storage_.reg(i.a));
  if (value == nullptr) report_.count({.name = std::string(kUnknownFrame)});
  if (kind != SystemValue::programmable_frame) state_.gaps |= ir::kZerosChanged;
  if (kind == SystemValue::programmable_frame) {
    set_programmable(value != nullptr ? *value : FrameValue{});
    if (value == nullptr) state_.unknown = kAllAxes;
  } else if (kind == SystemValue::active_frame) {
    activate(value);
  } else if (kind == SystemValue::base_frame) {
    activate_base(value);
    base_in_data_.reset();  // whether memory follows is the machine's (MD24050)
    base_waits_ = true;
  } else if (kind == SystemValue::base_frame_in_data) {
    base_in_data_ = value != nullptr ? std::optional(*value) : std::nullopt;
    base_waits_ = true;
  } else if (const auto number = small_number(storage_.reg(i.b)); !number.has_value()) {
    settable_.clear();
    shared_.forget(shared_.id_of(name_));
  } else {
    const auto index = static_cast<std::uint32_t>(*number);
    shared_.forget(shared_.id_of(name_), index);
    settable_.erase(index);
    half_known_.erase(index);
    if (value != nullptr)
      settable_.emplace(index, *value);
    else
      half_known_.insert(index);
  }
  return true;
}

std::optional<double> FrameAccess::settable_part(const Indices& indices) const {
  const auto known = settable_.find(indices[0]);
  if (known == settable_.end() || indices[2] >= kFrameParts) return std::nullopt;
  return part_of(known->second, indices[1], static_cast<FramePart>(indices[2]));
}

void FrameAccess::set_settable_part(const Indices& indices, double value) {
  state_.gaps |= ir::kZerosChanged;
  const auto known = settable_.find(indices[0]);
  if (known == settable_.end()) {
    half_known_.insert(indices[0]);
    return;
  }
  const bool fits = indices[2] < kFrameParts && !is_vacant(value) &&
                    set_part(known->second, indices[1], static_cast<FramePart>(indices[2]), value);
  if (fits) return;
  half_known_.insert(indices[0]);
  settable_.erase(known);
}

void FrameAccess::select(std::int32_t offset) {
  if (std::exchange(base_waits_, false)) activate_base(base_in_data_.has_value() ? &*base_in_data_ : nullptr);
  const bool was_known = state_.modes.settable_known;
  const bool same = state_.modes.work_offset == offset;
  const auto next = offset >= 0 ? settable_.find(static_cast<std::uint32_t>(offset)) : settable_.end();
  const bool is_known = next != settable_.end();
  const bool changed = offset >= 0 && half_known_.erase(static_cast<std::uint32_t>(offset)) > 0;
  if (same && !was_known && !is_known && !changed) return;
  state_.modes.work_offset = offset;
  state_.drilling.initial_known = state_.drilling.initial_known && same;
  activate(is_known ? &next->second : nullptr);
}

// The machine stands still while its coordinates change.
void FrameAccess::activate(const FrameValue* next) {
  if (state_.modes.settable_known && next != nullptr)
    move_position(state_.modes.settable, *next);
  else
    state_.unknown = kAllAxes;
  state_.modes.settable_known = next != nullptr;
  state_.modes.settable = next != nullptr ? *next : FrameValue{};
}

// Positions count in the settable frame, which lies in the base frame: where it turns is known or nothing is.
void FrameAccess::activate_base(const FrameValue* next) {
  if (base_.has_value() && next != nullptr && (*base_ == *next || state_.modes.settable_known)) {
    if (*base_ != *next) move_position(chain(*base_, state_.modes.settable), chain(*next, state_.modes.settable));
  } else {
    state_.unknown = kAllAxes;
  }
  base_ = next != nullptr ? std::optional(*next) : std::nullopt;
}

void FrameAccess::move_position(const FrameValue& from, const FrameValue& to) {
  if ((turns(from) || turns(to)) && (state_.unknown & 7U) != 0) state_.unknown |= 7U;
  FrameValue place;
  for (std::size_t axis = 0; axis < place.shift.size(); ++axis)
    place.shift[axis] = rules_.x_is_diameter && axis == 0 ? state_.position[axis] / 2.0 : state_.position[axis];
  const FrameValue moved = chain(inverse_of(to), chain(from, place));
  for (std::size_t axis = 0; axis < moved.shift.size(); ++axis)
    state_.position[axis] = rules_.x_is_diameter && axis == 0 ? moved.shift[axis] * 2.0 : moved.shift[axis];
}

FrameValue FrameAccess::programmable() const {
  FrameValue value{.shift = state_.modes.shift, .fine = state_.modes.fine_shift, .matrix = state_.modes.matrix};
  if (rules_.x_is_diameter) {
    value.shift[0] /= 2.0;
    value.fine[0] /= 2.0;
  }
  return value;
}

void FrameAccess::set_programmable(const FrameValue& value) {
  const Modes before = state_.modes;
  state_.modes.frame_languages |= 1;
  if (state_.modes.frame_languages == 3)
    report_.count({.name = "a frame of one of the control's languages together with one of the other"});
  state_.modes.shift = value.shift;
  state_.modes.fine_shift = value.fine;
  if (rules_.x_is_diameter) {
    state_.modes.shift[0] *= 2.0;
    state_.modes.fine_shift[0] *= 2.0;
  }
  state_.modes.matrix = value.matrix;
  state_.modes.has_matrix = value.matrix != kIdentity;
  mark_shifted(before, rules_, state_);
}

}  // namespace dripfeed::interpreter
