// The values of a milling cycle's call by Siemens' names, and what of them the cycles share.
#pragma once

#include <cstdint>
#include <string_view>

#include "dialects/ir/mill_cycle.h"

namespace dripfeed::sinumerik {

// The first fault stands: an alarm, or why the call is not interpreted.
class MillCall {
 public:
  MillCall(ir::MillValues values, const ir::MillUnits& units, std::string_view parameters)
      : values_(values), units_(units), parameters_(parameters) {}

  // 0 where it is left out, or where the cycle has none of that name. Lengths in mm; `size` without its sign.
  [[nodiscard]] double number(std::string_view name) const;
  [[nodiscard]] double length(std::string_view name) const { return number(name) * units_.mm; }
  [[nodiscard]] double size(std::string_view name) const;
  [[nodiscard]] double feed(std::string_view name) const { return number(name) * units_.feed_mm; }
  // The digit of that weight; a number that is not whole, or below 0, has the digit 9.
  [[nodiscard]] int digit(std::string_view name, double weight) const;

  void alarm(std::uint32_t number);
  void leave(std::string_view why);

  // RTP, RFP, SDIS, DP, DPR.
  void levels();
  // UMODE, GMODE, DMODE, AMODE.
  void screen_modes();
  void feeds();
  // MID, FAL, FALD: what roughing leaves, and how deep it goes at once.
  void allowances();
  // VARI, units. `may_do_both`: 0 is roughing and finishing.
  void kind(bool may_do_both);
  // VARI, tens, and DP1.
  void entry();
  // MIDA.
  void step();
  // CDIR.
  void direction();
  // LENG, WID, CRAD at PA, PO, turned by STA.
  void rectangle();
  // At PA, PO.
  void circle(double diameter_mm);
  // NUM, LENG, CPA, CPO, RAD, STA1, INDA: along rays from a centre, RAD is where each begins.
  void on_rays();

  ir::MillReading reading;

 private:
  [[nodiscard]] bool is_whole() const { return reading.alarm == 0 && reading.not_interpreted.empty(); }

  ir::MillValues values_;
  ir::MillUnits units_;
  std::string_view parameters_;
};

}  // namespace dripfeed::sinumerik
