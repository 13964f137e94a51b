// Which modes hold at each statement, on all ways that lead there: through jumps and structures, from a caller of the
// same text into its subprogram and back. What a caller outside of the text set, or a called program outside of it may
// have changed, is not known.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/passes/flow_graph.h"

namespace dripfeed::passes {

enum class Mode : std::uint8_t { feed, surface_speed, unit, distance, plane, diameter, count_ };
inline constexpr std::size_t kModes = static_cast<std::size_t>(Mode::count_);
constexpr std::size_t index_of(Mode mode) { return static_cast<std::size_t>(mode); }

// The mode that a code sets; nothing for a code that sets none of these.
std::optional<Mode> mode_of(const ir::Code& code);
// What the control wakes up in.
ir::Function power_on(Mode mode, const ir::Semantics& semantics);

bool is_call(ir::StatementKind kind);
// Statements that neither move nor change a mode.
bool keeps_modes(ir::StatementKind kind);
// A call of a cycle of the control: it leaves the modes as they were.
bool is_standard_cycle(const ir::Program& program, const ir::Statement& call);

struct ModeFact {
  static constexpr std::uint32_t kPowerOn = ir::kNoIndex - 1;  // as an origin
  static constexpr std::uint32_t kCaller = ir::kNoIndex - 2;   // … named beside the program

  ir::Function function = ir::Function::none;  // none: no way sets it
  std::uint32_t origin = ir::kNoIndex;         // the statement that set it
  ir::Function other = ir::Function::none;     // what another way brings
  std::uint32_t other_origin = ir::kNoIndex;
  bool inherited = false;                // on one way at least it is what an unknown caller set
  std::uint32_t changer = ir::kNoIndex;  // a statement on a way here whose effect on it is not known

  [[nodiscard]] bool agrees() const {
    return function != ir::Function::none && other == ir::Function::none && !inherited;
  }
  // What is left where two ways meet; true when that is less than before.
  bool meet(const ModeFact& with);
  friend bool operator==(const ModeFact&, const ModeFact&) = default;
};
using ModeFacts = std::array<ModeFact, kModes>;

class ModeFlow {
 public:
  // Both must outlive it.
  ModeFlow(const ir::Program& program, const ir::Control& control);

  // Before the statement; nullptr where no way leads.
  [[nodiscard]] const ModeFacts* before(std::uint32_t statement) const;
  // "per revolution from line 7 of O0001" for each way that the fact knows.
  [[nodiscard]] std::vector<std::string> ways(const ModeFact& fact) const;
  // The program of the text that holds the statement, by name; "" when it has none.
  [[nodiscard]] std::string program_at(std::uint32_t statement) const;

 private:
  // One program of the text.
  struct Part {
    StatementRange range;
    ir::StringId name = ir::StringId::none;
    bool is_called = false;                   // from this text
    std::array<bool, kModes> changes{};       // it or what it calls may set the mode
    std::optional<ModeFacts> exit = {};       // where it returns
    std::vector<std::uint32_t> callers = {};  // statements
  };
  void find_parts();
  void find_calls();
  void find_changes();
  [[nodiscard]] ModeFacts start_of(const Part& part) const;
  void flow();
  void reach(std::uint32_t statement, const ModeFacts& facts);
  [[nodiscard]] Part* called_by(const ir::Statement& statement);
  [[nodiscard]] Part& part_at(std::uint32_t statement);
  std::optional<ModeFacts> after(std::uint32_t statement, const ModeFacts& facts);
  std::optional<ModeFacts> after_call(const ir::Statement& statement, const Part& part, const ModeFacts& facts);
  void leave(std::uint32_t statement, const ModeFacts& facts);
  void take_block(std::uint32_t statement, ModeFacts& facts) const;
  void forget(std::uint32_t changer, ModeFacts& facts) const;
  [[nodiscard]] bool may_change(const ir::Statement& statement) const;
  [[nodiscard]] std::string way(ir::Function function, std::uint32_t origin) const;

  const ir::Program& program_;
  const ir::Control& control_;
  FlowGraph graph_;
  std::vector<Part> parts_;
  std::vector<std::optional<ModeFacts>> before_;
  std::vector<std::uint32_t> work_;
};

}  // namespace dripfeed::passes
