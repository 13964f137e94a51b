// One cell after the other.
#include "server/json/csv.h"

#include <utility>

#include <fmt/format.h>

namespace dripfeed::json {

namespace {

// What a spreadsheet begins a formula with.
constexpr std::string_view kFormula = "=+-@\t\r";
constexpr std::string_view kQuoted = "\",\r\n;";

}  // namespace

void Csv::add(std::string_view written) {
  if (!is_first_) text_ += ',';
  is_first_ = false;
  text_ += written;
}

Csv& Csv::cell(std::string_view text) {
  std::string cell(!text.empty() && kFormula.find(text.front()) != std::string_view::npos ? "'" : "");
  cell += text;
  if (cell.find_first_of(kQuoted) == std::string::npos) {
    add(cell);
    return *this;
  }
  std::string quoted = "\"";
  for (const char c : cell) quoted.append(c == '"' ? 2 : 1, c);
  add(quoted + '"');
  return *this;
}

Csv& Csv::cell(std::uint64_t number) {
  add(fmt::format("{}", number));
  return *this;
}

Csv& Csv::cell(double number) {
  add(fmt::format("{}", number));
  return *this;
}

Csv& Csv::cell(std::optional<double> number) {
  if (number) return cell(*number);
  add("");
  return *this;
}

void Csv::end_row() {
  text_ += "\r\n";
  is_first_ = true;
}

std::string Csv::take() { return std::move(text_); }

}  // namespace dripfeed::json
