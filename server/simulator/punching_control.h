// A control that punches: DC2, leader, its text in its code, trailer, DC4, at the pace of its line, held by the host's
// DC3. Afterwards its operator presses READ, so that it reads what the host answers. In virtual time, as all controls.
#pragma once

#include <string>
#include <vector>

#include "server/simulator/simulated_control.h"

namespace dripfeed::simulator {

class PunchingControl final : public Control {
 public:
  // `settings.punches` with LF as EOB. `record` gets what it reads afterwards.
  PunchingControl(const ControlSettings& settings, Record record);

  void start(Time_ns now) override;
  void reset() override;
  void receive(std::span<const std::byte> bytes, Time_ns looked_before, Time_ns now) override;
  void tick(Time_ns now) override;
  std::vector<std::byte> take_out(Time_ns now) override;
  void left_late(Time_ns by) override {
    if (reading_) reader_.left_late(by);
  }
  [[nodiscard]] std::optional<Time_ns> deadline() const override;
  [[nodiscard]] std::optional<Time_ns> look_every() const override;
  [[nodiscard]] ControlReport report() const override { return reader_.report(); }
  [[nodiscard]] ControlState state() const override;
  [[nodiscard]] std::optional<Time_ns> quiet_since() const override;
  [[nodiscard]] bool is_inside_program() const override { return reading_ && reader_.is_inside_program(); }
  [[nodiscard]] bool finished() const override;
  [[nodiscard]] bool speaks_first() const override { return true; }
  // Characters that left.
  [[nodiscard]] std::uint64_t punched() const { return next_; }

 private:
  [[nodiscard]] bool all_punched() const { return next_ == wire_.size(); }

  SimulatedControl reader_;
  bool reads_;
  Time_ns char_ns_;
  std::vector<std::byte> wire_;
  std::size_t next_ = 0;
  Time_ns begun_at_ = -1;
  Time_ns due_ = 0;  // of the next character
  bool held_ = false;
  Time_ns ended_at_ = -1;  // the punch
  bool reading_ = false;
};

}  // namespace dripfeed::simulator
