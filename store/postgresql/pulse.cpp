// Only silence counts: every answer, and every refusal, shows that there is someone.
#include "store/postgresql/pulse.h"

#include <array>
#include <utility>

#include <fmt/format.h>
#include <libpq-fe.h>

#include "store/postgresql/waiting.h"

namespace dripfeed::postgresql {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kAskEvery{1000};

}  // namespace

void HandleDrop::operator()(pg_conn* handle) const { PQfinish(handle); }

Pulse::Pulse(std::string url) : url_(std::move(url)), thread_([this](const std::stop_token& stop) { loop(stop); }) {}

Pulse::~Pulse() {
  thread_.request_stop();
  thread_.join();
}

void Pulse::loop(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    is_silent_.store(hears_nothing(), std::memory_order_relaxed);
    std::unique_lock lock(mutex_);
    woken_.wait_for(lock, stop, kAskEvery, [] { return false; });
  }
}

bool Pulse::hears_nothing() {
  if (handle_ == nullptr || PQstatus(handle_.get()) != CONNECTION_OK) return opens_nothing();
  const auto until = Clock::now() + kPatience;
  const bool is_sent = PQsendQuery(handle_.get(), "SELECT 1") == 1;
  const ResultPtr answer = wait_for_result(handle_.get(), is_sent, [&] { return Clock::now() >= until; });
  if (PQstatus(handle_.get()) == CONNECTION_OK) return false;
  handle_.reset();
  return Clock::now() >= until;
}

// A refusal comes at once; what takes all of the patience is no answer.
bool Pulse::opens_nothing() {
  const std::string patience = fmt::format("{}", kPatience.count());
  // After dbname: here the URL's own time does not count.
  constexpr std::array<const char*, 4> kNames{"fallback_application_name", "dbname", "connect_timeout", nullptr};
  const std::array<const char*, 4> values{"dripfeed", url_.c_str(), patience.c_str(), nullptr};
  const auto begun = Clock::now();
  handle_.reset(PQconnectdbParams(kNames.data(), values.data(), 1));
  if (handle_ != nullptr && PQstatus(handle_.get()) == CONNECTION_OK) {
    make_waitable(handle_.get());
    return false;
  }
  handle_.reset();
  return Clock::now() - begun >= kPatience - std::chrono::milliseconds{100};
}

}  // namespace dripfeed::postgresql
