// A tool is the same one where its number and its name are.
#include "server/app/checks/tool_list.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace dripfeed::app {

bool ToolList::take(const ir::Motion& motion) {
  const auto is_it = [&](const Tool& one) { return one.number == motion.number && one.text == motion.text; };
  const auto found = std::find_if(tools_.begin() + 1, tools_.end(), is_it);
  const auto tool = static_cast<std::uint32_t>(found - tools_.begin());
  if (found == tools_.end()) tools_.push_back({motion.number, motion.text, motion.place});
  return std::exchange(current_, tool) != tool;
}

std::string ToolList::name_of(std::uint32_t tool, const std::vector<std::string>& strings) const {
  if (tool == 0) return {};
  const Tool& one = tools_[tool];
  return one.text < strings.size() ? strings[one.text] : fmt::format("T{}", one.number);
}

}  // namespace dripfeed::app
