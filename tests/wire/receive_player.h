// Plays a dialog against a receiver in virtual time, as a driver would, and judges what it received.
//   set eighth=even|odd|data|clear quiet=ms short=ms end=04 hold=dc3|rts|none max=N eia=yes|no
//   < characters          * full | room | link off        > out        = state NAME | rts on|off
//   ! ENDED_BY FAULT CODE "text"
#pragma once

#include <deque>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "protocol/receive/transfer.h"
#include "tests/wire/dialog.h"

namespace dripfeed::wire {

enum class Cuts { whole, single_bytes, random };

// A receiver with its driver: what came out, judged.
class ReceiveDriver {
 public:
  explicit ReceiveDriver(const receive::Settings& settings) : receiver(settings) {}
  void give(std::span<const std::byte> bytes, receive::Time now);
  void take();

  struct Got {
    receive::Ending ending;
    receive::Transfer transfer;
    std::vector<std::byte> raw;
  };
  receive::Receiver receiver;
  std::deque<Got> got;

 private:
  std::vector<std::byte> raw_;
};

class ReceivePlayer {
 public:
  ReceivePlayer(Cuts cuts, unsigned seed, std::set<std::size_t>* rows) : cuts_(cuts), random_(seed), rows_(rows) {}
  // Empty if all went as written, else what did not.
  std::string play(const Dialog& dialog);

 private:
  std::string step(const Step& step);
  std::string set(const std::string& rest);
  std::string give_in(const std::string& rest);
  std::string command(const std::string& rest);
  std::string check(const std::string& rest);
  std::string expect_out(const std::string& rest);
  std::string expect_got(const std::string& rest);
  ReceiveDriver& driver();

  Cuts cuts_;
  std::mt19937 random_;
  std::set<std::size_t>* rows_;
  receive::Settings settings_{.hold = receive::Hold::dc3};
  std::optional<ReceiveDriver> driver_;
  receive::Time now_{1'000'000'000};
};

}  // namespace dripfeed::wire
