// Rigid taps in the order of the text: what stands between M29 and its tapping cycle, and in a synchronous tap.
#pragma once

#include <cstdint>
#include <string_view>

#include "dialects/ir/alarm_details.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/macro_b/validator/findings.h"

namespace dripfeed::macro_b {

class TapOrder {
 public:
  // All must outlive it.
  TapOrder(const ir::Program& program, const ir::Control& control, Findings& findings);

  // `moves`: it moves axes.
  void block(const ir::Block& block, bool moves);
  void end(text::Span span);  // of the program
  void forget();

 private:
  void rigid_tap(const ir::Block& block, bool moves);
  void speed_in_tap(const ir::Block& block);
  [[nodiscard]] bool names_synchronous(const ir::Block& block) const;
  void add(text::Span span, std::string_view what, ir::AlarmDetail detail);

  const ir::Program& program_;
  const ir::Control& control_;
  Findings& findings_;
  bool has_rigid_taps_;
  bool has_taps_;  // the text has a tapping cycle
  enum class Rigid : std::uint8_t { off, waits, taps } rigid_ = Rigid::off;
  bool sync_tap_ = false;
};

}  // namespace dripfeed::macro_b
