// Motions as blocks in the terms of the program that they are put into: its unit, its diameter, its plane.
#pragma once

#include <expected>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/motion.h"
#include "dialects/ir/program.h"
#include "dialects/passes/rewrite.h"

namespace dripfeed::compile {

// What holds where the blocks are put.
struct BlockTerms {
  double unit_mm = 1.0;  // of lengths and feeds
  double x_scale = 1.0;  // of the values that motions have for X
  ir::WordMode mode = ir::WordMode::as_modal;
  ir::Plane plane = ir::Plane::xy;
  ir::FeedMode feed_mode = ir::FeedMode::per_min;
  bool dwell_p_is_ms = false;
  int decimals = 3;  // of lengths, in mm
};

// Codes and words of the replaced block that are no part of what is replaced.
struct BlockRest {
  std::vector<ir::Code> before;  // a block of its own, in front of the moves
  std::vector<ir::Code> codes;   // with the first move
  std::vector<ir::Word> words;
  std::vector<ir::Code> after;  // a block of its own, after them
};

ir::Code motion_code(ir::Function function);

class PlainMoves {
 public:
  PlainMoves(ir::Program& program, passes::Rewrite& out, const BlockTerms& terms)
      : program_(program), out_(out), terms_(terms) {}

  // The error names what of them has no plain block.
  std::expected<void, std::string> write(std::span<const ir::Motion> motions, BlockRest rest);
  // What the last F stated; nothing where there was none.
  [[nodiscard]] std::optional<double> last_feed() const { return feed_; }
  // F was stated in a block of moves; nothing: it counts no longer.
  void set_last_feed(std::optional<double> feed) { feed_ = feed; }
  ir::Word feed_word(double feed);
  ir::Word position(std::size_t axis, double value);
  void dwell(double seconds);

 private:
  std::expected<void, std::string> event(const ir::Motion& motion, const BlockRest& rest);
  std::expected<void, std::string> move(const ir::Motion& motion, BlockRest& rest);
  void flush(BlockRest& rest);
  [[nodiscard]] double rounded(double value_mm) const;

  ir::Program& program_;
  passes::Rewrite& out_;
  BlockTerms terms_;
  std::optional<double> feed_;
  ir::Function comp_ = ir::Function::none;  // begins or ends with the next move
};

}  // namespace dripfeed::compile
