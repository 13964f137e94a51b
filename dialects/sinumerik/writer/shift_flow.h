// What G52 has set and whether G68, G51 or G51.1 is in effect, on all ways that lead to a statement.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/sinumerik/writer/drill_state.h"

namespace dripfeed::sinumerik {

class ShiftFlow {
 public:
  ShiftFlow(const ir::Program& program, const ir::Control& from);
  // Of X, Y and Z in units of the program before the statement; nothing where they are not known.
  [[nodiscard]] std::optional<std::array<double, 3>> shift_at(std::uint32_t statement) const;
  [[nodiscard]] std::optional<bool> turned_at(std::uint32_t statement) const;

 private:
  struct State {
    std::array<Fact<double>, 3> shift;
    Fact<bool> turned;
    void forget();
    bool meet(const State& other);
  };
  [[nodiscard]] State after(State state, const ir::Statement& statement) const;

  const ir::Program& program_;
  const ir::Control& from_;
  std::vector<std::optional<State>> before_;
};

}  // namespace dripfeed::sinumerik
