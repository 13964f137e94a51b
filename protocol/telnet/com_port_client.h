// The client's end of a serial port behind Telnet (RFC 2217): offers the option, sets the line, passes data through and
// shows what the server reports of its modem lines and its receiver.
//
// A server need not answer. What it does not confirm within kAnswerTime is taken as set and named as unconfirmed; a
// server that says another value than was asked for ends the connection, because a line at another speed or parity
// sends the machine something else. Data goes out only once the line is set, and stops while the server asks for it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "protocol/telnet/codes.h"
#include "protocol/telnet/decoder.h"
#include "protocol/telnet/options.h"
#include "protocol/telnet/output.h"

namespace dripfeed::telnet {

inline constexpr Time kOfferTime = std::chrono::seconds(5);   // for the answer to the option itself
inline constexpr Time kAnswerTime = std::chrono::seconds(3);  // for those to the settings
// A server's clock divides its crystal: a rate this near is the rate that was asked for.
inline constexpr std::uint32_t kBaudTolerance_percent = 2;

enum class LineParity : std::uint8_t { none = 1, odd = 2, even = 3 };
enum class LineFlow : std::uint8_t { none = 1, xonxoff = 2, hardware = 3 };

struct ComPortSettings {
  std::uint32_t baud = 9600;
  std::uint8_t data_bits = 8;
  LineParity parity = LineParity::none;
  std::uint8_t stop_bits = 2;
  LineFlow flow = LineFlow::none;
};

enum class ClientState : std::uint8_t { offering, setting, up, failed };
inline constexpr std::size_t kClientStates = 4;
std::string_view name(ClientState state);

enum class ClientInput : std::uint8_t {
  accepted,        // the server does the option
  refused,         // it does not, or not any more
  binary_refused,  // it does not carry eight bits
  answered,        // the last of the settings that count was confirmed
  differs,         // a setting is in effect that was not asked for
  time_out,
};
inline constexpr std::size_t kClientInputs = 6;
std::string_view name(ClientInput input);

enum class ClientAction : std::uint8_t {
  none,
  set,          // send the settings
  go_up,        // data may pass
  go_up_blind,  // data may pass; some settings are unconfirmed
  fail,
};

struct ClientRow {
  ClientState from;
  ClientInput input;
  ClientAction action;
  ClientState to;
};
// One row for each state and input, in their order.
std::span<const ClientRow> client_table();

enum class ClientFailure : std::uint8_t { none, no_answer, not_offered, seven_bits, differs };
std::string_view message(ClientFailure failure);

enum class Setting : std::uint8_t { baud, data_bits, parity, stop_bits, flow };
inline constexpr std::size_t kSettings = 5;
std::string_view name(Setting setting);

struct ClientEvent {
  enum class Kind : std::uint8_t {
    up,
    failed,
    unconfirmed,   // setting
    differs,       // setting, asked, value
    modem_change,  // value: bits of modem::
    line_error,    // value: bits of line::
    suspended,
    resumed,
  };
  Kind kind = Kind::up;
  Setting setting = Setting::baud;
  std::uint32_t asked = 0;
  std::uint32_t value = 0;
};

class ComPortClient : private DecoderSink {
 public:
  static constexpr std::size_t kMaxEvents = 32;

  explicit ComPortClient(const ComPortSettings& settings);
  // The connection stands.
  void begin(Time now);
  // The data among these bytes, into `data`, which has at least their count; how many.
  std::size_t receive(std::span<const std::byte> wire, std::span<std::byte> data, Time now);
  // How many of these bytes it took into pending_out(); none before it is up, while the server suspends, or while
  // earlier data waits.
  std::size_t send(std::span<const std::byte> data);
  void set_dtr(bool on) { set_control(on ? control::kDtrOn : control::kDtrOff); }
  void set_rts(bool on) { set_control(on ? control::kRtsOn : control::kRtsOff); }
  void set_break(bool on) { set_control(on ? control::kBreakOn : control::kBreakOff); }
  // What the server has not sent yet is dropped, where it can.
  void purge_output();

  [[nodiscard]] std::span<const std::byte> pending_out() const { return out_.pending(); }
  void mark_sent(std::size_t count) { out_.mark_sent(count); }
  std::optional<ClientEvent> next_event();
  [[nodiscard]] std::optional<Time> deadline() const { return deadline_; }
  void tick(Time now);

  [[nodiscard]] ClientState state() const { return state_; }
  [[nodiscard]] ClientFailure failure() const { return failure_; }
  [[nodiscard]] bool suspended() const { return suspended_; }
  // Of the last notification; nothing while there was none.
  [[nodiscard]] std::optional<std::uint8_t> modem_lines() const { return modem_; }
  // For a test of the table: a bit for each row of client_table() that was taken.
  [[nodiscard]] std::uint32_t rows_taken() const { return rows_taken_; }

 private:
  void on_negotiation(Verb verb, std::uint8_t option) override;
  void on_subnegotiation(std::uint8_t option, std::span<const std::uint8_t> parameters) override;
  void on_answer(Setting setting, std::uint32_t value);
  void on_control(std::uint8_t value);
  void react(ClientInput input);
  void send_settings();
  void report_unconfirmed();
  void set_control(std::uint8_t value);
  void emit(ClientEvent event);
  [[nodiscard]] std::uint32_t wanted(Setting setting) const;

  ComPortSettings settings_;
  Options options_;
  Decoder decoder_;
  Output out_;
  ClientState state_ = ClientState::offering;
  ClientFailure failure_ = ClientFailure::none;
  std::array<bool, kSettings> confirmed_{};
  bool suspended_ = false;
  std::optional<std::uint8_t> modem_;
  Time now_{};
  std::optional<Time> deadline_;
  std::uint32_t rows_taken_ = 0;
  std::array<ClientEvent, kMaxEvents> events_{};
  std::size_t first_event_ = 0;
  std::size_t event_count_ = 0;
};

}  // namespace dripfeed::telnet
