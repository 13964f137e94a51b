// One Modbus server as registers, and the thread of the bus that it lies on. Calls block, so they are made in turns on
// the bus's own thread. Whether a write that failed took effect is unknown: the handshake above reads back.
#pragma once

#include <chrono>
#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "server/machine/link_url.h"

namespace dripfeed::app {

// Where the register images of the block mailbox (protocol/modbus) lie at the server; the machine's words are right
// after the status.
inline constexpr std::uint16_t kMailboxAddress = 0;
inline constexpr std::uint16_t kAnswerAddress = 121;
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
  // Writes, and reads in the same request what stands at `from` after the write, where the bus can (FC23): true.
  // False: written only, `into` is as it was.
  virtual std::expected<bool, BusFailure> exchange(std::uint16_t to, std::span<const std::uint16_t> registers,
                                                   [[maybe_unused]] std::uint16_t from,
                                                   [[maybe_unused]] std::span<std::uint16_t> into) {
    const auto written = write(to, registers);
    if (!written) return std::unexpected(written.error());
    return false;
  }
};

// Who has a server on a bus.
class BusUser {
 public:
  // On the bus's thread: makes one request at most (two where the bus cannot write and read in one). In how long the
  // next turn is wanted; nothing: not before a wake().
  virtual std::optional<std::chrono::nanoseconds> turn(RegisterBus& bus) = 0;

 protected:
  ~BusUser() = default;
};

// A user's place on the bus. Its turns begin at once; the destructor waits for one that has begun.
class BusSeat {
 public:
  BusSeat() = default;
  BusSeat(const BusSeat&) = delete;
  BusSeat& operator=(const BusSeat&) = delete;
  virtual ~BusSeat() = default;
  // A turn as soon as the others let it. From any thread.
  virtual void wake() = 0;
};

// A seat for a modbus-tcp:// or modbus-rtu: link; or one sentence that says why there is none. The bus connects with
// the first call. `user` must outlive the seat.
using BusSeatMaker = std::expected<std::unique_ptr<BusSeat>, std::string> (*)(const machine::LinkUrl& url,
                                                                              BusUser& user);

}  // namespace dripfeed::app
