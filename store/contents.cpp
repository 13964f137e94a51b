// Reading a small content whole.
#include "store/contents.h"

#include <fmt/format.h>

namespace dripfeed::store {

Result<std::string> read_whole(Contents& contents, std::string_view sha256, std::uint64_t most) {
  const auto content = contents.find(sha256);
  if (!content) return std::unexpected(content.error());
  if (content->bytes > most) {
    return std::unexpected(Error{ErrorCode::invalid_value, fmt::format("{} bytes, at most {}", content->bytes, most)});
  }
  std::string text(static_cast<std::size_t>(content->bytes), '\0');
  std::size_t have = 0;
  while (have < text.size()) {
    const auto got = contents.read(sha256, have, std::span(text).subspan(have));
    if (!got) return std::unexpected(got.error());
    if (*got == 0) return std::unexpected(Error{ErrorCode::corrupt, fmt::format("content {}", sha256)});
    have += *got;
  }
  return text;
}

}  // namespace dripfeed::store
