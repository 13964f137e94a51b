// The stages between a program's text and its plan, as figure 8 of A. Keinert, A. Verl shows them: when each ran on
// which thread. One thread interprets, because a block means what those before it made of the modes. What cutter
// compensation leads next to the programmed path, the shapes of the moves, and the rounding of the corners between them
// (smoothing) need neighbours alone and are made batch by batch by all; the look-ahead cuts the whole path into parts.
// By hand: build/dev/pipeline_bench [blocks] [threads]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "checks/gouge/compensation.h"
#include "checks/timing/kinematics.h"
#include "checks/timing/look_ahead.h"
#include "dialects/compile/dialect/stream.h"
#include "dialects/text/number.h"

namespace {

using namespace dripfeed;
using Clock = std::chrono::steady_clock;

enum class Stage : std::uint8_t { interpret, compensate, shape, smooth, join, look_ahead };
constexpr std::array kStageNames = {"interpret", "compensate", "shape", "smooth", "join", "look-ahead"};
constexpr std::size_t kBatch = 4096;  // moves
constexpr double kRadius_mm = 3.0;

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

// What one thread takes at a time. A move's path next to the programmed one depends on its neighbours: the first `lead`
// are there for that, and so is the last, unless the program ends with it; they belong to another batch.
constexpr std::size_t kLead = 3;
struct Batch {
  std::size_t number = 0;
  std::vector<ir::Motion> motions;
  std::size_t lead = 0;
  bool is_last = false;
};

class Pipeline final : public ir::MotionSink {
 public:
  Pipeline(unsigned threads, std::size_t batch) : threads_(threads), batch_(batch) {
    rates_.rapid.fill(400);
    rates_.feed.fill(400);
    rates_.acceleration.fill(2000);
    rates_.jerk.fill(timing::kNoLimit);
    rates_.sample_s = 0.004;
    rates_.contour_tolerance_mm = 0.01;
  }

  void run(const std::string& text) {
    std::vector<std::jthread> workers;
    for (unsigned i = 1; i < threads_; ++i) workers.emplace_back([this, i] { work(i); });
    Text bytes(text);
    const compile::Dialect& dialect = *compile::find_dialect("fanuc");
    const ir::Control control = dialect.control(ir::MachineKind::mill, ir::GSystem::a);
    compile::ProgramLibrary library(control, [](std::string_view) { return std::nullopt; });
    since_ = now_s();
    compile::execute_stream(bytes, "bench", dialect, control, &library, *this, {});
    next_.is_last = true;
    hand_over();
    {
      const std::lock_guard lock(mutex_);
      closed_ = true;
    }
    ready_.notify_all();
    work(0);
    workers.clear();
    const double from = now_s();
    for (const timing::PieceArrays& part : parts_) {
      for (std::size_t i = 0; i < part.size(); ++i) pieces_.push_back(part.at(i));
    }
    const double joined = now_s();
    note({Stage::join, 0, from, joined});
    timing::plan_path(pieces_, {0, threads_}, plan_);
    note({Stage::look_ahead, 0, joined, now_s()});
  }

  void consume(std::span<const ir::Motion> motions) override {
    for (const ir::Motion& motion : motions) {
      if (motion.kind == ir::MotionKind::linear) next_.motions.push_back(motion);
    }
    if (next_.motions.size() >= batch_) hand_over();
  }

  // Whether both planned the same, to the last bit.
  [[nodiscard]] bool agrees_with(const Pipeline& other) const {
    return pieces_.length == other.pieces_.length && pieces_.start2 == other.pieces_.start2 &&
           plan_.speed2 == other.plan_.speed2 && plan_.total_s == other.plan_.total_s;
  }

  void report() const {
    double end = 0;
    for (const Span& span : spans_) end = std::max(end, span.end_s);
    double begin = end;
    for (const Span& span : spans_) begin = std::min(begin, span.begin_s);
    fmt::print("{} moves, {} threads, {} ms; cycle {} s; a column is a fiftieth of the time\n", pieces_.size(),
               threads_, text::format_fixed((end - begin) * 1e3, 1), text::format_fixed(plan_.total_s, 1));
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

  void hand_over() {
    Batch following{next_.number + 1, {}, 0, false};
    if (!next_.is_last) {
      following.motions.assign(next_.motions.end() - (kLead + 1), next_.motions.end());
      following.lead = kLead;
    }
    note({Stage::interpret, 0, since_, now_s()});
    {
      const std::lock_guard lock(mutex_);
      waiting_.push_back(std::exchange(next_, std::move(following)));
      parts_.resize(parts_.size() + 1);
    }
    ready_.notify_one();
    since_ = now_s();
  }

  void work(unsigned thread) {
    std::vector<ir::Motion> led;
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
      compensate(batch, led);
      const double compensated = now_s();
      note({Stage::compensate, thread, from, compensated});
      timing::PieceArrays part = shape(batch, led, shapes);
      const double shaped = now_s();
      note({Stage::shape, thread, compensated, shaped});
      round_corners(shapes, part);
      note({Stage::smooth, thread, shaped, now_s()});
      const std::lock_guard lock(mutex_);
      parts_[batch.number] = std::move(part);
    }
  }

  static void compensate(const Batch& batch, std::vector<ir::Motion>& led) {
    checks::NotCheckedList notes;
    gouge::Compensation compensation(gouge::OuterCorner::straight, notes);
    led.clear();
    for (const ir::Motion& motion : batch.motions) {
      compensation.add(motion, kRadius_mm);
      const auto known = compensation.known();
      led.insert(led.end(), known.begin(), known.end());
      compensation.clear_known();
    }
    if (!batch.is_last) return;
    compensation.flush();
    led.insert(led.end(), compensation.known().begin(), compensation.known().end());
  }

  // Pieces of the batch's own moves; `shapes` begins with that of the move before them.
  timing::PieceArrays shape(const Batch& batch, const std::vector<ir::Motion>& led,
                            std::vector<timing::PathShape>& shapes) const {
    const std::uint64_t first = batch.motions[batch.lead].place.ordinal;
    const std::uint64_t end = batch.is_last ? UINT64_MAX : batch.motions.back().place.ordinal;
    timing::PieceArrays part;
    shapes.assign(1, {});
    for (const ir::Motion& motion : led) {
      const timing::PathShape shape = timing::shape_of(motion, false);
      if (!(shape.length > 0.0) || motion.place.ordinal >= end) continue;
      if (motion.place.ordinal < first) {
        shapes.front() = shape;
        continue;
      }
      const double feed = timing::feed_speed(motion, shape, false, 0);
      const double speed = std::min(feed, timing::speed_limit(shape, rates_, false));
      part.push_back({shape.length, speed * speed, 0.0, timing::path_acceleration(shape, rates_)});
      shapes.push_back(shape);
    }
    return part;
  }

  void round_corners(const std::vector<timing::PathShape>& shapes, timing::PieceArrays& part) const {
    for (std::size_t i = 0; i < part.size(); ++i) {
      const timing::PathShape& a = shapes[i];
      const timing::PathShape& b = shapes[i + 1];
      if (!(a.length > 0.0)) continue;  // the first of all
      part.start2[i] =
          timing::corner_speed2(a.end_direction, b.start_direction, rates_, 0.5 * std::min(a.length, b.length));
    }
  }

  unsigned threads_;
  std::size_t batch_;
  timing::AxisRates rates_{};
  timing::SpeedPlan plan_;
  timing::PieceArrays pieces_;
  Batch next_;
  double since_ = 0;
  std::mutex mutex_;
  std::condition_variable ready_;
  std::deque<Batch> waiting_;
  std::vector<timing::PieceArrays> parts_;  // by the batch's number
  bool closed_ = false;
  std::mutex spans_mutex_;
  std::vector<Span> spans_;
};

std::string program(std::size_t blocks) {
  std::string text = "%\nO1\nG21 G90 G94\nG0 X-10. Y0. Z0.\nG1 G41 D1 X0. F3000.\n";
  for (std::size_t i = 1; i <= blocks; ++i) {
    const double t = 0.01 * static_cast<double>(i);
    text += fmt::format("X{} Y{} Z{}\n", text::format_fixed(0.1 * static_cast<double>(i), 1),
                        text::format_fixed(10 * std::sin(t), 4), text::format_fixed(std::cos(3 * t), 4));
  }
  return text + "G40 Y100.\nM30\n%\n";
}

std::size_t number_of(int argc, char** argv, int index, std::size_t usual) {
  const auto number = index < argc ? text::parse_number(argv[index]) : std::nullopt;
  return number && *number >= 1.0 ? static_cast<std::size_t>(*number) : usual;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t blocks = number_of(argc, argv, 1, 200'000);
  const auto threads = static_cast<unsigned>(number_of(argc, argv, 2, 2));
  const std::string text = program(blocks);
  Pipeline whole(1, SIZE_MAX);
  whole.run(text);
  Pipeline pipeline(threads, kBatch);
  pipeline.run(text);
  pipeline.report();
  if (pipeline.agrees_with(whole)) return 0;
  fmt::print("DIFFERENT from one batch on one thread\n");
  return 1;
}
