// The library answers the interpreter's questions.
#include "dialects/compile/execute.h"

namespace dripfeed::compile {

namespace {

class LibraryFinder final : public interpreter::ProgramFinder {
 public:
  explicit LibraryFinder(ProgramLibrary& library) : library_(library) {}
  const ir::Program* find(std::string_view name) override { return library_.find(name); }

 private:
  ProgramLibrary& library_;
};

}  // namespace

interpreter::RunResult execute(const ir::Program& program, const ir::Control& control, ProgramLibrary* library,
                               ir::MotionSink& sink, const interpreter::RunOptions& options) {
  if (library == nullptr) return interpreter::run(program, control, interpreter::no_programs(), sink, options);
  LibraryFinder finder(*library);
  return interpreter::run(program, control, finder, sink, options);
}

}  // namespace dripfeed::compile
