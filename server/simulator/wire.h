// The simulated end of a wire: the master of a pseudo-terminal or a listening socket with one peer. Blocking nowhere.
#pragma once

#include <cstddef>
#include <expected>
#include <memory>
#include <span>
#include <string>

#include "server/machine/link_url.h"
#include "server/simulator/control.h"

namespace dripfeed::simulator {

class Wire {
 public:
  static std::expected<std::unique_ptr<Wire>, std::string> open(const machine::LinkUrl& url);
  Wire() = default;
  Wire(const Wire&) = delete;
  Wire& operator=(const Wire&) = delete;
  virtual ~Wire() = default;
  // What to poll for input; -1 while there is nothing to wait for.
  [[nodiscard]] virtual int descriptor() const = 0;
  // A peer connected since the last call (a socket only; a pty does not show it).
  [[nodiscard]] virtual bool take_connected() { return false; }
  // Bytes that came; 0 when none.
  virtual std::size_t read(std::span<std::byte> into) = 0;
  virtual void write(std::span<const std::byte> bytes) = 0;
  // Shows the lines to the host, where the wire has any.
  virtual void show(const ControlLines&) {}
  // Closes at once, as a cut cable or a reset connection.
  virtual void cut() = 0;
  [[nodiscard]] virtual std::string address() const = 0;
};

}  // namespace dripfeed::simulator
