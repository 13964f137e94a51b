// Holes of a family as a modal drilling cycle. The cycle is written with its first hole, and again where another path
// may have led to the hole; in between a hole is its place alone.
#pragma once

#include <utility>
#include <vector>

#include "dialects/family/bind.h"
#include "dialects/family/emitter.h"
#include "dialects/family/value_writer.h"

namespace dripfeed::family {

class DrillWriter {
 public:
  DrillWriter(const BoundFamily& bound, ValueWriter& values, Emitter& emit)
      : bound_(bound), values_(values), emit_(emit) {}

  // Takes the values of the cycle: later ones of the same names do not count.
  void begin(const Step& step);
  [[nodiscard]] bool is_open() const { return step_ != nullptr; }
  [[nodiscard]] bool taps() const;
  // The level where the tool is between holes, other than where their feed begins.
  [[nodiscard]] const ValueWriter::Bound& return_level() const { return return_level_; }
  // `place`: its words; `feed`: F where it is to be said.
  void hole(std::vector<EmittedWord> place, const std::vector<EmittedWord>& feed);
  // Before a step where paths part or meet.
  void fork(StepKind kind);
  void end();

 private:
  std::vector<EmittedWord> cycle_words();
  void cancel();

  const BoundFamily& bound_;
  ValueWriter& values_;
  Emitter& emit_;
  const Step* step_ = nullptr;
  std::vector<std::pair<ir::Address, ValueWriter::Bound>> words_;
  ValueWriter::Bound return_level_;
  bool is_in_effect_ = false;  // on every path that leads here
  int depth_ = 0;              // of loops and conditions among the holes
};

}  // namespace dripfeed::family
