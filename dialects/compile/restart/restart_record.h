// One run of a program for a restart: its motions, what every line of the main program was found in, and everything
// that is known where one of them begins.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/interpreter/interpreter.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/ir/control.h"
#include "dialects/ir/motion.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

// What a line stands in, where no restart begins.
enum class RestartObstacle : std::uint8_t {
  none,
  not_modelled,
  modal_call,
  compensation,
  drilling,
  turning,
  transformation,
  turned_frame,
  shift,
  polar_words,
  curve,
  corner,
  inverse_time,
  contour_offset,
  written_offsets,
  arc,
  thread,
  in_shape,
};
// "cutter compensation is": the beginning of a sentence that ends with "in effect".
std::string_view words_of(RestartObstacle obstacle);
RestartObstacle obstacle_of(const interpreter::ModalState& state);

struct LineSeen {
  std::uint32_t visits = 0;  // how often the run began it
  RestartObstacle obstacle = RestartObstacle::none;
  bool guessed = false;  // the run came there by a branch that a value decides which is not known
};

struct RestartPoint {
  interpreter::ModalState state;
  std::uint64_t ordinal = 0;
  std::vector<interpreter::VariableValue> variables;
  std::set<std::string> changed;  // variables that blocks before it have set …
  std::set<std::string> unknown;  // … to a value that is not known
};

struct RestartRun {
  std::vector<LineSeen> lines;        // by line - 1
  std::optional<RestartPoint> point;  // nothing: the run never began the line
  std::vector<ir::Motion> motions;    // without those of spindle and coolant, which each move has, too
  bool is_whole = true;               // false: it made more motions than are kept
  interpreter::RunNames names;
  interpreter::RunResult result;

  [[nodiscard]] const LineSeen& seen(std::uint32_t line) const {
    static constexpr LineSeen kNever;
    return line == 0 || line > lines.size() ? kNever : lines[line - 1];
  }
  // Index of the first motion of `ordinal` or after it.
  [[nodiscard]] std::size_t first_motion(std::uint64_t ordinal) const;
  [[nodiscard]] std::size_t moves_before(std::uint64_t ordinal) const;
};

// `line`: whose start is kept. What only the control holds is not known in the run.
RestartRun run_for_restart(const ir::Program& program, const ir::Control& control, interpreter::ProgramFinder& finder,
                           const interpreter::RunOptions& options, std::uint32_t line);

}  // namespace dripfeed::compile
