// A comment never lengthens a block beyond what the control reads, and holds only letters, digits and signs that every
// code of the wire has.
#include "dialects/compile/render/annotate.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/printed_lines.h"
#include "dialects/family/evaluate.h"

namespace dripfeed::compile {

namespace {

constexpr std::size_t kLongest = 60;  // characters of a comment

std::string comment(std::string_view text, CommentStyle style) {
  return style == CommentStyle::brackets ? fmt::format("({})", shown(text, style)) : "; " + shown(text, style);
}

std::string value_of(const family::BoundFamily& bound, const family::Parameter& parameter) {
  const double value = bound.values[static_cast<std::size_t>(parameter.symbol)];
  if (!parameter.choices.empty()) return parameter.choices[static_cast<std::size_t>(value)];
  if (parameter.kind == family::ParameterKind::text) return bound.texts.at(parameter.symbol);
  if (parameter.kind != family::ParameterKind::list) return family::format_value(parameter, value);
  std::string out;
  for (const double one : family::list_in(bound.values, parameter.symbol))
    out += (out.empty() ? "" : ", ") + family::format_value(parameter, one);
  return out;
}

std::string with_text(std::string_view name, std::string_view text) {
  return text.empty() ? std::string(name) : fmt::format("{}, {}", name, text);
}

class Annotator {
 public:
  Annotator(const Annotation& annotation, const ir::Control& to, CommentStyle style)
      : annotation_(annotation), most_(to.limits.block_length_bytes), style_(style) {}

  void put_into(ir::PrintResult& printed) {
    std::map<std::uint32_t, std::string> left = annotation_.meaning;
    bool has_heading = false;
    for_each_line(printed.text, [&](const PrintedLine& line) {
      const std::uint32_t origin =
          line.number <= printed.origin_lines.size() ? printed.origin_lines[line.number - 1] : 0;
      if (origin != 0 && !std::exchange(has_heading, true)) heading();
      if (const std::string name = name_in(line.text, origin); !name.empty()) return add(with(line.text, name), origin);
      const auto meaning = left.find(origin);
      if (meaning == left.end()) return add(line.text, origin);
      add(with(line.text, meaning->second), origin);
      left.erase(meaning);
    });
    printed.text = std::move(text_);
    printed.origin_lines = std::move(origins_);
  }

 private:
  void heading() {
    for (const std::string& one : annotation_.heading) add(comment(one, style_), 0);
  }

  // Of the variable that a verb's line assigns to for the first time; "" for none.
  std::string name_in(std::string_view line, std::uint32_t origin) {
    if (style_ != CommentStyle::brackets || !annotation_.verbs.contains(origin)) return {};
    const auto found = annotation_.names.find(std::string(line.substr(0, line.find('='))));
    return found != annotation_.names.end() && named_.insert(found->first).second ? found->second : std::string();
  }

  [[nodiscard]] std::string with(std::string_view line, std::string_view meaning) const {
    const char begins = style_ == CommentStyle::brackets ? '(' : ';';
    // The printer has named the variable already.
    if (const std::size_t at = line.find(" ; ");
        at != std::string_view::npos && meaning.starts_with(line.substr(at + 3)))
      line = line.substr(0, at);
    const std::string out =
        fmt::format("{}{}{}", line, style_ == CommentStyle::brackets ? "" : " ", comment(meaning, style_));
    return line.contains(begins) || (most_ != 0 && out.size() > most_) ? std::string(line) : out;
  }

  void add(std::string_view line, std::uint32_t origin) {
    text_ += line;
    text_ += '\n';
    origins_.push_back(origin);
  }

  const Annotation& annotation_;
  std::size_t most_;
  CommentStyle style_;
  std::string text_;
  std::vector<std::uint32_t> origins_;
  std::set<std::string> named_;
};

}  // namespace

bool shows(char c, CommentStyle style) {
  constexpr std::string_view kSigns = " +-./,";
  if (style == CommentStyle::semicolon) return c >= ' ' && c <= '~' && c != ';' && c != '%';
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || kSigns.contains(c);
}

// "HALF AXIS X, RADIUS AT THE WAIST" of a control whose comments stand in brackets.
std::string shown(std::string_view text, CommentStyle style) {
  std::string out;
  for (const char c : text.substr(0, kLongest)) {
    const bool to_capital = style == CommentStyle::brackets && c >= 'a' && c <= 'z';
    out += !shows(c, style) ? ' ' : to_capital ? static_cast<char>(c - 'a' + 'A') : c;
  }
  out.erase(out.find_last_not_of(' ') + 1);
  return out;
}

Annotation annotation_of(const family::BoundFamily& bound, const std::vector<std::string>& more, bool computed) {
  const family::Family& family = *bound.family;
  Annotation out;
  out.heading.push_back(with_text(family.name, family.title));
  out.heading.insert(out.heading.end(), more.begin(), more.end());
  for (const family::Parameter& one : family.parameters) {
    const bool is_variable = one.kind == family::ParameterKind::number || one.kind == family::ParameterKind::list;
    if (one.kind == family::ParameterKind::tool) continue;  // T shows it
    if (!computed || !is_variable) out.heading.push_back(fmt::format("{} {}", one.name, value_of(bound, one)));
    if (computed && is_variable)
      out.meaning.emplace(family.source.position(one.span.begin).line, with_text(one.name, one.text));
  }
  if (!computed) return out;
  const auto name_of = [&](ir::SymbolId symbol) { return family.arena.strings.at(family.arena.at(symbol).name); };
  for (const family::Definition& one : family.definitions) out.meaning.emplace(one.line, name_of(one.symbol));
  for (const family::List& one : family.lists)
    out.meaning.emplace(one.line, with_text(name_of(one.symbol), one.counts_chords ? "for these values only" : ""));
  for (const family::Step& one : family.steps) {
    if ((one.kind == family::StepKind::require && one.number == 0) || one.kind == family::StepKind::contour ||
        one.kind == family::StepKind::offset)
      out.verbs.insert(one.line);
    if (one.kind == family::StepKind::let && !out.verbs.contains(one.line))
      out.meaning.emplace(one.line, name_of(one.target));
  }
  return out;
}

std::map<std::string, std::string> names_of_variables(const std::vector<LegendEntry>& legend) {
  std::map<std::string, std::string> out;
  std::set<std::string> shared;
  const auto is_passing = [](std::string_view name) { return name.starts_with("other") || name.starts_with("chosen"); };
  for (const LegendEntry& one : legend) {
    const bool is_first = out.emplace(one.variable, one.name).second;
    if (!is_first || one.count > 1 || is_passing(one.name)) shared.insert(one.variable);
  }
  std::erase_if(out, [&](const auto& one) { return shared.contains(one.first); });
  return out;
}

void annotate(ir::PrintResult& printed, const Annotation& annotation, const ir::Control& to, CommentStyle style) {
  Annotator(annotation, to, style).put_into(printed);
}

}  // namespace dripfeed::compile
