// Running a text while it is read, in constant memory as long as its blocks are plain: chunks of bytes are scanned into
// batches, the interpreter runs them, and once a block is not plain the program is read whole and goes on from there.
// What opens files is left to others.
#pragma once

#include <expected>
#include <optional>
#include <string>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/library.h"
#include "dialects/text/byte_reader.h"

namespace dripfeed::compile {

// The bytes of a program, once from the front and, if asked for, all of them again.
class ProgramText : public text::ByteReader {
 public:
  virtual std::expected<std::string, std::string> whole() = 0;
};

struct StreamRun {
  interpreter::RunResult result;
  // The whole program, once it was needed. Errors among its diagnostics ended the run at the block that needed it.
  std::optional<text::Source> source;
  std::vector<text::Diagnostic> diagnostics;
  std::string read_error;  // why bytes could not be read; the run ended there
};

// As execute() of the program that dialect.read(text) gives, but that what it says of a faulty block comes when the run
// arrives at the first block that is not plain, and that nothing after the end of
// the program is read. `name` is what messages call the text. options.observer is not heard.
StreamRun execute_stream(ProgramText& bytes, const std::string& name, const Dialect& dialect,
                         const ir::Control& control, ProgramLibrary* library, ir::MotionSink& sink,
                         const interpreter::RunOptions& options);

}  // namespace dripfeed::compile
