// The interpreter with the library as its finder.
#include "dialects/compile/dialect/execute.h"

namespace dripfeed::compile {

interpreter::RunResult execute(const ir::Program& program, const ir::Control& control, ProgramLibrary* library,
                               ir::MotionSink& sink, const interpreter::RunOptions& options) {
  interpreter::ProgramFinder& none = interpreter::no_programs();
  return interpreter::run(program, control, library == nullptr ? none : *library, sink, options);
}

}  // namespace dripfeed::compile
