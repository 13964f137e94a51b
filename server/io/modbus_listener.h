// A Modbus TCP server on an address of its own, for PLCs that read what the machines do. Frames and answers are
// those of protocol/modbus; the registers come from whoever gives the view.
#pragma once

#include <cstdint>
#include <expected>
#include <memory>
#include <string>
#include <vector>

#include "protocol/modbus/register_server.h"

namespace dripfeed::io {

struct ModbusListenSettings {
  std::string host = "127.0.0.1";
  std::uint16_t port = 502;
  // IP addresses that may connect; others are let go at once. Empty: whoever reaches a loopback address, and then the
  // address must be one, because Modbus itself knows no rights.
  std::vector<std::string> allowed;
};

class ModbusListener {
 public:
  // Connections at the same time; more are let go at once.
  static constexpr std::size_t kMaxConnections = 16;

  ModbusListener() = default;
  ModbusListener(const ModbusListener&) = delete;
  ModbusListener& operator=(const ModbusListener&) = delete;
  virtual ~ModbusListener() = default;
  [[nodiscard]] virtual std::uint16_t port() const = 0;
  // From any thread: who may connect from now on, and connections of others end. Or the sentence of listen_modbus(),
  // and nothing changes.
  virtual std::expected<void, std::string> set_allowed(const std::vector<std::string>& allowed) = 0;
  // Connections that were not allowed or were too many, since the start.
  [[nodiscard]] virtual std::uint64_t refused() const = 0;
};

// Listens and answers on a thread of its own; the view is used there alone and must outlive the listener. Or one
// sentence that says what is wrong with the settings, or what the system refused.
std::expected<std::unique_ptr<ModbusListener>, std::string> listen_modbus(const ModbusListenSettings& settings,
                                                                          modbus::RegisterView& view);

}  // namespace dripfeed::io
