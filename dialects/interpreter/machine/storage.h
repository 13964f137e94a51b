// The machine's registers: variables of the run, a stack of frames, a stack of local sets, strings. It knows where a
// register lies, not what it means.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "dialects/interpreter/bytecode/bytecode.h"
#include "dialects/interpreter/bytecode/variable_map.h"
#include "dialects/interpreter/state/shared_data.h"

namespace dripfeed::interpreter {

// Where the registers of a running program begin in their stacks.
struct Bases {
  std::uint32_t frame = 0;
  std::uint32_t local = 0;
  std::uint32_t string = 0;
};

class Storage {
 public:
  Storage(const VariableMap& variables, SharedData& shared, const ir::Semantics& semantics);

  // Makes room for the program's frame at `bases` and clears its declared names; the registers that `reg` gives are not
  // changed by it.
  void open_frame(const CompiledProgram& program, const Bases& bases);
  // Makes room without clearing anything.
  void make_room(const CompiledProgram& program, const Bases& bases);
  // A fresh local set at the base.
  void open_locals(const Bases& bases);
  // Makes these the registers that `reg` gives. The program's constants must live as long.
  void enter(CompiledProgram& program, const Bases& bases);

  [[nodiscard]] double& reg(std::uint32_t operand) { return bases_[operand & 3U][operand >> 2]; }
  // A string to read, and one to write (of the frame).
  [[nodiscard]] const std::string& text(std::uint32_t operand) const {
    return static_cast<Space>(operand & 3U) == Space::constant ? program_->texts[operand >> 2]
                                                               : strings_[current_.string + (operand >> 2)];
  }
  [[nodiscard]] std::string& string(std::uint32_t operand) { return strings_[current_.string + (operand >> 2)]; }
  [[nodiscard]] double& frame_at(std::uint32_t absolute) { return frames_[absolute]; }
  [[nodiscard]] std::string& string_at(std::uint32_t absolute) { return strings_[absolute]; }
  [[nodiscard]] double& local_at(std::uint32_t absolute) { return locals_[absolute]; }
  [[nodiscard]] double& global_at(std::uint32_t index) { return globals_[index]; }
  [[nodiscard]] std::uint32_t local_count() const { return local_count_; }

  // A reference is a number that a register can hold: the space and the place in its whole stack.
  [[nodiscard]] double refer(Space space, std::uint32_t index) const;
  [[nodiscard]] double& at_reference(double reference);
  // Data of the control has no register; its places are counted in the space that constants have otherwise.
  static double refer_shared(std::uint32_t place) {
    return static_cast<double>(std::uint64_t{place} << 2 | static_cast<std::uint64_t>(Space::constant));
  }
  [[nodiscard]] const Bases& bases() const { return current_; }

 private:
  SharedData& shared_;
  std::vector<double> globals_;
  std::vector<double> frames_;
  std::vector<double> locals_;
  std::vector<std::string> strings_;
  std::array<double*, 4> bases_{};
  Bases current_;
  CompiledProgram* program_ = nullptr;
  std::uint32_t local_count_;
  double unset_local_;  // what a fresh local variable reads
};

}  // namespace dripfeed::interpreter
