// What facts know of a lathe's tool at a statement, as the passes of turning ask for it: where it stands, the feed, the
// turning cycle in effect and its words. Values are numbers of the program, as they are written there (an X as its
// diameter or radius), so that shifts and units do not matter while they stay the same.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dialects/facts/resolved.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/plain_block.h"
#include "dialects/ir/control.h"
#include "dialects/ir/motion.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

// Nothing where paths differ, or where it is not known.
struct LatheState {
  static constexpr std::int16_t kNone = -1;
  std::optional<double> x, z, c;
  std::optional<double> feed;          // 0: none was given yet
  std::optional<ir::Function> motion;  // outside of cycles
  std::optional<std::int16_t> cycle;   // argument of Function::turning_cycle
  std::optional<bool> has_x, has_z;    // of the cycle: words that it keeps
  std::optional<double> end_x, end_z, taper;
};

class LatheFacts {
 public:
  // Both must outlive it.
  LatheFacts(const ir::Program& program, const ir::Control& control);

  // Before the statement; nothing where no path leads.
  [[nodiscard]] std::optional<LatheState> before(std::uint32_t statement) const;
  [[nodiscard]] const facts::Resolved& facts() const { return facts_; }
  // Nothing where paths differ or a caller decides.
  [[nodiscard]] std::optional<ir::Function> mode(facts::Mode mode, std::uint32_t statement) const;
  // A word's value in units of the program: nothing where it is computed, or counts increments of an unknown unit.
  [[nodiscard]] std::optional<double> number(const ir::Word& word, std::uint32_t statement) const;
  [[nodiscard]] std::optional<double> feed_of(const ir::Word& word, std::uint32_t statement) const;
  // … and whether it is an increment; nothing where that is not known.
  [[nodiscard]] std::optional<bool> is_increment(const ir::Word& word, std::uint32_t statement) const;
  [[nodiscard]] bool is_increment_of_c(const ir::Word& word) const;
  // A block of G74 to G76 as the interpreter carries it out from `state`; nothing where something that it needs is not
  // known.
  struct Repeated {
    std::vector<ir::Motion> motions;  // none where the block only sets data
    bool inch = false;
    bool fails = false;  // with an alarm
  };
  [[nodiscard]] std::optional<Repeated> repeat(std::uint32_t statement, const LatheState& state) const;

 private:
  // By feed and unit.
  [[nodiscard]] std::optional<double> scaled_feed(const facts::Written& feed, std::optional<ir::Function> mode,
                                                  std::optional<ir::Function> unit) const;
  [[nodiscard]] std::optional<ir::Function> mode_before(facts::Mode mode, std::uint32_t statement) const;
  // What G74 to G76 go by besides the block itself: stated by blocks before it.
  [[nodiscard]] std::optional<interpreter::Repetitive> data_before(std::uint32_t statement, facts::Mode data) const;
  [[nodiscard]] std::optional<interpreter::PlainBlock> plain_block(std::uint32_t statement) const;
  // As far as these cycles look at it.
  [[nodiscard]] std::optional<interpreter::ModalState> modal_at(std::uint32_t statement) const;

  const ir::Program& program_;
  const ir::Control& control_;
  interpreter::BlockRules rules_;
  facts::Resolved facts_;
};

// Wholly or in part, by the operator's switch.
bool may_be_skipped(const ir::Program& program, const ir::Statement& statement);
// X or Z, by the letter of its increment, too; nothing for other addresses.
std::optional<ir::Address> turning_axis(ir::Address address, const ir::Control& control);

// On some path after the statement: whether a cut may follow before a feed is given; whether a block may follow that
// moves without stating how.
bool needs_feed_after(const ir::Program& program, std::uint32_t statement);
bool needs_motion_after(const ir::Program& program, std::uint32_t statement);

}  // namespace dripfeed::compile
