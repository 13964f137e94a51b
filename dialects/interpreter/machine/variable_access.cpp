// Look-ups while running.
#include "dialects/interpreter/machine/variable_access.h"

#include <utility>

#include "dialects/ir/alarm_details.h"
#include "dialects/text/number.h"

namespace dripfeed::interpreter {

namespace {

using text::DiagnosticId;

constexpr double kLastNumber = 4294967294.0;

ir::Bank bank_of(const Instruction& i) { return static_cast<ir::Bank>(i.extra); }

}  // namespace

std::optional<std::uint32_t> VariableAccess::whole_number(double value, double last) const {
  if (value >= 0.0 && value <= last)  // most indices are whole already; no vacant one comes here
    if (const auto number = static_cast<std::uint32_t>(value); static_cast<double>(number) == value) return number;
  if (is_vacant(value)) return std::nullopt;
  const double whole = arithmetic_.round(value);
  if (whole < 0.0 || whole > last) return std::nullopt;
  return static_cast<std::uint32_t>(whole);
}

std::optional<VariableAccess::Found> VariableAccess::find(const Instruction& i, double value) {
  const ir::Bank bank = bank_of(i);
  const auto number = whole_number(value, kLastNumber);
  const Slot slot = number.has_value() ? variables_.find(bank, *number) : Slot{};
  if (slot.kind != SlotKind::none) return Found{slot, *number};
  const std::string shown = is_vacant(value) ? "[vacant]" : text::format_shortest(value);
  report_.fail(i, DiagnosticId::variable_out_of_range, {(bank == ir::Bank::r ? "R" : "#") + shown}, ir::kFirstIndex);
  return std::nullopt;
}

double& VariableAccess::at(const Slot& slot) {
  return slot.kind == SlotKind::global ? storage_.global_at(slot.index)
                                       : storage_.local_at(storage_.bases().local + slot.index);
}

std::optional<double> VariableAccess::peek(ir::Bank bank, std::uint32_t number) const {
  const Slot slot = variables_.find(bank, number);
  if (slot.kind == SlotKind::global) return storage_.global_at(slot.index);
  if (slot.kind == SlotKind::local) return storage_.local_at(storage_.bases().local + slot.index);
  if (slot.kind == SlotKind::system) return system_.read(slot.index, number, state_);
  return std::nullopt;
}

bool VariableAccess::load_number(const Instruction& i) {
  if (is_unknown(storage_.reg(i.b))) {
    storage_.reg(i.a) = kUnknown;
    return true;
  }
  const auto found = find(i, storage_.reg(i.b));
  if (!found.has_value()) return false;
  double& to = storage_.reg(i.a);
  if (found->slot.kind == SlotKind::vacant)
    to = kVacant;
  else if (found->slot.kind == SlotKind::system)
    to = read_system(found->slot.index, found->number);
  else
    to = at(found->slot);
  return true;
}

bool VariableAccess::store_number(const Instruction& i) {
  if (is_unknown(storage_.reg(i.a))) return forget_bank(i);
  const auto found = find(i, storage_.reg(i.a));
  if (!found.has_value()) return false;
  if (!found->slot.writable)
    return report_.fail(i, DiagnosticId::variable_write_protected, {variable_name(bank_of(i), found->number)});
  if (found->slot.kind == SlotKind::system)
    write_system(found->slot.index, found->number, storage_.reg(i.b));
  else
    at(found->slot) = storage_.reg(i.b);
  return true;
}

bool VariableAccess::refer_number(const Instruction& i) {
  if (is_unknown(storage_.reg(i.b))) {
    storage_.reg(i.a) = Storage::refer_shared(shared_.nameless());
    return true;
  }
  const auto found = find(i, storage_.reg(i.b));
  if (!found.has_value()) return false;
  if (found->slot.kind != SlotKind::global && found->slot.kind != SlotKind::local)
    return report_.fail(i, DiagnosticId::wrong_type,
                        {variable_name(bank_of(i), found->number), "a value of the control", "a variable"});
  const Space space = found->slot.kind == SlotKind::global ? Space::global : Space::local;
  storage_.reg(i.a) = storage_.refer(space, found->slot.index);
  return true;
}

// --- arrays
// -----------------------------------------------------------------------------------------------------------

std::optional<std::uint32_t> VariableAccess::find_element(const Instruction& i, const CompiledProgram& program,
                                                          std::uint32_t array, std::uint32_t indices) {
  const Array& a = program.arrays[array];
  const auto row = whole_number(storage_.reg(indices), a.dimension1 - 1.0);
  const auto column = whole_number(storage_.reg(next_register(indices)), a.dimension2 - 1.0);
  const auto layer = whole_number(storage_.reg(next_register(next_register(indices))), a.dimension3 - 1.0);
  if (!row.has_value() || !column.has_value() || !layer.has_value()) {
    report_.fail(i, DiagnosticId::variable_out_of_range, {name_of_element(program, array, indices)},
                 row.has_value() ? ir::kSecondIndex : ir::kFirstIndex);
    return std::nullopt;
  }
  return a.first_slot + (*row * a.dimension2 + *column) * a.dimension3 + *layer;
}

std::string VariableAccess::name_of_element(const CompiledProgram& program, std::uint32_t array,
                                            std::uint32_t indices) {
  const ir::Symbol& symbol = program.source->at(program.arrays[array].symbol);
  std::string name(program.source->strings.at(symbol.name));
  name += '[' + text::format_shortest(arithmetic_.round(value_or_zero(storage_.reg(indices))));
  if (symbol.dimension2 > 0)
    name += ',' + text::format_shortest(arithmetic_.round(value_or_zero(storage_.reg(next_register(indices)))));
  if (symbol.dimension3 > 0)
    name += ',' + text::format_shortest(
                      arithmetic_.round(value_or_zero(storage_.reg(next_register(next_register(indices))))));
  return name + ']';
}

// One element was written, it is not known which: nothing of them is known any more. Among numbered variables are work
// offsets and lengths of tools.
bool VariableAccess::forget_bank(const Instruction& i) {
  const ir::Bank bank = bank_of(i);
  for (const VariableMap::Named& entry : variables_.list())
    if (entry.bank == bank) at(Slot{entry.kind, true, entry.index}) = kUnknown;
  if (bank != ir::Bank::hash) return true;
  report_.count({.name = "an assignment to a variable whose number is not known"});
  state_.unknown = kAllAxes;
  state_.gaps |= ir::kZerosChanged | ir::kLengthsChanged | ir::kRadiiChanged;
  return true;
}

bool VariableAccess::has_unknown_index(std::uint32_t indices) {
  return is_unknown(storage_.reg(indices)) || is_unknown(storage_.reg(next_register(indices))) ||
         is_unknown(storage_.reg(next_register(next_register(indices))));
}

bool VariableAccess::load_element(const Instruction& i, const CompiledProgram& program) {
  if (has_unknown_index(i.c)) {
    storage_.reg(i.a) = kVacant;
    return true;
  }
  const auto element = find_element(i, program, i.b, i.c);
  if (!element.has_value()) return false;
  storage_.reg(i.a) = storage_.frame_at(storage_.bases().frame + *element);
  return true;
}

bool VariableAccess::store_element(const Instruction& i, const CompiledProgram& program) {
  if (has_unknown_index(i.b)) {
    fill(program.arrays[i.a], kVacant);
    return true;
  }
  const auto element = find_element(i, program, i.a, i.b);
  if (!element.has_value()) return false;
  storage_.frame_at(storage_.bases().frame + *element) = storage_.reg(i.c);
  return true;
}

bool VariableAccess::refer_element(const Instruction& i, const CompiledProgram& program) {
  if (has_unknown_index(i.c)) {
    storage_.reg(i.a) = Storage::refer_shared(shared_.nameless());
    return true;
  }
  const auto element = find_element(i, program, i.b, i.c);
  if (!element.has_value()) return false;
  storage_.reg(i.a) = storage_.refer(Space::frame, *element);
  return true;
}

// nullptr after an alarm.
double* VariableAccess::find_in_row(const Instruction& i, const CompiledProgram& program, std::uint32_t array,
                                    double index) {
  const Array& a = program.arrays[array];
  const std::uint32_t first = storage_.bases().frame + a.first_slot;
  if (index >= 0.0 && index < a.dimension1)  // most indices are whole already
    if (const auto row = static_cast<std::uint32_t>(index); static_cast<double>(row) == index)
      return &storage_.frame_at(first + row);
  if (const auto row = whole_number(index, a.dimension1 - 1.0)) return &storage_.frame_at(first + *row);
  std::string name(program.source->strings.at(program.source->at(a.symbol).name));
  name += '[' + text::format_shortest(arithmetic_.round(value_or_zero(index))) + ']';
  report_.fail(i, DiagnosticId::variable_out_of_range, {std::move(name)}, ir::kFirstIndex);
  return nullptr;
}

bool VariableAccess::load_of_row(const Instruction& i, const CompiledProgram& program) {
  const double index = storage_.reg(i.c);
  const bool unknown = is_unknown(index);
  const double* element = unknown ? nullptr : find_in_row(i, program, i.b, index);
  if (unknown)
    storage_.reg(i.a) = kVacant;
  else if (element != nullptr)
    storage_.reg(i.a) = *element;
  return unknown || element != nullptr;
}

bool VariableAccess::store_in_row(const Instruction& i, const CompiledProgram& program) {
  const double index = storage_.reg(i.b);
  if (is_unknown(index)) {
    fill(program.arrays[i.a], kVacant);
    return true;
  }
  double* element = find_in_row(i, program, i.a, index);
  if (element != nullptr) *element = storage_.reg(i.c);
  return element != nullptr;
}

void VariableAccess::fill_array(const Instruction& i, const CompiledProgram& program) {
  fill(program.arrays[i.a], storage_.reg(i.b));
}

void VariableAccess::fill(const Array& a, double value) {
  for (std::uint32_t n = 0; n < a.dimension1 * a.dimension2 * a.dimension3; ++n)
    storage_.frame_at(storage_.bases().frame + a.first_slot + n) = value;
}

// --- system variables
// -------------------------------------------------------------------------------------------------

std::string VariableAccess::system_name(std::uint32_t row, std::uint32_t number) const {
  const auto rows = control_.system_variables;
  const bool named = row < rows.size() && !rows[row].name.empty();
  return named ? std::string(rows[row].name) : variable_name(ir::Bank::hash, number);
}

// The report names what is not known. It reads as not known where a run goes on with such values, otherwise vacant, or
// 0 where there is no vacant.
double VariableAccess::read_system(std::uint32_t row, std::uint32_t number) {
  if (const auto known = system_.read(row, number, state_)) return *known;
  const bool stays_unknown = control_.semantics.unset_is_unknown;
  report_.count({.name = system_name(row, number), .is_input = stays_unknown});
  if (stays_unknown && control_.semantics.has_vacant) return kUnknown;
  return stays_unknown || control_.semantics.has_vacant ? kVacant : 0.0;
}

bool VariableAccess::load_system(const Instruction& i) {
  const auto number = whole_number(storage_.reg(i.c), kLastNumber);
  if (!number.has_value()) return report_.fail(i, DiagnosticId::variable_out_of_range, {system_name(i.b, 0)});
  storage_.reg(i.a) = read_system(i.b, *number);
  return true;
}

bool VariableAccess::store_system(const Instruction& i) {
  const auto number = whole_number(storage_.reg(i.b), kLastNumber);
  if (!number.has_value()) return report_.fail(i, DiagnosticId::variable_out_of_range, {system_name(i.a, 0)});
  const auto rows = control_.system_variables;
  if (i.a < rows.size() && !rows[i.a].writable)
    return report_.fail(i, DiagnosticId::variable_write_protected, {system_name(i.a, *number)});
  write_system(i.a, *number, storage_.reg(i.c));
  return true;
}

void VariableAccess::write_system(std::uint32_t row, std::uint32_t number, double value) {
  if (!system_.write(row, number, value, state_))
    report_.count({.name = "an assignment to " + system_name(row, number)});
}

void VariableAccess::set_system(const DataValue& set) {
  const std::uint32_t row = set.is_extended_offset ? kExtendedOffsetRow : variables_.system_row(set.number);
  const double before = set.adds ? system_.read(row, set.number, state_).value_or(0.0) : 0.0;
  system_.write(row, set.number, before + set.value, state_);
}

void VariableAccess::forget_commons() {
  for (const VariableMap::Named& entry : variables_.list())
    if (entry.kind == SlotKind::global) storage_.global_at(entry.index) = kUnknown;
}

void VariableAccess::forget_tool_offsets() { system_.forget_tool_offsets(); }

void VariableAccess::set_initial(const InitialValue& value) {
  if (value.bank == ir::Bank::system && value.name.empty())
    return void(system_.write(value.number, 0, value.value, state_));
  const Slot slot = variables_.find(value.bank, value.number);
  if (slot.kind == SlotKind::system) return system_.set_initial(slot.index, value.number, value.value, state_);
  if (slot.kind == SlotKind::global || slot.kind == SlotKind::local) at(slot) = value.value;
}

}  // namespace dripfeed::interpreter
