// Patterns are compared segment by segment; there are few dozen routes, so a scan is quicker than anything cleverer.
#include "server/http/router.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>

namespace dripfeed::http {

namespace {

constexpr std::array<std::string_view, 6> kRightNames = {"anybody",    "viewer",   "operator",
                                                         "programmer", "approver", "admin"};
constexpr std::array<std::string_view, 6> kMethodNames = {"GET", "POST", "PUT", "DELETE", "PATCH", "other"};

// The values of the pattern's {names} when the path fits it.
std::optional<std::vector<std::string>> fit(std::string_view pattern, const std::vector<std::string>& path) {
  std::vector<std::string> values;
  std::size_t index = 0;
  while (!pattern.empty()) {
    pattern.remove_prefix(1);  // the slash
    const std::string_view segment = pattern.substr(0, pattern.find('/'));
    pattern.remove_prefix(segment.size());
    if (index == path.size()) return std::nullopt;
    if (segment.starts_with('{')) {
      if (path[index].empty()) return std::nullopt;
      values.push_back(path[index]);
    } else if (segment != path[index]) {
      return std::nullopt;
    }
    ++index;
  }
  if (index != path.size()) return std::nullopt;
  return values;
}

std::optional<unsigned> hex_digit(char c) {
  if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
  if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a' + 10);
  if (c >= 'A' && c <= 'F') return static_cast<unsigned>(c - 'A' + 10);
  return std::nullopt;
}

// Percent-decoding; in a query '+' is a blank. Nothing when an escape is broken or hides a NUL.
std::optional<std::string> decode(std::string_view text, bool in_query) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '+' && in_query) {
      out += ' ';
    } else if (text[i] != '%') {
      out += text[i];
    } else {
      const auto high = i + 2 < text.size() ? hex_digit(text[i + 1]) : std::nullopt;
      const auto low = i + 2 < text.size() ? hex_digit(text[i + 2]) : std::nullopt;
      if (!high || !low || (*high == 0 && *low == 0)) return std::nullopt;
      out += static_cast<char>(*high * 16 + *low);
      i += 2;
    }
  }
  return out;
}

bool read_path(std::string_view path, Request& request) {
  if (!path.starts_with('/')) return false;
  path.remove_prefix(1);
  for (bool more = true; more;) {
    const std::size_t slash = path.find('/');
    more = slash != std::string_view::npos;
    const auto segment = decode(path.substr(0, slash), false);
    if (!segment || *segment == "." || *segment == "..") return false;
    request.path.push_back(*segment);
    path.remove_prefix(more ? slash + 1 : path.size());
  }
  // The one folder that people type: with and without its slash.
  if (request.path.size() == 2 && request.path[0] == "docs" && request.path[1].empty()) request.path.pop_back();
  return true;
}

bool read_query(std::string_view query, Request& request) {
  while (!query.empty()) {
    const std::string_view item = query.substr(0, query.find('&'));
    query.remove_prefix(std::min(query.size(), item.size() + 1));
    const std::size_t equals = item.find('=');
    const auto name = decode(item.substr(0, equals), true);
    const auto value = decode(equals == std::string_view::npos ? std::string_view() : item.substr(equals + 1), true);
    if (!name || !value) return false;
    request.query[*name] = *value;
  }
  return true;
}

}  // namespace

std::string_view name_of(Right right) { return kRightNames[static_cast<std::size_t>(right)]; }
std::string_view name_of(Method method) { return kMethodNames[static_cast<std::size_t>(method)]; }

std::string escape_segment(std::string_view name) {
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~";
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string out;
  for (const char c : name) {
    if (kPlain.find(c) != std::string_view::npos) {
      out += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    out += {'%', kHex[byte / 16], kHex[byte % 16]};
  }
  return out;
}

std::optional<std::string> decode_segment(std::string_view text) { return decode(text, false); }

bool read_target(std::string_view target, Request& request) {
  request.target = target;
  const std::size_t question = target.find('?');
  if (!read_path(target.substr(0, question), request)) return false;
  return question == std::string_view::npos || read_query(target.substr(question + 1), request);
}

std::vector<std::string_view> words_in(std::string_view list) {
  std::vector<std::string_view> all;
  while (!list.empty()) {
    const std::string_view word = list.substr(0, list.find(' '));
    if (!word.empty()) all.push_back(word);
    list.remove_prefix(std::min(list.size(), word.size() + 1));
  }
  return all;
}

namespace {

constexpr std::string_view kPageQuery = "limit after";

std::vector<std::string_view> taken_query(const Route& route) {
  std::vector<std::string_view> names = words_in(route.takes == Takes::page ? kPageQuery : std::string_view());
  std::ranges::copy(own_query(route), std::back_inserter(names));
  return names;
}

}  // namespace

std::vector<std::string_view> own_query(const Route& route) { return words_in(route.query); }
std::vector<std::string_view> other_types(const Route& route) { return words_in(route.answer.types); }

std::string_view unknown_query(const Route& route, const Request& request) {
  const std::vector<std::string_view> taken = taken_query(route);
  for (const auto& [name, value] : request.query) {
    if (std::ranges::find(taken, name) == taken.end()) return name;
  }
  return {};
}

std::string query_names(const Route& route) {
  std::string names;
  for (const std::string_view name : taken_query(route)) {
    names += names.empty() ? "" : ", ";
    names += name;
  }
  return names.empty() ? "none" : names;
}

Match find_route(std::span<const Route> routes, const Request& request) {
  Match match;
  for (const Route& route : routes) {
    auto values = fit(route.pattern, request.path);
    if (!values) continue;
    match.path_known = true;
    if (route.method != request.method) {
      match.allowed += match.allowed.empty() ? "" : ", ";
      match.allowed += name_of(route.method);
      continue;
    }
    match.route = &route;
    match.parameters = std::move(*values);
    return match;
  }
  return match;
}

}  // namespace dripfeed::http
