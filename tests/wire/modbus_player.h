// Plays a dialog against a mailbox sender: the dialog is the bus and the receiver.
//   > read | open | data SEQ "text" | eof SEQ | hold | idle | abort | nothing     < ok | fail | garbled | foreign |
//   status k=v ...
// The status keeps its values from one reading to the next: session, state, ack, nak, nak_seq, free, consumed, boot,
// has (so many characters of the text are appended), crc=wrong.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "protocol/modbus/modbus.h"
#include "tests/wire/dialog.h"

namespace dripfeed::wire {

using SenderCellTaken = std::pair<modbus::SenderState, modbus::SenderInput>;

class ModbusPlayer {
 public:
  explicit ModbusPlayer(std::set<SenderCellTaken>* cells) : cells_(cells) {}
  // Empty if all went as written, else what did not.
  std::string play(const Dialog& dialog);

 private:
  // A text that may be kept back.
  class Source final : public tape_code::TextSource {
   public:
    explicit Source(std::string text) : text_(std::move(text)) {}
    tape_code::TextPiece next() noexcept override;
    std::size_t ready = SIZE_MAX;
    bool broken = false;

   private:
    std::string text_;
    std::size_t given_ = 0;
  };

  std::string step(const Step& step);
  std::string set(const std::string& rest);
  std::string expect_request(const std::string& rest);
  std::string answer(const std::string& rest);
  std::string change_status(const std::string& rest);
  std::string command(const std::string& rest);
  std::string check(const std::string& rest);
  std::string expect_event(const std::string& rest);
  std::optional<modbus::Request> take(std::chrono::nanoseconds patience);
  void drain();

  std::set<SenderCellTaken>* cells_;
  modbus::SenderSettings settings_;
  std::optional<modbus::Sender> sender_;
  std::string text_ = "%\nO1\nG1X1\nM30\n%\n";
  std::unique_ptr<Source> source_;
  std::size_t ready_ = SIZE_MAX;
  bool wrong_crc_ = false;
  modbus::Status status_{.state = modbus::ReceiverState::idle, .free_blocks = 5, .boot_counter = 1};
  modbus::Time now_{1'000'000'000};
  std::deque<std::string> events_;
};

}  // namespace dripfeed::wire
