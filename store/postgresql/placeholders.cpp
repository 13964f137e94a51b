// One pass over the bytes of a statement.
#include "store/postgresql/placeholders.h"

#include <algorithm>

#include <fmt/format.h>

namespace dripfeed::postgresql {

std::string numbered_parameters(std::string_view sql) {
  std::string numbered;
  int parameters = 0;
  std::size_t at = 0;
  const auto copy_to = [&](std::size_t end) {
    numbered += sql.substr(at, end - at);
    at = std::min(end, sql.size());
  };
  while (at < sql.size()) {
    const char c = sql[at];
    if (c == '?') {
      numbered += fmt::format("${}", ++parameters);
      ++at;
    } else if (c == '\'' || c == '"') {
      // A quote inside is written twice: the second half is a text of its own.
      const std::size_t end = sql.find(c, at + 1);
      copy_to(end == std::string_view::npos ? sql.size() : end + 1);
    } else if (sql.substr(at).starts_with("--")) {
      copy_to(std::min(sql.find('\n', at), sql.size()));
    } else {
      copy_to(at + 1);
    }
  }
  return numbered;
}

std::string_view table_of_insert(std::string_view sql) {
  constexpr std::string_view kInsert = "INSERT INTO ";
  if (!sql.starts_with(kInsert)) return {};
  sql.remove_prefix(kInsert.size());
  return sql.substr(0, sql.find_first_of(" ("));
}

}  // namespace dripfeed::postgresql
