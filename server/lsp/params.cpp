// Settings are read as every document of dripfeed: a misspelled member is a fault. The protocol's own objects may have
// members that this server does not know.
#include "server/lsp/params.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "dialects/compile/renumber/renumber.h"
#include "server/app/library/rewriting.h"
#include "server/json/object_reader.h"

namespace dripfeed::lsp {

namespace {

std::unexpected<std::string> fault(std::string text) { return std::unexpected(std::move(text)); }

Read<std::string> text_in(const Document& document, std::string_view name) {
  const Document* found = member(document, name);
  if (found == nullptr || !found->is_string()) return fault(std::string(name) + " must be a text");
  return found->get<std::string>();
}

Read<std::uint32_t> count_in(const Document& document, std::string_view name) {
  const Document* found = member(document, name);
  const bool is_count = found != nullptr && found->is_number_unsigned() &&
                        found->get<std::uint64_t>() <= std::numeric_limits<std::int32_t>::max();
  if (!is_count) return fault(std::string(name) + " must be a whole number from 0");
  return found->get<std::uint32_t>();
}

Read<Position> position_in(const Document* document) {
  if (document == nullptr) return fault("a position is missing");
  const auto line = count_in(*document, "line");
  if (!line) return fault(line.error());
  const auto character = count_in(*document, "character");
  if (!character) return fault(character.error());
  return Position{*line, *character};
}

Read<Range> range_in(const Document& document) {
  const auto start = position_in(member(document, "start"));
  if (!start) return fault(start.error());
  const auto end = position_in(member(document, "end"));
  if (!end) return fault(end.error());
  return Range{*start, *end};
}

std::int64_t version_in(const Document& document) {
  const Document* version = member(document, "version");
  return version != nullptr && version->is_number_integer() ? version->get<std::int64_t>() : 0;
}

Read<Change> change_of(const Document& document) {
  auto text = text_in(document, "text");
  if (!text) return fault(text.error());
  Change change{.range = std::nullopt, .text = std::move(*text)};
  const Document* range = member(document, "range");
  if (range == nullptr) return change;
  const auto read = range_in(*range);
  if (!read) return fault(read.error());
  change.range = *read;
  return change;
}

void read_numbering(json::ObjectReader& of, Settings& into) {
  if (const auto blocks = of.choice("blocks", compile::kNumberingNames))
    into.numbering = compile::kNumberingNames[*blocks];
  of.integer("first", into.first_number, 1, app::kMostNumberStep);
  of.integer("step", into.number_step, 1, app::kMostNumberStep);
}

void read_paths(json::ObjectReader& of, Settings& into) {
  const Document* paths = of.member("path", json::any(""));
  if (paths == nullptr) return;
  const bool are_texts =
      paths->is_array() && std::ranges::all_of(*paths, [](const Document& one) { return one.is_string(); });
  if (!are_texts) return of.fault("path", "must be a list of folders");
  into.paths = paths->get<std::vector<std::string>>();
}

void read_settings_object(json::ObjectReader& of, Settings& into) {
  constexpr std::int64_t kMostSeconds = 3600;
  of.text("machine", into.machine);
  of.text("dialect", into.dialect);
  of.text("control", into.control);
  of.text("modes", into.modes);
  read_paths(of, into);
  of.text("docs", into.docs);
  of.integer("seconds", into.seconds, 0, kMostSeconds);
  of.object("renumber", [&](json::ObjectReader& inner) { read_numbering(inner, into); });
}

}  // namespace

const Document* member(const Document& document, std::string_view name) {
  if (!document.is_object()) return nullptr;
  const auto found = document.find(name);
  return found == document.end() ? nullptr : &*found;
}

Client read_client(const Document& params) {
  Client client;
  const auto below = [](const Document* document, std::string_view name) {
    return document == nullptr ? nullptr : member(*document, name);
  };
  const Document* capabilities = member(params, "capabilities");
  const Document* units = below(below(capabilities, "general"), "positionEncodings");
  if (units != nullptr && units->is_array() && std::ranges::find(*units, Document("utf-8")) != units->end())
    client.unit = PositionUnit::utf8;
  const Document* trees =
      below(below(below(capabilities, "textDocument"), "documentSymbol"), "hierarchicalDocumentSymbolSupport");
  client.takes_symbol_trees = trees != nullptr && trees->is_boolean() && trees->get<bool>();
  return client;
}

Read<Settings> read_settings(const Document& document, Settings base) {
  if (!document.is_object()) return base;
  const auto read = json::read_object(json::dump(document), "the settings",
                                      [&](json::ObjectReader& of) { read_settings_object(of, base); });
  if (!read) return fault(read.error().text);
  return base;
}

Read<std::string> read_uri(const Document& params) {
  const Document* document = member(params, "textDocument");
  return document == nullptr ? fault("textDocument is missing") : text_in(*document, "uri");
}

Read<Position> read_position(const Document& params) { return position_in(member(params, "position")); }

Read<Range> read_range(const Document& params) {
  const Document* range = member(params, "range");
  return range == nullptr ? fault("range is missing") : range_in(*range);
}

Read<OpenedText> read_opened(const Document& params) {
  auto uri = read_uri(params);
  if (!uri) return fault(uri.error());
  const Document& document = *member(params, "textDocument");
  auto text = text_in(document, "text");
  if (!text) return fault(text.error());
  return OpenedText{std::move(*uri), version_in(document), std::move(*text)};
}

Read<ChangedText> read_changed(const Document& params) {
  auto uri = read_uri(params);
  if (!uri) return fault(uri.error());
  const Document* changes = member(params, "contentChanges");
  if (changes == nullptr || !changes->is_array()) return fault("contentChanges must be a list");
  ChangedText changed{std::move(*uri), version_in(*member(params, "textDocument")), {}};
  for (const Document& one : *changes) {
    auto change = change_of(one);
    if (!change) return fault(change.error());
    changed.changes.push_back(std::move(*change));
  }
  return changed;
}

}  // namespace dripfeed::lsp
