// Where a walk over a program with drilling cycles stands: what is known of the machine there, and what is reported
// about it. It follows the order of the text; what the paths to a place say otherwise is settled where a hole needs it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dialects/facts/resolved.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/passes/refusal.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::macro_b {

// Feed and spindle.
struct Turning {
  std::optional<ir::Function> feed_mode;
  std::optional<double> feed;
  std::optional<double> speed;
  std::optional<ir::Function> spindle;

  // A tap may be written by its feed, and feed and speed again after it.
  [[nodiscard]] bool is_known() const {
    const bool by_path = feed_mode == ir::Function::feed_per_min || feed_mode == ir::Function::feed_per_rev;
    return by_path && feed.has_value() && speed.has_value();
  }
};

// What is not known where paths meet or something runs that is not followed.
struct DrillState {
  std::optional<double> height;                   // along Z
  std::array<std::optional<double>, 2> in_plane;  // X and Y
  Turning turning;
};

class DrillPlace {
 public:
  // All must outlive it.
  DrillPlace(const ir::Program& program, const ir::Control& from, const ir::Control& to);

  // On to the statement, the next one of the text.
  void move_to(std::uint32_t index);
  // What the block here does.
  void take_block();
  void forget() { state = {}; }

  [[nodiscard]] std::uint32_t index() const { return index_; }
  [[nodiscard]] const ir::Statement& statement() const { return program_.statements[index_]; }
  [[nodiscard]] ir::Function plane() const { return plane_; }
  [[nodiscard]] std::optional<ir::Function> motion() const { return motion_; }
  // As all paths here have it; where they differ that is reported and the text's order holds.
  void state_plane();
  // G90 or G91 where all paths here have the one that the text's order does not, and the block does not say it.
  std::optional<ir::Function> state_distance();

  // The other control has no counterpart for it.
  void cannot(passes::Refusal what);
  // … and it is written without all the same.
  void warn(passes::Refusal what);
  std::vector<text::Diagnostic> take_diagnostics() { return std::move(diagnostics_); }

  DrillState state;  // who writes a hole says here what it leaves

 private:
  // What a caller or a called program may have set is taken as it is here, and reported.
  bool is_known(std::string_view what, const facts::Known<facts::Setting>& fact);
  // Nothing where the paths differ.
  [[nodiscard]] std::optional<bool> is_incremental(std::span<const ir::Code> codes) const;
  void take_code(const ir::Code& code);
  void take_position(const ir::Block& block);
  void lose_position();
  void take_turning(const ir::Block& block);

  const ir::Program& program_;
  const ir::Control& to_;
  std::vector<bool> is_target_;  // of a jump
  facts::Resolved modes_;
  std::set<std::pair<std::string, bool>> reported_;  // and whether it was an error
  std::vector<text::Diagnostic> diagnostics_;
  std::uint32_t index_ = 0;
  ir::Function plane_;
  bool incremental_;
  std::optional<ir::Function> motion_;
  bool in_cycle_ = false;  // by its code, of a program's other language: where it leaves the tool is not followed
};

}  // namespace dripfeed::macro_b
