// A buffer that slides over the text. Only whole lines are scanned.
#include "dialects/compile/dialect/stream.h"

#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include "dialects/compile/dialect/execute.h"

namespace dripfeed::compile {

namespace {

constexpr std::size_t kBufferBytes = std::size_t{256} * 1024;  // with its batch it stays in a core's own cache

class TextStream final : public interpreter::PlainStream {
 public:
  TextStream(ProgramText& bytes, std::string name, const Dialect& dialect, const ir::Control& control)
      : bytes_(bytes),
        name_(std::move(name)),
        dialect_(dialect),
        control_(control),
        scanner_(dialect.plain_scanner(control)),
        buffer_(kBufferBytes + 1) {}

  const ir::PlainBatch* next() override {
    batch_.clear();
    while (!stopped_ && batch_.blocks.empty()) {
      if (scanned_ == lines_end_ && !refill()) break;
      scan();
    }
    return batch_.blocks.empty() ? nullptr : &batch_;
  }

  Rest rest() override {
    if (!read_error_.empty()) return {.program = nullptr, .offset = 0, .broken = true};
    if (!stopped_) return {};
    std::expected<std::string, std::string> text = bytes_.whole();
    if (!text) {
      read_error_ = text.error();
      return {.program = nullptr, .offset = 0, .broken = true};
    }
    source_.emplace(name_, std::move(*text));
    read_ = dialect_.read(*source_, control_);
    if (text::has_error(read_.diagnostics)) return {.program = nullptr, .offset = 0, .broken = true};
    return {.program = &read_.program, .offset = static_cast<std::uint32_t>(before_ + scanned_), .broken = false};
  }

  [[nodiscard]] std::string_view name() const override { return scanner_->name(); }

  // After the run. The program of rest() stays here: it must outlive the run.
  void give(StreamRun& run) {
    run.source = std::move(source_);
    run.diagnostics = std::move(read_.diagnostics);
    run.read_error = std::move(read_error_);
  }

 private:
  void scan() {
    const ir::PlainScan scan = scanner_->scan({buffer_.data() + scanned_, lines_end_ - scanned_}, batch_);
    scanned_ += scan.taken;
    stopped_ = scan.stop == ir::PlainStop::not_plain;
  }

  // Moves what is left to the front and reads after it. False when nothing is left, or a line is longer than the
  // buffer, which the reader may judge.
  bool refill() {
    std::memmove(buffer_.data(), buffer_.data() + scanned_, filled_ - scanned_);
    filled_ -= scanned_;
    before_ += std::exchange(scanned_, 0);
    while (!at_end_ && filled_ < kBufferBytes) {
      const auto count = bytes_.read({buffer_.data() + filled_, kBufferBytes - filled_});
      if (!count) read_error_ = count.error();
      if (!count || *count == 0) at_end_ = true;
      if (count) filled_ += *count;
    }
    if (!read_error_.empty()) return false;
    lines_end_ = at_end_ ? filled_ : end_of_lines();
    if (at_end_) buffer_[filled_] = '\n';  // the scanner stops there
    stopped_ = lines_end_ == 0 && filled_ > 0;
    return lines_end_ > 0;
  }

  // After the last EOB that is whole whatever follows: LF CR CR, or LF that no CR follows.
  [[nodiscard]] std::size_t end_of_lines() const {
    const std::string_view text(buffer_.data(), filled_);
    for (std::size_t end = filled_ - 1; end > 0; --end) {
      if (text[end - 1] == '\n' && text[end] != '\r') return end;
      if (text.substr(0, end).ends_with("\n\r\r")) return end;
    }
    return 0;
  }

  ProgramText& bytes_;
  std::string name_;
  const Dialect& dialect_;
  const ir::Control& control_;
  std::unique_ptr<ir::PlainScanner> scanner_;
  std::vector<char> buffer_;   // and one byte for an EOB after the text
  std::uint64_t before_ = 0;   // bytes of the text before the buffer
  std::size_t scanned_ = 0;    // in the buffer
  std::size_t lines_end_ = 0;  // of the whole lines in it
  std::size_t filled_ = 0;
  bool at_end_ = false;   // of the text
  bool stopped_ = false;  // at a block that is not plain
  ir::PlainBatch batch_;
  std::string read_error_;
  std::optional<text::Source> source_;
  ir::ReadResult read_;
};

}  // namespace

StreamRun execute_stream(ProgramText& bytes, const std::string& name, const Dialect& dialect,
                         const ir::Control& control, ProgramLibrary* library, ir::MotionSink& sink,
                         const interpreter::RunOptions& options) {
  TextStream stream(bytes, name, dialect, control);
  interpreter::ProgramFinder& none = interpreter::no_programs();
  StreamRun run;
  run.result = interpreter::run(stream, control, library == nullptr ? none : *library, sink, options);
  stream.give(run);
  return run;
}

}  // namespace dripfeed::compile
