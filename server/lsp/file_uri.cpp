// Bytes that a URI cannot hold are written in hexadecimal, as %20.
#include "server/lsp/file_uri.h"

#include <optional>

#include <fmt/format.h>

namespace dripfeed::lsp {

namespace {

constexpr std::string_view kScheme = "file://";

std::optional<unsigned> digit_of(char c) {
  if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
  if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a' + 10);
  if (c >= 'A' && c <= 'F') return static_cast<unsigned>(c - 'A' + 10);
  return std::nullopt;
}

bool stays(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("/-._~").contains(c);
}

}  // namespace

std::string path_of(std::string_view uri) {
  if (!uri.starts_with(kScheme)) return {};
  uri.remove_prefix(kScheme.size());
  uri.remove_prefix(std::min(uri.size(), uri.find('/')));  // the host: this one
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const auto high = uri[i] == '%' && i + 2 < uri.size() ? digit_of(uri[i + 1]) : std::nullopt;
    const auto low = high ? digit_of(uri[i + 2]) : std::nullopt;
    path += low ? static_cast<char>(*high * 16 + *low) : uri[i];
    if (low) i += 2;
  }
  return path;
}

std::string file_uri(std::string_view path) {
  std::string uri(kScheme);
  for (const char c : path) {
    if (stays(c))
      uri += c;
    else
      uri += fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
  }
  return uri;
}

}  // namespace dripfeed::lsp
