// Which number the control has for a tool that is called by name, the program does not show.
#include "dialects/interpreter/machine/active_tool.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

namespace dripfeed::interpreter {

namespace {

// Of its edge, or of any edge, as the machine's profile has it.
template <class Row>
std::optional<double> in_profile(const Tool& tool, const std::vector<Row>& rows, double Row::* figure) {
  const auto of_edge = [&](std::int32_t offset) -> std::optional<double> {
    const auto found = std::ranges::find_if(
        rows, [&](const Row& one) { return one.tool == tool.number && one.offset == offset && one.*figure > 0.0; });
    return found == rows.end() ? std::nullopt : std::optional((*found).*figure);
  };
  const std::optional<double> own = of_edge(std::max(1, tool.offset));
  return own ? own : of_edge(0);
}

std::optional<double> written(ir::SystemValue value, const ir::Control& control, SharedData& shared, const Tool& tool) {
  const std::string_view name = ir::name_of_system(control, value);
  if (tool.name != kNoText || name.empty()) return std::nullopt;
  const auto edge = static_cast<std::uint32_t>(std::max(1, tool.offset));
  const SharedValue* const found = shared.find(shared.id_of(name), {static_cast<std::uint32_t>(tool.number), edge});
  return found != nullptr && found->number > 0.0 ? std::optional(found->number) : std::nullopt;
}

template <class Row>
std::optional<double> figure_of(ir::SystemValue value, std::uint8_t changed, const std::vector<Row>& rows,
                                double Row::* figure, const ir::Control& control, SharedData& shared,
                                const ModalState& state) {
  const bool is_numbered = state.tool.number != 0;
  const bool is_off = state.length_offset == ir::LengthOffset::off && control.semantics.d_selects_edge;
  if (is_off && (is_numbered || state.tool.name != kNoText)) return 0.0;
  if (!is_numbered) return std::nullopt;
  if ((state.gaps & changed) != 0) return written(value, control, shared, state.tool);
  return in_profile(state.tool, rows, figure);
}

}  // namespace

std::optional<double> active_radius(const ir::Control& control, SharedData& shared, const ModalState& state) {
  return figure_of(ir::SystemValue::tool_radius, ir::kRadiiChanged, control.tool_radii, &ir::ToolRadius::radius_mm,
                   control, shared, state);
}

std::optional<double> active_length(const ir::Control& control, SharedData& shared, const ModalState& state) {
  return figure_of(ir::SystemValue::tool_length, ir::kLengthsChanged, control.tool_lengths, &ir::ToolLength::length_mm,
                   control, shared, state);
}

}  // namespace dripfeed::interpreter
