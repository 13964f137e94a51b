// One Modbus server as registers. Calls block, so a bus has a thread of its own. Whether a write that failed took
// effect is unknown: the handshake above reads back.
#pragma once

#include <cstdint>
#include <expected>
#include <memory>
#include <span>
#include <string>

#include "server/machine/link_url.h"

namespace dripfeed::app {

// Where the two register images of the block mailbox (protocol/modbus) lie at the server.
inline constexpr std::uint16_t kMailboxAddress = 0;
inline constexpr std::uint16_t kStatusAddress = 128;

struct BusFailure {
  bool link_lost = false;  // the connection is closed; the next call opens it again
  std::string text;
};

class RegisterBus {
 public:
  RegisterBus() = default;
  RegisterBus(const RegisterBus&) = delete;
  RegisterBus& operator=(const RegisterBus&) = delete;
  virtual ~RegisterBus() = default;
  virtual std::expected<void, BusFailure> write(std::uint16_t address, std::span<const std::uint16_t> registers) = 0;
  virtual std::expected<void, BusFailure> read(std::uint16_t address, std::span<std::uint16_t> registers) = 0;
  // Writes, and reads in the same request what stands at `from` behind the write, where the bus can (FC23): true.
  // False: written only, `into` is as it was.
  virtual std::expected<bool, BusFailure> exchange(std::uint16_t to, std::span<const std::uint16_t> registers,
                                                   [[maybe_unused]] std::uint16_t from,
                                                   [[maybe_unused]] std::span<std::uint16_t> into) {
    const auto written = write(to, registers);
    if (!written) return std::unexpected(written.error());
    return false;
  }
};

// Makes a bus for modbus-tcp:// and modbus-rtu: links. It connects with the first call.
using RegisterBusMaker = std::unique_ptr<RegisterBus> (*)(const machine::LinkUrl& url);

}  // namespace dripfeed::app
