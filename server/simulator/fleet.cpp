// The loop: wait for input or the earliest deadline, give each control its bytes and the time, send what is due.
#include "server/simulator/fleet.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <mutex>
#include <utility>

#include <poll.h>

#include "server/simulator/wire.h"

namespace dripfeed::simulator {

namespace {

constexpr Time_ns kMillisecond = 1'000'000;
constexpr Time_ns kLongestWait = 20 * kMillisecond;  // an operator and a stop request are looked at this often
constexpr Time_ns kStayAfterEnd = 1000 * kMillisecond;
constexpr Time_ns kUnconnectedWait = 5 * kMillisecond;
constexpr Time_ns kNever = std::numeric_limits<Time_ns>::max();

Time_ns now_ns() { return std::chrono::steady_clock::now().time_since_epoch().count(); }

}  // namespace

class Fleet::Station {
 public:
  Station(StationSettings settings, std::unique_ptr<Wire> wire, std::unique_ptr<Control> control)
      : settings_(std::move(settings)), wire_(std::move(wire)), control_(std::move(control)) {
    control_->start(now_ns());
  }

  // -1: nothing to wait for. A pty without a host is always "hung up", so it is left out for a moment instead of spun
  // on.
  [[nodiscard]] int descriptor() const { return cut_ || now_ns() < rest_until_ ? -1 : wire_->descriptor(); }
  [[nodiscard]] Time_ns deadline() const {
    if (cut_) return kNever;
    const auto every = control_->look_every();
    const Time_ns look = every ? std::max(looked_at_ + *every, rest_until_) : kNever;
    return std::min(control_->deadline().value_or(kNever), look);
  }
  [[nodiscard]] std::string address() const { return wire_->address(); }

  void read(bool hung_up) {
    std::array<std::byte, 4096> buffer;
    const Time_ns before = std::exchange(looked_at_, now_ns());
    const std::size_t count = wire_->read(buffer);
    const std::lock_guard lock(mutex_);
    if (wire_->take_connected() && taken_ == 0) control_->start(now_ns());
    if (count == 0) {
      if (hung_up) rest_until_ = now_ns() + kUnconnectedWait;
      return;
    }
    std::span<const std::byte> bytes = std::span(buffer).first(count);
    taken_ += count;
    if (settings_.cut_after && taken_ >= *settings_.cut_after) {
      bytes = bytes.first(count - static_cast<std::size_t>(taken_ - *settings_.cut_after));
      cut_ = true;
    }
    control_->receive(bytes, before, now_ns());
    if (cut_) wire_->cut();
  }

  void tick() {
    const std::lock_guard lock(mutex_);
    const Time_ns now = now_ns();
    control_->tick(now);
    if (cut_) return;
    const std::vector<std::byte> out = control_->take_out(now);
    if (!out.empty()) wire_->write(out);
    const auto quiet = control_->quiet_since();
    if ((control_->finished() || control_->state() == ControlState::alarm) && !settings_.repeat) return;
    if (settings_.operator_s > 0 && quiet && static_cast<double>(now - *quiet) > settings_.operator_s * 1e9) {
      control_->reset();
      control_->start(now);
    }
  }

  [[nodiscard]] bool over() const {
    if (settings_.repeat) return cut_;
    // The host must hear the last DC3 and see the line stay up behind it before the cable is pulled.
    const auto quiet = control_->quiet_since();
    const bool left = control_->finished() && quiet && now_ns() - *quiet > kStayAfterEnd;
    return cut_ || left || control_->state() == ControlState::alarm;
  }

  [[nodiscard]] ControlReport report() const {
    const std::lock_guard lock(mutex_);
    return control_->report();
  }

 private:
  StationSettings settings_;
  std::unique_ptr<Wire> wire_;
  mutable std::mutex mutex_;
  std::unique_ptr<Control> control_;
  std::uint64_t taken_ = 0;
  Time_ns rest_until_ = 0;
  Time_ns looked_at_ = now_ns();
  bool cut_ = false;
};

Fleet::Fleet() = default;
Fleet::~Fleet() = default;

std::expected<std::size_t, std::string> Fleet::add(StationSettings settings) {
  auto control = make_control(settings.control, settings.record);
  if (!control) return std::unexpected(control.error());
  auto wire = Wire::open(settings.link);
  if (!wire) return std::unexpected(wire.error());
  stations_.push_back(std::make_unique<Station>(std::move(settings), std::move(*wire), std::move(*control)));
  return stations_.size() - 1;
}

void Fleet::run(const std::stop_token& stop) {
  std::vector<pollfd> files(stations_.size());
  while (!stop.stop_requested() && !std::ranges::all_of(stations_, [](const auto& s) { return s->over(); })) {
    Time_ns until = now_ns() + kLongestWait;
    for (std::size_t i = 0; i < stations_.size(); ++i) {
      files[i] = {.fd = stations_[i]->descriptor(), .events = POLLIN, .revents = 0};
      until = std::min(until, stations_[i]->deadline());
    }
    const Time_ns wait = std::max<Time_ns>(0, until - now_ns());
    const timespec timeout{.tv_sec = wait / 1'000'000'000, .tv_nsec = wait % 1'000'000'000};
    ::ppoll(files.data(), files.size(), &timeout, nullptr);
    for (std::size_t i = 0; i < stations_.size(); ++i) {
      if (files[i].fd >= 0) stations_[i]->read((files[i].revents & (POLLHUP | POLLERR)) != 0);
      stations_[i]->tick();
    }
  }
}

ControlReport Fleet::report(std::size_t index) const { return stations_[index]->report(); }
std::string Fleet::address(std::size_t index) const { return stations_[index]->address(); }

}  // namespace dripfeed::simulator
