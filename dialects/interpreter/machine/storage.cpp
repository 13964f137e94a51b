// Stacks of registers. They only grow; a frame that was left is overwritten by the next.
#include "dialects/interpreter/machine/storage.h"

#include <algorithm>

#include "dialects/interpreter/arithmetic/arithmetic.h"

namespace dripfeed::interpreter {

namespace {

// What a variable reads that outlives programs and was not set by this one.
double unset_global(const ir::Semantics& semantics) {
  if (semantics.unset_is_unknown) return kUnknown;
  return semantics.has_vacant ? kVacant : 0.0;
}

}  // namespace

Storage::Storage(const VariableMap& variables, SharedData& shared, const ir::Semantics& semantics)
    : shared_(shared),
      globals_(variables.global_count(), unset_global(semantics)),
      local_count_(variables.local_count()),
      unset_local_(semantics.has_vacant || semantics.unset_is_unknown ? kVacant : 0.0) {}

void Storage::open_frame(const CompiledProgram& program, const Bases& bases) {
  make_room(program, bases);
  std::fill_n(frames_.begin() + bases.frame, program.declared_slots, 0.0);
  for (std::uint32_t i = 0; i < program.declared_strings; ++i) strings_[bases.string + i].clear();
  if (program_ != nullptr) enter(*program_, current_);
}

void Storage::make_room(const CompiledProgram& program, const Bases& bases) {
  const std::size_t frame_end = std::size_t{bases.frame} + program.frame_slots;
  const std::size_t string_end = std::size_t{bases.string} + program.string_slots;
  if (frames_.size() < frame_end) frames_.resize(frame_end);
  if (strings_.size() < string_end) strings_.resize(string_end);
  if (program_ != nullptr) enter(*program_, current_);
}

void Storage::open_locals(const Bases& bases) {
  const std::size_t end = std::size_t{bases.local} + local_count_;
  if (locals_.size() < end) locals_.resize(end);
  std::fill_n(locals_.begin() + bases.local, local_count_, unset_local_);
  if (program_ != nullptr) enter(*program_, current_);
}

void Storage::enter(CompiledProgram& program, const Bases& bases) {
  program_ = &program;
  current_ = bases;
  bases_[static_cast<std::size_t>(Space::global)] = globals_.data();
  bases_[static_cast<std::size_t>(Space::frame)] = frames_.data() + bases.frame;
  bases_[static_cast<std::size_t>(Space::local)] = locals_.data() + bases.local;
  bases_[static_cast<std::size_t>(Space::constant)] = program.constants.data();
}

double Storage::refer(Space space, std::uint32_t index) const {
  const std::uint32_t base = space == Space::frame ? current_.frame : space == Space::local ? current_.local : 0;
  return static_cast<double>((std::uint64_t{base} + index) << 2 | static_cast<std::uint64_t>(space));
}

double& Storage::at_reference(double reference) {
  const auto bits = static_cast<std::uint64_t>(reference);
  const std::uint64_t index = bits >> 2;
  const auto space = static_cast<Space>(bits & 3U);
  if (space == Space::global) return globals_[index];
  if (space == Space::constant) return shared_.at(static_cast<std::uint32_t>(index)).number;
  return space == Space::local ? locals_[index] : frames_[index];
}

}  // namespace dripfeed::interpreter
