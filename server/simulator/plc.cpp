// One thread: it waits for requests and gives each to its unit, and lets the units run.
#include "server/simulator/plc.h"

#include <algorithm>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "server/machine/bus_settings.h"
#include "server/simulator/plc_port.h"
#include "server/simulator/plc_unit.h"

namespace dripfeed::simulator {

namespace {

constexpr int kPoll_ms = 5;
constexpr std::size_t kLastUnit = 247;

using Units = std::vector<std::unique_ptr<PlcUnit>>;

class ModbusPlc final : public Plc {
 public:
  ModbusPlc(Units units, std::unique_ptr<PlcPort> port)
      : units_(std::move(units)),
        port_(std::move(port)),
        thread_([this](const std::stop_token& stop) { loop(stop); }) {}
  ~ModbusPlc() override {
    thread_.request_stop();
    thread_.join();
  }

  [[nodiscard]] PlcReport report(std::size_t index) const override { return units_.at(index)->report(); }
  [[nodiscard]] std::uint16_t port() const override { return port_->port(); }

 private:
  void loop(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      port_->serve(kPoll_ms, [this](const PlcRequest& request) { return answer(request); });
      for (const auto& unit : units_) unit->run();
    }
  }

  std::span<const std::uint8_t> answer(const PlcRequest& request) {
    // A TCP server of its own is asked by whatever unit; on a line others answer for theirs.
    const bool alone = units_.size() == 1 && !port_->is_serial();
    const auto unit = alone ? units_.begin() : std::ranges::find(units_, request.unit(), &PlcUnit::number);
    if (unit == units_.end()) return {};
    const auto out = (*unit)->answer(request);
    if ((*unit)->take_restarted()) port_->drop_all();
    return out;
  }

  Units units_;
  std::unique_ptr<PlcPort> port_;
  std::jthread thread_;  // last: it uses all of the above
};

}  // namespace

std::expected<std::unique_ptr<Plc>, std::string> Plc::start(const machine::LinkUrl& url, const PlcSettings& settings) {
  const auto bus = machine::bus_settings_of(url);
  if (!bus) return std::unexpected(bus.error());
  if (bus->unit + settings.units - 1 > kLastUnit)
    return std::unexpected(fmt::format("{}: the units end at {}", url.text, kLastUnit));
  const bool is_serial = url.kind == machine::LinkKind::modbus_rtu;
  auto port = is_serial ? open_rtu_port(url) : open_tcp_port(url);
  if (!port) return std::unexpected(port.error());
  Units units;
  for (std::size_t i = 0; i < settings.units; ++i)
    units.push_back(PlcUnit::make(settings, static_cast<std::uint8_t>(bus->unit + i), is_serial));
  return std::make_unique<ModbusPlc>(std::move(units), std::move(*port));
}

}  // namespace dripfeed::simulator
