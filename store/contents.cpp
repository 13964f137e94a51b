// Reading a content whole, and again and again.
#include "store/contents.h"

#include <fmt/format.h>

namespace dripfeed::store {
namespace {

class InPlace final : public ContentReader {
 public:
  InPlace(Contents& contents, std::string_view sha256) : contents_(contents), sha256_(sha256) {}
  Result<std::size_t> read(std::uint64_t offset, std::span<char> into) override {
    return contents_.read(sha256_, offset, into);
  }

 private:
  Contents& contents_;
  std::string sha256_;
};

}  // namespace

std::shared_ptr<ContentReader> read_in_place(Contents& contents, std::string_view sha256) {
  return std::make_shared<InPlace>(contents, sha256);
}

Result<std::shared_ptr<ContentReader>> Contents::reader(std::string_view sha256) {
  if (auto whole = verify(sha256); !whole) return std::unexpected(whole.error());
  return read_in_place(*this, sha256);
}

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
