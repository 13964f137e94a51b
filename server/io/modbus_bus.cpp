// Recovery by the library is off: it would repeat a write whose effect is unknown. After any failure but an exception
// of the server the connection is closed, so that a late answer can never be taken for the next one's.
#include "server/io/modbus_bus.h"

#include <cerrno>
#include <condition_variable>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <modbus.h>

#include "server/machine/bus_settings.h"

namespace dripfeed::io {

namespace {

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

// A mutex that is given in the order of asking, so that a busy unit leaves the others their turn.
class FairLock {
 public:
  void lock() {
    std::unique_lock lock(mutex_);
    const std::uint64_t mine = next_++;
    turn_.wait(lock, [&] { return serving_ == mine; });
  }
  void unlock() {
    {
      const std::lock_guard lock(mutex_);
      ++serving_;
    }
    turn_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable turn_;
  std::uint64_t next_ = 0;
  std::uint64_t serving_ = 0;
};

// One connection or serial line, for all units on it.
class Trunk {
 public:
  Trunk(LinkUrl url, const BusSettings& settings) : url_(std::move(url)), settings_(settings) {}

  [[nodiscard]] bool fits(const BusSettings& settings) const {
    return url_.kind == LinkKind::modbus_tcp ||
           (settings.baud == settings_.baud && settings.framing == settings_.framing);
  }

  // Runs `request` on the connected context; what it returns, or errno where that is below 0. Nothing: not connected.
  template <class Request>
  std::expected<int, app::BusFailure> call(const BusSettings& settings, const Request& request) {
    const std::lock_guard turn(lock_);
    if (!context_) context_ = connect();
    if (!context_ || modbus_set_slave(context_.get(), settings.unit) != 0) return fail(errno);
    modbus_set_response_timeout(context_.get(), settings.timeout_ms / 1000, settings.timeout_ms % 1000 * 1000);
    const int result = request(context_.get());
    if (result >= 0) return result;
    return fail(errno);
  }

 private:
  std::unexpected<app::BusFailure> fail(int error) {
    const bool lost = !is_exception(error);
    if (lost) context_.reset();
    return std::unexpected(
        app::BusFailure{.link_lost = lost, .text = fmt::format("{}: {}", url_.text, modbus_strerror(error))});
  }

  [[nodiscard]] Context connect() const {
    constexpr std::array<char, 3> kParities{'N', 'E', 'O'};
    const bool is_rtu = url_.kind == LinkKind::modbus_rtu;
    Context context(is_rtu ? modbus_new_rtu(url_.path.c_str(), static_cast<int>(settings_.baud),
                                            kParities[static_cast<std::size_t>(settings_.framing.parity)],
                                            settings_.framing.data_bits, settings_.framing.stop_bits)
                           : modbus_new_tcp(url_.host.empty() ? "127.0.0.1" : url_.host.c_str(), url_.port));
    if (!context) return context;
    modbus_set_error_recovery(context.get(), MODBUS_ERROR_RECOVERY_NONE);
    modbus_set_response_timeout(context.get(), settings_.timeout_ms / 1000, settings_.timeout_ms % 1000 * 1000);
    const int error = modbus_connect(context.get()) == 0 ? 0 : errno;
    if (error != 0) {
      context.reset();
      errno = error;
    } else if (is_rtu) {
      modbus_flush(context.get());  // what was on the way to who had the line before
    }
    return context;
  }

  LinkUrl url_;
  BusSettings settings_;
  FairLock lock_;
  Context context_;
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
      return std::unexpected(fmt::format("{}: there are {} register buses already", url.text, kMaxBuses));
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

class ModbusBus final : public app::RegisterBus {
 public:
  ModbusBus(std::shared_ptr<Trunk> trunk, const BusSettings& settings)
      : trunk_(std::move(trunk)), settings_(settings) {}

  std::expected<void, app::BusFailure> write(std::uint16_t address, std::span<const std::uint16_t> registers) override {
    return done(trunk_->call(settings_, [&](modbus_t* context) {
      return modbus_write_registers(context, address, static_cast<int>(registers.size()), registers.data());
    }));
  }
  std::expected<void, app::BusFailure> read(std::uint16_t address, std::span<std::uint16_t> registers) override {
    return done(trunk_->call(settings_, [&](modbus_t* context) {
      return modbus_read_registers(context, address, static_cast<int>(registers.size()), registers.data());
    }));
  }
  std::expected<bool, app::BusFailure> exchange(std::uint16_t to, std::span<const std::uint16_t> registers,
                                                std::uint16_t from, std::span<std::uint16_t> into) override {
    if (has_exchange_ && registers.size() <= MODBUS_MAX_WR_WRITE_REGISTERS) {
      const auto exchanged = trunk_->call(settings_, [&](modbus_t* context) {
        return modbus_write_and_read_registers(context, to, static_cast<int>(registers.size()), registers.data(), from,
                                               static_cast<int>(into.size()), into.data());
      });
      if (exchanged) return true;
      // A server that answers with an exception does not do it this way; it is asked in two steps from now on.
      if (exchanged.error().link_lost) return std::unexpected(exchanged.error());
      has_exchange_ = false;
    }
    const auto written = write(to, registers);
    if (!written) return std::unexpected(written.error());
    return false;
  }

 private:
  static std::expected<void, app::BusFailure> done(const std::expected<int, app::BusFailure>& result) {
    if (result) return {};
    return std::unexpected(result.error());
  }

  std::shared_ptr<Trunk> trunk_;
  BusSettings settings_;
  bool has_exchange_ = true;
};

// A link that cannot be had: every call says why.
class NoBus final : public app::RegisterBus {
 public:
  explicit NoBus(std::string why) : why_(std::move(why)) {}
  std::expected<void, app::BusFailure> write(std::uint16_t, std::span<const std::uint16_t>) override { return fail(); }
  std::expected<void, app::BusFailure> read(std::uint16_t, std::span<std::uint16_t>) override { return fail(); }

 private:
  [[nodiscard]] std::unexpected<app::BusFailure> fail() const {
    return std::unexpected(app::BusFailure{.link_lost = true, .text = why_});
  }
  std::string why_;
};

}  // namespace

std::unique_ptr<app::RegisterBus> make_modbus_bus(const machine::LinkUrl& url) {
  const auto settings = machine::bus_settings_of(url);
  if (!settings) return std::make_unique<NoBus>(settings.error());
  auto trunk = trunks().find(url, *settings);
  if (!trunk) return std::make_unique<NoBus>(trunk.error());
  return std::make_unique<ModbusBus>(std::move(*trunk), *settings);
}

}  // namespace dripfeed::io
