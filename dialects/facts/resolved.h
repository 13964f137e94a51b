// What is in effect before each statement of a text. A call of a program of the same text joins the caller's facts into
// that program's start; what the called program never touches passes the call unchanged, the rest comes from its
// returns. What a caller outside of the text has set, or a called program outside of it may have changed, is not known.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dialects/facts/effects.h"
#include "dialects/facts/flow_graph.h"
#include "dialects/facts/modal_facts.h"
#include "dialects/facts/shape_blocks.h"

namespace dripfeed::facts {

class Resolved {
 public:
  // Both must outlive it. Cost: linear in the statements for text that runs as it is written.
  Resolved(const ir::Program& program, const ir::Control& control, ToolChange change = ToolChange::as_the_control);

  // Before the statement, or at the end of the text for the number of statements; nullptr where no path leads. Valid
  // until the next call; asked in the order of the text it costs one statement. Not for two threads at once.
  [[nodiscard]] const Facts* before(std::uint32_t statement) const;
  // The mode where all paths to the statement agree and nothing unknown may have changed it.
  [[nodiscard]] std::optional<Setting> certain(Mode mode, std::uint32_t statement) const;
  // As the statement's own motion finds it: the block's codes and words have taken effect.
  [[nodiscard]] std::optional<Facts> at(std::uint32_t statement) const;
  // Whether T brings a tool in, without M6.
  [[nodiscard]] bool tool_comes_by_t() const { return effects_.tool_comes_by_t(); }
  // "feed per revolution from line 7 of O0001" for each path that the fact knows.
  [[nodiscard]] std::vector<std::string> paths(const Known<Setting>& fact) const;
  // The program of the text that holds the statement, by name; "" when it has none.
  [[nodiscard]] std::string program_at(std::uint32_t statement) const;

 private:
  // One program of the text.
  struct Part {
    StatementRange range;
    ir::StringId name = ir::StringId::none;
    bool is_called = false;                   // from the text
    bool saves_modes = false;                 // PROC … SAVE
    FactSet touched = {};                     // by it or by what it calls
    std::optional<Facts> exit = {};           // where it returns
    std::vector<std::uint32_t> callers = {};  // statements
  };
  void find_parts();
  void find_calls();
  void find_touched();
  void find_leaders();
  [[nodiscard]] Facts start_of(const Part& part) const;
  void flow();
  void run_from(std::uint32_t leader);
  void go_on(std::uint32_t from, std::uint32_t to, const Facts& facts);
  void reach(std::uint32_t statement, const Facts& facts);
  [[nodiscard]] std::uint32_t part_called_by(const ir::Statement& statement) const;
  [[nodiscard]] std::uint32_t part_at(std::uint32_t statement) const;
  // False: a called program has not returned yet, nothing is known of what follows.
  bool step(std::uint32_t statement, Facts& facts);
  bool step_over_call(std::uint32_t statement, Part& part, Facts& facts);
  void step_over_modal_calls(std::uint32_t statement, Facts& facts) const;
  void leave(std::uint32_t statement, const Facts& facts);
  void enter_callers_at_labels(std::uint32_t statement, const Part& part, const Facts& facts);
  [[nodiscard]] bool ends_part(std::uint32_t statement) const;

  const ir::Program& program_;
  const ir::Control& control_;
  FlowGraph graph_;
  Effects effects_;
  std::vector<Shape> shapes_;  // that G70 to G73 run
  std::vector<Part> parts_;
  std::vector<std::uint32_t> part_of_call_;       // by statement, kNoIndex for others
  std::vector<bool> is_leader_;                   // where states are kept
  std::vector<std::uint32_t> leaders_;            // in order
  std::vector<std::optional<Facts>> at_leaders_;  // before each of them
  std::vector<std::uint32_t> work_;               // leaders
  [[nodiscard]] bool leads_nowhere(std::uint32_t from, std::uint32_t last) const;
  // Where before() stands.
  mutable std::uint32_t cursor_ = ir::kNoIndex;
  mutable Facts cursor_facts_;
};

}  // namespace dripfeed::facts
