// From a family with its values to a program. What is built of the order of the steps stands in build.cpp, moves and
// feeds in build_moves.cpp, what the machine switches in build_machine.cpp.
#pragma once

#include <span>
#include <vector>

#include "dialects/family/build_names.h"
#include "dialects/family/drill_writer.h"
#include "dialects/family/emitter.h"
#include "dialects/family/loop_writer.h"
#include "dialects/family/value_writer.h"
#include "dialects/ir/motion.h"

namespace dripfeed::family {

class Builder {
 public:
  explicit Builder(const BoundFamily& bound)
      : bound_(bound),
        family_(*bound.family),
        names_(bound),
        emit_(program_),
        values_(bound, names_, program_, emit_),
        drill_(bound, values_, emit_),
        loops_(family_, names_, program_, values_, emit_),
        has_one_feed_mode_(!sets(StepKind::feed, kFeedPerRev) || !sets(StepKind::feed, kFeedPerMin)),
        uses_surface_speed_(sets(StepKind::spindle, kSurfaceSpeed)) {}

  ir::Program build();

 private:
  [[nodiscard]] bool sets(StepKind kind, Dimension dimension) const;

  // Lets and lists in the order of the text.
  void define();
  void build_list(const List& list);
  void safe_start();

  // Returns the last step that was built. What a control may skip stands in blocks of its own: nothing that waits goes
  // into them, and the next block states again what they might have set. What is computed for them is computed always.
  std::size_t build_step(std::size_t at);
  std::size_t build_one(std::size_t at);
  void set(const Step& step);

  // Of a condition that is decided now only one branch is built.
  std::size_t if_begin(std::size_t at);
  std::size_t if_else(std::size_t at);
  void if_end();
  std::vector<EmittedWord> words(const Step& step);

  // Compensation begins and ends with a straight move: its code goes into the next one's block.
  void move(ir::Function motion, const Step& step);
  void arc(ir::Function motion, const Step& step);
  void take_feed(std::vector<EmittedWord>& words);

  // F of a tap or a thread is its pitch, and an entry has its own: the feed before is written again after them. Where
  // that may be one of several, or a value that has changed, a variable of its own keeps it.
  [[nodiscard]] bool keeps_feed() const;
  // A number, or a name that no step gives a value.
  [[nodiscard]] bool is_declared(ir::ExpressionId id) const;
  ir::ExpressionId say_feed(const Step& step);

  // Each has its pitch: on controls that have it in F the next cut writes the feed again.
  void thread(const Step& step);
  void drill_begin(const Step& step);
  void hole(const Step& step);
  void drill_end();

  // An M function stands for it until it is printed. What it may have changed is stated again after it.
  void native(const Step& step);

  // The code, unless it is in effect.
  void take_motion(ir::Function motion, std::vector<EmittedCode>& codes);

  // After these another block may have come before: what is in effect there is not known.
  static bool joins_paths(StepKind kind);

  // Of an `if`, its `else` and its end: whether there is one path alone, the branch that is built.
  [[nodiscard]] bool is_decided(const Step& step) const;
  void work_offset(const Step& step);

  // The first edge of the tool, as controls with edges say it; others make their own offset number of it.
  void tool(const Step& step);
  void spindle(const Step& step);

  static constexpr ir::Function kPlanes[] = {ir::Function::plane_xy, ir::Function::plane_zx, ir::Function::plane_yz};
  static constexpr ir::Function kCompensation[] = {ir::Function::comp_off, ir::Function::comp_left,
                                                   ir::Function::comp_right};
  void coolant(const Step& step);

  // Into the block of the next cut, unless something comes between that is on one path only.
  void feed(const Step& step);

  // In a block of its own, from where it waits for a move on one path only.
  void write_compensation();
  void write_feed();

  // The plane of the face counts inside of it.
  void polar_begin();
  void polar_end();
  void cylinder_begin(const Step& step);
  void transformation(std::int16_t use, std::span<const EmittedWord> words);

  // Seconds, as controls say it that count a dwell in F.
  void dwell(const Step& step);

  const BoundFamily& bound_;
  const Family& family_;
  BuildNames names_;
  ir::Program program_;
  Emitter emit_;
  ValueWriter values_;
  DrillWriter drill_;
  LoopWriter loops_;
  bool has_one_feed_mode_;                          // the start of the program states it for all
  bool uses_surface_speed_;                         // otherwise the start of the program ends it
  std::vector<bool> decided_;                       // of open `if`s: only one branch is built
  ir::Function compensation_ = ir::Function::none;  // waits for the next move
  ir::Function motion_ = ir::Function::none;        // in effect, as far as that is known
  const Step* feed_ = nullptr;                      // waits for the next cut
  const Step* last_feed_ = nullptr;                 // in the order of the text
  ir::SymbolId feed_now_ = ir::SymbolId::none;      // keeps the feed while taps and threads are cut
};

}  // namespace dripfeed::family
