// The moves of a tapping cycle, in and out by the lead, as the other control says them:
//
//   M19                    SPOS, then G331 and G332: the spindle is turned by its position
//   G331 Z-20. K1.5 S300
//   G332 Z2. K1.5
//   G94                    G63 twice: in a compensating chuck
//   G63 Z-20. F450.
//   G63 Z2. M4
//   S300                   G84 along Z and G88 along X, with M29, ,R1 or as G84.2 where it is rigid
//   M29
//   G84 Z-20. R0. F1.5
//   G80
#pragma once

#include <expected>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dialects/compile/translate/plain_moves.h"
#include "dialects/ir/control.h"
#include "dialects/ir/motion.h"
#include "dialects/ir/program.h"
#include "dialects/passes/rewrite.h"

namespace dripfeed::compile {

struct TapCut {
  std::size_t axis = 2;
  double level = 0.0;
  double depth = 0.0;
  double lead_mm = 0.0;  // below 0: left-hand, of a rigid tap
  double speed_rpm = 0.0;
  double dwell_s = 0.0;
  ir::SpindleState in = ir::SpindleState::stopped;
  ir::SpindleState out = ir::SpindleState::stopped;
  std::size_t count = 0;  // of motions
};

// The tap that begins with the first of these motions; nothing where that is a plain move. The error names what of it
// is no tap that could be written.
std::expected<std::optional<TapCut>, std::string> tap_at(std::span<const ir::Motion> motions);

class TapMoves {
 public:
  TapMoves(ir::Program& program, passes::Rewrite& out, const BlockTerms& terms, const ir::Control& to, bool rigid)
      : program_(program), out_(out), terms_(terms), to_(to), rigid_(rigid), plain_(program, out, terms) {}

  // The error names what of them cannot be written.
  std::expected<void, std::string> write(std::span<const ir::Motion> motions, BlockRest rest);
  [[nodiscard]] PlainMoves& plain() { return plain_; }

 private:
  std::expected<void, std::string> write(const TapCut& tap);
  std::expected<void, std::string> write_cycle(const TapCut& tap);
  void write_rigid(const TapCut& tap);
  void write_floating(const TapCut& tap);
  void feed_per_minute();
  void turn(ir::SpindleState to, double speed_rpm);
  ir::Word length(ir::Address address, double value_mm);
  ir::Word number(ir::Address address, double value);

  ir::Program& program_;
  passes::Rewrite& out_;
  BlockTerms terms_;
  const ir::Control& to_;
  bool rigid_;
  PlainMoves plain_;
  std::optional<ir::SpindleState> state_;  // that the written blocks left; nothing: it is to be stated
  bool changed_feed_mode_ = false;
};

}  // namespace dripfeed::compile
