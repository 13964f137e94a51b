// A link of bytes to one control: a tty, a pty, a socket. All calls and callbacks happen on the links' thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace dripfeed::app {

// What the receiver of the line counted since the link was opened.
struct LineErrors {
  std::uint64_t parity = 0;
  std::uint64_t framing = 0;
  std::uint64_t overrun = 0;
  std::uint64_t breaks = 0;
  friend bool operator==(const LineErrors&, const LineErrors&) = default;
};

// The note of a link whose other side sends more than any line can bring.
inline constexpr std::string_view kFloodNote =
    "the other side floods the line: more than 262144 bytes a second came. It is read in pieces, and nothing is sent "
    "until it was heard";

class LinkListener {
 public:
  LinkListener() = default;
  LinkListener(const LinkListener&) = delete;
  LinkListener& operator=(const LinkListener&) = delete;
  virtual ~LinkListener() = default;
  // The link carries bytes from now on (a socket after its connect; a tty at once).
  virtual void on_up() = 0;
  virtual void on_receive(std::span<const std::byte> bytes) = 0;
  // A write that was taken in part may go on.
  virtual void on_writable() = 0;
  virtual void on_cts(bool on) = 0;
  virtual void on_dsr(bool on) = 0;
  // The link is gone for good; `reason` is for people. It is called once and never from inside write().
  virtual void on_lost(std::string_view reason) = 0;
};

class Link {
 public:
  Link() = default;
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  // Closes; drops what the driver has not sent where the system allows it. No callback comes after it.
  virtual ~Link() = default;
  // Gives bytes to the driver without blocking; how many it took. 0 when none, then on_writable() follows.
  virtual std::size_t write(std::span<const std::byte> bytes) = 0;
  // What came in and was not given to on_receive() yet, without blocking; 0 when nothing. For a look before a write: a
  // stop sign that has come must be seen before more goes out, and the system's own notice of it may be late.
  virtual std::size_t read(std::span<std::byte> into) = 0;
  // The other side sends more than is read at once: something came that is not given out yet, or did half a second ago.
  // Nothing may be armed meanwhile: a start sign among it was given before. While something lies unread write() takes
  // nothing.
  [[nodiscard]] virtual bool unheard() const { return false; }
  // Bytes that the driver holds unsent, where it shows.
  [[nodiscard]] virtual std::optional<std::uint64_t> unsent() = 0;
  // Bytes that the network past the driver has not confirmed, where there is one.
  [[nodiscard]] virtual std::optional<std::uint64_t> unconfirmed() = 0;
  // Our RTS, off asks the control to stop sending. False where the link has no such line.
  virtual bool set_rts(bool /*on*/) { return false; }
  // Of the UART, where it shows.
  [[nodiscard]] virtual LineErrors errors() const { return {}; }
  // "" or what people should know of a link that is up: what a device server did not confirm.
  [[nodiscard]] virtual std::string_view note() const { return {}; }
};

}  // namespace dripfeed::app
