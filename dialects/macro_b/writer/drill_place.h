// Where a walk over a program with drilling cycles stands: what facts know of the machine there, and what is reported
// about it.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dialects/facts/resolved.h"
#include "dialects/ir/called_pattern.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/passes/refusal.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::macro_b {

// Feed and spindle; nothing is known of a speed that follows the diameter.
struct Turning {
  std::optional<ir::Function> feed_mode;
  std::optional<double> feed;
  std::optional<double> speed;
  std::optional<ir::Function> spindle;

  // A tap may be stated by its feed, and feed and speed again after it.
  [[nodiscard]] bool is_known() const {
    const bool by_path = feed_mode == ir::Function::feed_per_min || feed_mode == ir::Function::feed_per_rev;
    return by_path && feed.has_value() && speed.has_value();
  }
};

class DrillPlace {
 public:
  // All must outlive it.
  DrillPlace(const ir::Program& program, const ir::Control& from, const ir::Control& to);

  // On to the statement, the next one of the text.
  void move_to(std::uint32_t index);
  // The block here has been made, but no hole of a modal call.
  void take_block();

  [[nodiscard]] std::uint32_t index() const { return index_; }
  [[nodiscard]] const ir::Statement& statement() const { return program_.statements[index_]; }
  // As the paths here have it; where they disagree, one of them.
  [[nodiscard]] ir::Function plane() const;
  [[nodiscard]] std::optional<ir::Function> motion() const;
  // Nothing where it is not known.
  [[nodiscard]] std::optional<double> height() const { return height_; }  // along Z
  [[nodiscard]] std::optional<ir::PlanePoint> in_plane() const;           // X and Y
  [[nodiscard]] const Turning& turning() const { return turning_; }
  // Where the statement's holes that are written so far have left the tool along Z, and how the spindle turns after
  // them.
  void leave_at(std::optional<double> height) { height_ = height; }
  void leave_turning(std::optional<ir::Function> spindle) { turning_.spindle = spindle; }

  // Reported where the paths here disagree about it.
  void state_plane();
  // G90 or G91 where all paths here have the one that the text's order does not, and the block does not state it.
  std::optional<ir::Function> state_distance();

  // The other control has no counterpart for it.
  void cannot(passes::Refusal what);
  // … and it is written without all the same.
  void warn(passes::Refusal what);
  std::vector<text::Diagnostic> take_diagnostics() { return std::move(diagnostics_); }

 private:
  void load();
  // What a caller or a called program may have set is taken as it is here, and reported.
  bool is_known(std::string_view what, const facts::Known<facts::Setting>& fact);
  [[nodiscard]] std::optional<double> number(facts::Kept word) const;

  const ir::Program& program_;
  const ir::Control& to_;
  facts::Resolved facts_;
  std::optional<facts::Facts> here_;                 // nothing: no path leads there
  std::set<std::pair<std::string, bool>> reported_;  // and whether it was an error
  std::vector<text::Diagnostic> diagnostics_;
  std::uint32_t index_ = 0;
  ir::Function power_on_plane_;
  bool incremental_;  // in the order of the text, as who prints it follows it
  std::optional<double> height_;
  Turning turning_;
};

}  // namespace dripfeed::macro_b
