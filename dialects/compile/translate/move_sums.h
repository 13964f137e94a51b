// What the moves in the stretches of a program add up to, piece by piece; and where each line outside of them leads,
// because the lines were translated without the stretches before them. Two programs whose sums are the same move alike.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "dialects/ir/motion.h"
#include "dialects/ir/plain_stretch.h"

namespace dripfeed::compile {

class MoveSums final : public ir::MotionSink {
 public:
  // `origins`: the line of the source for each line of a translation; nullptr: it is the source.
  MoveSums(const std::vector<ir::PlainStretch>& stretches, const std::vector<std::uint32_t>* origins)
      : stretches_(stretches), origins_(origins) {}

  void consume(std::span<const ir::Motion> motions) override;
  // A difference of a few millionths of a millimetre is none.
  [[nodiscard]] bool same(const MoveSums& other) const;

  static constexpr std::uint32_t kLinesOfAPiece = 256;

 private:
  // Where the moves of one line of the source lie and end.
  struct Reach {
    std::array<double, ir::kAxisCount> low{};
    std::array<double, ir::kAxisCount> high{};
    std::array<double, ir::kAxisCount> end{};
  };
  struct Piece {
    std::size_t stretch = 0;
    std::uint32_t number = 0;  // in its stretch
    std::uint64_t moves = 0;
    std::uint64_t kinds = 0;
    std::array<double, ir::kAxisCount> ends{};
    std::array<double, 3> centers{};
    double feeds = 0.0;
    double speeds = 0.0;
  };

  static bool same_reach(const Reach& a, const Reach& b);
  static bool same_piece(const Piece& a, const Piece& b);
  void add(const ir::Motion& m);
  void add_outside(std::uint32_t line, const ir::Motion& m);

  const std::vector<ir::PlainStretch>& stretches_;
  const std::vector<std::uint32_t>* origins_;
  std::map<std::uint32_t, Reach> outside_;  // by line of the source
  std::size_t at_ = 0;
  std::vector<Piece> pieces_;
};

}  // namespace dripfeed::compile
