// A system variable that a person wrote (the program, or a start value) reads what was written; otherwise the modal
// state answers what it can.
#include "dialects/interpreter/machine/shared_access.h"

#include <algorithm>
#include <cmath>

#include "dialects/interpreter/arithmetic/unknown.h"
#include "dialects/interpreter/machine/active_tool.h"
#include "dialects/interpreter/machine/system_values.h"
#include "dialects/ir/alarm_details.h"
#include "dialects/text/number.h"

namespace dripfeed::interpreter {

namespace {

using text::DiagnosticId;

constexpr double kLastIndex = 4294967294.0;

}  // namespace

bool SharedAccess::execute(const Instruction& i) {
  if (i.op == Opcode::load_shared) return load(i);
  if (i.op == Opcode::store_shared) return store(i);
  if (i.op == Opcode::load_shared_text) return load_text(i);
  return i.op == Opcode::store_shared_text ? store_text(i) : refer(i);
}

SharedAccess::IndexState SharedAccess::find_indices(const Instruction& i, std::uint32_t id, std::uint32_t registers,
                                                    Indices& indices) {
  IndexState state = IndexState::known;
  const SharedDefinition* definition = shared_.definition_of(id);
  for (std::uint32_t n = 0; n < i.extra; ++n, registers = next_register(registers)) {
    const double value = storage_.reg(registers);
    if (is_vacant(value)) {
      state = IndexState::unknown;
      continue;
    }
    const std::uint32_t size = definition == nullptr ? 0 : definition->dimensions[n];
    const auto index = access_.whole_number(value, size > 0 ? size - 1.0 : kLastIndex);
    if (!index.has_value()) {
      report_.fail(i, DiagnosticId::variable_out_of_range,
                   {shared_.name_of(id) + '[' + text::format_shortest(value) + ']'},
                   n == 0 ? ir::kFirstIndex : ir::kSecondIndex);
      return IndexState::failed;
    }
    indices[n] = *index;
  }
  return state;
}

void SharedAccess::report_input(std::string name) {
  report_.count({.name = std::move(name), .function = ir::Function::not_modelled, .is_input = true});
}

// $C_X and $C_X_PROG. Of several I, J or K the first alone is known by its place.
std::optional<double> SharedAccess::call_argument(const ir::SystemVariableRow& row, const Indices& indices) const {
  const std::uint32_t locals = storage_.bases().local;
  if (locals == 0 || indices[0] > 0) return std::nullopt;  // no macro is running
  const double value = storage_.local_at(locals + row.first - 1);
  if (row.kind == ir::SystemValue::call_argument_given) return is_vacant(value) ? 0.0 : 1.0;
  return value_or_zero(value);
}

// $TC_DP3 and $TC_DP6 of a tool that the machine's profile has, in a program in mm; nothing once the program has
// changed such data.
std::optional<double> SharedAccess::tool_figure(const ir::SystemVariableRow& row, const Indices& indices) const {
  const auto find_in = [&](const auto& known, auto figure) {
    const auto one = std::ranges::find_if(known, [&](const auto& candidate) {
      return candidate.tool == static_cast<std::int32_t>(indices[0]) &&
             candidate.offset == static_cast<std::int32_t>(indices[1]);
    });
    return one == known.end() ? std::nullopt : std::optional((*one).*figure);
  };
  if (state_.modes.inch) return std::nullopt;
  const bool is_radius = row.kind == ir::SystemValue::tool_radius;
  if ((state_.gaps & (is_radius ? ir::kRadiiChanged : ir::kLengthsChanged)) != 0) return std::nullopt;
  return is_radius ? find_in(control_.tool_radii, &ir::ToolRadius::radius_mm)
                   : find_in(control_.tool_lengths, &ir::ToolLength::length_mm);
}

// $P_TOOLR and $P_TOOLL[1], in a program in mm. Of length 2 and 3 no profile states anything.
std::optional<double> SharedAccess::active_figure(const ir::SystemVariableRow& row, const Indices& indices) const {
  if (state_.modes.inch) return std::nullopt;
  if (row.kind == ir::SystemValue::tool_radius) return active_radius(control_, shared_, state_);
  return indices[0] == 1 ? active_length(control_, shared_, state_) : std::nullopt;
}

std::optional<double> SharedAccess::answer(const Instruction& i, const Indices& indices) const {
  if (i.detail == 0) return std::nullopt;
  const ir::SystemVariableRow& row = control_.system_variables[i.detail - 1U];
  if (row.kind == ir::SystemValue::settable_frame) return frames_.settable_part(indices);
  if (row.kind == ir::SystemValue::call_argument || row.kind == ir::SystemValue::call_argument_given)
    return call_argument(row, indices);
  if (row.kind == ir::SystemValue::tool_radius || row.kind == ir::SystemValue::tool_length) {
    if (row.name != shared_.name_of(i.b)) return std::nullopt;
    return row.writable ? tool_figure(row, indices) : active_figure(row, indices);
  }
  return answer_system(control_, row, indices, state_);
}

bool SharedAccess::load(const Instruction& i) {
  Indices indices{};
  double& to = storage_.reg(i.a);
  const IndexState state = find_indices(i, i.b, i.c, indices);
  if (state == IndexState::failed) return false;
  const SharedValue* value = state == IndexState::known ? shared_.find(i.b, indices) : nullptr;
  if (value != nullptr && !is_vacant(value->number)) {
    to = value->number;
    return true;
  }
  if (state == IndexState::known)
    if (const auto known = answer(i, indices)) {
      to = *known;
      return true;
    }
  report_input(state == IndexState::known ? shared_.name_of_element(i.b, indices, i.extra)
                                          : shared_.name_of(i.b) + "[?]");
  to = kVacant;
  return true;
}

bool SharedAccess::may_write(const Instruction& i) {
  if (i.detail == 0) return true;
  const ir::SystemVariableRow& row = control_.system_variables[i.detail - 1U];
  const std::string& name = shared_.name_of(i.a);
  const bool has_row = name == row.name;
  if (has_row && !row.writable) return report_.fail(i, DiagnosticId::variable_write_protected, {name});
  if (!has_row || !row.inert) report_.count({.name = name});
  return true;
}

// What equals the machine's profile changes nothing.
void SharedAccess::take_tool_data(const Instruction& i, const Indices* indices) {
  if (i.detail == 0) return;
  const ir::SystemVariableRow& row = control_.system_variables[i.detail - 1U];
  if (row.name != shared_.name_of(i.a)) return;
  constexpr double kSame_mm = 1e-6;
  const double value = storage_.reg(i.c);
  const auto is_as_known = [&](const auto& known, auto figure) {
    return indices != nullptr && std::ranges::any_of(known, [&](const auto& one) {
             return one.tool == static_cast<std::int32_t>((*indices)[0]) &&
                    one.offset == static_cast<std::int32_t>((*indices)[1]) && std::abs(one.*figure - value) < kSame_mm;
           });
  };
  std::uint8_t changed = 0;
  if (row.kind == ir::SystemValue::tool_type && (indices == nullptr || value == 0.0))
    changed = ir::kRadiiChanged | ir::kLengthsChanged;
  if (row.kind == ir::SystemValue::tool_radius && !is_as_known(control_.tool_radii, &ir::ToolRadius::radius_mm))
    changed = ir::kRadiiChanged;
  if (row.kind == ir::SystemValue::tool_length && !is_as_known(control_.tool_lengths, &ir::ToolLength::length_mm))
    changed = ir::kLengthsChanged;
  if (changed == 0) return;
  state_.gaps |= changed;
  report_.count({.name = std::string(row.name), .function = ir::Function::data_input, .effects_known = true});
}

// Timers and what the PLC writes: what the program wrote is not what it reads.
bool SharedAccess::is_changed_by_control(const Instruction& i) const {
  if (i.detail == 0) return false;
  const ir::SystemVariableRow& row = control_.system_variables[i.detail - 1U];
  return row.kind == ir::SystemValue::changing && row.name == shared_.name_of(i.a);
}

bool SharedAccess::store(const Instruction& i) {
  Indices indices{};
  const IndexState state = find_indices(i, i.a, i.b, indices);
  if (state == IndexState::failed || !may_write(i)) return false;
  take_tool_data(i, state == IndexState::known && !is_vacant(storage_.reg(i.c)) ? &indices : nullptr);
  if (state == IndexState::unknown) {
    shared_.forget(i.a);
    return true;
  }
  if (is_changed_by_control(i)) {
    shared_.forget(i.a);
    return true;
  }
  SharedValue& value = shared_.at(shared_.place_of(i.a, indices));
  value.number = storage_.reg(i.c);
  value.has_text = false;
  const bool frame = i.detail != 0 && control_.system_variables[i.detail - 1U].kind == ir::SystemValue::settable_frame;
  if (frame) frames_.set_settable_part(indices, value.number);
  return true;
}

bool SharedAccess::load_text(const Instruction& i) {
  Indices indices{};
  const IndexState state = find_indices(i, i.b, i.c, indices);
  if (state == IndexState::failed) return false;
  std::string& to = storage_.string(i.a);
  const SharedValue* value = state == IndexState::known ? shared_.find(i.b, indices) : nullptr;
  if (value != nullptr && value->has_text) {
    to = value->text;
  } else if (value != nullptr && !is_vacant(value->number)) {
    to = text::format_shortest(value->number + 0.0);
  } else {
    report_input(state == IndexState::known ? shared_.name_of_element(i.b, indices, i.extra)
                                            : shared_.name_of(i.b) + "[?]");
    to = kUnknownText;
  }
  return true;
}

bool SharedAccess::store_text(const Instruction& i) {
  Indices indices{};
  const IndexState state = find_indices(i, i.a, i.b, indices);
  if (state == IndexState::failed || !may_write(i)) return false;
  if (state == IndexState::unknown) {
    shared_.forget(i.a);
    return true;
  }
  SharedValue& value = shared_.at(shared_.place_of(i.a, indices));
  value = {.number = kVacant, .text = storage_.text(i.c), .has_text = true};
  return true;
}

bool SharedAccess::refer(const Instruction& i) {
  Indices indices{};
  const IndexState state = find_indices(i, i.b, i.c, indices);
  if (state == IndexState::failed) return false;
  const std::uint32_t place = state == IndexState::known ? shared_.place_of(i.b, indices) : shared_.nameless();
  storage_.reg(i.a) = Storage::refer_shared(place);
  return true;
}

}  // namespace dripfeed::interpreter
