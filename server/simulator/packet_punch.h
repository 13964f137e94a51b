// A control that punches in packets: it is the sender of XMODEM, YMODEM or 3964(R), or plays the remote buffer's host.
// One text, once the host asks for it; in alarm when the transfer breaks.
#pragma once

#include <string>
#include <vector>

#include "protocol/packet/packet.h"
#include "protocol/tape_code/text_source.h"
#include "server/simulator/control.h"

namespace dripfeed::simulator {

class PacketPunch final : public Control {
 public:
  // `settings.punches` with LF as EOB, a whole program; `settings.protocol` is "punch-" and the name of a packet
  // protocol. Nothing is read, so nothing is recorded.
  PacketPunch(const ControlSettings& settings, Record record);

  void start(Time_ns now) override;
  void reset() override;
  void receive(std::span<const std::byte> bytes, Time_ns looked_before, Time_ns now) override;
  void tick(Time_ns now) override;
  std::vector<std::byte> take_out(Time_ns now) override;
  [[nodiscard]] std::optional<Time_ns> deadline() const override;
  [[nodiscard]] std::optional<Time_ns> look_every() const override { return std::nullopt; }
  [[nodiscard]] ControlReport report() const override { return report_; }
  [[nodiscard]] ControlState state() const override { return report_.state; }
  [[nodiscard]] std::optional<Time_ns> quiet_since() const override;
  [[nodiscard]] bool is_inside_program() const override { return false; }
  [[nodiscard]] bool finished() const override { return report_.state == ControlState::ended; }
  [[nodiscard]] bool speaks_first() const override { return true; }

 private:
  void judge();

  std::string text_;
  tape_code::SpanSource source_;
  packet::Sender sender_;
  Time_ns now_ = 0;
  Time_ns last_sign_ = 0;
  ControlReport report_;
};

}  // namespace dripfeed::simulator
