// Lines of the profile are followed by the lines that they came from.
#include "dialects/compile/render/optimized_render.h"

#include <algorithm>

#include "dialects/compile/dialect/printed_lines.h"

namespace dripfeed::compile {

namespace {

std::vector<optimize::NumberRange> user_variables(const ir::Control& control) {
  std::vector<optimize::NumberRange> out;
  for (const ir::VariableRange& range : control.variables)
    if (range.writable && range.use != ir::VariableUse::system) out.push_back({range.bank, range.first, range.last});
  return out;
}

bool is_in(const std::vector<family::LineRange>& ranges, std::uint32_t line) {
  return std::ranges::any_of(ranges, [line](const family::LineRange& r) { return r.first <= line && line <= r.last; });
}

// New lines between two of the profile are of the profile, too.
std::vector<family::LineRange> moved(const std::vector<family::LineRange>& ranges,
                                     const std::vector<std::uint32_t>& origin_lines) {
  std::vector<family::LineRange> out;
  for (std::uint32_t i = 0; i < origin_lines.size(); ++i) {
    if (!is_in(ranges, origin_lines[i])) continue;
    const std::uint32_t line = i + 1;
    const bool goes_on = !out.empty() && std::ranges::all_of(origin_lines.begin() + out.back().last,
                                                             origin_lines.begin() + i, [](auto o) { return o == 0; });
    if (goes_on)
      out.back().last = line;
    else
      out.push_back({line, line});
  }
  return out;
}

}  // namespace

OptimizeResult optimize_rendered(RenderResult& rendered, const ir::Control& control, const ir::CostModel& cost,
                                 const optimize::Rules& rules) {
  OptimizeResult result;
  if (rendered.is_kept) result.obstacle = "the native program is kept unchanged";
  if (rendered.mode == RenderMode::explicit_blocks) result.obstacle = "plain blocks have nothing to compute";
  if (!result.obstacle.empty()) return result;
  OptimizeRequest request{.source = text::Source("rendered", rendered.text), .control = control, .cost = cost};
  request.settings.rules = rules;
  request.settings.own = request.settings.free = user_variables(control);
  result = optimize_text(request);
  if (result.changes.empty()) return result;
  rendered.text = result.text;
  rendered.bytes = rendered.text.size();
  rendered.blocks = count_blocks(rendered.text);
  keep_parameters(rendered.legend, rendered.text, control);
  rendered.profile_lines = moved(rendered.profile_lines, result.origin_lines);
  return result;
}

}  // namespace dripfeed::compile
