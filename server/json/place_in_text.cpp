// Walks down to the member, value by value. The text is known to be whole JSON, so a value ends where its brackets do,
// and a string where its quote is not escaped.
#include "server/json/place_in_text.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

namespace dripfeed::json {

namespace {

class Walker {
 public:
  explicit Walker(std::string_view text) : text_(text) { skip_blank(); }

  // At the beginning of the value.
  [[nodiscard]] std::size_t at() const { return at_; }

  // Goes from a value to its member or element; where its name, or it, begins. Nothing where there is none.
  std::optional<std::size_t> enter(std::string_view name) {
    if (at_ >= text_.size() || (text_[at_] != '{' && text_[at_] != '[')) return std::nullopt;
    const bool is_object = text_[at_] == '{';
    ++at_;
    skip_blank();
    for (std::size_t i = 0; at_ < text_.size() && text_[at_] != '}' && text_[at_] != ']'; ++i) {
      const std::size_t begin = at_;
      if (is_object ? read_name() == name : std::to_string(i) == name) return begin;
      skip_value();
      skip_blank();
      if (at_ < text_.size() && text_[at_] == ',') ++at_;
      skip_blank();
    }
    return std::nullopt;
  }

 private:
  void skip_blank() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

  void skip_string() {
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      if (text_[at_] == '\\') ++at_;
    }
    ++at_;
  }

  // The name, escaped as a pointer has it; then it stands at the value.
  std::string read_name() {
    const std::size_t begin = at_ + 1;
    skip_string();
    std::string name;
    for (const char c : text_.substr(begin, at_ - 1 - begin))
      name += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    skip_blank();
    ++at_;  // the colon
    skip_blank();
    return name;
  }

  void skip_value() {
    std::size_t depth = 0;
    do {
      const char c = at_ < text_.size() ? text_[at_] : ']';
      if (c == '"') {
        skip_string();
      } else if (c == '{' || c == '[') {
        ++depth;
        ++at_;
      } else if (c == '}' || c == ']') {
        --depth;
        ++at_;
      } else if (depth == 0) {
        at_ = std::min(text_.find_first_of(",}] \t\r\n", at_), text_.size());
      } else {
        ++at_;
      }
    } while (depth > 0 && at_ < text_.size());
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

TextPlace place_of(std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, at);
  const std::size_t line_begin = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  return {.line = static_cast<std::uint32_t>(std::ranges::count(before, '\n')) + 1,
          .column = static_cast<std::uint32_t>(at - line_begin) + 1};
}

}  // namespace

TextPlace place_in_text(std::string_view text, std::string_view pointer) {
  Walker walker(text);
  std::size_t found = walker.at();
  while (pointer.starts_with('/')) {
    pointer.remove_prefix(1);
    const std::string_view name = pointer.substr(0, pointer.find('/'));
    pointer.remove_prefix(name.size());
    const auto begin = walker.enter(name);
    if (!begin) break;
    found = *begin;
  }
  return place_of(text, found);
}

}  // namespace dripfeed::json
