// SHA-256 of bytes that come in pieces, as 64 lower-case hexadecimal digits.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace dripfeed::hash {

class Sha256 {
 public:
  Sha256();
  void add(std::string_view bytes);
  void add(std::span<const std::byte> bytes);
  // The digest of all that was added; further bytes may follow and count from the start on.
  [[nodiscard]] std::string hex() const;

 private:
  // libsodium's state, without its header; sha256.cpp compares the sizes.
  struct alignas(8) State {
    std::array<std::byte, 104> bytes{};
  };
  State state_;
};

std::string sha256_hex(std::string_view bytes);

}  // namespace dripfeed::hash
