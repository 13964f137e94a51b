// A control that reads its program in packets: XMODEM, YMODEM, 3964(R), the remote buffer's protocol A. It acknowledges
// a packet when its buffer has room for another, runs whole blocks only, and is in alarm when the transfer breaks.
#pragma once

#include "protocol/packet/packet.h"
#include "server/simulator/control.h"
#include "server/simulator/tape_reader.h"

namespace dripfeed::simulator {

// What a control with these settings says of its packets.
packet::Settings packet_settings(const ControlSettings& settings, packet::Protocol protocol);

class PacketControl final : public Control, private packet::Sink {
 public:
  // `record` gets the text in the frames, as it is coded and with what fills the last one, not the frames.
  PacketControl(const ControlSettings& settings, Record record);

  void start(Time_ns now) override;
  void reset() override;
  void receive(std::span<const std::byte> bytes, Time_ns looked_before, Time_ns now) override;
  void tick(Time_ns now) override;
  std::vector<std::byte> take_out(Time_ns now) override;
  [[nodiscard]] std::optional<Time_ns> deadline() const override;
  [[nodiscard]] std::optional<Time_ns> look_every() const override { return std::nullopt; }
  [[nodiscard]] ControlReport report() const override;
  [[nodiscard]] ControlState state() const override { return report_.state; }
  [[nodiscard]] std::optional<Time_ns> quiet_since() const override;
  [[nodiscard]] bool is_inside_program() const override {
    return report_.state == ControlState::reading && tape_.has_begun() && !tape_.at_end();
  }
  [[nodiscard]] bool finished() const override;

 private:
  [[nodiscard]] std::size_t room() const noexcept override;
  void append(std::span<const std::byte> bytes) noexcept override;
  void judge();
  void raise(std::string_view alarm);

  ControlSettings settings_;
  Record record_;
  tape_code::EighthBit eighth_bit_;
  packet::Receiver receiver_;
  TapeReader tape_;
  Time_ns now_ = 0;
  Time_ns last_arrival_ = 0;
  Time_ns first_arrival_ = -1;
  ControlReport report_;
};

}  // namespace dripfeed::simulator
