// Ranges of a control's variables, laid out one after the other.
#include "dialects/interpreter/bytecode/variable_map.h"

#include <algorithm>

namespace dripfeed::interpreter {

namespace {

constexpr ir::VariableRange kNeutralRanges[] = {
    {ir::Bank::hash, 1, 33, ir::VariableUse::local, true},
    {ir::Bank::hash, 100, 999, ir::VariableUse::common, true},
    {ir::Bank::r, 0, 999, ir::VariableUse::common, true},
};
// Where the arguments of a macro call lie on a control without numbered variables (G65 in SINUMERIK's ISO mode).
constexpr ir::VariableRange kArguments = {ir::Bank::hash, 1, 33, ir::VariableUse::local, false};
// No control has more; a profile that says so is cut here instead of filling the memory.
constexpr std::uint32_t kSlotsAtMost = 1U << 20;

}  // namespace

VariableMap::VariableMap(const ir::Control& control)
    : control_(control),
      system_variables_(control.system_variables),
      has_vacant_(control.semantics.has_vacant),
      options_exist_(control.semantics.has_vacant && control.semantics.unset_is_unknown) {
  const std::span<const ir::VariableRange> declared =
      control.variables.empty() ? std::span<const ir::VariableRange>(kNeutralRanges) : control.variables;
  for (ir::VariableRange range : declared) {
    if (range.last < range.first || range.bank == ir::Bank::named || range.bank == ir::Bank::system) continue;
    std::uint32_t first_slot = 0;
    if (range.use != ir::VariableUse::system) {
      std::uint32_t& count = range.use == ir::VariableUse::local ? local_count_ : global_count_;
      first_slot = count;
      if (count == kSlotsAtMost) continue;
      range.last = std::min(range.last, range.first + (kSlotsAtMost - count) - 1);
      count += range.last - range.first + 1;
    }
    ranges_.push_back({range, first_slot});
  }
  const auto holds_arguments = [](const Range& r) { return r.range.use == ir::VariableUse::local; };
  if (std::ranges::none_of(ranges_, holds_arguments)) {
    ranges_.push_back({kArguments, local_count_, true});
    local_count_ += kArguments.last;
  }
}

Slot VariableMap::find(ir::Bank bank, std::uint32_t number) const {
  if (bank == ir::Bank::hash && number == 0 && has_vacant_) return {SlotKind::vacant, false, 0};
  for (const Range& r : ranges_) {
    if (r.range.bank != bank || number < r.range.first || number > r.range.last) continue;
    if (r.range.use == ir::VariableUse::system) return {SlotKind::system, r.range.writable, system_row(number)};
    const SlotKind kind = r.range.use == ir::VariableUse::local ? SlotKind::local : SlotKind::global;
    return {kind, r.range.writable, r.first_slot + (number - r.range.first)};
  }
  const std::uint32_t row = bank == ir::Bank::hash ? system_row(number) : kNoRow;
  if (row != kNoRow) return {SlotKind::system, system_variables_[row].writable, row};
  if (options_exist_ && bank == ir::Bank::hash && ir::may_have_variable(control_, bank, number))
    return {SlotKind::system, true, kNoRow};
  return {};
}

std::uint32_t VariableMap::system_row(std::uint32_t number) const {
  const auto row = std::ranges::find_if(system_variables_, [&](const ir::SystemVariableRow& r) {
    return r.name.empty() && r.first <= number && number <= r.last;
  });
  return row == system_variables_.end() ? kNoRow : static_cast<std::uint32_t>(row - system_variables_.begin());
}

std::vector<VariableMap::Named> VariableMap::list() const {
  std::vector<Named> result;
  for (const ir::VariableUse use : {ir::VariableUse::local, ir::VariableUse::common, ir::VariableUse::permanent})
    for (const Range& r : ranges_)
      if (r.range.use == use && !r.is_hidden)
        for (std::uint32_t i = 0; i <= r.range.last - r.range.first; ++i)
          result.push_back({r.range.bank, r.range.first + i,
                            use == ir::VariableUse::local ? SlotKind::local : SlotKind::global, r.first_slot + i});
  return result;
}

std::string variable_name(ir::Bank bank, std::uint32_t number) {
  return (bank == ir::Bank::r ? "R" : "#") + std::to_string(number);
}

}  // namespace dripfeed::interpreter
