// Recovery by the library is off: it would repeat a write whose effect is unknown. After any failure but an exception
// of the server the connection is closed, so that a late answer can never be taken for the next one's.
//
// Whose turn: of those who are due the one that was served longest ago. A unit that failed twice in a row rests for
// three times what it cost, as long as it does not have the bus to itself: so a dead one has a quarter of the bus at
// the most, and nothing waits for it longer than its time-out.
#include "server/io/modbus_bus.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <modbus.h>
#include <spdlog/spdlog.h>
#include <sys/prctl.h>

#include "server/io/serial_port.h"
#include "server/machine/bus_settings.h"

namespace dripfeed::io {

namespace {

using Clock = std::chrono::steady_clock;
using machine::BusSettings;
using machine::LinkKind;
using machine::LinkUrl;

struct FreeContext {
  void operator()(modbus_t* context) const {
    modbus_close(context);
    modbus_free(context);
  }
};
using Context = std::unique_ptr<modbus_t, FreeContext>;

// The server answered, with an exception: the connection is in step.
bool is_exception(int error) { return error >= EMBXILFUN && error <= EMBXGTAR; }

// The socket or the serial line below a bus.
class Connection {
 public:
  Connection(LinkUrl url, const BusSettings& settings) : url_(std::move(url)), settings_(settings) {}

  [[nodiscard]] bool fits(const BusSettings& settings) const {
    return url_.kind == LinkKind::modbus_tcp ||
           (settings.baud == settings_.baud && settings.framing == settings_.framing);
  }

  // Runs `request` on the connected context; what it returns, or errno where that is below 0.
  template <class Request>
  std::expected<int, app::BusFailure> call(const BusSettings& settings, const Request& request) {
    if (!context_) context_ = connect(settings);
    if (!context_ || modbus_set_slave(context_.get(), settings.unit) != 0) return fail(errno);
    set_timeout(*context_, settings);
    const int result = request(context_.get());
    if (result >= 0) return result;
    return fail(errno);
  }

 private:
  static void set_timeout(modbus_t& context, const BusSettings& settings) {
    modbus_set_response_timeout(&context, settings.timeout_ms / 1000, settings.timeout_ms % 1000 * 1000);
  }

  std::unexpected<app::BusFailure> fail(int error) {
    const bool lost = !is_exception(error);
    if (lost) context_.reset();
    return std::unexpected(
        app::BusFailure{.link_lost = lost, .text = fmt::format("{}: {}", url_.text, modbus_strerror(error))});
  }

  [[nodiscard]] Context connect(const BusSettings& settings) const {
    constexpr std::array<char, 3> kParities{'N', 'E', 'O'};
    const bool is_rtu = url_.kind == LinkKind::modbus_rtu;
    Context context(is_rtu ? modbus_new_rtu(url_.path.c_str(), static_cast<int>(settings_.baud),
                                            kParities[static_cast<std::size_t>(settings_.framing.parity)],
                                            settings_.framing.data_bits, settings_.framing.stop_bits)
                           : modbus_new_tcp(url_.host.empty() ? "127.0.0.1" : url_.host.c_str(), url_.port));
    if (!context) return context;
    modbus_set_error_recovery(context.get(), MODBUS_ERROR_RECOVERY_NONE);
    set_timeout(*context, settings);
    const int error = modbus_connect(context.get()) == 0 ? 0 : errno;
    if (error != 0) {
      context.reset();
      errno = error;
    } else if (is_rtu && !take_port(modbus_get_socket(context.get()), url_.path)) {
      context.reset();
      errno = EBUSY;
    } else if (is_rtu) {
      modbus_flush(context.get());  // what was in transit to who had the line before
    }
    return context;
  }

  LinkUrl url_;
  BusSettings settings_;
  Context context_;
};

// One unit's registers.
class UnitBus final : public app::RegisterBus {
 public:
  UnitBus(Connection& connection, const BusSettings& settings) : connection_(connection), settings_(settings) {}

  std::expected<void, app::BusFailure> write(std::uint16_t address, std::span<const std::uint16_t> registers) override {
    return done(call([&](modbus_t* context) {
      return modbus_write_registers(context, address, static_cast<int>(registers.size()), registers.data());
    }));
  }
  std::expected<void, app::BusFailure> read(std::uint16_t address, std::span<std::uint16_t> registers) override {
    return done(call([&](modbus_t* context) {
      return modbus_read_registers(context, address, static_cast<int>(registers.size()), registers.data());
    }));
  }
  std::expected<bool, app::BusFailure> exchange(std::uint16_t to, std::span<const std::uint16_t> registers,
                                                std::uint16_t from, std::span<std::uint16_t> into) override {
    if (has_exchange_ && registers.size() <= MODBUS_MAX_WR_WRITE_REGISTERS) {
      const auto exchanged = call([&](modbus_t* context) {
        return modbus_write_and_read_registers(context, to, static_cast<int>(registers.size()), registers.data(), from,
                                               static_cast<int>(into.size()), into.data());
      });
      if (exchanged) return true;
      // A server that answers with an exception does not do it like this; it is asked in two steps from now on.
      if (exchanged.error().link_lost) return std::unexpected(exchanged.error());
      has_exchange_ = false;
    }
    const auto written = write(to, registers);
    if (!written) return std::unexpected(written.error());
    return false;
  }

  // Requests in a row that no one answered.
  [[nodiscard]] int lost() const { return lost_; }

 private:
  template <class Request>
  std::expected<int, app::BusFailure> call(const Request& request) {
    auto result = connection_.call(settings_, request);
    const bool answered = result || !result.error().link_lost;
    lost_ = answered ? 0 : lost_ + 1;
    return result;
  }
  static std::expected<void, app::BusFailure> done(const std::expected<int, app::BusFailure>& result) {
    if (result) return {};
    return std::unexpected(result.error());
  }

  Connection& connection_;
  BusSettings settings_;
  bool has_exchange_ = true;
  int lost_ = 0;
};

constexpr int kLostUntilRest = 2;
constexpr int kRestFor = 3;  // times what the failure cost
constexpr std::chrono::seconds kLongestRest{5};
constexpr std::chrono::seconds kAfterException{1};

// Who sits on a bus.
struct Place {
  Place(app::BusUser& user_, Connection& connection, const BusSettings& settings)
      : user(user_), bus(connection, settings) {}
  app::BusUser& user;
  UnitBus bus;
  Clock::time_point due = Clock::time_point::min();
  Clock::time_point rests_until = Clock::time_point::min();
  std::uint64_t served = 0;  // when, in turns
  bool woken = false;        // during its turn
  bool leaving = false;
};

// One connection with its thread.
class Trunk {
 public:
  Trunk(LinkUrl url, const BusSettings& settings)
      : connection_(std::move(url), settings), thread_([this](const std::stop_token& stop) { loop(stop); }) {}

  [[nodiscard]] bool fits(const BusSettings& settings) const { return connection_.fits(settings); }

  std::shared_ptr<Place> enter(app::BusUser& user, const BusSettings& settings) {
    auto place = std::make_shared<Place>(user, connection_, settings);
    const std::lock_guard lock(mutex_);
    places_.push_back(place);
    ++wakes_;
    wake_.notify_all();
    return place;
  }

  // After it the user has no turn any more.
  void leave(const std::shared_ptr<Place>& place) {
    std::unique_lock lock(mutex_);
    place->leaving = true;
    turn_over_.wait(lock, [&] { return running_ != place.get(); });
    std::erase(places_, place);
  }

  void wake(Place& place) {
    const std::lock_guard lock(mutex_);
    place.woken = true;
    place.due = Clock::time_point::min();
    ++wakes_;
    wake_.notify_all();
  }

 private:
  [[nodiscard]] Clock::time_point due_of(const Place& place) const {
    return places_.size() > 1 ? std::max(place.due, place.rests_until) : place.due;
  }

  // Who is due and was served longest ago; no user: when the next one will be.
  std::shared_ptr<Place> next(Clock::time_point now, Clock::time_point& earliest) const {
    std::shared_ptr<Place> chosen;
    earliest = Clock::time_point::max();
    for (const auto& place : places_) {
      if (place->leaving) continue;
      const Clock::time_point due = due_of(*place);
      earliest = std::min(earliest, due);
      if (due <= now && (!chosen || place->served < chosen->served)) chosen = place;
    }
    return chosen;
  }

  void loop(const std::stop_token& stop) {
    ::prctl(PR_SET_NAME, "register bus");
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
      Clock::time_point earliest;
      const auto place = next(Clock::now(), earliest);
      if (place) {
        give_turn(*place, lock);
        continue;
      }
      const auto changed = [this, before = wakes_] { return wakes_ != before; };
      if (earliest == Clock::time_point::max()) {
        wake_.wait(lock, stop, changed);
      } else {
        wake_.wait_until(lock, stop, earliest, changed);
      }
    }
  }

  void give_turn(Place& place, std::unique_lock<std::mutex>& lock) {
    place.woken = false;
    running_ = &place;
    lock.unlock();
    const Clock::time_point begun = Clock::now();
    const int lost_before = place.bus.lost();
    const auto wait = fenced_turn(place);
    const Clock::time_point ended = Clock::now();
    const int lost = place.bus.lost();
    lock.lock();
    running_ = nullptr;
    place.served = ++turns_;
    if (!place.woken) place.due = wait ? due_in(ended, *wait) : Clock::time_point::max();
    if (lost > lost_before && lost >= kLostUntilRest)
      place.rests_until = ended + std::min<Clock::duration>(kRestFor * (ended - begun), kLongestRest);
    if (place.leaving) turn_over_.notify_all();
  }

  // The fence of the thread: what one user throws (no memory, say) is reported, and the others have their turns.
  static std::optional<std::chrono::nanoseconds> fenced_turn(Place& place) {
    try {
      return place.user.turn(place.bus);
    } catch (const std::exception& error) {
      spdlog::critical("a register bus: {}", error.what());
      return kAfterException;
    }
  }

  // Times beyond a day are looked at again then.
  static Clock::time_point due_in(Clock::time_point now, std::chrono::nanoseconds wait) {
    return now + std::min<Clock::duration>(wait, std::chrono::hours(24));
  }

  Connection connection_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::condition_variable turn_over_;
  std::vector<std::shared_ptr<Place>> places_;
  const Place* running_ = nullptr;
  std::uint64_t turns_ = 0;
  std::uint64_t wakes_ = 0;  // grows with all that may make a user due
  std::jthread thread_;      // last: it uses all of the above
};

// Who shares what: machines on one serial line, or behind one gateway.
class Trunks {
 public:
  std::expected<std::shared_ptr<Trunk>, std::string> find(const LinkUrl& url, const BusSettings& settings) {
    const std::string key = url.kind == LinkKind::modbus_rtu ? url.path : fmt::format("{}:{}", url.host, url.port);
    const std::lock_guard lock(mutex_);
    std::erase_if(trunks_, [](const auto& row) { return row.second.expired(); });
    if (const auto known = trunks_.find(key); known != trunks_.end()) {
      if (const auto trunk = known->second.lock()) {
        if (trunk->fits(settings)) return trunk;
        return std::unexpected(fmt::format("{}: another machine uses this line with other settings", url.text));
      }
    }
    if (trunks_.size() >= kMaxBuses) {
      return std::unexpected(
          fmt::format("{}: there are {} register buses already; more than that are not served", url.text, kMaxBuses));
    }
    auto trunk = std::make_shared<Trunk>(url, settings);
    trunks_[key] = trunk;
    return trunk;
  }

 private:
  std::mutex mutex_;
  std::map<std::string, std::weak_ptr<Trunk>> trunks_;
};

Trunks& trunks() {
  static Trunks all;
  return all;
}

class ModbusSeat final : public app::BusSeat {
 public:
  ModbusSeat(std::shared_ptr<Trunk> trunk, app::BusUser& user, const BusSettings& settings)
      : trunk_(std::move(trunk)), place_(trunk_->enter(user, settings)) {}
  ~ModbusSeat() override { trunk_->leave(place_); }
  void wake() override { trunk_->wake(*place_); }

 private:
  std::shared_ptr<Trunk> trunk_;
  std::shared_ptr<Place> place_;
};

}  // namespace

std::expected<std::unique_ptr<app::BusSeat>, std::string> take_modbus_seat(const machine::LinkUrl& url,
                                                                           app::BusUser& user) {
  const auto settings = machine::bus_settings_of(url);
  if (!settings) return std::unexpected(settings.error());
  auto trunk = trunks().find(url, *settings);
  if (!trunk) return std::unexpected(trunk.error());
  return std::make_unique<ModbusSeat>(std::move(*trunk), user, *settings);
}

}  // namespace dripfeed::io
