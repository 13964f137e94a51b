// The text is read twice: once by a scrutiny that keeps only the names, then into a document.
#include "server/json/parse.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "server/json/sentences.h"

namespace dripfeed::json {

namespace {

// "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error …": the place is found here.
std::string_view words_of(const nlohmann::json::exception& error) {
  std::string_view words = error.what();
  if (const std::size_t name = words.find("] "); name != std::string_view::npos) words.remove_prefix(name + 2);
  if (words.starts_with("parse error")) words.remove_prefix(std::min(words.size(), words.find(": ") + 2));
  return words;
}

class Scrutiny final : public nlohmann::json_sax<Document> {
 public:
  Scrutiny(std::string_view text, std::size_t most_values) : text_(text), most_values_(most_values) {}
  [[nodiscard]] const std::optional<app::Error>& error() const { return error_; }

  bool null() override { return begin_value(); }
  bool boolean(bool /*value*/) override { return begin_value(); }
  bool number_integer(number_integer_t /*value*/) override { return begin_value(); }
  bool number_unsigned(number_unsigned_t /*value*/) override { return begin_value(); }
  bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return begin_value(); }
  bool string(string_t& /*value*/) override { return begin_value(); }
  bool binary(binary_t& /*value*/) override { return begin_value(); }
  bool start_object(std::size_t /*elements*/) override { return begin_level(false); }
  bool start_array(std::size_t /*elements*/) override { return begin_level(true); }
  bool end_object() override { return end_level(); }
  bool end_array() override { return end_level(); }

  bool key(string_t& name) override {
    Level& level = levels_.back();
    level.name = name;
    if (level.names.size() == kMostMembers) {
      levels_.pop_back();  // the object has the fault, not its last member
      return refuse(fmt::format("has more than {} members", kMostMembers));
    }
    if (level.names.insert(name).second) return true;
    return refuse("is given twice");
  }

  bool parse_error(std::size_t position, const std::string& /*token*/,
                   const nlohmann::json::exception& error) override {
    const std::string_view before = text_.substr(0, position == 0 ? 0 : position - 1);
    const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
    app::ErrorPlace place{.pointer = pointer(),
                          .line = static_cast<std::uint32_t>(1 + std::ranges::count(before, '\n')),
                          .column = static_cast<std::uint32_t>(before.size() - line_begin + 1),
                          .text = std::string(words_of(error))};
    error_ = {app::ErrorCode::malformed,
              fmt::format("this is not JSON: line {}, column {}: {}", place.line, place.column, place.text),
              {std::move(place)}};
    return false;
  }

 private:
  struct Level {
    bool is_array = false;
    std::size_t values = 0;
    std::string name;  // of the present member
    std::set<std::string, std::less<>> names;
  };

  bool begin_value() {
    if (!levels_.empty()) ++levels_.back().values;
    if (values_++ < most_values_) return true;
    return refuse(fmt::format("is more than {} values in one document", most_values_));
  }
  bool begin_level(bool is_array) {
    if (!begin_value()) return false;
    if (levels_.size() == kDeepest) return refuse(fmt::format("is nested deeper than {} levels", kDeepest));
    levels_.push_back({.is_array = is_array, .values = 0, .name = {}, .names = {}});
    return true;
  }
  bool end_level() {
    levels_.pop_back();
    return true;
  }

  [[nodiscard]] std::string pointer() const {
    std::string out;
    for (const Level& level : levels_) {
      const std::size_t index = level.values == 0 ? 0 : level.values - 1;
      out += level.is_array ? fmt::format("/{}", index) : level.name.empty() ? "" : "/" + escape_pointer(level.name);
    }
    return out;
  }

  bool refuse(std::string text) {
    app::ErrorPlace place{.pointer = pointer(), .line = 0, .column = 0, .text = std::move(text)};
    error_ = {app::ErrorCode::malformed,
              fmt::format("{} {}", place.pointer.empty() ? "the document" : place.pointer, place.text),
              {std::move(place)}};
    return false;
  }

  std::string_view text_;
  std::size_t most_values_;
  std::size_t values_ = 0;
  std::vector<Level> levels_;
  std::optional<app::Error> error_;
};

}  // namespace

std::string escape_pointer(std::string_view name) {
  std::string out;
  for (const char c : name) {
    if (c == '~') {
      out += "~0";
    } else if (c == '/') {
      out += "~1";
    } else {
      out += c;
    }
  }
  return out;
}

app::Result<Document> parse(std::string_view text, std::size_t most_values) {
  try {
    Scrutiny scrutiny(text, most_values);
    if (!Document::sax_parse(text, &scrutiny) && scrutiny.error()) return std::unexpected(*scrutiny.error());
    return Document::parse(text);
  } catch (const nlohmann::json::exception& error) {
    return app::fail(app::ErrorCode::malformed, fmt::format("this is not JSON: {}", words_of(error)));
  }
}

Document embedded(std::string_view text) {
  auto document = parse(text, std::numeric_limits<std::size_t>::max());
  return document ? std::move(*document) : Document(nullptr);
}

std::string dump(const Document& document) { return document.dump(-1, ' ', false, Document::error_handler_t::replace); }

Document sentence_or_null(std::string_view sentence) {
  const auto found = sentence_of(sentence);
  if (!found) return nullptr;
  Document values = Document::object();
  for (const auto& [name, value] : found->values)
    values[std::string(name)] = {{"text", value}, {"said", sentence_or_null(value)}};
  return {{"id", found->id}, {"values", std::move(values)}};
}

}  // namespace dripfeed::json
