// Hashes of one transfer: of every byte on the wire, and of the text from the first to the last '%'.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "protocol/tape_code/wire_decoder.h"
#include "server/cli/documents.h"
#include "store/hash/hash.h"

namespace dripfeed::cli {

class WireHasher {
 public:
  explicit WireHasher(const tape_code::DecodeFormat& format) : decoder_(format) {}
  void add(std::uint8_t byte);
  // Of all bytes so far.
  [[nodiscard]] WireHashes finish();
  // The text as received, LF as EOB, from the first to the last '%'.
  [[nodiscard]] std::string text();

 private:
  hash::Sha256 wire_;
  tape_code::WireDecoder decoder_;
  std::string text_;
};

}  // namespace dripfeed::cli
