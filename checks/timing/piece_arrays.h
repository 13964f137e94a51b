// A path as flat arrays, one entry a piece: what the look-ahead sweeps over. Who fills it makes sure that every figure
// is finite and above zero (start2 may be zero: a rest).
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace dripfeed::timing {

// "No limit" of a speed or an acceleration: large, but finite, so that sums and quotients stay numbers.
inline constexpr double kNoLimit = 1e15;

// Lengths in mm, speeds in mm/s as squares, accelerations in mm/s².
struct Piece {
  double length = 0.0;
  double speed2 = 0.0;        // highest along the piece, > 0
  double start2 = 0.0;        // highest at its start; 0: it starts from rest
  double acceleration = 0.0;  // along the path, > 0
};

struct PieceArrays {
  std::vector<double> length;
  std::vector<double> speed2;
  std::vector<double> start2;
  std::vector<double> acceleration;

  [[nodiscard]] std::size_t size() const { return length.size(); }
  [[nodiscard]] Piece at(std::size_t i) const { return {length[i], speed2[i], start2[i], acceleration[i]}; }
  void push_back(const Piece& piece) {
    length.push_back(piece.length);
    speed2.push_back(piece.speed2);
    start2.push_back(piece.start2);
    acceleration.push_back(piece.acceleration);
  }
  void resize(std::size_t count) {
    for (auto* array : {&length, &speed2, &start2, &acceleration}) array->resize(count);
  }
  void erase_front(std::size_t count) {
    for (auto* array : {&length, &speed2, &start2, &acceleration})
      array->erase(array->begin(), array->begin() + static_cast<std::ptrdiff_t>(count));
  }
};

}  // namespace dripfeed::timing
