// What the fuzz targets share: naming a broken property, and reading an input as a row of small decisions. Each target
// is one source with LLVMFuzzerTestOneInput; who calls it is libFuzzer (preset fuzz) or replay.cpp (every other build).
//
//   cmake --preset fuzz && cmake --build build/fuzz --target fuzz_targets     builds the fuzzers
//   tests/fuzz/run.sh SECONDS [NAME...]                                        runs them one after the other
//   ctest --test-dir build/dev -L fuzz                                         replays the seeds of tests/fuzz/corpus
//
// An input that breaks a property is made small (-minimize_crash=1), written as a seed of the target's folder
// under tests/fuzz/corpus, and committed with the fix.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace dripfeed::fuzz {

// Ends the process with the property's name where it does not hold, so that whoever runs the target keeps the input.
void require(bool holds, std::string_view property);

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

// Decisions from the front of an input; zeros once it is used up.
class Choices {
 public:
  Choices(const std::uint8_t* data, std::size_t size) : left_(data, size) {}

  [[nodiscard]] bool done() const { return left_.empty(); }
  std::uint8_t byte() {
    if (left_.empty()) return 0;
    const std::uint8_t first = left_.front();
    left_ = left_.subspan(1);
    return first;
  }
  // 0 .. count - 1; count is at most 256.
  std::uint32_t below(std::uint32_t count) { return byte() % count; }
  bool flag() { return below(2) == 1; }
  std::uint32_t word() {
    const std::uint32_t high = byte();
    return high << 8U | byte();
  }
  // Up to `count` bytes as text.
  std::string_view text(std::size_t count) {
    const std::size_t taken = count < left_.size() ? count : left_.size();
    const std::string_view out = text_of(left_.data(), taken);
    left_ = left_.subspan(taken);
    return out;
  }

 private:
  std::span<const std::uint8_t> left_;
};

}  // namespace dripfeed::fuzz
