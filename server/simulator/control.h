// What every simulated control is to the driver of its wire (fleet.h), whatever protocol it speaks: it is given bytes
// and the time, and says what it sends and when it wants to be called. No I/O and no clock. The kinds of control are
// rows of a table in control.cpp, by the name of their protocol.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/tape_code/eia.h"
#include "protocol/tape_code/eob.h"
#include "protocol/tape_code/framing.h"
#include "server/simulator/block_clock.h"
#include "server/simulator/fault.h"

namespace dripfeed::simulator {

using Time_ns = std::int64_t;

struct ControlSettings {
  std::string protocol = "dc";  // a name of control_protocols()
  tape_code::Framing framing;
  std::uint32_t baud = 9600;
  tape_code::Code code = tape_code::Code::iso;
  tape_code::EiaSpecials eia_specials;      // for code eia
  tape_code::Eob eob = tape_code::Eob::lf;  // of what it punches
  std::uint32_t buffer_bytes = 2048;
  std::uint32_t stop_free_bytes = 256;   // DC3 when less is free
  std::uint32_t go_free_bytes = 1024;    // DC1 when more is free
  std::uint32_t overrun_budget = 10;     // characters taken after its own DC3
  std::uint32_t host_latency_chars = 5;  // its DC3 on the line and the 4-character time-out of a 16550 before the
                                         // host sees it
  Time_ns host_latency_ns = 0;           // and what does not depend on the line's speed
  double clock_ppm = 0.0;                // by which the line is faster than it should be
  bool uses_dc = true;                   // DC1 and DC3
  bool drives_rts = false;               // its RTS, the host's CTS, is on only while it reads
  Faults faults;                         // those of the control take effect here
  double speed = 1.0;                    // runs this much faster than a machine would
  BlockClockSettings clock;
  // Packet protocols, as in the profile's line.
  std::uint32_t payload_bytes = 128;
  bool counted_frames = false;
  bool messages_end_with_cr = false;
  std::string punches;  // the text that a punching control sends
};

enum class ControlState : std::uint8_t { waiting, reading, held, ended, alarm };
std::string_view name_of(ControlState state);

inline constexpr std::size_t kAfterDc3Bins = 33;  // 0..31 characters, and more

struct ControlReport {
  std::uint64_t bytes = 0;  // arrived
  std::uint64_t blocks_run = 0;
  std::uint64_t bytes_run = 0;  // of finished blocks that were run
  std::uint64_t holds = 0;
  std::uint64_t after_dc3_max = 0;
  std::array<std::uint64_t, kAfterDc3Bins> after_dc3{};
  double line_use = 0.0;  // of the time not held, from the first to the last character
  std::uint64_t parity_errors = 0;
  std::uint64_t framing_errors = 0;
  std::string alarm;         // "" or "087 BUFFER OVERFLOW"
  std::uint64_t stalls = 0;  // times that it ran dry before the end
  double stall_s = 0.0;
  std::uint64_t buffer_min = 0;  // bytes that lay ready when a block was taken, before the end was read
  std::uint64_t buffer_max = 0;
  ControlState state = ControlState::waiting;
  bool unfinished_block = false;  // the text broke off inside a block; it was not run
};

// The lines that the control drives, as its host sees them.
struct ControlLines {
  bool cts = true;  // the control's RTS
  bool dsr = true;  // the control's DTR
};

class Control {
 public:
  Control() = default;
  Control(const Control&) = delete;
  Control& operator=(const Control&) = delete;
  virtual ~Control() = default;

  // The operator starts: a reading control asks for its program. After an end, for the next one.
  virtual void start(Time_ns now) = 0;
  // The operator presses RESET: whatever was read and not run is dropped, an alarm is cleared.
  virtual void reset() = 0;
  // `looked_before`: when the driver last looked and found nothing; the bytes came since, and are taken to have come
  // then. A driver that overslept must not make the host's line look slower than it is.
  virtual void receive(std::span<const std::byte> bytes, Time_ns looked_before, Time_ns now) = 0;
  virtual void tick(Time_ns now) = 0;
  // Bytes that are due to reach the host now; cleared by the call. A driver that comes late has let its own stop sign
  // leave late: what arrived in between came before it and does not count against the host.
  virtual std::vector<std::byte> take_out(Time_ns now) = 0;
  // What the last take_out() gave left so much later: the driver was kept from writing it. The same holds for that.
  virtual void left_late(Time_ns /*by*/) {}
  // When tick() or take_out() has something to do; nothing when only an input can move it.
  [[nodiscard]] virtual std::optional<Time_ns> deadline() const = 0;
  // The time between two looks at the line that this control needs; nothing while it does not listen.
  [[nodiscard]] virtual std::optional<Time_ns> look_every() const = 0;
  [[nodiscard]] virtual ControlLines lines() const { return {}; }
  [[nodiscard]] virtual ControlReport report() const = 0;
  [[nodiscard]] virtual ControlState state() const = 0;
  // Nothing came, nothing runs and nothing is held since this instant (waiting for the host); nothing while busy.
  [[nodiscard]] virtual std::optional<Time_ns> quiet_since() const = 0;
  // Some of a program came and its end did not: who presses RESET now loses the rest of it.
  [[nodiscard]] virtual bool is_inside_program() const = 0;
  // The program ended and everything was run.
  [[nodiscard]] virtual bool finished() const = 0;
  // It begins by itself to send, so it is started when a host is there and not before.
  [[nodiscard]] virtual bool speaks_first() const { return false; }
};

// Gets every wire byte that reaches the control, in the order of arrival; of packets the text in them.
using Record = std::function<void(std::uint8_t)>;

// The names that ControlSettings::protocol may have.
std::vector<std::string_view> control_protocols();
// The control that speaks `settings.protocol`; or one sentence that says which names there are.
std::expected<std::unique_ptr<Control>, std::string> make_control(const ControlSettings& settings, Record record);

}  // namespace dripfeed::simulator
