// Each line is one assignment; what it is not, is reported with its line.
#include "server/cli/state_file.h"

#include <optional>

#include <fmt/format.h>

#include "dialects/text/number.h"
#include "server/cli/inputs.h"

namespace dripfeed::cli {

namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

std::optional<interpreter::InitialValue> read_line(std::string_view line) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) return std::nullopt;
  const std::string_view name = trimmed(line.substr(0, equals));
  const auto value = text::parse_number(trimmed(line.substr(equals + 1)));
  if (name.empty() || !value) return std::nullopt;
  interpreter::InitialValue initial;
  initial.value = *value;
  const auto number = text::parse_integer(name.substr(1));
  const bool numbered = number && *number >= 0 && *number <= UINT32_MAX;
  if (name.front() == '#' || (name.front() == 'R' && numbered)) {
    if (!numbered) return std::nullopt;
    initial.bank = name.front() == '#' ? ir::Bank::hash : ir::Bank::r;
    initial.number = static_cast<std::uint32_t>(*number);
  } else {
    initial.bank = name.front() == '$' ? ir::Bank::system : ir::Bank::named;
    initial.name = name;
  }
  return initial;
}

}  // namespace

app::Result<std::vector<interpreter::InitialValue>> read_state(const std::string& path) {
  std::vector<interpreter::InitialValue> values;
  if (path.empty()) return values;
  const auto source = read_source(path);
  if (!source) return std::unexpected(source.error());
  for (std::uint32_t i = 1; i <= source->line_count(); ++i) {
    const std::string_view line = source->line(i);
    const std::string_view code = trimmed(line.substr(0, line.find(';')));
    if (code.empty()) continue;
    const auto value = read_line(code);
    if (!value)
      return app::fail(app::ErrorCode::invalid, fmt::format("{}:{}: \"{}\" is not NAME=NUMBER", path, i, code));
    values.push_back(*value);
  }
  return values;
}

}  // namespace dripfeed::cli
