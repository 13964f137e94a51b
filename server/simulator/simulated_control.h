// The control that reads a program under DC1 and DC3, in virtual time: what arrives when, what it buffers, when it says
// DC3 and DC1, what it runs and which alarm it raises.
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/tape_code/code_table.h"
#include "server/simulator/control.h"

namespace dripfeed::simulator {

class SimulatedControl final : public Control {
 public:
  SimulatedControl(const ControlSettings& settings, Record record);

  void start(Time_ns now) override;
  void reset() override;
  void receive(std::span<const std::byte> bytes, Time_ns looked_before, Time_ns now) override;
  void tick(Time_ns now) override;
  std::vector<std::byte> take_out(Time_ns now) override;
  void left_late(Time_ns by) override;
  [[nodiscard]] std::optional<Time_ns> deadline() const override;
  [[nodiscard]] std::optional<Time_ns> look_every() const override;
  [[nodiscard]] ControlLines lines() const override { return lines_; }
  [[nodiscard]] ControlReport report() const override;
  [[nodiscard]] ControlState state() const override { return report_.state; }
  [[nodiscard]] std::optional<Time_ns> quiet_since() const override;
  [[nodiscard]] bool is_inside_program() const override {
    return report_.state == ControlState::reading && (seen_percent_ || !label_skip_);
  }
  [[nodiscard]] bool finished() const override {
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
  [[nodiscard]] bool strikes(const Arrival& arrival);
  void take_character(char c, Time_ns at);
  void take_eia(const Arrival& arrival);
  void finish_block(Time_ns at);
  void start_reading(Time_ns at);
  void stop_reading(Time_ns at);
  void run_blocks(Time_ns now);
  void check_flow(Time_ns at);
  void count_after_dc3(Time_ns at);
  void dc3_left(Time_ns late);
  void dc1_left(Time_ns late);
  [[nodiscard]] bool is_before_own_stop(Time_ns at) const;
  void close_hold(Time_ns at);
  void send(std::uint8_t byte, Time_ns at);
  void raise(std::string_view alarm);
  [[nodiscard]] std::uint64_t free_bytes() const;

  ControlSettings settings_;
  Record record_;
  Time_ns char_ns_;
  std::optional<tape_code::DecodeTable> eia_;
  ControlLines lines_;
  bool silent_ = false;
  BlockClock clock_;
  std::deque<Arrival> pending_;
  std::deque<Due> out_;
  std::deque<Block> blocks_;
  std::uint64_t block_characters_ = 0;  // of the present one, for the TV check
  std::string block_;
  std::uint64_t buffered_ = 0;
  std::optional<std::uint64_t> buffer_min_;
  Time_ns last_arrival_ = 0;
  Time_ns first_arrival_ = -1;
  Time_ns held_ns_ = 0;
  Time_ns dc3_at_ = -1;
  Time_ns dc3_due_at_ = -1;    // when it should have left; dc3_at_ is when it did
  std::uint64_t excused_ = 0;  // characters of this hold that came because our DC3 left late
  bool took_dc3_ = false;      // by the last take_out()
  bool took_dc1_ = false;
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
