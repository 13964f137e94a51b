// The stages between a program's text and its plan, as figure 8 of A. Keinert, A. Verl shows them: when each ran on
// which thread. One thread interprets, because a block means what those before it made of the modes; the shapes of the
// moves, and the rounding of the corners between them (smoothing), need their neighbours alone and are made batch by
// batch by all; the look-ahead cuts the whole path into parts. Tool compensation is no stage here: times are of the
// programmed path. By hand:
// build/dev/pipeline_bench [blocks] [threads]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "checks/timing/kinematics.h"
#include "checks/timing/look_ahead.h"
#include "dialects/compile/stream.h"
#include "dialects/text/number.h"

namespace {

using namespace dripfeed;
using Clock = std::chrono::steady_clock;

enum class Stage : std::uint8_t { interpret, shape, smooth, look_ahead };
constexpr std::array kStageNames = {"interpret", "shape", "smooth", "look-ahead"};

struct Span {
  Stage stage;
  unsigned thread;
  double begin_s, end_s;
};

const Clock::time_point start = Clock::now();
double now_s() { return std::chrono::duration<double>(Clock::now() - start).count(); }

class Text final : public compile::ProgramText {
 public:
  explicit Text(std::string text) : text_(std::move(text)) {}
  std::expected<std::size_t, std::string> read(std::span<char> into) override {
    const std::size_t count = std::min(into.size(), text_.size() - at_);
    std::memcpy(into.data(), text_.data() + at_, count);
    at_ += count;
    return count;
  }
  std::expected<std::string, std::string> whole() override { return text_; }

 private:
  std::string text_;
  std::size_t at_ = 0;
};

struct Batch {
  std::vector<ir::Motion> motions;  // the first is the last of the batch before
  std::size_t first_piece = 0;
};

class Pipeline final : public ir::MotionSink {
 public:
  Pipeline(unsigned threads, std::size_t blocks) : threads_(threads) {
    pieces_.resize(blocks + 8);
    rates_.rapid.fill(400);
    rates_.feed.fill(400);
    rates_.acceleration.fill(2000);
    rates_.jerk.fill(timing::kNoLimit);
    rates_.sample_s = 0.004;
    rates_.contour_tolerance_mm = 0.01;
  }

  void run(const std::string& text) {
    std::vector<std::jthread> workers;
    for (unsigned i = 1; i < threads_; ++i) workers.emplace_back([this, i] { shape_batches(i); });
    Text bytes(text);
    const compile::Dialect& dialect = *compile::find_dialect("fanuc");
    const ir::Control control = dialect.control(ir::MachineKind::mill, ir::GSystem::a);
    compile::ProgramLibrary library(control, [](std::string_view) { return std::nullopt; });
    since_ = now_s();
    compile::execute_stream(bytes, "bench", dialect, control, &library, *this, {});
    {
      const std::lock_guard lock(mutex_);
      closed_ = true;
    }
    ready_.notify_all();
    shape_batches(0);
    workers.clear();
    pieces_.resize(moves_);
    const double from = now_s();
    timing::plan_path(pieces_, {0, threads_}, plan_);
    note({Stage::look_ahead, 0, from, now_s()});
  }

  void consume(std::span<const ir::Motion> motions) override {
    Batch batch;
    if (has_last_) batch.motions.push_back(last_);
    for (const ir::Motion& motion : motions) {
      if (motion.kind == ir::MotionKind::linear) batch.motions.push_back(motion);
    }
    batch.first_piece = moves_;
    moves_ += batch.motions.size() - (has_last_ ? 1 : 0);
    if (batch.motions.empty()) return;
    last_ = batch.motions.back();
    if (!has_last_) batch.motions.insert(batch.motions.begin(), ir::Motion{});
    has_last_ = true;
    const double now = now_s();
    note({Stage::interpret, 0, since_, now});
    {
      const std::lock_guard lock(mutex_);
      waiting_.push_back(std::move(batch));
    }
    ready_.notify_one();
    since_ = now_s();
  }

  void report() const {
    double end = 0;
    for (const Span& span : spans_) end = std::max(end, span.end_s);
    double begin = end;
    for (const Span& span : spans_) begin = std::min(begin, span.begin_s);
    fmt::print("{} moves, {} threads, {} ms; cycle {} s; a column is a fiftieth of the time\n", moves_, threads_,
               text::format_fixed((end - begin) * 1e3, 1), text::format_fixed(plan_.total_s, 1));
    for (std::size_t stage = 0; stage < kStageNames.size(); ++stage) {
      for (unsigned thread = 0; thread < threads_; ++thread) {
        std::string row(50, '.');
        double busy = 0;
        for (const Span& span : spans_) {
          if (static_cast<std::size_t>(span.stage) != stage || span.thread != thread) continue;
          busy += span.end_s - span.begin_s;
          const auto column = [&](double s) {
            return std::min<std::size_t>(49, static_cast<std::size_t>((s - begin) / (end - begin) * 50));
          };
          for (std::size_t k = column(span.begin_s); k <= column(span.end_s); ++k) row[k] = '#';
        }
        if (busy > 0)
          fmt::print("{:>11} thread {} {} {:>7} ms\n", kStageNames[stage], thread, row,
                     text::format_fixed(busy * 1e3, 1));
      }
    }
  }

 private:
  void note(const Span& span) {
    const std::lock_guard lock(spans_mutex_);
    spans_.push_back(span);
  }

  void shape_batches(unsigned thread) {
    std::vector<timing::PathShape> shapes;
    for (;;) {
      Batch batch;
      {
        std::unique_lock lock(mutex_);
        ready_.wait(lock, [this] { return closed_ || !waiting_.empty(); });
        if (waiting_.empty()) return;
        batch = std::move(waiting_.front());
        waiting_.pop_front();
      }
      const double from = now_s();
      shapes.clear();
      for (const ir::Motion& motion : batch.motions) shapes.push_back(timing::shape_of(motion, false));
      for (std::size_t i = 1; i < batch.motions.size(); ++i) {
        const timing::PathShape& shape = shapes[i];
        const double feed = timing::feed_speed(batch.motions[i], shape, false, 0);
        const double speed = std::min(feed, timing::speed_limit(shape, rates_, false));
        const std::size_t piece = batch.first_piece + i - 1;
        pieces_.length[piece] = shape.length;
        pieces_.speed2[piece] = speed * speed;
        pieces_.acceleration[piece] = timing::path_acceleration(shape, rates_);
      }
      const double shaped = now_s();
      note({Stage::shape, thread, from, shaped});
      for (std::size_t i = 1; i < batch.motions.size(); ++i) {
        const std::size_t piece = batch.first_piece + i - 1;
        pieces_.start2[piece] = piece == 0 ? 0.0 : corner(shapes[i - 1], shapes[i]);
      }
      note({Stage::smooth, thread, shaped, now_s()});
    }
  }
  [[nodiscard]] double corner(const timing::PathShape& a, const timing::PathShape& b) const {
    return std::max(
        timing::corner_speed2(a.end_direction, b.start_direction, rates_),
        timing::rounded_corner_speed2(a.end_direction, b.start_direction, rates_, 0.5 * std::min(a.length, b.length)));
  }

  unsigned threads_;
  timing::AxisRates rates_{};
  timing::PieceArrays pieces_;
  timing::SpeedPlan plan_;
  std::size_t moves_ = 0;
  ir::Motion last_;
  bool has_last_ = false;
  double since_ = 0;
  std::mutex mutex_;
  std::condition_variable ready_;
  std::deque<Batch> waiting_;
  bool closed_ = false;
  std::mutex spans_mutex_;
  std::vector<Span> spans_;
};

std::string program(std::size_t blocks) {
  std::string text = "%\nO1\nG21 G90 G94\nG0 X0. Y0. Z0.\nG1 F3000.\n";
  for (std::size_t i = 1; i <= blocks; ++i) {
    const double t = 0.01 * static_cast<double>(i);
    text += fmt::format("X{} Y{} Z{}\n", text::format_fixed(0.1 * static_cast<double>(i % 2000), 4),
                        text::format_fixed(10 * std::sin(t), 4), text::format_fixed(std::cos(3 * t), 4));
  }
  return text + "M30\n%\n";
}

std::size_t number_of(int argc, char** argv, int index, std::size_t usual) {
  const auto number = index < argc ? text::parse_number(argv[index]) : std::nullopt;
  return number && *number >= 1.0 ? static_cast<std::size_t>(*number) : usual;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t blocks = number_of(argc, argv, 1, 200'000);
  const auto threads = static_cast<unsigned>(number_of(argc, argv, 2, 2));
  Pipeline pipeline(threads, blocks);
  pipeline.run(program(blocks));
  pipeline.report();
  return 0;
}
