// Hashing by single bytes is slow and here it does not matter: a line is slower.
#include "server/cli/wire_hashes.h"

namespace dripfeed::cli {

void WireHasher::add(std::uint8_t byte) {
  const std::byte one{byte};
  wire_.add(std::span(&one, 1));
  decoder_.decode(std::span(&one, 1), text_);
}

std::string WireHasher::text() { return text_.substr(0, static_cast<std::size_t>(decoder_.kept())); }

WireHashes WireHasher::finish() { return {.wire_sha256 = wire_.hex(), .text_sha256 = hash::sha256_hex(text())}; }

}  // namespace dripfeed::cli
