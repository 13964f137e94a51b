// What is known of a lathe's tool at each statement, on all ways that lead there: where it stands, the feed, the
// turning cycle in effect and its words. Values are numbers of the program, as they are written there (an X as its
// diameter or radius), so that shifts and units do not matter while they stay the same.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dialects/facts/resolved.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/ir/control.h"
#include "dialects/ir/motion.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

// A value that is the same on all ways, or not known.
template <class T>
struct Known {
  std::optional<T> value;

  [[nodiscard]] bool is(const T& wanted) const { return value && *value == wanted; }
  // What is left where two ways meet; true when that is less than before.
  bool meet(const Known& other) {
    if (!value || value == other.value) return false;
    value.reset();
    return true;
  }
};

// What G76 keeps of the first of two blocks.
struct ThreadData {
  std::int32_t finishes = 1;
  double angle_deg = 60.0;
  double run_out_leads = 0.0;
  double least_cut_mm = 0.0;
  double allowance_mm = 0.0;
  double first_cut_mm = 0.0;
  friend bool operator==(const ThreadData&, const ThreadData&) = default;
};

struct LatheState {
  static constexpr std::int16_t kNone = -1;
  Known<double> x, z, c;
  Known<double> feed;          // 0: none was given yet
  Known<ir::Function> motion;  // outside of cycles
  Known<std::int16_t> cycle;   // argument of Function::turning_cycle
  Known<bool> has_x, has_z;    // of the cycle: words that it keeps
  Known<double> end_x, end_z, taper;
  Known<ThreadData> thread;
  Known<double> retract_mm;  // G74, G75

  bool meet(const LatheState& other);
};

class LatheFlow {
 public:
  // Both must outlive it.
  LatheFlow(const ir::Program& program, const ir::Control& control);
  // Before the statement; nullptr where no way leads.
  [[nodiscard]] const LatheState* before(std::uint32_t statement) const;
  [[nodiscard]] const facts::Resolved& facts() const { return modes_; }
  // Nothing where ways differ or a caller decides.
  [[nodiscard]] std::optional<ir::Function> mode(facts::Mode mode, std::uint32_t statement) const;
  // A word's value in units of the program: nothing where it is computed, or counts increments of an unknown unit.
  [[nodiscard]] std::optional<double> number(const ir::Word& word, std::uint32_t statement) const;
  [[nodiscard]] std::optional<double> feed_of(const ir::Word& word, std::uint32_t statement) const;
  // … and whether it is an increment; nothing where that is not known.
  [[nodiscard]] std::optional<bool> is_increment(const ir::Word& word, std::uint32_t statement) const;
  // A block of G74 to G76 as the interpreter carries it out from `state`; nothing where something that it needs is not
  // known.
  struct Repeated {
    std::vector<ir::Motion> motions;  // none where the block only sets data
    Known<ThreadData> thread;
    Known<double> retract_mm;
    bool inch = false;
    bool fails = false;  // with an alarm
  };
  [[nodiscard]] std::optional<Repeated> repeat(std::uint32_t statement, const LatheState& state) const;
  [[nodiscard]] bool is_increment_of_c(const ir::Word& word) const;
  // On some way behind the statement: whether a cut may follow before a feed is given; whether a block may follow that
  // moves without saying how.
  [[nodiscard]] bool needs_feed(std::uint32_t statement) const;
  [[nodiscard]] bool needs_motion(std::uint32_t statement) const;

 private:
  [[nodiscard]] std::optional<ir::Function> mode_before(facts::Mode mode, std::uint32_t statement) const;
  [[nodiscard]] LatheState start() const;
  [[nodiscard]] LatheState after(std::uint32_t statement, LatheState state) const;
  void take_codes(const ir::Block& block, std::uint32_t statement, LatheState& state) const;
  void take_moves(const ir::Block& block, std::uint32_t statement, LatheState& state) const;
  void take_cycle_words(const ir::Block& block, std::uint32_t statement, LatheState& state) const;

  const ir::Program& program_;
  const ir::Control& control_;
  interpreter::BlockRules rules_;
  facts::Resolved modes_;
  std::vector<bool> in_shape_;  // by statement
  std::vector<std::optional<LatheState>> before_;
};

// Wholly or in part, by the operator's switch.
bool may_be_skipped(const ir::Program& program, const ir::Statement& statement);
// X or Z, by the letter of its increment, too; nothing for other addresses.
std::optional<ir::Address> turning_axis(ir::Address address, const ir::Control& control);

}  // namespace dripfeed::compile
