// Each line that counts becomes one assignment in the control's own words, and is run by itself: what one of them says
// wrong does not touch another.
#include "server/app/lines/variable_dump.h"

#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/execute.h"
#include "dialects/text/number.h"

namespace dripfeed::app {

namespace {

struct Line {
  std::uint32_t number = 0;
  std::string value;  // what is assigned
};

// What is left of a line, from front to back.
class Rest {
 public:
  explicit Rest(std::string_view text) : text_(text) {}
  void skip_blanks() {
    while (!text_.empty() && (text_.front() == ' ' || text_.front() == '\t')) text_.remove_prefix(1);
  }
  bool take(char c) {
    if (text_.empty() || text_.front() != c) return false;
    text_.remove_prefix(1);
    return true;
  }
  bool take_letter() { return !text_.empty() && text_.front() >= 'A' && text_.front() <= 'Z' && take(text_.front()); }
  // Digits; what has more than five names no variable.
  std::optional<std::uint32_t> take_number() {
    std::size_t digits = 0;
    while (digits < text_.size() && text_[digits] >= '0' && text_[digits] <= '9') ++digits;
    if (digits == 0 || digits > 5) return std::nullopt;
    const auto number = static_cast<std::uint32_t>(*text::parse_integer(text_.substr(0, digits)));
    text_.remove_prefix(digits);
    return number;
  }
  std::string_view take_all() {
    skip_blanks();
    while (!text_.empty() && (text_.back() == ' ' || text_.back() == '\t')) text_.remove_suffix(1);
    return std::exchange(text_, {});
  }

 private:
  std::string_view text_;
};

// "N10 #500 = value", "R[20]=value", "$R[20]=value".
std::optional<Line> assignment_of(std::string_view text) {
  Rest rest(text);
  rest.skip_blanks();
  if (rest.take('N') && !rest.take_number()) return std::nullopt;
  rest.skip_blanks();
  rest.take('$');
  if (!rest.take('#') && !rest.take('R')) return std::nullopt;
  rest.skip_blanks();
  const bool bracket = rest.take('[');
  const auto number = rest.take_number();
  if (!number || (bracket && !rest.take(']'))) return std::nullopt;
  rest.skip_blanks();
  if (!rest.take('=')) return std::nullopt;
  return Line{*number, std::string(rest.take_all())};
}

// "500 412.", "V500 = 412.000".
std::optional<Line> pair_of(std::string_view text) {
  Rest rest(text);
  rest.skip_blanks();
  rest.take_letter();
  const auto number = rest.take_number();
  if (!number) return std::nullopt;
  rest.skip_blanks();
  rest.take('=');
  const std::string_view value = rest.take_all();
  if (!text::parse_number(value)) return std::nullopt;
  return Line{*number, std::string(value)};
}

std::optional<Line> line_of(std::string_view text) {
  const auto assignment = assignment_of(text);
  return assignment ? assignment : pair_of(text);
}

// Nothing: the control would not take the assignment, or it leaves nothing.
std::optional<double> value_of(const Line& line, const compile::Dialect& dialect, const ir::Control& control) {
  const bool sinumerik = control.dialect.starts_with("sinumerik");
  const std::string name = fmt::format("{}{}", sinumerik ? "R" : "#", line.number);
  const text::Source source("values", fmt::format("{}={}\nM30\n", name, line.value));
  const ir::ReadResult read = dialect.read(source, control);
  if (text::has_error(read.diagnostics)) return std::nullopt;
  compile::NoMotions no_sink;
  interpreter::RunOptions options;
  options.want_variables = true;
  const interpreter::RunResult run = compile::execute(read.program, control, nullptr, no_sink, options);
  if (run.ended != interpreter::Ended::end) return std::nullopt;
  for (const interpreter::VariableValue& one : run.variables) {
    if (one.name == name) return one.value;
  }
  return std::nullopt;
}

}  // namespace

Result<std::map<std::uint32_t, double>> read_variables(std::string_view text, const compile::Dialect& dialect,
                                                       const ir::Control& control) {
  std::map<std::uint32_t, double> values;
  const text::Source source("values", std::string(text));
  for (std::uint32_t i = 1; i <= source.line_count(); ++i) {
    const std::string_view code = source.line(i);
    const auto line = line_of(code);
    if (!line) continue;
    const auto value = value_of(*line, dialect, control);
    if (!value) return fail(ErrorCode::invalid, fmt::format("line {}: \"{}\" gives no variable a value", i, code));
    if (!values.emplace(line->number, *value).second)
      return fail(ErrorCode::invalid, fmt::format("line {}: variable {} is given twice", i, line->number));
  }
  if (values.empty()) return fail(ErrorCode::invalid, "no line has a variable's number and its value");
  return values;
}

}  // namespace dripfeed::app
