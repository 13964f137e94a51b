// Passwords and PINs: argon2id with a salt of its own, as text that names its cost, so that the cost can grow. A hash
// takes about a tenth of a second and kPasswordMemory_bytes; whoever computes many at once needs as much for each.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace dripfeed::hash {

inline constexpr std::size_t kPasswordMemory_bytes = std::size_t{64} << 20U;

// What the store keeps of a password. Nothing when there is no memory for it.
std::optional<std::string> password_hash(std::string_view password);
// Whether the hash is of this password. An empty or broken hash is of none, and takes as long.
bool is_password_of(std::string_view password, const std::string& hash);

}  // namespace dripfeed::hash
