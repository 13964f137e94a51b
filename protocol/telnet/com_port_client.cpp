// Every change of state is a row of kTable. The settings that count for a machine (speed, bits, parity, stop bits) are
// awaited; flow control is asked for and reported, because servers differ in what they say of it.
#include "protocol/telnet/com_port_client.h"

namespace dripfeed::telnet {

namespace {

using S = ClientState;
using I = ClientInput;
using A = ClientAction;

constexpr std::array kTable = {
    ClientRow{S::offering, I::accepted, A::set, S::setting},
    ClientRow{S::offering, I::refused, A::fail, S::failed},
    ClientRow{S::offering, I::binary_refused, A::fail, S::failed},
    ClientRow{S::offering, I::answered, A::none, S::offering},
    ClientRow{S::offering, I::differs, A::none, S::offering},
    ClientRow{S::offering, I::time_out, A::fail, S::failed},

    ClientRow{S::setting, I::accepted, A::none, S::setting},
    ClientRow{S::setting, I::refused, A::fail, S::failed},
    ClientRow{S::setting, I::binary_refused, A::fail, S::failed},
    ClientRow{S::setting, I::answered, A::go_up, S::up},
    ClientRow{S::setting, I::differs, A::fail, S::failed},
    ClientRow{S::setting, I::time_out, A::go_up_blind, S::up},

    ClientRow{S::up, I::accepted, A::none, S::up},
    ClientRow{S::up, I::refused, A::fail, S::failed},
    ClientRow{S::up, I::binary_refused, A::fail, S::failed},
    ClientRow{S::up, I::answered, A::none, S::up},
    ClientRow{S::up, I::differs, A::fail, S::failed},
    ClientRow{S::up, I::time_out, A::none, S::up},

    ClientRow{S::failed, I::accepted, A::none, S::failed},
    ClientRow{S::failed, I::refused, A::none, S::failed},
    ClientRow{S::failed, I::binary_refused, A::none, S::failed},
    ClientRow{S::failed, I::answered, A::none, S::failed},
    ClientRow{S::failed, I::differs, A::none, S::failed},
    ClientRow{S::failed, I::time_out, A::none, S::failed},
};

constexpr bool table_is_whole() {
  if (kTable.size() != kClientStates * kClientInputs) return false;
  for (std::size_t i = 0; i < kTable.size(); ++i) {
    if (static_cast<std::size_t>(kTable[i].from) != i / kClientInputs) return false;
    if (static_cast<std::size_t>(kTable[i].input) != i % kClientInputs) return false;
  }
  return true;
}
static_assert(table_is_whole());

constexpr std::array kOptions = {
    OptionRow{.option = kComPort, .ours = true, .theirs = false},
    OptionRow{.option = kBinary, .ours = true, .theirs = true},
    OptionRow{.option = kSuppressGoAhead, .ours = true, .theirs = true},
};

struct SettingRow {
  Setting setting;
  ComPort command;
  std::size_t octets;
  bool awaited;
};
constexpr std::array kSettingRows = {
    SettingRow{Setting::baud, ComPort::set_baudrate, 4, true},
    SettingRow{Setting::data_bits, ComPort::set_datasize, 1, true},
    SettingRow{Setting::parity, ComPort::set_parity, 1, true},
    SettingRow{Setting::stop_bits, ComPort::set_stopsize, 1, true},
    SettingRow{Setting::flow, ComPort::set_control, 1, false},
};

bool same_value(Setting setting, std::uint32_t asked, std::uint32_t got) {
  if (setting != Setting::baud) return asked == got;
  const std::uint32_t off = asked > got ? asked - got : got - asked;
  return static_cast<std::uint64_t>(off) * 100 <= static_cast<std::uint64_t>(asked) * kBaudTolerance_percent;
}

std::uint32_t number(std::span<const std::uint8_t> octets) {
  std::uint32_t value = 0;
  for (const std::uint8_t octet : octets) value = value << 8U | octet;
  return value;
}

constexpr ClientFailure failure_of(ClientState from, ClientInput input) {
  switch (input) {
    case I::accepted:
    case I::answered: return ClientFailure::none;
    case I::refused: return ClientFailure::not_offered;
    case I::binary_refused: return ClientFailure::seven_bits;
    case I::differs: return ClientFailure::differs;
    case I::time_out: return from == S::offering ? ClientFailure::no_answer : ClientFailure::none;
  }
  return ClientFailure::none;
}

}  // namespace

std::span<const ClientRow> client_table() { return kTable; }

std::string_view name(ClientState state) {
  static constexpr std::array<std::string_view, kClientStates> kNames = {"offering", "setting", "up", "failed"};
  return kNames[static_cast<std::size_t>(state)];
}

std::string_view name(ClientInput input) {
  static constexpr std::array<std::string_view, kClientInputs> kNames = {"accepted", "refused", "binary_refused",
                                                                         "answered", "differs", "time_out"};
  return kNames[static_cast<std::size_t>(input)];
}

std::string_view name(Setting setting) {
  static constexpr std::array<std::string_view, kSettings> kNames = {"baud", "data bits", "parity", "stop bits",
                                                                     "flow control"};
  return kNames[static_cast<std::size_t>(setting)];
}

std::string_view message(ClientFailure failure) {
  static constexpr std::array<std::string_view, 5> kTexts = {
      "",
      "the server does not answer as an RFC 2217 server",
      "the server refuses the COM-PORT option of RFC 2217",
      "the server refuses eight-bit (BINARY) transmission",
      "the server did not set the line as requested",
  };
  return kTexts[static_cast<std::size_t>(failure)];
}

ComPortClient::ComPortClient(const ComPortSettings& settings) : settings_(settings), options_(kOptions) {}

void ComPortClient::begin(Time now) {
  now_ = now;
  deadline_ = now + kOfferTime;
  options_.ask(out_);
}

std::size_t ComPortClient::receive(std::span<const std::byte> wire, std::span<std::byte> data, Time now) {
  now_ = now;
  return decoder_.decode(wire, data, *this);
}

std::size_t ComPortClient::send(std::span<const std::byte> data) {
  if (state_ != ClientState::up || suspended_ || !out_.pending().empty()) return 0;
  return out_.data(data, options_.ours(kBinary) == Options::Side::on);
}

void ComPortClient::purge_output() {
  if (state_ != ClientState::up && state_ != ClientState::setting) return;
  constexpr std::array<std::uint8_t, 1> kOutput = {kPurgeOutput};
  out_.subnegotiate(kComPort, static_cast<std::uint8_t>(ComPort::purge_data), kOutput);
}

void ComPortClient::set_control(std::uint8_t value) {
  const std::array<std::uint8_t, 1> octet = {value};
  out_.subnegotiate(kComPort, static_cast<std::uint8_t>(ComPort::set_control), octet);
}

std::uint32_t ComPortClient::wanted(Setting setting) const {
  switch (setting) {
    case Setting::baud: return settings_.baud;
    case Setting::data_bits: return settings_.data_bits;
    case Setting::parity: return static_cast<std::uint32_t>(settings_.parity);
    case Setting::stop_bits: return settings_.stop_bits;
    case Setting::flow: return static_cast<std::uint32_t>(settings_.flow);
  }
  return 0;
}

// What an earlier client left in the server's buffer must not reach the machine now.
void ComPortClient::send_settings() {
  for (const SettingRow& row : kSettingRows) {
    const std::uint32_t value = wanted(row.setting);
    std::array<std::uint8_t, 4> octets{};
    for (std::size_t i = 0; i < row.octets; ++i) {
      octets[i] = static_cast<std::uint8_t>(value >> (8 * (row.octets - 1 - i)));
    }
    out_.subnegotiate(kComPort, static_cast<std::uint8_t>(row.command), std::span(octets).first(row.octets));
  }
  set_dtr(true);
  set_rts(true);
  // All but the ring's trailing edge: FF would have to be doubled here, and there are servers that do not undouble it
  // and send what they take for data to the machine.
  constexpr std::array<std::uint8_t, 1> kAllLines = {0xFB};
  constexpr std::array<std::uint8_t, 1> kErrors = {line::kErrors};
  out_.subnegotiate(kComPort, static_cast<std::uint8_t>(ComPort::set_modemstate_mask), kAllLines);
  out_.subnegotiate(kComPort, static_cast<std::uint8_t>(ComPort::set_linestate_mask), kErrors);
  constexpr std::array<std::uint8_t, 1> kOutput = {kPurgeOutput};
  out_.subnegotiate(kComPort, static_cast<std::uint8_t>(ComPort::purge_data), kOutput);
  deadline_ = now_ + kAnswerTime;
}

void ComPortClient::report_unconfirmed() {
  for (const SettingRow& row : kSettingRows) {
    if (!confirmed_[static_cast<std::size_t>(row.setting)])
      emit({.kind = ClientEvent::Kind::unconfirmed, .setting = row.setting, .asked = wanted(row.setting), .value = 0});
  }
}

void ComPortClient::react(ClientInput input) {
  const std::size_t index = static_cast<std::size_t>(state_) * kClientInputs + static_cast<std::size_t>(input);
  const ClientRow& row = kTable[index];
  rows_taken_ |= 1U << index;
  state_ = row.to;
  switch (row.action) {
    case A::none: return;
    case A::set: return send_settings();
    case A::go_up_blind:
    case A::go_up:
      report_unconfirmed();
      return emit({.kind = ClientEvent::Kind::up, .setting = {}, .asked = 0, .value = 0});
    case A::fail:
      failure_ = failure_of(row.from, input);
      return emit({.kind = ClientEvent::Kind::failed, .setting = {}, .asked = 0, .value = 0});
  }
}

void ComPortClient::tick(Time now) {
  now_ = now;
  if (!deadline_ || now < *deadline_) return;
  deadline_.reset();
  react(ClientInput::time_out);
}

void ComPortClient::on_negotiation(Verb verb, std::uint8_t option) {
  options_.receive(verb, option, out_);
  decoder_.set_binary(options_.theirs(kBinary) == Options::Side::on);
  if (option == kComPort && verb == Verb::do_it && options_.ours(kComPort) == Options::Side::on)
    react(ClientInput::accepted);
  if (option == kComPort && verb == Verb::dont) react(ClientInput::refused);
  if (option == kBinary && verb == Verb::dont) react(ClientInput::binary_refused);
}

void ComPortClient::on_subnegotiation(std::uint8_t option, std::span<const std::uint8_t> parameters) {
  if (option != kComPort || parameters.empty()) return;
  const std::uint8_t code = parameters[0];
  const std::span<const std::uint8_t> value = parameters.subspan(1);
  if (code == static_cast<std::uint8_t>(ComPort::flow_suspend) ||
      code == static_cast<std::uint8_t>(ComPort::flow_suspend) + kServer ||
      code == static_cast<std::uint8_t>(ComPort::flow_resume) ||
      code == static_cast<std::uint8_t>(ComPort::flow_resume) + kServer) {
    const std::uint8_t plain = code >= kServer ? static_cast<std::uint8_t>(code - kServer) : code;
    suspended_ = plain == static_cast<std::uint8_t>(ComPort::flow_suspend);
    const auto kind = suspended_ ? ClientEvent::Kind::suspended : ClientEvent::Kind::resumed;
    return emit({.kind = kind, .setting = {}, .asked = 0, .value = 0});
  }
  if (code < kServer || value.empty()) return;
  const auto answer = static_cast<ComPort>(code - kServer);
  if (answer == ComPort::notify_modemstate) {
    modem_ = value[0];
    return emit({.kind = ClientEvent::Kind::modem_change, .setting = {}, .asked = 0, .value = value[0]});
  }
  if (answer == ComPort::notify_linestate) {
    if ((value[0] & line::kErrors) == 0) return;
    return emit({.kind = ClientEvent::Kind::line_error, .setting = {}, .asked = 0, .value = value[0]});
  }
  if (answer == ComPort::set_control) return on_control(value[0]);
  for (const SettingRow& row : kSettingRows) {
    if (row.command == answer && value.size() == row.octets) return on_answer(row.setting, number(value));
  }
}

// One code answers for flow control, break, DTR and RTS; only the outbound flow is a setting of ours. Where the server
// is to hold the line and does not, the machine would be overrun; a server that holds unasked only hides the hold.
void ComPortClient::on_control(std::uint8_t value) {
  if (value < control::kFlowNone || value > control::kFlowHardware) return;
  if (value == wanted(Setting::flow)) {
    confirmed_[static_cast<std::size_t>(Setting::flow)] = true;
    return;
  }
  emit({.kind = ClientEvent::Kind::differs, .setting = Setting::flow, .asked = wanted(Setting::flow), .value = value});
  if (settings_.flow != LineFlow::none) react(ClientInput::differs);
}

void ComPortClient::on_answer(Setting setting, std::uint32_t value) {
  const std::uint32_t asked = wanted(setting);
  if (!same_value(setting, asked, value)) {
    emit({.kind = ClientEvent::Kind::differs, .setting = setting, .asked = asked, .value = value});
    return react(ClientInput::differs);
  }
  confirmed_[static_cast<std::size_t>(setting)] = true;
  for (const SettingRow& row : kSettingRows) {
    if (row.awaited && !confirmed_[static_cast<std::size_t>(row.setting)]) return;
  }
  react(ClientInput::answered);
}

void ComPortClient::emit(ClientEvent event) {
  if (event_count_ == kMaxEvents) {  // no one reads: the oldest is worth least
    first_event_ = (first_event_ + 1) % kMaxEvents;
    --event_count_;
  }
  events_[(first_event_ + event_count_) % kMaxEvents] = event;
  ++event_count_;
}

std::optional<ClientEvent> ComPortClient::next_event() {
  if (event_count_ == 0) return std::nullopt;
  const ClientEvent event = events_[first_event_];
  first_event_ = (first_event_ + 1) % kMaxEvents;
  --event_count_;
  return event;
}

}  // namespace dripfeed::telnet
