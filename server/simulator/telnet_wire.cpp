// The server's end of protocol/telnet over another wire. A new peer finds a new server; the modem lines stay as the
// control drives them.
#include "server/simulator/telnet_wire.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "protocol/telnet/com_port_server.h"

namespace dripfeed::simulator {

namespace {

class TelnetWire final : public Wire {
 public:
  explicit TelnetWire(std::unique_ptr<Wire> socket) : socket_(std::move(socket)) {}

  [[nodiscard]] int descriptor() const override { return socket_->descriptor(); }
  [[nodiscard]] bool take_connected() override { return std::exchange(connected_, false); }

  std::size_t read(std::span<std::byte> into) override {
    std::array<std::byte, 1024> wire{};
    const std::size_t most = std::min(wire.size(), into.size());
    const std::size_t count = socket_->read(std::span(wire).first(most));
    if (socket_->take_connected()) {
      connected_ = true;
      server_.emplace();
      server_->begin();
      server_->set_modem_lines(lines_);
    }
    const std::size_t data = server_->receive(std::span(wire).first(count), into);
    flush();
    return data;
  }

  void write(std::span<const std::byte> bytes) override {
    while (!bytes.empty()) {
      const std::size_t taken = server_->send(bytes);
      flush();
      if (taken == 0) return;  // the client suspends: what a control says meanwhile is lost, as in a full device server
      bytes = bytes.subspan(taken);
    }
  }

  void show(const ControlLines& lines) override {
    lines_ = static_cast<std::uint8_t>((lines.cts ? telnet::modem::kCts : 0) | (lines.dsr ? telnet::modem::kDsr : 0));
    server_->set_modem_lines(lines_);
    flush();
  }

  void cut() override { socket_->cut(); }
  [[nodiscard]] std::string address() const override {
    const std::string below = socket_->address();
    return "rfc2217" + below.substr(below.find(':'));
  }

 private:
  void flush() {
    const auto pending = server_->pending_out();
    if (pending.empty()) return;
    socket_->write(pending);
    server_->mark_sent(pending.size());
  }

  std::unique_ptr<Wire> socket_;
  std::optional<telnet::ComPortServer> server_{std::in_place};
  std::uint8_t lines_ = telnet::modem::kCts | telnet::modem::kDsr;
  bool connected_ = false;
};

}  // namespace

std::unique_ptr<Wire> over_telnet(std::unique_ptr<Wire> socket) {
  return std::make_unique<TelnetWire>(std::move(socket));
}

}  // namespace dripfeed::simulator
