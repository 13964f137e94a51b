// The hash of a name: FNV-1a over its upper-case letters.
#include "dialects/sinumerik/tables/name_index.h"

#include <algorithm>

namespace dripfeed::sinumerik {

namespace {

std::size_t hash_of(std::string_view name) {
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(to_upper(c))) * 0x100000001B3ULL;
  return static_cast<std::size_t>(hash ^ (hash >> 29U));
}

}  // namespace

bool same_name(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, {}, [](char c) { return to_upper(c); }, [](char c) { return to_upper(c); });
}

UpperName::UpperName(std::string_view name) : size_(std::min(name.size(), buffer_.size())) {
  std::ranges::transform(name.substr(0, size_), buffer_.begin(), to_upper);
}

NameIndex::NameIndex(std::span<const std::string_view> names) {
  std::size_t size = 16;
  while (size < names.size() * 4) size *= 2;
  slots_.resize(size);
  mask_ = size - 1;
  for (std::uint32_t i = 0; i < names.size(); ++i) {
    std::size_t at = hash_of(names[i]) & mask_;
    while (slots_[at].index != kNotFound) at = (at + 1) & mask_;
    slots_[at] = {names[i], i};
  }
}

std::uint32_t NameIndex::find(std::string_view name) const {
  for (std::size_t at = hash_of(name) & mask_; slots_[at].index != kNotFound; at = (at + 1) & mask_) {
    if (same_name(slots_[at].name, name)) return slots_[at].index;
  }
  return kNotFound;
}

}  // namespace dripfeed::sinumerik
