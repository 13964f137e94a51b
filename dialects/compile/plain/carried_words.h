// What a block says and motions do not: numbers of tool lengths and compensation, M functions of the machine, the
// direction to the reference point. The explicit form takes it over as it stands in the program.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dialects/compile/plain/by_line.h"
#include "dialects/family/emitter.h"
#include "dialects/interpreter/interpreter.h"
#include "dialects/ir/axis_letters.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/passes/refusal.h"

namespace dripfeed::compile {

struct CarriedWord {
  ir::Address address = ir::Address::h;
  double value = 0.0;
  ir::WordMode mode = ir::WordMode::as_modal;
};

struct CarriedWords {
  std::vector<family::EmittedCode> codes;
  std::vector<CarriedWord> words;

  [[nodiscard]] bool empty() const { return codes.empty() && words.empty(); }
};

struct CarriedBlock {
  CarriedWords attached;              // goes into the block of what the source's block does
  CarriedWords alone;                 // stands in a block of its own, after that
  std::vector<passes::Refusal> lost;  // words that would have to be carried and cannot be: "H#1"

  [[nodiscard]] bool empty() const { return attached.empty() && alone.empty() && lost.empty(); }
};

// Functions that are carried, so that nothing is lost when the interpreter does not carry them out.
bool is_carried(ir::Function function);

// The blocks that have something to carry, by program of the run and line. Words with a computed value cannot be.
class CarriedBlocks {
 public:
  // `main` is program 0 of the run; the others are asked of `finder` by name. Where D selects the edge on `control`,
  // motions have it, and H is no number of a length.
  CarriedBlocks(const ir::Program& main, const ir::Control& control, interpreter::ProgramFinder& finder)
      : main_(main),
        semantics_(control.semantics),
        h_is_length_(!ir::incremented_axis(control, 'H').has_value()),
        prepares_tools_(control.kind == ir::MachineKind::mill && control.semantics.tool_word == ir::ToolWord::number),
        finder_(finder) {}

  // Number `program` of the run; nullptr when there is none. `names` are the run's programs.
  const ir::Program* source_of(std::uint32_t program, const std::vector<std::string>& names) const;
  // nullptr: nothing. Valid as long as this.
  const CarriedBlock* at(std::uint32_t program, const std::vector<std::string>& names, std::uint32_t line) {
    ByLine<CarriedBlock>* const known = programs_.of(program);
    return (known != nullptr ? *known : look_at(program, names)).at(line);
  }

 private:
  ByLine<CarriedBlock>& look_at(std::uint32_t program, const std::vector<std::string>& names);
  [[nodiscard]] ByLine<CarriedBlock> collect(const ir::Program& program) const;
  [[nodiscard]] CarriedBlock carried_by(const ir::Program& program, const ir::Block& block) const;
  [[nodiscard]] bool is_section(std::uint32_t program, const std::vector<std::string>& names) const;

  const ir::Program& main_;
  const ir::Semantics& semantics_;
  const bool h_is_length_;
  bool prepares_tools_;  // T waits for M6
  interpreter::ProgramFinder& finder_;
  ByProgram<CarriedBlock> programs_;
};

}  // namespace dripfeed::compile
