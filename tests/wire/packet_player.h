// Plays a dialog against a packet sender or receiver; the dialog is the other side.
//   set protocol=NAME role=sender|receiver answer=TIME payload=N name=FILE ...    set text "..."
//   > and < take characters, or a block of XMODEM: short|long NUMBER crc|sum "text" [wrong], or YMODEM's header: header
//   crc|sum "text" [wrong], filled up with NUL
//   * link on|off, arm, disarm, stop, resume, cancel, abort, confirm_reset, reserve N, ready N, broken, room N, start,
//   take (the partner's telegram)
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>

#include "protocol/packet/packet.h"
#include "tests/wire/dialog.h"
#include "tests/wire/feed_player.h"

namespace dripfeed::wire {

struct PacketCells {
  std::set<std::pair<packet::State, packet::Input>> sender;
  std::set<std::pair<packet::ReceiveState, packet::ReceiveInput>> receiver;
};

class RoomySink final : public packet::Sink {
 public:
  std::size_t room() const noexcept override { return space; }
  void append(std::span<const std::byte> bytes) noexcept override {
    for (const std::byte byte : bytes) text += static_cast<char>(byte);
  }
  std::size_t space = 1U << 20;
  std::string text;
};

class PacketPlayer {
 public:
  PacketPlayer(Splits splits, unsigned seed, PacketCells* cells) : splits_(splits), random_(seed), cells_(cells) {}
  // Empty if all went as written, else what did not.
  std::string play(const Dialog& dialog);

 private:
  std::string step(const Step& step);
  std::string set(const std::string& rest);
  std::string bytes_of(const std::string& rest) const;
  std::string expect_out(const std::string& rest);
  std::string give_in(const std::string& rest);
  std::string pass_time(const std::string& rest);
  std::string expect_event(const std::string& rest);
  std::string command(const std::string& rest);
  std::string one_command(const std::string& name, const std::string& argument);
  std::string check(const std::string& rest);
  std::size_t piece(std::size_t most);
  void begin();
  void drain();
  std::span<const std::byte> pending() const { return sender_ ? sender_->pending_out() : receiver_->pending_out(); }
  std::optional<packet::Time> deadline() const { return sender_ ? sender_->deadline() : receiver_->deadline(); }
  void tick();

  Splits splits_;
  std::mt19937 random_;
  PacketCells* cells_;
  packet::Settings settings_;
  bool receives_ = false;
  std::string text_ = "%\nO1\nG1X1\nM30\n%\n";
  std::string name_;
  std::optional<packet::Sender> sender_;
  std::optional<packet::Receiver> receiver_;
  RoomySink sink_;
  std::unique_ptr<StagedSource> source_;
  std::size_t ready_ = SIZE_MAX;
  packet::Time now_{1'000'000'000};
  std::deque<std::string> events_;
};

}  // namespace dripfeed::wire
