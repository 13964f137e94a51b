// What comes in on a line while nothing is fed: the receiver with its bytes, on the links' thread. Finished receptions
// wait for whoever judges and keeps them, on another thread.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "protocol/receive/receiver.h"
#include "server/app/lines/line.h"
#include "server/app/ports/line_mutex.h"

namespace dripfeed::app {

class LineInput {
 public:
  // Receptions that wait. From half of it on the control is held where the profile has a hold; beyond it one is lost
  // and counted.
  static constexpr std::size_t kMaxWaiting = 16;

  explicit LineInput(const receive::Settings& settings) : receiver_(settings) {}

  // One byte. The reception that it ended, if it did.
  std::optional<receive::EndedBy> take(std::byte byte, receive::Time now);
  void tick(receive::Time now);
  void link_lost(receive::Time now);
  [[nodiscard]] std::optional<receive::Time> deadline() const { return receiver_.deadline(); }
  [[nodiscard]] bool idle() const { return receiver_.state() == receive::State::idle; }
  [[nodiscard]] std::span<const std::byte> pending_out() const { return receiver_.pending_out(); }
  void mark_sent(std::size_t n) { receiver_.mark_sent(n); }
  // The control is asked to wait, by a DC3 or by what our RTS should be.
  [[nodiscard]] bool holding() const { return receiver_.holding(); }
  [[nodiscard]] bool rts() const { return receiver_.rts(); }
  // Receptions that ended since the start, lost ones among them.
  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] std::uint64_t lost() const { return lost_; }

  // From any thread.
  std::vector<Reception> take_finished();

 private:
  void collect(receive::Time now);

  receive::Receiver receiver_;
  std::vector<std::byte> raw_;
  std::uint64_t count_ = 0;
  std::uint64_t lost_ = 0;
  std::optional<receive::EndedBy> ended_by_;
  LineMutex mutex_{"a line's receptions"};
  std::vector<Reception> finished_;
};

}  // namespace dripfeed::app
