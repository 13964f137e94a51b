// Arcs are parted where they turn back, so that each piece only rises or only falls.
#include "dialects/interpreter/cycles/contour_sections.h"

#include <cmath>

namespace dripfeed::interpreter {

namespace {

constexpr double kSmall = 1e-6;  // mm

class Sections {
 public:
  Sections(const std::vector<ContourPiece>& contour, double rise) : rise_(rise) {
    for (const ContourPiece& piece : contour)
      for (const ShapeSegment& part : split_at_turns(piece.segment)) pieces_.push_back({part, piece.ccw});
  }

  ContourSections run() {
    ContourSections out;
    if (const std::uint32_t line = line_of_reversal(); line != 0)
      return {{}, {}, "along a contour that reverses in line " + std::to_string(line)};
    for (at_ = 0; at_ < pieces_.size();) {
      const ContourPiece& piece = pieces_[at_];
      if (height(piece.segment.to) >= height(piece.segment.from) - kSmall) {
        out.front.push_back(piece);
        ++at_;
        continue;
      }
      const std::uint32_t line = piece.segment.line;
      Relief relief;
      if (!take(relief)) return {{}, {}, "with a relief cut that is not a plain one, in line " + std::to_string(line)};
      ContourPiece bridge;
      bridge.segment = {.from = relief.begin(), .to = relief.end(), .center = {}, .line = line};
      out.front.push_back(bridge);
      out.reliefs.push_back(std::move(relief));
    }
    return out;
  }

 private:
  [[nodiscard]] double height(ShapePoint p) const { return rise_ * p.level; }

  // Line of the first piece against the direction of the travel, 0 when there is none.
  [[nodiscard]] std::uint32_t line_of_reversal() const {
    double direction = 0.0;
    for (const ContourPiece& piece : pieces_) {
      const double step = piece.segment.to.travel - piece.segment.from.travel;
      if (std::abs(step) <= kSmall) continue;
      if (step * direction < 0.0) return piece.segment.line;
      direction = step;
    }
    return 0;
  }

  // Down from the piece that falls, and up to its height; what is left of the last piece stays. False when the contour
  // falls once more while it rises, or ends before it is as high.
  bool take(Relief& relief) {
    const double level = pieces_[at_].segment.from.level;
    for (; at_ < pieces_.size(); ++at_) {
      ContourPiece& piece = pieces_[at_];
      const bool rises = height(piece.segment.to) > height(piece.segment.from) + kSmall;
      const bool falls = height(piece.segment.to) < height(piece.segment.from) - kSmall;
      if (!rises && relief.up.empty()) {
        relief.down.push_back(piece);
        continue;
      }
      if (falls) return false;
      relief.up.push_back(piece);
      if (height(piece.segment.to) < rise_ * level - kSmall) continue;
      const ShapePoint end{travel_at(piece.segment, level).value_or(piece.segment.to.travel), level};
      relief.up.back().segment.to = end;
      reshape(relief.up.back().segment);
      const bool used = height(piece.segment.to) <= rise_ * level + kSmall;
      if (used) return ++at_, true;
      piece.segment.from = end;
      reshape(piece.segment);
      return true;
    }
    return false;
  }

  static void reshape(ShapeSegment& s) {
    if (s.arc) s.turn = turn_of(s, s.turn > 0.0);
  }

  double rise_;
  std::vector<ContourPiece> pieces_;
  std::size_t at_ = 0;
};

}  // namespace

ContourSections sections_of(const std::vector<ContourPiece>& contour, double rise) {
  return Sections(contour, rise).run();
}

}  // namespace dripfeed::interpreter
