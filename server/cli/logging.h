// Where the commands that serve lines write what people read: the log, messages, the address of the server. A terminal
// that is stopped (Ctrl-S), a pager, or a collector that hangs takes no more bytes, and whoever writes to it waits. So
// each of both outputs has a bounded queue and a thread of its own; everybody else puts a line into the queue and goes
// on. What a full queue drops is counted, and the count is written in its place.
//
// spdlog's own asynchronous logger is not used: it joins its thread at the end, and that thread may hang in a write.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace dripfeed::cli {

enum class LogForm : std::uint8_t {
  text,
  json,  // an object a line: time, level, text
};

// Lines to a descriptor. push() may be called from any thread; it waits for no other.
class LineQueue {
 public:
  static constexpr std::size_t kMostLines = 4096;
  static constexpr std::size_t kMostBytes = std::size_t{1} << 20;

  explicit LineQueue(int descriptor, LogForm form = LogForm::text);
  // Waits until what is in the queue is written, but not longer than kPatience; then the thread is abandoned.
  ~LineQueue();
  LineQueue(const LineQueue&) = delete;
  LineQueue& operator=(const LineQueue&) = delete;

  // The oldest lines make room for a new one. Never throws but where memory is out.
  void push(std::string line);
  [[nodiscard]] LogForm form() const;

 private:
  struct Shared;
  static void write_until_the_end(const std::shared_ptr<Shared>& shared);
  static void write_lines(const std::shared_ptr<Shared>& shared);

  std::shared_ptr<Shared> shared_;  // the thread may outlive this object
};

// While it lives, spdlog and say() go to standard error and announce() to standard output, by the queues. One at a
// time, in the thread that runs the command.
class Logging {
 public:
  explicit Logging(LogForm form = LogForm::text);
  ~Logging();
  Logging(const Logging&) = delete;
  Logging& operator=(const Logging&) = delete;
};

// "dripfeed: SENTENCE" on standard error, or a line of the log where that is JSON. Without a Logging it is written at
// once. An output that is gone is no fault, and neither is a sentence for which there is no memory.
void say(std::string_view sentence);
// A line on standard output; the same.
void announce(std::string_view line);

}  // namespace dripfeed::cli
