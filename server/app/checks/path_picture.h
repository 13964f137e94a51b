// A toolpath as a small drawing, for a list of programs: lines on a coarse grid, each once, so that a long path is no
// larger than a short one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "server/app/checks/tool_path.h"

namespace dripfeed::app {

enum class PictureView : std::uint8_t {
  turning,    // a path that never leaves y = constant: z to the right, x up
  isometric,  // all others: x to the right and up, y to the left and up, z up
};
inline constexpr std::array<std::string_view, 2> kPictureViewNames = {"turning", "isometric"};

struct PathPicture {
  static constexpr int kWidth = 240;
  static constexpr int kHeight = 180;
  static constexpr std::size_t kMostLines = 3000;  // more make the grid coarser

  PictureView view = PictureView::isometric;
  std::string cut;  // path data as in SVG ("M1 2 3 4"), of whole numbers from 0, 0 at the top left
  std::string rapid;
  bool has_all_cuts = false;  // it was run to its end, and no cut lies at a position that is not known
};

// The cuts fill the drawing; of rapids, parts may lie outside of it. Without any line both texts are empty.
PathPicture picture_of(const ToolPath& path);

}  // namespace dripfeed::app
