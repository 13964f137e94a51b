// Member access by name with a memory of what was asked for.
#include "server/json/object_reader.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dialects/text/number.h"
#include "server/app/base/names.h"

namespace dripfeed::json {

ObjectReader::ObjectReader(const Document& object, std::string pointer, std::vector<app::ErrorPlace>& faults)
    : object_(object), pointer_(std::move(pointer)), faults_(faults) {}

namespace {

const Document& nothing() {
  static const Document kNothing = Document::object();
  return kNothing;
}

}  // namespace

ObjectReader::ObjectReader(Members& into, std::vector<app::ErrorPlace>& unused)
    : object_(nothing()), faults_(unused), described_(&into) {}

bool ObjectReader::describes(std::string_view name, const Schema& shape, bool required) {
  if (described_ == nullptr) return false;
  described_->push_back(
      {.name = std::string(name), .schema = shape, .presence = required ? Presence::required : Presence::optional});
  return true;
}

void ObjectReader::fault(std::string_view name, std::string text) {
  if (described_ != nullptr) return;
  faults_.push_back(
      {.pointer = pointer_ + "/" + escape_pointer(name), .line = 0, .column = 0, .text = std::move(text)});
}

const Document* ObjectReader::member(std::string_view name, const Schema& shape, bool required) {
  return describes(name, shape, required) ? nullptr : find(name, required);
}

const Document* ObjectReader::find(std::string_view name, bool required) {
  asked_.emplace(name);
  const auto found = object_.find(name);
  if (found != object_.end() && !found->is_null()) return &*found;
  if (required) fault(name, "is missing");
  return nullptr;
}

void ObjectReader::text(std::string_view name, std::string& into, bool required) {
  const Document* value = member(name, required ? filled_text("") : json::text(""), required);
  if (value == nullptr) return;
  if (!value->is_string()) return fault(name, "must be a text");
  into = value->get<std::string>();
  if (required && into.empty()) fault(name, "must not be empty");
}

void ObjectReader::words(std::string_view name, std::string& into, bool required) {
  text(name, into, required);
  if (!into.empty() && into.find_first_not_of(" \t\r\n") == std::string::npos) fault(name, "is blank");
}

void ObjectReader::proper_name(std::string_view name, std::string& into, bool required) {
  text(name, into, required);
  if (into.empty()) return;  // a fault already, where it is required
  if (std::string why = app::why_no_name(into); !why.empty()) fault(name, std::move(why));
}

void ObjectReader::flag(std::string_view name, bool& into) {
  const Document* value = member(name, json::flag(""));
  if (value == nullptr) return;
  if (!value->is_boolean()) return fault(name, "must be true or false");
  into = value->get<bool>();
}

std::optional<double> ObjectReader::number_at(std::string_view name, double low, double high, bool required) {
  const Document* value = member(name, json::number(low, high, ""), required);
  if (value == nullptr) return std::nullopt;
  if (!value->is_number()) {
    fault(name, "must be a number");
    return std::nullopt;
  }
  const double number = value->get<double>();
  if (std::isfinite(number) && low <= number && number <= high) return number;
  fault(name, fmt::format("must be from {} to {}, and is {}", text::format_shortest(low), text::format_shortest(high),
                          text::format_shortest(number)));
  return std::nullopt;
}

void ObjectReader::number(std::string_view name, double& into, double low, double high, bool required) {
  if (const auto value = number_at(name, low, high, required)) into = *value;
}
void ObjectReader::number(std::string_view name, std::optional<double>& into, double low, double high) {
  if (const auto value = number_at(name, low, high, false)) into = *value;
}

std::optional<std::int64_t> ObjectReader::integer_at(std::string_view name, std::int64_t low, std::int64_t high,
                                                     bool required) {
  const auto shape = json::integer(static_cast<double>(low), static_cast<double>(high), "");
  const Document* value = member(name, shape, required);
  if (value == nullptr) return std::nullopt;
  if (!value->is_number_integer() || (value->is_number_unsigned() && value->get<std::uint64_t>() > INT64_MAX)) {
    fault(name, "must be a whole number");
    return std::nullopt;
  }
  const auto number = value->get<std::int64_t>();
  if (low <= number && number <= high) return number;
  fault(name, fmt::format("must be from {} to {}, and is {}", low, high, number));
  return std::nullopt;
}

std::optional<std::size_t> ObjectReader::choice(std::string_view name, std::span<const std::string_view> words,
                                                bool required) {
  const Document* value = member(name, one_of(words, ""), required);
  if (value == nullptr) return std::nullopt;
  const std::string word = value->is_string() ? value->get<std::string>() : std::string();
  const auto found = std::ranges::find(words, word);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  fault(name, fmt::format("must be one of \"{}\"", fmt::join(words, "\", \"")));
  return std::nullopt;
}

void ObjectReader::object(std::string_view name, const std::function<void(ObjectReader&)>& read, bool required) {
  if (described_ != nullptr) {
    describes(name, describe("", read), required);
    return;
  }
  const Document* value = find(name, required);
  if (value == nullptr) return;
  if (!value->is_object()) return fault(name, "must be an object");
  ObjectReader reader(*value, pointer_ + "/" + escape_pointer(name), faults_);
  read(reader);
  reader.finish();
}

void ObjectReader::objects(std::string_view name, const std::function<void(ObjectReader&)>& read, bool required) {
  if (described_ != nullptr) {
    describes(name, list_of(describe("", read), ""), required);
    return;
  }
  const Document* value = find(name, required);
  if (value == nullptr) return;
  if (!value->is_array()) return fault(name, "must be a list of objects");
  for (std::size_t i = 0; i < value->size(); ++i) {
    const std::string element = fmt::format("{}/{}", name, i);
    if (!(*value)[i].is_object()) {
      faults_.push_back({.pointer = pointer_ + "/" + element, .line = 0, .column = 0, .text = "must be an object"});
      continue;
    }
    ObjectReader reader((*value)[i], pointer_ + "/" + element, faults_);
    read(reader);
    reader.finish();
  }
}

bool ObjectReader::has(std::string_view name) const {
  const auto found = object_.find(name);
  return found != object_.end() && !found->is_null();
}

void ObjectReader::finish() {
  for (const auto& [name, value] : object_.items()) {
    if (!asked_.contains(name)) fault(name, "is not known here");
  }
}

app::Result<void> read_object(std::string_view text, std::string_view what,
                              const std::function<void(ObjectReader&)>& read) {
  const auto document = parse(text);
  if (!document) return std::unexpected(document.error());
  if (!document->is_object())
    return app::fail(app::ErrorCode::invalid, fmt::format("{}: a JSON object is expected", what));
  std::vector<app::ErrorPlace> faults;
  ObjectReader reader(*document, "", faults);
  read(reader);
  reader.finish();
  if (faults.empty()) return {};
  std::string sentence = fmt::format("{}: {} {}", what, faults.front().pointer, faults.front().text);
  if (faults.size() > 1) sentence += fmt::format(" (and {} more)", faults.size() - 1);
  return app::fail(app::ErrorCode::invalid, sentence, std::move(faults));
}

Schema describe(std::string about, const std::function<void(ObjectReader&)>& read) {
  Members members;
  std::vector<app::ErrorPlace> unused;
  ObjectReader reader(members, unused);
  read(reader);
  return closed_object(std::move(about), std::move(members));
}

}  // namespace dripfeed::json
