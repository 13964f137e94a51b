// Motions written down as plain blocks: the state that blocks have set is kept, and each block says what differs from
// it. Which control prints them is left to others.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "dialects/compile/plain/carried_words.h"
#include "dialects/family/emitter.h"
#include "dialects/interpreter/interpreter.h"
#include "dialects/ir/control.h"
#include "dialects/ir/motion.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

class BlockWriter {
 public:
  // `control` says how the blocks mean their words: lathe or mill, diameter, tool words. `names` must be those of the
  // run.
  BlockWriter(ir::Program& program, const ir::Control& control, const interpreter::RunNames& names, bool inch);

  // Unit, plane, distance, feed mode, compensation off, diameter: before the first motion.
  void safe_start(ir::Plane plane, ir::FeedMode feed_mode);
  // `line` is what Statement::line of its blocks becomes.
  void write(const ir::Motion& motion, std::uint32_t line);
  // Whether the move's block would name positions and nothing else.
  [[nodiscard]] bool states_positions_alone(const ir::Motion& motion) const;
  // The motions of one hole that is tapped in the X-Y plane, as the cycle that makes them.
  void write_tap(std::span<const ir::Motion> hole, std::uint32_t line);
  // The end of a subprogram.
  void write_return(std::uint32_t line);
  // `words` belong to the block that is written next.
  void carry(const CarriedWords& words);
  // A block of these words alone.
  void write_alone(const CarriedWords& words, std::uint32_t line);
  // Carried words that found no block get one of their own.
  void flush(std::uint32_t line);
  // The next block states its motion and feed, whatever blocks before have set.
  void forget(std::uint32_t line);

 private:
  void move(const ir::Motion& motion);
  void tool(const ir::Motion& motion);
  void spindle(const ir::Motion& motion);
  void speed_limit(double limit_rpm);
  void speed(const ir::Motion& motion);
  // After a tool change: all that a program which is entered there needs, with the first move.
  void restate(const ir::Motion& motion);
  void event_block(ir::Function function);
  void message(const ir::Motion& motion);
  void plane(const ir::Motion& motion);
  void feed(const ir::Motion& motion);
  [[nodiscard]] bool has_feed(const ir::Motion& motion) const;
  void center(const ir::Motion& motion);
  [[nodiscard]] bool counts_along_x(const ir::Motion& motion) const;
  void add(ir::Function function, std::int16_t argument = 0) { codes_.push_back({function, argument}); }
  void add(ir::Address address, double value) { words_.push_back({address, emit_.constant(value)}); }
  // Of a length in mm, or of a feed that is a length.
  void add_length(ir::Address address, double value_mm) { add(address, value_mm / unit_mm_); }
  // The block of what was added.
  void block();

  ir::Program& program_;
  const ir::Control& control_;
  const interpreter::RunNames& names_;
  family::Emitter emit_;
  std::vector<family::EmittedCode> codes_;
  std::vector<family::EmittedWord> words_;
  CarriedWords carried_;
  double unit_mm_;

  // What the blocks have set.
  ir::Function motion_ = ir::Function::none;
  ir::Plane plane_ = ir::Plane::xy;
  ir::FeedMode feed_mode_ = ir::FeedMode::per_min;
  double feed_ = 0.0;
  ir::SpindleState spindle_ = ir::SpindleState::stopped;
  bool surface_speed_ = false;
  double limit_rpm_ = 0.0;
  std::int32_t work_offset_ = -1;  // none so far
  std::int32_t tool_number_ = -1;
  std::uint32_t tool_name_ = 0xFFFFFFFFU;
  std::int32_t tool_offset_ = 0;
  bool has_moved_ = false;
  bool restates_ = false;        // the next move does
  bool restates_speed_ = false;  // … and no block has started the spindle since
};

}  // namespace dripfeed::compile
