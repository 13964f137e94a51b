// The entrance.
#include "dialects/interpreter/interpreter.h"
#include "dialects/interpreter/machine/machine.h"

namespace dripfeed::interpreter {

namespace {

class NoPrograms : public ProgramFinder {
 public:
  const ir::Program* find(std::string_view) override { return nullptr; }
};

}  // namespace

ProgramFinder& no_programs() {
  static NoPrograms none;
  return none;
}

std::string_view name_of(Ended ended) {
  constexpr std::string_view kNames[] = {"end", "alarm", "limit", "text_end"};
  return kNames[static_cast<std::size_t>(ended)];
}

RunResult run(const ir::Program& program, const ir::Control& control, ProgramFinder& finder, ir::MotionSink& sink,
              const RunOptions& options) {
  return Machine(control, finder, sink, options).run(program);
}

RunResult run(PlainStream& stream, const ir::Control& control, ProgramFinder& finder, ir::MotionSink& sink,
              const RunOptions& options) {
  return Machine(control, finder, sink, options).run(stream);
}

}  // namespace dripfeed::interpreter
