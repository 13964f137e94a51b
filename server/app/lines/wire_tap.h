// What passes on a line, for people who look at it: the last characters in both directions and what the link's own
// lines do, with times. While no person looks it keeps nothing, and a line pays for one look at a flag.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "protocol/feed/settings.h"
#include "protocol/tape_code/code_table.h"
#include "server/app/ports/line_mutex.h"

namespace dripfeed::app {

enum class WireKind : std::uint8_t { in, out, up, lost, cts_on, cts_off, dsr_on, dsr_off };
constexpr std::string_view name_of(WireKind kind) {
  constexpr std::array<std::string_view, 8> kNames = {"in",     "out",     "up",     "lost",
                                                      "cts_on", "cts_off", "dsr_on", "dsr_off"};
  return kNames[static_cast<std::size_t>(kind)];
}

class WireTap {
 public:
  // Characters that are kept; who reads more slowly than they come loses the oldest.
  static constexpr std::size_t kKept = 8192;
  static constexpr std::size_t kMostAtOnce = 1024;  // so long is the lock held

  struct Entry {
    feed::Time at{};
    WireKind kind = WireKind::in;
    std::uint8_t byte = 0;  // of `in` and `out`, as it is on the wire
  };
  struct Batch {
    std::uint64_t from = 0;  // number of the first entry, counted since the line was made
    std::uint64_t lost = 0;  // entries before it that are gone
    std::vector<Entry> entries;
  };

  explicit WireTap(const tape_code::DecodeTable& code) : code_(code) {}

  // On the line's thread.
  [[nodiscard]] bool is_watched() const { return watchers_.load(std::memory_order_relaxed) > 0; }
  void note(WireKind direction, std::span<const std::byte> bytes, feed::Time at) {
    if (is_watched()) keep(direction, bytes, at);
  }
  void note(WireKind event, feed::Time at);
  // The line is gone; whoever watches asks for the next one.
  void end() { ended_ = true; }

  // From any thread. A person looks from now on, until as many leave(). Gives the number of the first entry to look at:
  // what others saw before is shown, too.
  std::uint64_t join();
  void leave();
  [[nodiscard]] bool ended() const { return ended_; }
  // Whether there is one of number `from` or later.
  [[nodiscard]] bool has(std::uint64_t from) const;
  // At most kMostAtOnce entries from number `from` on.
  [[nodiscard]] Batch since(std::uint64_t from) const;
  // How the line's bytes are read.
  [[nodiscard]] const tape_code::DecodeTable& code() const { return code_; }

 private:
  void keep(WireKind direction, std::span<const std::byte> bytes, feed::Time at);

  tape_code::DecodeTable code_;
  std::atomic<std::uint32_t> watchers_ = 0;
  std::atomic<bool> ended_ = false;
  mutable LineMutex mutex_{"a line's tap"};
  std::vector<Entry> ring_;  // empty until the first person looks: the line's thread allocates nothing
  std::uint64_t next_ = 0;
  std::uint64_t since_ = 0;  // the first entry since a person watches without a break
};

}  // namespace dripfeed::app
