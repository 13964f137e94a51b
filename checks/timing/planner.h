// The look-ahead plan: at which speed each piece of path begins and ends, and how long it takes, with trapezoids of
// speed. Exact for a path of any length in bounded memory, whatever the size of its pieces. What limits the speed at a
// corner is decided by who appends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace dripfeed::timing {

// "No limit" of a speed or an acceleration: large, but finite, so that sums and quotients stay numbers.
inline constexpr double kNoLimit = 1e15;

// Lengths in mm, speeds in mm/s as squares, accelerations in mm/s².
struct PlannedPiece {
  double length = 0.0;
  double speed2 = 0.0;        // highest along the piece, > 0
  double start2 = 0.0;        // highest at its start; 0: it starts from rest
  double acceleration = 0.0;  // along the path, > 0
};

class PlanSink {
 public:
  PlanSink() = default;
  PlanSink(const PlanSink&) = delete;
  PlanSink& operator=(const PlanSink&) = delete;
  virtual ~PlanSink() = default;
  // In the order of appending. `start` and `end` are speeds in mm/s.
  virtual void planned(double duration_s, double start, double end) = 0;
};

class Planner {
 public:
  // `look_ahead` pieces are seen at a time: the plan can stop within them; 0: all. `chunk` is how many pieces are kept
  // before those that are certain are given out; it changes memory and nothing else.
  Planner(PlanSink& sink, std::size_t look_ahead, std::size_t chunk = 4096);

  // A piece with start2 = 0 ends the path before it: that is planned and given out.
  void append(const PlannedPiece& piece);
  // The path ends at rest: everything is given out.
  void finish();
  [[nodiscard]] std::size_t kept() const { return pieces_.size(); }

 private:
  struct Kept {
    PlannedPiece piece;
    double stop_sum = 0.0;  // sum of 2·a·L of all pieces before it since the last rest
    double low2 = 0.0;      // at its start: the plan if the path ended at rest after the kept pieces
    double high2 = 0.0;     // and if it went on without limit
  };

  [[nodiscard]] double limit_of(std::size_t index, bool ends) const;
  void look_back(bool ends);
  void give(std::size_t count, double end2_of_last);
  void settle();

  PlanSink& sink_;
  std::size_t look_ahead_;
  std::size_t chunk_;
  std::size_t wanted_;
  std::vector<Kept> pieces_;
  double sum_ = 0.0;
  double speed2_ = 0.0;  // at the start of the first kept piece: what was given out so far ended with it
};

}  // namespace dripfeed::timing
