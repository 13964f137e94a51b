// What the server's machines do, as Modbus registers for a PLC to read. One unit a machine; who has which unit is
// stated by a person, never derived, so that a machine that is added moves no other. Input and holding registers are
// the same; 32-bit values have the high word first; nothing can be written.
//
//   0      magic DF02h, which proves unit and byte order; 1: version of this map, 1
//   2      heartbeat: seconds of the server's clock, modulo 65536
//   3      state: 0 disconnected, 1 idle, 2 armed, 3 feeding, 4 held, 5 draining, 6 torn, 65535 no line yet
//   4      stall: 0 none, 1 waiting for DC1, 2 held by DC3, 3 CTS off, 4 peer gone, 5 waiting for ledger, 6 waiting for
//          text, 7 waiting for end, 8 stopped, 9 waiting for credit, 10 waiting for receiver, 11 stopped by a fault,
//          12 machine held, 13 machine alarm, 14 machine in emergency stop, 255 another
//   5      how the last job ended: 0 not, 1 done, 2 failed, 3 cancelled, 4 disarmed
//   6-7    job number, 0 none since the start
//   8-9    bytes of the job in total, 10-11 handed, 12-13 clocked, 14-15 confirmed
//   16-17  line (1-based) that the last confirmed or clocked byte lies in, 18-19 that of the last byte handed; 0
//   unknown 20     bit 0: the protocol confirms; 1: the budget is estimated; 2: a person's stop is in force; 3: the
//   link is down 21-36  name of the machine, 2 characters a register, the first in the high byte, filled with 0
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "protocol/modbus/register_server.h"
#include "server/app/out/events.h"
#include "server/app/ports/clock.h"

namespace dripfeed::app {

class StatusRegisters final : public modbus::RegisterView {
 public:
  static constexpr std::size_t kCount = 37;
  static constexpr std::uint16_t kMagic = 0xDF02;
  static constexpr std::uint16_t kVersion = 1;

  // Both must outlive this. machines: the unit of each, 1 to 247.
  StatusRegisters(const Events& events, const Clock& clock, std::map<std::uint8_t, std::string> machines)
      : events_(events), clock_(clock), machines_(std::move(machines)) {}

  bool has_unit(std::uint8_t unit) override { return machines_.contains(unit); }
  bool read(std::uint8_t unit, std::uint16_t first, std::span<std::uint16_t> into) override;

 private:
  const Events& events_;
  const Clock& clock_;
  std::map<std::uint8_t, std::string> machines_;
};

}  // namespace dripfeed::app
