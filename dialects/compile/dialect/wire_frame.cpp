// Lines are added in front, so the origins move with them.
#include "dialects/compile/dialect/wire_frame.h"

#include <string>

#include <fmt/format.h>

namespace dripfeed::compile {

namespace {

// As the control names files: letters, digits and '_', at most 24.
std::string file_name(std::string_view program_name) {
  constexpr std::size_t kLongest = 24;
  std::string name;
  for (const char c : program_name.substr(0, kLongest)) {
    const char upper = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    const bool legal = (upper >= 'A' && upper <= 'Z') || (upper >= '0' && upper <= '9');
    name += legal ? upper : '_';
  }
  return name.empty() ? "PROGRAM" : name;
}

}  // namespace

void wrap_for_wire(ir::PrintResult& printed, std::string_view dialect, std::string_view program_name) {
  if (dialect != "sinumerik-840d" || printed.text.starts_with('%')) return;
  printed.text = fmt::format("%_N_{}_MPF\n;$PATH=/_N_MPF_DIR\n{}%\n", file_name(program_name), printed.text);
  printed.origin_lines.insert(printed.origin_lines.begin(), 2, 0);
  printed.origin_lines.push_back(0);
}

}  // namespace dripfeed::compile
