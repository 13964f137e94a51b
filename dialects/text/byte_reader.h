// Where program bytes come from, seen from the dialects: a file, a pipe, a store's chunks. The reader is passed in, so
// that dialects and checks open nothing themselves.
#pragma once

#include <cstddef>
#include <expected>
#include <span>
#include <string>

namespace dripfeed::text {

class ByteReader {
 public:
  ByteReader() = default;
  ByteReader(const ByteReader&) = delete;
  ByteReader& operator=(const ByteReader&) = delete;
  virtual ~ByteReader() = default;
  // Fills the front of `into`; returns how many bytes, 0 at the end, or a message that says what failed.
  virtual std::expected<std::size_t, std::string> read(std::span<char> into) = 0;
};

}  // namespace dripfeed::text
