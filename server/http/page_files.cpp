// A tag is the beginning of the content's SHA-256, worked out once for each state of a file.
#include "server/http/page_files.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "store/hash/hash.h"

namespace dripfeed::http {

namespace {

// The page loads nothing from elsewhere and runs nothing inline.
constexpr std::string_view kPagePolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src 'self' data:; font-src "
    "'self'; manifest-src 'self'; form-action 'self'; "
    "base-uri 'none'; frame-ancestors 'none'";

struct FileType {
  std::string_view ending;
  std::string_view type;
};
constexpr std::array kFileTypes = {
    FileType{".html", "text/html; charset=utf-8"},
    FileType{".js", "text/javascript; charset=utf-8"},
    FileType{".css", "text/css; charset=utf-8"},
    FileType{".svg", "image/svg+xml"},
    FileType{".png", "image/png"},
    FileType{".woff2", "font/woff2"},
    FileType{".json", "application/json"},
    FileType{".map", "application/json"},
    FileType{".webmanifest", "application/manifest+json"},
};

// In the order in which we like them.
struct Coding {
  std::string_view name;
  std::string_view ending;
};
constexpr std::array kCodings = {Coding{"br", ".br"}, Coding{"gzip", ".gz"}};

std::string_view type_of(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  const auto* const row = std::ranges::find(kFileTypes, ending, &FileType::ending);
  return row == kFileTypes.end() ? "application/octet-stream" : row->type;
}

// A folder opens like a file and throws when it is read, so only regular files are looked at.
bool is_file(const std::filesystem::path& path) {
  std::error_code unknown;  // what cannot be looked at is not there
  return std::filesystem::is_regular_file(path, unknown);
}

std::optional<std::string> read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ') || text.starts_with('\t')) text.remove_prefix(1);
  while (text.ends_with(' ') || text.ends_with('\t')) text.remove_suffix(1);
  return text;
}

// The next item of a list, taken off its front.
std::string_view take_item(std::string_view& list, char separator) {
  const std::string_view item = list.substr(0, list.find(separator));
  list.remove_prefix(std::min(list.size(), item.size() + 1));
  return trimmed(item);
}

bool same_word(std::string_view one, std::string_view other) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::ranges::equal(one, other, {}, lower, lower);
}

bool is_no_weight(std::string_view weight) {
  return weight.starts_with('0') && weight.find_first_not_of("0.") == std::string_view::npos;
}

}  // namespace

bool takes_coding(std::string_view accept_encoding, std::string_view coding) {
  while (!accept_encoding.empty()) {
    std::string_view item = take_item(accept_encoding, ',');
    if (!same_word(take_item(item, ';'), coding)) continue;
    return !(same_word(take_item(item, '='), "q") && is_no_weight(trimmed(item)));
  }
  return false;
}

bool names_tag(std::string_view if_none_match, std::string_view tag) {
  while (!if_none_match.empty()) {
    std::string_view item = take_item(if_none_match, ',');
    if (item == "*") return true;
    if (item.starts_with("W/")) item.remove_prefix(2);
    if (item == tag) return true;
  }
  return false;
}

bool has_content_hash(std::string_view name) {
  constexpr std::size_t kHash = 8;
  for (std::size_t dash = name.find('-'); dash != std::string_view::npos; dash = name.find('-', dash + 1)) {
    const std::string_view hash = name.substr(dash + 1, kHash);
    const bool is_hash = hash.size() == kHash && std::ranges::all_of(hash, [](char c) {
                           return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
                         });
    if (is_hash && name.substr(dash + 1 + kHash).starts_with('.')) return true;
  }
  return false;
}

// `body` is filled where the file had to be read for it.
std::string PageFiles::tag_of(const std::filesystem::path& path, std::string& body) {
  std::error_code unknown;
  const Seen now{.changed = std::filesystem::last_write_time(path, unknown),
                 .bytes = std::filesystem::file_size(path, unknown),
                 .tag = {}};
  {
    const std::lock_guard lock(mutex_);
    const auto known = seen_.find(path.string());
    if (known != seen_.end() && known->second.changed == now.changed && known->second.bytes == now.bytes)
      return known->second.tag;
  }
  auto read = read_file(path);
  if (!read) return {};
  body = std::move(*read);
  std::string tag = fmt::format("\"{}\"", hash::sha256_hex(body).substr(0, 32));
  const std::lock_guard lock(mutex_);
  if (seen_.size() >= kMost) seen_.clear();
  seen_[path.string()] = {.changed = now.changed, .bytes = now.bytes, .tag = tag};
  return tag;
}

std::optional<Response> PageFiles::answer(const std::filesystem::path& path, const Request& request) {
  if (!is_file(path)) return std::nullopt;
  Response response;
  response.content_type = type_of(path);
  std::filesystem::path sent = path;
  std::string_view coding;
  for (const Coding& row : kCodings) {
    const std::filesystem::path twin = path.string() + std::string(row.ending);
    if (!coding.empty() || !is_file(twin) || !takes_coding(request.accept_encoding, row.name)) continue;
    coding = row.name;
    sent = twin;
  }
  const std::string tag = tag_of(sent, response.body);
  if (tag.empty()) return std::nullopt;
  const bool never_changes = has_content_hash(path.filename().string());
  response.headers.emplace_back("Content-Security-Policy", kPagePolicy);
  response.headers.emplace_back("Cache-Control", never_changes ? "public, max-age=31536000, immutable" : "no-cache");
  response.headers.emplace_back("ETag", tag);
  response.headers.emplace_back("Vary", "Accept-Encoding");
  if (names_tag(request.if_none_match, tag)) {
    response.status = 304;
    response.content_type.clear();
    response.body.clear();
    return response;
  }
  if (!coding.empty()) response.headers.emplace_back("Content-Encoding", coding);
  if (response.body.empty()) {
    auto body = read_file(sent);
    if (!body) return std::nullopt;
    response.body = std::move(*body);
  }
  return response;
}

}  // namespace dripfeed::http
