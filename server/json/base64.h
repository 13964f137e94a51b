// Columns of numbers in JSON: their bytes, little-endian, in base64 (RFC 4648). Only files of this
// folder and of server/oidc include this.
#pragma once

#include <bit>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace dripfeed::json {

std::string base64(std::span<const std::byte> bytes);

template <class Number>
std::string base64_column(const std::vector<Number>& column) {
  static_assert(sizeof(Number) == 1 || std::endian::native == std::endian::little);
  return base64(std::as_bytes(std::span(column)));
}

}  // namespace dripfeed::json
