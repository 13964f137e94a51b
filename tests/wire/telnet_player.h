// Plays a dialog against a COM-port client in virtual time; bytes come in whole, byte by byte or at random splits.
//   * begin | drop | purge | dtr on|off | rts on|off | break on|off | send BYTES TAKEN
//   = state NAME | data BYTES (what came through since the last look)
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <string>

#include "protocol/telnet/telnet.h"
#include "tests/wire/dialog.h"

namespace dripfeed::wire {

class TelnetPlayer {
 public:
  enum class Splits : std::uint8_t { whole, single_bytes, random };
  TelnetPlayer(Splits splits, unsigned seed) : splits_(splits), random_(seed) {}
  // Empty if all went as written, else what did not.
  std::string play(const Dialog& dialog);
  [[nodiscard]] std::uint32_t rows_taken() const { return client_ ? client_->rows_taken() : 0; }

 private:
  std::string step(const Step& step);
  void set(const std::string& rest);
  std::string expect_out(const std::string& rest);
  std::string take_out();
  void give_in(const std::string& rest);
  void pass_time(const std::string& rest);
  std::string expect_event(const std::string& rest);
  std::string command(const std::string& rest);
  std::string check(const std::string& rest);
  telnet::ComPortClient& client();
  void drain();

  Splits splits_;
  std::mt19937 random_;
  telnet::ComPortSettings settings_;
  std::optional<telnet::ComPortClient> client_;
  telnet::Time now_{1'000'000'000};
  std::string data_;
  std::deque<std::string> events_;
};

}  // namespace dripfeed::wire
