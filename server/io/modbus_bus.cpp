// Recovery by the library is off: it would repeat a write whose effect is unknown. After any failure the connection is
// closed, so that a late answer can never be taken for the next one's.
#include "server/io/modbus_bus.h"

#include <cerrno>
#include <string>

#include <fmt/format.h>
#include <modbus.h>

namespace dripfeed::io {

namespace {

constexpr std::uint32_t kResponseTimeout_s = 1;

struct FreeContext {
  void operator()(modbus_t* context) const {
    modbus_close(context);
    modbus_free(context);
  }
};

class ModbusTcpBus final : public app::RegisterBus {
 public:
  explicit ModbusTcpBus(machine::LinkUrl url) : url_(std::move(url)) {}

  std::expected<void, app::BusFailure> write(std::uint16_t address, std::span<const std::uint16_t> registers) override {
    return call([&](modbus_t* context) {
      return modbus_write_registers(context, address, static_cast<int>(registers.size()), registers.data());
    });
  }
  std::expected<void, app::BusFailure> read(std::uint16_t address, std::span<std::uint16_t> registers) override {
    return call([&](modbus_t* context) {
      return modbus_read_registers(context, address, static_cast<int>(registers.size()), registers.data());
    });
  }

 private:
  template <class Request>
  std::expected<void, app::BusFailure> call(const Request& request) {
    if (!context_) {
      if (const auto connected = connect(); !connected) return connected;
    }
    if (request(context_.get()) >= 0) return {};
    const int error = errno;
    context_.reset();
    return std::unexpected(
        app::BusFailure{.link_lost = true, .text = fmt::format("{}: {}", url_.text, modbus_strerror(error))});
  }

  std::expected<void, app::BusFailure> connect() {
    std::unique_ptr<modbus_t, FreeContext> context(modbus_new_tcp(url_.host.c_str(), url_.port));
    if (!context || modbus_set_slave(context.get(), url_.unit) != 0) {
      return std::unexpected(
          app::BusFailure{.link_lost = true, .text = fmt::format("{}: {}", url_.text, modbus_strerror(errno))});
    }
    modbus_set_response_timeout(context.get(), kResponseTimeout_s, 0);
    modbus_set_error_recovery(context.get(), MODBUS_ERROR_RECOVERY_NONE);
    if (modbus_connect(context.get()) != 0) {
      return std::unexpected(
          app::BusFailure{.link_lost = true, .text = fmt::format("{}: {}", url_.text, modbus_strerror(errno))});
    }
    context_ = std::move(context);
    return {};
  }

  machine::LinkUrl url_;
  std::unique_ptr<modbus_t, FreeContext> context_;
};

}  // namespace

std::unique_ptr<app::RegisterBus> make_modbus_bus(const machine::LinkUrl& url) {
  return std::make_unique<ModbusTcpBus>(url);
}

}  // namespace dripfeed::io
