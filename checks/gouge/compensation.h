// The path of a mill's axis under cutter compensation (G41, G42) in the x-y plane, as controls lead it. Moves come in
// as they are programmed and leave as the axis makes them, without compensation; which radius the control takes is the
// caller's.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "checks/finding.h"
#include "dialects/curves/path.h"
#include "dialects/ir/motion.h"

namespace dripfeed::gouge {

// How an outer corner is passed: around it by an arc (SINUMERIK's G450), or by straight moves to where the offset lines
// meet, cut off a radius beyond the corner where it is sharper than a right angle (controls with Custom Macro B).
enum class OuterCorner : std::uint8_t { arc, straight };

class Compensation {
 public:
  // `notes` gets what the control would refuse, or what was assumed; it must outlive this.
  Compensation(OuterCorner corner, checks::NotCheckedList& notes) : corner_(corner), notes_(notes) {}

  // A move in work coordinates; arcs in the x-y plane. `radius_mm` >= 0 counts while motion.comp is on.
  void add(const ir::Motion& move, double radius_mm);
  // Nothing follows that the last end could depend on.
  void flush();
  // Where the axis stands is not known any more.
  void forget();
  // The moves of the axis that have become known since they were cleared, in order.
  [[nodiscard]] std::span<const ir::Motion> known() const { return out_; }
  void clear_known() { out_.clear(); }
  // Moves without compensation are what the axis makes, and nothing waits.
  [[nodiscard]] bool is_idle() const { return !pending_ && offset_ == curves::Point{}; }

 private:
  // A move in the plane whose end waits for the next one. Points are x and y, in this order.
  struct Piece {
    ir::Motion move;
    curves::PathPiece path;
    curves::PathPiece led;  // next to it by the radius
    double from = 0.0;      // where on `led` it begins: 0..1, beyond it on lines
    double radius = 0.0;
    bool is_start_up = false;  // the straight line to the next piece's beginning
    bool has_path = true;      // its start is known
    curves::Point start_up_from;
  };

  [[nodiscard]] Piece piece_of(const ir::Motion& move, double radius);
  void join(Piece next);
  void pass_outer_corner(const Piece& before, const Piece& after);
  void close(double to);            // the pending piece ends there on its led path
  void close_at(curves::Point at);  // the pending start-up ends there
  void end_waiting(curves::Point programmed, curves::Point led);
  void lead_away(const ir::Motion& move);
  void emit_straight(const ir::Motion& like, curves::Point from, curves::Point to);
  void emit_piece(const ir::Motion& move, const curves::PathPiece& piece);

  OuterCorner corner_;
  checks::NotCheckedList& notes_;
  std::optional<Piece> pending_;
  std::vector<ir::Motion> waiting_;  // after it, without a path in the plane
  std::vector<ir::Motion> out_;
  curves::Point offset_;  // of the axis from the programmed place, where the last known move ended
};

}  // namespace dripfeed::gouge
