// The loop: wait for input or the earliest deadline (or the grid), give each control its bytes and the time, send what
// is due.
#include "server/simulator/fleet.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <mutex>
#include <utility>

#include <poll.h>
#include <sys/resource.h>
#include <time.h>

#include "server/simulator/wire.h"

namespace dripfeed::simulator {

namespace {

constexpr Time_ns kMillisecond = 1'000'000;
constexpr Time_ns kSecond = 1000 * kMillisecond;
constexpr Time_ns kLongestWait = 20 * kMillisecond;  // an operator and a stop request are looked at this often
constexpr Time_ns kStayAfterEnd = 1000 * kMillisecond;
constexpr Time_ns kUnconnectedWait = 5 * kMillisecond;
constexpr Time_ns kUnplugged = 2 * kSecond;
constexpr Time_ns kNever = std::numeric_limits<Time_ns>::max();

Time_ns now_ns() { return std::chrono::steady_clock::now().time_since_epoch().count(); }

}  // namespace

// One control and its wire. A lock keeps report() apart from the loop.
class Fleet::Station {
 public:
  Station(StationSettings settings, std::unique_ptr<Wire> wire, std::unique_ptr<Control> control)
      : settings_(std::move(settings)),
        wire_(std::move(wire)),
        control_(std::move(control)),
        line_(settings_.control.faults, settings_.seed),
        cut_after_(find_fault(settings_.control.faults, FaultKind::cut)),
        unplug_after_(find_fault(settings_.control.faults, FaultKind::unplug)),
        deaf_after_(find_fault(settings_.control.faults, FaultKind::half_open)) {
    if (!control_->speaks_first()) control_->start(now_ns());
  }

  // -1: nothing to wait for. A pty without a host is always "hung up", so it is left out for a moment instead of spun
  // on.
  [[nodiscard]] int descriptor() const { return !listens() || now_ns() < rest_until_ ? -1 : wire_->descriptor(); }
  [[nodiscard]] Time_ns deadline() const {
    if (plug_in_at_) return *plug_in_at_;
    if (cut_) return kNever;
    const auto every = control_->look_every();
    const Time_ns look = every && !deaf_ ? std::max(looked_at_ + *every, rest_until_) : kNever;
    return std::min(control_->deadline().value_or(kNever), look);
  }
  [[nodiscard]] std::string address() const { return wire_->address(); }

  void read(bool hung_up) {
    if (!listens()) return;
    std::array<std::byte, 4096> buffer;
    const Time_ns before = std::exchange(looked_at_, now_ns());
    const std::size_t count = wire_->read(buffer);
    const std::lock_guard lock(mutex_);
    const bool connected = wire_->take_connected();
    const bool opened = settings_.link.kind == machine::LinkKind::pty && !hung_up && !reached_;
    if ((connected && taken_ == 0) || (opened && control_->speaks_first())) control_->start(now_ns());
    reached_ = reached_ || connected || opened;
    if (control_->is_inside_program()) host_left_ = host_left_ || connected || (hung_up && count == 0);
    if (count == 0) {
      if (hung_up) rest_until_ = now_ns() + kUnconnectedWait;
      return;
    }
    take(std::span(buffer).first(count), before);
  }

  void tick() {
    const std::lock_guard lock(mutex_);
    const Time_ns now = now_ns();
    if (plug_in_at_ && now >= *plug_in_at_) plug_in();
    control_->tick(now);
    if (cut_ || plug_in_at_ || deaf_) return;
    // By the time of the write and not that of the tick: what the simulation was kept from is not the host's fault.
    const Time_ns taken_at = now_ns();
    std::vector<std::byte> out = control_->take_out(taken_at);
    line_.to_host(out);
    if (!out.empty()) {
      wire_->write(out);
      control_->left_late(now_ns() - taken_at);
    }
    wire_->show(control_->lines());
    if ((control_->finished() || control_->state() == ControlState::alarm) && !settings_.repeat) return;
    if (const auto quiet = control_->quiet_since()) operate(static_cast<double>(now - *quiet) * 1e-9, now);
  }

  [[nodiscard]] bool over() const {
    if (settings_.repeat) return cut_;
    // The host must hear the last DC3 and see the line stay up after it before the cable is pulled.
    const auto quiet = control_->quiet_since();
    const bool left = control_->finished() && quiet && now_ns() - *quiet > kStayAfterEnd;
    return cut_ || left || control_->state() == ControlState::alarm;
  }

  [[nodiscard]] ControlReport report() const {
    const std::lock_guard lock(mutex_);
    return control_->report();
  }

 private:
  [[nodiscard]] bool listens() const { return !cut_ && !plug_in_at_ && !deaf_; }

  // The operator at the control after so many seconds of silence. Inside a program RESET is pressed later, as the
  // rest may still come, unless the host left meanwhile.
  void operate(double quiet_s, Time_ns now) {
    if (settings_.operator_s <= 0) return;
    const bool may_go_on = control_->is_inside_program() && !host_left_;
    if (quiet_s <= (may_go_on ? std::max(settings_.patience_s, settings_.operator_s) : settings_.operator_s)) return;
    host_left_ = false;
    control_->reset();
    control_->start(now);
  }

  // What arrives up to the character at which the line breaks.
  void take(std::span<const std::byte> came, Time_ns before) {
    const auto breaks_at = [&](std::optional<std::uint64_t> after) { return after && taken_ + came.size() >= *after; };
    std::optional<std::uint64_t> first;
    for (const auto& after : {cut_after_, unplug_after_, deaf_after_}) {
      if (breaks_at(after) && (!first || *after < *first)) first = after;
    }
    if (first) came = came.first(static_cast<std::size_t>(*first - std::min(*first, taken_)));
    taken_ += came.size();
    std::vector<std::byte> bytes(came.begin(), came.end());
    line_.to_control(bytes);
    control_->receive(bytes, before, now_ns());
    if (!first) return;
    if (first == deaf_after_) {
      deaf_ = true;
      return;
    }
    wire_->cut();
    if (first == cut_after_) {
      cut_ = true;
      return;
    }
    unplug_after_.reset();
    plug_in_at_ = now_ns() + kUnplugged;
  }

  // The same wire again; a port or path that another took meanwhile stays lost.
  void plug_in() {
    plug_in_at_.reset();
    auto wire = Wire::open(settings_.link);
    if (wire) {
      wire_ = std::move(*wire);
    } else {
      cut_ = true;
    }
  }

  StationSettings settings_;
  std::unique_ptr<Wire> wire_;
  mutable std::mutex mutex_;
  std::unique_ptr<Control> control_;
  LineFaults line_;
  std::optional<std::uint64_t> cut_after_;
  std::optional<std::uint64_t> unplug_after_;
  std::optional<std::uint64_t> deaf_after_;
  std::optional<Time_ns> plug_in_at_;
  std::uint64_t taken_ = 0;
  Time_ns rest_until_ = 0;
  Time_ns looked_at_ = now_ns();
  bool cut_ = false;
  bool deaf_ = false;
  bool reached_ = false;    // a host was there
  bool host_left_ = false;  // or closed its end inside the program
};

// Hundreds of wires are more files than a shell allows by default.
Fleet::Fleet(Time_ns grid_ns) : grid_ns_(grid_ns) {
  rlimit files{};
  if (::getrlimit(RLIMIT_NOFILE, &files) != 0) return;
  files.rlim_cur = files.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &files);
}
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
  next_look_ = now_ns();
  while (!stop.stop_requested() && !std::ranges::all_of(stations_, [](const auto& s) { return s->over(); })) {
    if (grid_ns_ > 0) {
      wait_for_grid();
    } else {
      wait_for_input();
    }
  }
}

void Fleet::wait_for_input() {
  std::vector<pollfd> files(stations_.size());
  Time_ns until = now_ns() + kLongestWait;
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    files[i] = {.fd = stations_[i]->descriptor(), .events = POLLIN, .revents = 0};
    until = std::min(until, stations_[i]->deadline());
  }
  const Time_ns wait = std::max<Time_ns>(0, until - now_ns());
  const timespec timeout{.tv_sec = wait / kSecond, .tv_nsec = wait % kSecond};
  ::ppoll(files.data(), files.size(), &timeout, nullptr);
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    if (files[i].fd >= 0) stations_[i]->read((files[i].revents & (POLLHUP | POLLERR)) != 0);
    stations_[i]->tick();
  }
}

// By absolute time; rounds that were missed are left out.
void Fleet::wait_for_grid() {
  next_look_ = std::max(next_look_ + grid_ns_, now_ns());
  const timespec at{.tv_sec = next_look_ / kSecond, .tv_nsec = next_look_ % kSecond};
  ::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, nullptr);
  for (const auto& station : stations_) {
    if (station->descriptor() >= 0) station->read(false);
    station->tick();
  }
}

ControlReport Fleet::report(std::size_t index) const { return stations_[index]->report(); }
std::string Fleet::address(std::size_t index) const { return stations_[index]->address(); }

}  // namespace dripfeed::simulator
