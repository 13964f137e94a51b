// Each tick: characters arrive, one block is computed, and the axes move. How fast they may go is looked up from the
// far end of the computed blocks to the near one, as long as nothing new was computed; the end of what is known is a
// stop.
#include "server/simulator/stepped_control.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "dialects/text/number.h"

namespace dripfeed::simulator {

namespace {

constexpr double kTick_s = 1e-3;

struct Move {
  std::uint32_t line = 0;
  std::size_t bytes = 0;
  bool ends = false;
  double dwell_s = 0.0;
  std::array<double, 3> unit{};
  double length = 0.0;
  double speed = 0.0;
  double acceleration = 0.0;
  bool rapid = false;
  double exit = 0.0;  // highest speed at its end, by what is known
};

class Reader {
 public:
  explicit Reader(const SteppedSettings& settings) : settings_(settings) {}
  [[nodiscard]] const std::string& fault() const { return fault_; }

  std::optional<Move> read(std::string_view block) {
    Move move;
    std::array<double, 3> to = at_;
    bool dwells = false;
    for (std::size_t i = 0; i < block.size();) {
      const char letter = block[i++];
      if (letter == ' ' || letter == '%' || letter == '\r') continue;
      if (letter == '(') return move;  // a comment takes the rest
      const bool minus = i < block.size() && block[i] == '-';
      if (minus) ++i;
      const auto number = text::read_decimal(block.substr(std::min(i, block.size())));
      if (letter < 'A' || letter > 'Z' || !number) {
        fault_ = std::string(block);
        return std::nullopt;
      }
      i += number->length;
      const double value = minus ? -number->value : number->value;
      if (letter >= 'X' && letter <= 'Z') to[static_cast<std::size_t>(letter - 'X')] = value;
      if (letter == 'F') feed_ = value / 60.0;
      if (letter == 'G' && value < 1.5) rapid_ = value < 0.5;
      if (letter == 'G' && value == 4.0) dwells = true;
      if (letter == 'P' && dwells) move.dwell_s = value * 1e-3;
      if (letter == 'M' && value == 30.0) move.ends = true;
    }
    shape(move, to);
    at_ = to;
    return move;
  }

 private:
  void shape(Move& move, const std::array<double, 3>& to) const {
    for (std::size_t k = 0; k < 3; ++k) move.length = std::hypot(move.length, to[k] - at_[k]);
    if (move.length <= 0.0) return;
    move.rapid = rapid_;
    move.speed = rapid_ ? 1e9 : feed_;
    move.acceleration = 1e9;
    for (std::size_t k = 0; k < 3; ++k) {
      move.unit[k] = (to[k] - at_[k]) / move.length;
      const double share = std::abs(move.unit[k]);
      if (share < 1e-12) continue;
      move.speed = std::min(move.speed, settings_.rapid_mm_min[k] / 60.0 / share);
      move.acceleration = std::min(move.acceleration, settings_.acceleration_mm_s2[k] / share);
    }
  }

  const SteppedSettings& settings_;
  std::array<double, 3> at_{};
  double feed_ = 0.0;
  bool rapid_ = true;
  std::string fault_;
};

class Machine {
 public:
  Machine(std::string_view text, const SteppedSettings& settings)
      : text_(text), settings_(settings), reader_(settings) {
    arrives_at_ = settings.first_char_ms * 1e-3;
  }

  SteppedReport run(double most_s) {
    for (; !done_ && now_ < most_s && report_.fault.empty(); now_ += kTick_s) {
      receive();
      compute();
      move(kTick_s);
    }
    if (!done_ && report_.fault.empty()) report_.fault = "it did not come to an end";
    report_.standstill_s = moved_ ? stood_s_ : 0.0;
    return report_;
  }

 private:
  // Characters up to the end of this tick, while there is room.
  void receive() {
    const double char_s = settings_.char_ms * 1e-3;
    while (sent_ < text_.size()) {
      const bool from_memory = char_s <= 0.0;
      if (from_memory ? received_.size() >= settings_.look_ahead : buffered_ >= settings_.buffer_bytes) {
        arrives_at_ = std::max(arrives_at_, now_);
        return;
      }
      if (!from_memory && arrives_at_ + char_s > now_ + kTick_s) return;
      arrives_at_ += char_s;
      const char c = text_[sent_++];
      ++buffered_;
      if (c != '\n') {
        block_ += c;
        continue;
      }
      received_.push_back(block_);
      block_.clear();
    }
  }

  void compute() {
    if (computes_until_ < now_) computes_until_ = now_;
    while (!received_.empty() && ahead_.size() < settings_.look_ahead && computes_until_ < now_ + kTick_s) {
      auto next = reader_.read(received_.front());
      if (!next) {
        report_.fault = reader_.fault();
        return;
      }
      next->bytes = received_.front().size() + 1;
      next->line = ++line_;
      received_.pop_front();
      computes_until_ += settings_.block_ms * 1e-3;
      pending_.push_back({computes_until_, *next});
    }
    bool is_new = false;
    while (!pending_.empty() && pending_.front().at <= now_ + 0.5 * kTick_s && ahead_.size() < settings_.look_ahead) {
      ahead_.push_back(pending_.front().move);
      knows_end_ = knows_end_ || ahead_.back().ends;
      pending_.pop_front();
      is_new = true;
    }
    if (is_new) look_back();
  }

  [[nodiscard]] double corner(const Move& a, const Move& b) const {
    if (a.rapid || b.rapid || a.length <= 0.0 || b.length <= 0.0) return 0.0;
    double speed = std::min(a.speed, b.speed);
    for (std::size_t k = 0; k < 3; ++k) {
      const double jump = std::abs(b.unit[k] - a.unit[k]);
      if (jump > 1e-12) speed = std::min(speed, settings_.acceleration_mm_s2[k] * settings_.corner_ms * 1e-3 / jump);
    }
    return speed;
  }

  void look_back() {
    double next_entry = 0.0;
    for (std::size_t k = ahead_.size(); k-- > 0;) {
      Move& move = ahead_[k];
      // A word that moves nothing lies between two moves without stopping them.
      const bool passes = move.length <= 0.0 && move.dwell_s <= 0.0 && !move.ends;
      std::size_t other = k + 1;
      while (other < ahead_.size() && ahead_[other].length <= 0.0 && ahead_[other].dwell_s <= 0.0 &&
             !ahead_[other].ends)
        ++other;
      move.exit = other < ahead_.size() ? std::min(corner(move, ahead_[other]), next_entry) : 0.0;
      if (!passes)
        next_entry = move.length > 0.0 ? std::sqrt(move.exit * move.exit + 2 * move.acceleration * move.length) : 0.0;
    }
  }

  void take_next() {
    // Its bytes are free once it begins.
    buffered_ -= std::min(buffered_, ahead_.front().bytes);
    current_ = ahead_.front();
    has_current_ = true;
    place_ = 0.0;
    dwelt_s_ = 0.0;
    if (current_.ends) done_ = true;
  }
  void drop_current() {
    ahead_.pop_front();
    has_current_ = false;
  }

  void stand(double time_s) {
    speed_ = 0.0;
    if (moved_) stood_s_ += time_s;
    note_late(line_of_next());
  }
  [[nodiscard]] std::uint32_t line_of_next() const { return (ahead_.empty() ? last_line_ : ahead_.back().line) + 1; }
  void note_late(std::uint32_t line) {
    if (!moved_ || report_.first_late_line != 0 || knows_end_) return;
    report_.first_late_line = line;
    report_.first_late_s = now_;
  }

  void move(double left_s) {
    while (left_s > 1e-12 && !done_) {
      if (!has_current_) {
        if (ahead_.empty()) return stand(left_s);
        take_next();
        if (done_) {
          report_.cycle_s = now_ + kTick_s - left_s;
          return;
        }
      }
      last_line_ = current_.line;
      current_.exit = ahead_.front().exit;
      if (current_.length > 0.0) {
        left_s -= advance(left_s);
      } else {
        const double waits = std::min(left_s, current_.dwell_s - dwelt_s_);
        if (current_.dwell_s > 0.0) {
          speed_ = 0.0;
          if (!moved_) begin(now_ + kTick_s - left_s);
        }
        dwelt_s_ += waits;
        left_s -= waits;
        if (dwelt_s_ >= current_.dwell_s - 1e-12) drop_current();
      }
    }
  }
  void begin(double at_s) {
    moved_ = true;
    report_.first_move_s = at_s;
  }

  // Moves within the block for up to `time_s`; returns the time used.
  double advance(double time_s) {
    const Move& m = current_;
    if (!moved_) begin(now_ + kTick_s - time_s);
    const double rest = m.length - place_;
    const double room = std::max(0.0, rest - 0.5 * speed_ * time_s);
    const double braked = std::sqrt(m.exit * m.exit + 2 * m.acceleration * room);
    const double wished = std::min(speed_ + m.acceleration * time_s, m.speed);
    const double next = std::max({std::min(wished, braked), speed_ - 1.02 * m.acceleration * time_s, 0.0});
    if (next < wished - 1e-9 && known_end_limits()) note_late(line_of_next());
    double mean = 0.5 * (speed_ + next);
    mean = std::max(mean, std::min(m.speed, 0.25 * m.acceleration * time_s));  // never stuck just before the end
    if (mean * time_s < rest) {
      place_ += mean * time_s;
      speed_ = next;
      return time_s;
    }
    const double used = rest / mean;
    speed_ = std::min(speed_ + (next - speed_) * used / time_s, m.exit);
    drop_current();
    return std::min(used, time_s);
  }

  // Whether the exit of the current block comes from the end of the known ones alone.
  [[nodiscard]] bool known_end_limits() const {
    if (knows_end_ || ahead_.size() >= settings_.look_ahead) return false;
    double speed2 = 0.0;
    for (std::size_t k = ahead_.size(); k-- > 1;) {
      if (ahead_[k].dwell_s > 0.0) return false;
      if (ahead_[k].length > 0.0) speed2 += 2 * ahead_[k].acceleration * ahead_[k].length;
    }
    return std::abs(std::sqrt(speed2) - current_.exit) < 1e-6 * (1.0 + current_.exit);
  }

  struct Pending {
    double at = 0.0;
    Move move;
  };

  std::string_view text_;
  SteppedSettings settings_;
  Reader reader_;
  SteppedReport report_;
  double now_ = 0.0;
  std::size_t sent_ = 0;
  double arrives_at_ = 0.0;
  std::size_t buffered_ = 0;
  std::string block_;
  std::deque<std::string> received_;
  double computes_until_ = 0.0;
  std::deque<Pending> pending_;
  std::deque<Move> ahead_;  // computed, the one that moves first
  Move current_;
  bool has_current_ = false;
  bool knows_end_ = false;
  double place_ = 0.0;
  double dwelt_s_ = 0.0;
  double speed_ = 0.0;
  double stood_s_ = 0.0;
  bool moved_ = false;
  bool done_ = false;
  std::uint32_t line_ = 0;
  std::uint32_t last_line_ = 0;
};

}  // namespace

SteppedReport run_stepped(std::string_view text, const SteppedSettings& settings, double most_s) {
  return Machine(text, settings).run(most_s);
}

}  // namespace dripfeed::simulator
