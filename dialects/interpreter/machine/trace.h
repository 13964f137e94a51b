// The canonical trace: one line for each motion and event, the same for every control. It only formats what the
// interpreter emits.
//
//   [@k:]LINE KIND words            @k NAME declares the k-th called program before its first line
//   12 linear X10.0000 Y0.0000 Z-1.0000 F900.0000/min
//   13 arc-cw X20.0000 Y0.0000 Z-1.0000 G17 I5.0000 J0.0000 K0.0000 F900.0000/min
//   rapid … | thread … F1.5000/rev [+0.1000/rev2: by which the lead grows in each turn] | dwell P1.5000 (s) | offset 2
//   | tool 6 [offset 16] | tool "NAME" | comp left|right|off | spindle cw|ccw S500.0000/rpm | spindle cw
//   S200.0000/m_min [limit 3200.0000] | spindle off | coolant flood|mist|off | message "text" | stop program|optional |
//   end
//
// Every move prints all axes of the control in the order X Y Z A B C U V W; a move in machine coordinates ends with
// G53. Within one block the order is: offset, tool, spindle on, coolant on, comp, the move or dwell, coolant off,
// spindle off, stop, end.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/interpreter/interpreter.h"
#include "dialects/ir/control.h"
#include "dialects/ir/motion.h"

namespace dripfeed::interpreter {

// A sink that writes trace lines, each ended by LF, into a text that is kept or handed on a batch at a time.
class TraceWriter : public ir::MotionSink {
 public:
  using Consumer = std::function<void(std::string_view)>;
  // `names` is what the run fills (RunOptions::names). Without a consumer the whole trace is kept: see text().
  TraceWriter(const ir::Control& control, const RunNames& names, Consumer consumer = {});

  void consume(std::span<const ir::Motion> motions) override;
  // What was written and not handed to a consumer.
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void write(const ir::Motion& motion);
  void write_head(const ir::Motion& motion);
  void write_move(const ir::Motion& motion);
  void write_event(const ir::Motion& motion);
  void append_word(std::string_view letter, double value);

  const RunNames& names_;
  std::vector<ir::Axis> axes_;
  bool edges_;  // the control's D is a tool's edge
  bool pairs_;  // T names tool and offset (T0606)
  Consumer consumer_;
  std::vector<bool> declared_;  // by program
  std::string text_;
};

}  // namespace dripfeed::interpreter
