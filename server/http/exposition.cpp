// https://prometheus.io/docs/instrumenting/exposition_formats/: help escapes backslash and line feed, a label's value
// the quote, too; all samples of a family stand together.
#include "server/http/exposition.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "dialects/text/number.h"

namespace dripfeed::http {

namespace {

constexpr std::array<std::string_view, 4> kTypes = {"counter", "gauge", "histogram", "summary"};

void append_escaped(std::string& out, std::string_view text, bool in_quotes) {
  for (const char c : text) {
    if (c == '\\') {
      out += "\\\\";
    } else if (c == '\n') {
      out += "\\n";
    } else if (c == '"' && in_quotes) {
      out += "\\\"";
    } else {
      out += c;
    }
  }
}

}  // namespace

std::string exposition_number(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "+Inf" : "-Inf";
  return text::format_shortest(value);
}

void Exposition::family(std::string_view name, MetricType type, std::string_view help) {
  name_ = name;
  head_ = fmt::format("# HELP {} ", name);
  append_escaped(head_, help, false);
  head_ += fmt::format("\n# TYPE {} {}\n", name, kTypes[static_cast<std::size_t>(type)]);
}

void Exposition::begin_line(std::string_view suffix, Labels labels) {
  text_ += head_;
  head_.clear();
  text_ += name_;
  if (!suffix.empty()) {
    text_ += '_';
    text_ += suffix;
  }
  char before = '{';
  for (const auto& [name, value] : labels) {
    text_ += before;
    text_ += name;
    text_ += "=\"";
    append_escaped(text_, value, true);
    text_ += '"';
    before = ',';
  }
  if (labels.size() > 0) text_ += '}';
  text_ += ' ';
}

void Exposition::end_line(std::string_view value) {
  text_ += value;
  text_ += '\n';
}

void Exposition::sample(Labels labels, std::uint64_t value) { part({}, labels, value); }
void Exposition::sample(Labels labels, double value) { part({}, labels, value); }

void Exposition::part(std::string_view suffix, Labels labels, std::uint64_t value) {
  begin_line(suffix, labels);
  end_line(fmt::format_int(value).c_str());
}

void Exposition::part(std::string_view suffix, Labels labels, double value) {
  begin_line(suffix, labels);
  end_line(exposition_number(value));
}

}  // namespace dripfeed::http
