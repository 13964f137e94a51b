// Plain blocks made fewer within a tolerance: straight cuts that lie near one line become one cut, arcs of one circle
// one arc. The path changes, so it is off unless it is asked for, and the greatest distance between both paths is
// proved.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dialects/compile/dialect/library.h"
#include "dialects/ir/control.h"
#include "dialects/text/source.h"

namespace dripfeed::compile {

struct MergeWishes {
  bool lines = false;
  bool arcs = false;
  double tolerance_mm = 0.0;
};

struct MergedGroup {
  std::uint32_t first_line = 0;  // of the source, both included: one block instead of these
  std::uint32_t last_line = 0;
  bool is_arc = false;
  double off_mm = 0.0;  // how far the paths lie apart at most
};

struct MergedBlocks {
  std::string text;                         // the source's own bytes where nothing was merged
  std::vector<std::uint32_t> origin_lines;  // per line of the text: the source's
  std::vector<MergedGroup> groups;
  double most_mm = 0.0;  // over all groups: no point of either path is further from the other
  std::string obstacle;  // why nothing was merged; empty where it could be
};

// A block is left out only where its run is known: the program has no jumps, loops or calls, each block of a group
// names axes alone, and feed, spindle, coolant and offsets are the same in all of them. All other blocks keep their
// bytes. The new text is run, too: every other motion must be the same to the last bit, and each group's end. `most_mm`
// follows from the old points: along a line that never turns back no point of a chain is further from its chord than a
// corner of it, and no point of the chord further from the chain; an arc of another center and radius lies off by the
// sum of both differences at most. Diameters count as they are: twice the distance.
MergedBlocks merge_blocks(const text::Source& source, const ir::Control& control, ProgramLibrary& library,
                          const MergeWishes& wishes);

}  // namespace dripfeed::compile
