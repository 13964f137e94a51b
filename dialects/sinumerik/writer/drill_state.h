// What is known of modal drilling (G81 to G89) at each statement of a program of another control, on all ways that lead
// there: which cycle is on, with which words, and the modes that its words depend on.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::sinumerik {

// A value that is the same on all ways, or not known.
template <class T>
struct Fact {
  T value{};
  bool known = true;

  void set(T to) { *this = {to, true}; }
  void forget() { *this = {T{}, false}; }
  [[nodiscard]] bool is(T wanted) const { return known && value == wanted; }
  // What is left where two ways meet; true when that is less than before.
  bool meet(const Fact& other) {
    if (!known || (other.known && value == other.value)) return false;
    forget();
    return true;
  }
};

struct DrillState {
  static constexpr std::int16_t kNone = -1;
  Fact<std::int16_t> cycle{kNone};  // argument of Function::drill
  Fact<ir::ExpressionId> depth{ir::ExpressionId::none}, level{ir::ExpressionId::none}, peck{ir::ExpressionId::none},
      dwell{ir::ExpressionId::none};  // Z, R, Q, P as they were written
  Fact<ir::ExpressionId> shift_i{ir::ExpressionId::none}, shift_j{ir::ExpressionId::none};  // I, J of boring cycles
  Fact<bool> depth_by_distance, level_by_distance;                                          // written under G91
  Fact<ir::ExpressionId> feed{ir::ExpressionId::none}, speed{ir::ExpressionId::none};
  Fact<bool> to_level;     // G99
  Fact<bool> incremental;  // G91
  Fact<bool> inch;
  Fact<bool> at_initial;  // the tool stands at the level where the cycle began
  // Levels of the drilling axis in units of the program, as a number or as a name that has one value.
  struct Level {
    Fact<double> number{0.0, false};
    Fact<ir::SymbolId> name{ir::SymbolId::none, false};

    void forget();
    bool meet(const Level& other);
  };
  Level height;   // outside of cycles
  Level initial;  // where the cycle began, or would begin
  Fact<ir::Function> motion, plane, spindle, feed_mode;

  bool meet(const DrillState& other);
  void forget();
};

class DrillFlow {
 public:
  DrillFlow(const ir::Program& program, const ir::Control& from);
  // Before the statement; nothing where no way leads.
  [[nodiscard]] const DrillState* before(std::uint32_t statement) const;
  // After a block that begins in `state`.
  [[nodiscard]] DrillState after(const DrillState& state, const ir::Block& block) const;

 private:
  void take_code(const ir::Code& code, DrillState& state) const;
  void take_words(std::span<const ir::Word> words, bool drills, DrillState& state) const;
  [[nodiscard]] DrillState::Level level_of(const ir::Word& word, const DrillState& state) const;
  [[nodiscard]] DrillState step(const DrillState& state, const ir::Statement& statement) const;

  const ir::Program& program_;
  const ir::Control& from_;
  std::set<ir::SymbolId> settled_;  // names with one value from the first place where paths part to the end
  std::vector<std::optional<DrillState>> before_;
};

// Address of the axis that stands on the plane.
ir::Address drilling_axis(ir::Function plane);

}  // namespace dripfeed::sinumerik
