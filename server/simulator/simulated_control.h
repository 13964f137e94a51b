// A control at the end of a serial line, in virtual time: what arrives when, what it buffers, when it says DC3 and DC1,
// what it runs and which alarm it raises. No I/O: a driver gives it bytes and the time, and takes what it sends.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/tape_code/framing.h"
#include "server/simulator/block_clock.h"

namespace dripfeed::simulator {

using Time_ns = std::int64_t;

struct ControlSettings {
  tape_code::Framing framing;
  std::uint32_t baud = 9600;
  tape_code::Code code = tape_code::Code::iso;
  std::uint32_t buffer_bytes = 2048;
  std::uint32_t stop_free_bytes = 256;  // DC3 when less is free
  std::uint32_t go_free_bytes = 1024;   // DC1 when more is free
  std::uint32_t overrun_budget = 10;    // characters taken after its own DC3
  std::uint32_t host_latency_chars =
      5;               // its DC3 on the line and the 4-character time-out of a 16550 before the host sees it
  double speed = 1.0;  // runs this much faster than a machine would
  BlockClockSettings clock;
};

enum class ControlState : std::uint8_t { waiting, reading, held, ended, alarm };
std::string_view name_of(ControlState state);

inline constexpr std::size_t kAfterDc3Bins = 33;  // 0..31 characters, and more

struct ControlReport {
  std::uint64_t bytes = 0;  // arrived
  std::uint64_t blocks_run = 0;
  std::uint64_t bytes_run = 0;  // of finished blocks that were run
  std::uint64_t holds = 0;
  std::uint64_t after_dc3_max = 0;
  std::array<std::uint64_t, kAfterDc3Bins> after_dc3{};
  double line_use = 0.0;  // of the time not held, from the first to the last character
  std::uint64_t parity_errors = 0;
  std::string alarm;         // "" or "087 BUFFER OVERFLOW"
  std::uint64_t stalls = 0;  // times that it ran dry before the end
  double stall_s = 0.0;
  ControlState state = ControlState::waiting;
  bool unfinished_block = false;  // the text broke off inside a block; it was not run
};

class SimulatedControl {
 public:
  // `record` gets every wire byte in the order of arrival.
  SimulatedControl(const ControlSettings& settings, std::function<void(std::uint8_t)> record);

  // The operator starts reading: DC1 goes out. After an end, for the next program.
  void start(Time_ns now);
  // The operator presses RESET: whatever was read and not run is dropped, an alarm is cleared.
  void reset();
  // `looked_before`: when the driver last looked and found nothing; the bytes came since, and are taken to have come
  // then. A driver that overslept must not make the host's line look slower than it is.
  void receive(std::span<const std::byte> bytes, Time_ns looked_before, Time_ns now);
  // The time between two looks at the line while it is read.
  [[nodiscard]] std::optional<Time_ns> look_every() const;
  void tick(Time_ns now);
  // Bytes that are due to reach the host now; cleared by the call. A driver that comes late has let its own DC3 leave
  // late: what arrived in between came before it and does not count against the host.
  std::vector<std::byte> take_out(Time_ns now);
  [[nodiscard]] std::optional<Time_ns> deadline() const;
  [[nodiscard]] ControlReport report() const;
  [[nodiscard]] ControlState state() const { return report_.state; }
  // Nothing came, nothing runs and nothing is held since this instant (waiting for the host); nothing while busy.
  [[nodiscard]] std::optional<Time_ns> quiet_since() const;
  // The program ended and everything was run.
  [[nodiscard]] bool finished() const {
    return report_.state == ControlState::ended && pending_.empty() && blocks_.empty() && !running_;
  }

 private:
  struct Arrival {
    std::uint8_t byte;
    Time_ns at;
  };
  struct Due {
    std::byte byte;
    Time_ns at;
  };
  struct Block {
    std::string text;
    std::uint64_t bytes;
  };

  void arrive(const Arrival& arrival);
  void take_character(char c, Time_ns at);
  void finish_block(Time_ns at);
  void run_blocks(Time_ns now);
  void check_flow(Time_ns at);
  void count_after_dc3(Time_ns at);
  void dc3_left(Time_ns late);
  void close_hold(Time_ns at);
  void send(std::uint8_t byte, Time_ns at);
  void raise(std::string_view alarm);
  [[nodiscard]] std::uint64_t free_bytes() const;

  ControlSettings settings_;
  std::function<void(std::uint8_t)> record_;
  Time_ns char_ns_;
  BlockClock clock_;
  std::deque<Arrival> pending_;
  std::deque<Due> out_;
  std::deque<Block> blocks_;
  std::string block_;
  std::uint64_t buffered_ = 0;
  Time_ns last_arrival_ = 0;
  Time_ns first_arrival_ = -1;
  Time_ns held_ns_ = 0;
  Time_ns dc3_at_ = -1;
  std::uint64_t after_dc3_ = 0;
  std::vector<Time_ns> before_dc3_left_;  // arrivals since the decision for a DC3 that take_out() has not given yet
  bool label_skip_ = true;
  bool seen_percent_ = false;
  bool running_ = false;
  Time_ns run_until_ = 0;
  Time_ns idle_since_ = -1;
  Time_ns started_at_ = 0;
  ControlReport report_;
};

}  // namespace dripfeed::simulator
