// Rows as CSV (RFC 4180), for a spreadsheet: UTF-8 with its mark, a first row of heads, CR LF. As the page writes it
// (web/src/rules/csv.ts): a text that a spreadsheet would take for a formula begins with an apostrophe.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace dripfeed::json {

class Csv {
 public:
  Csv& cell(std::string_view text);
  Csv& cell(std::uint64_t number);
  Csv& cell(double number);
  Csv& cell(std::optional<double> number);  // nothing: an empty cell
  void end_row();
  // All of it.
  [[nodiscard]] std::string take();

 private:
  void add(std::string_view written);

  std::string text_ = "\xEF\xBB\xBF";
  bool is_first_ = true;
};

}  // namespace dripfeed::json
