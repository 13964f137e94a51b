// A called hole as blocks of these controls: their modal cycle, or the moves that it makes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/macro_b/writer/called_hole.h"
#include "dialects/macro_b/writer/drill_place.h"
#include "dialects/passes/rewrite.h"

namespace dripfeed::macro_b {

class HoleWriter {
 public:
  // All must outlive it. What a hole leaves in effect is given to `place`.
  HoleWriter(ir::Program& program, const ir::Control& to, DrillPlace& place, passes::Rewrite& out)
      : program_(program), to_(to), place_(place), out_(out) {}

  // Whether a modal cycle does the same here.
  [[nodiscard]] bool fits_modal_cycle(const Hole& hole) const;
  // Whether it is what write_moves() writes; what hinders it is reported.
  bool has_moves(const Hole& hole);

  // Holes at each position that follows, up to end_modal().
  void begin_modal(const Hole& hole) { write_cycle(hole, true, false); }
  void end_modal(const Hole& hole);
  // One hole where the tool stands.
  void write_hole(const Hole& hole);
  void write_moves(const Hole& hole);

  // G90 or G91 as the paths here have it.
  void state_distance();
  // The motion code that was in effect; `always`: after G80, where another than G00 is not certain either.
  void motion_again(bool always);
  void emit_code(ir::Function function);
  ir::Word absolute(ir::Address address, double value) { return absolute(address, constant(value)); }

 private:
  // Of a plane, and the axis that stands on it.
  struct PlaneAxes {
    ir::Address first, second, normal;
  };
  static PlaneAxes axes_of(ir::Function plane);

  void write_cycle(const Hole& hole, bool modal, bool to_level);
  void end_hole(const Hole& hole);
  void add_tap(const Hole& hole, ir::Code& drill, std::vector<ir::Word>& words);
  void write_by_cycle(const Hole& hole);
  void cut(const Hole& hole, ir::Address axis);
  void draw_out(const Hole& hole, const PlaneAxes& axes);
  void shift(const Hole& hole, const PlaneAxes& axes, double sign, double lift);
  void turn_again(const Hole& hole);
  // How the spindle turns on the approach; nothing where that is not known.
  [[nodiscard]] std::optional<ir::Function> cutting_direction(const Hole& hole) const;
  [[nodiscard]] std::optional<double> number(ir::ExpressionId id) const { return constant_value(program_, id); }

  ir::ExpressionId constant(double value) { return program_.add_constant(value, {}, true); }
  ir::ExpressionId whole(double value) { return program_.add_constant(value, {}, false); }
  ir::Word absolute(ir::Address address, ir::ExpressionId value);
  ir::Word by(ir::Address axis, double distance);
  ir::Word feed(double value);

  ir::Program& program_;
  const ir::Control& to_;
  DrillPlace& place_;
  passes::Rewrite& out_;
};

}  // namespace dripfeed::macro_b
