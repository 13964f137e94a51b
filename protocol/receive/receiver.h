// receive: what a control punches into an idle line. Here live the machine that finds start and end of a reception, the
// judgement of what came (code, parity, start and end, binary, a device server's own words), the names of programs, and
// the requests that an operator punches. No I/O and no store: a driver gives bytes and the time. The machine sends
// nothing but DC3 while a reception is on and it can take no more, and the DC1 that takes this back.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "protocol/receive/state.h"
#include "protocol/tape_code/eia.h"
#include "protocol/tape_code/framing.h"

namespace dripfeed::receive {

// As feed::Time: since an epoch of the driver's choice that never steps back.
using Time = std::chrono::nanoseconds;

// How the control's output is held while we can take no more.
enum class Hold : std::uint8_t { none, dc3, rts };

struct Settings {
  tape_code::EighthBit eighth_bit = tape_code::EighthBit::even;  // what bit 7 carries on this line
  bool eia = false;                                              // the control punches EIA for certain
  bool eia_known = false;  // false: a reception that begins with the stop code of EIA is EIA
  bool find_code =
      false;  // ISO, ASCII or EIA is found out from what comes up to the first EOB, whatever the line sends
  tape_code::EiaSpecials eia_specials{};
  Time quiet = std::chrono::seconds(5);               // without an end sign this long silence ends a reception
  Time short_quiet = std::chrono::milliseconds(500);  // after the final '%'
  std::optional<std::uint8_t> end_character{};        // EOT, ETX, SUB … (7 bits), where the profile has one
  std::uint8_t xon = 0x11;  // the line's flow characters (7 bits): what DC1 and DC3 are on others
  std::uint8_t xoff = 0x13;
  bool flow_below = false;  // they are taken out of what comes in before it is seen here
  Hold hold = Hold::none;
  std::uint64_t max_bytes = kMaxBytes;

  static constexpr std::uint64_t kMaxBytes = std::uint64_t{8} << 20U;
};

enum class EndedBy : std::uint8_t {
  punch_off,
  percent,
  end_code,
  quiet,
  reader_on,
  reset,
  link_lost,
  too_long,
  renewed
};
std::string_view name(EndedBy ended_by);

// A reception that is over.
struct Ending {
  EndedBy by = EndedBy::quiet;
  bool punch_signs = false;  // DC2 began it
  bool eia = false;          // by its first character, or by the settings
  std::uint64_t bytes = 0;   // kept
  Time began_at{};
  Time at{};
};

// Signs on a line of 7 or 8 bits, without parity but for EIA.
inline constexpr std::uint8_t kEiaStop = 0x0B;  // EIA's '%'
inline constexpr std::uint8_t kEiaEob = 0x80;

// One line's receiver. Not thread-safe. Never allocates: characters go to the driver piece by piece.
class Receiver {
 public:
  static constexpr std::size_t kMaxPiece = 512;

  explicit Receiver(const Settings& settings) : settings_(settings) {}

  // Takes bytes up to and with one that ends a reception, or until kMaxPiece are kept; how many it took. Before the
  // next call the driver takes kept() and ended().
  std::size_t receive(std::span<const std::byte> bytes, Time now);
  // The characters of the present reception that were not taken yet, as they came.
  std::span<const std::byte> kept() const { return {piece_.data(), piece_size_}; }
  void mark_taken() { piece_size_ = 0; }
  // The reception that ended, once. All it kept was given by kept() before the next receive().
  std::optional<Ending> ended();
  void link_lost(Time now);
  void tick(Time now);
  std::optional<Time> deadline() const;

  // Whether we can take more. Where the profile has a hold the control's output stands still meanwhile, and so does
  // the quiet time.
  void can_take(bool more, Time now);
  // DC3 or DC1 that wants to go out: at most one byte.
  std::span<const std::byte> pending_out() const { return {out_.data(), out_size_}; }
  void mark_sent(std::size_t n) { out_size_ = n > 0 ? 0 : out_size_; }
  // What RTS should be where the hold is by RTS.
  bool rts() const { return settings_.hold != Hold::rts || !holding_; }
  bool holding() const { return holding_; }

  State state() const { return state_; }
  const Settings& settings() const { return settings_; }

  // For a test of the table: the row's index, reactions first.
  using RowTaken = void (*)(void* context, std::size_t row);
  void observe_rows(RowTaken taken, void* context) {
    row_taken_ = taken;
    row_context_ = context;
  }

 private:
  // What the bytes of a reception say of its code so far.
  enum class Looks : std::uint8_t { open, eia, other };

  bool at_rest() const { return state_ == State::idle || state_ == State::opened; }
  Looks look(std::uint8_t byte) const;
  Input classify(std::uint8_t byte) const;
  Input classify_eia(std::uint8_t byte) const;
  std::optional<Input> sign_of(std::uint8_t character) const;
  void react(Input input, std::uint8_t byte);
  void perform(Action action, Input input, std::uint8_t byte, State to);
  void begin(bool punch_signs);
  void keep(Input input, std::uint8_t byte);
  void end(EndedBy by);
  void put_out(std::uint8_t character);
  bool update(Time now);
  bool progress_by(Condition condition);
  bool holds(Condition condition) const;
  std::optional<Time> ends_at(Condition condition) const;

  Settings settings_;
  State state_ = State::idle;
  Time now_{};
  Time last_input_{};
  Time began_at_{};
  std::uint64_t bytes_ = 0;
  bool percent_seen_ = false;
  bool punch_signs_ = false;
  Looks looks_ = Looks::other;
  bool holding_ = false;
  std::array<std::byte, kMaxPiece> piece_{};
  std::size_t piece_size_ = 0;
  std::array<std::byte, 1> out_{};
  std::size_t out_size_ = 0;
  std::optional<Ending> ended_;
  RowTaken row_taken_ = nullptr;
  void* row_context_ = nullptr;
};

}  // namespace dripfeed::receive
