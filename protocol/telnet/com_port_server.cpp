// What a device server does with each command; its masks decide what it reports unasked.
#include "protocol/telnet/com_port_server.h"

namespace dripfeed::telnet {

namespace {

constexpr std::array kOptions = {
    OptionRow{.option = kComPort, .ours = false, .theirs = true},
    OptionRow{.option = kBinary, .ours = true, .theirs = true},
    OptionRow{.option = kSuppressGoAhead, .ours = true, .theirs = true},
};
constexpr std::array<std::uint8_t, 8> kSignature = {'d', 'r', 'i', 'p', 'f', 'e', 'e', 'd'};

// One-octet settings: which values there are, and where the value in effect lives.
struct OctetRow {
  ComPort command;
  std::uint8_t least;
  std::uint8_t most;
  std::uint8_t PortState::* value;
};
constexpr std::array kOctetRows = {
    OctetRow{ComPort::set_datasize, 5, 8, &PortState::data_bits},
    OctetRow{ComPort::set_parity, 1, 5, &PortState::parity},
    OctetRow{ComPort::set_stopsize, 1, 3, &PortState::stop_bits},
};

}  // namespace

ComPortServer::ComPortServer() : options_(kOptions) {}

void ComPortServer::begin() { options_.ask(out_); }

std::size_t ComPortServer::receive(std::span<const std::byte> wire, std::span<std::byte> data) {
  return decoder_.decode(wire, data, *this);
}

std::size_t ComPortServer::send(std::span<const std::byte> data) {
  if (suspended_ || !out_.pending().empty()) return 0;
  return out_.data(data, options_.ours(kBinary) == Options::Side::on);
}

void ComPortServer::answer(ComPort command, std::span<const std::uint8_t> value) {
  if (offered_)
    out_.subnegotiate(kComPort, static_cast<std::uint8_t>(static_cast<std::uint8_t>(command) + kServer), value);
}

void ComPortServer::answer_octet(ComPort command, std::uint8_t value) {
  const std::array<std::uint8_t, 1> octet = {value};
  answer(command, octet);
}

void ComPortServer::set_modem_lines(std::uint8_t lines) {
  const auto now = static_cast<std::uint8_t>(lines & 0xF0U);
  const auto changed = static_cast<std::uint8_t>((now ^ modem_) >> 4U);
  modem_ = now;
  if (changed != 0 && ((changed << 4U | changed) & modem_mask_) != 0)
    answer_octet(ComPort::notify_modemstate, static_cast<std::uint8_t>((now | changed) & modem_mask_));
}

void ComPortServer::notify_line(std::uint8_t bits) {
  const auto reported = static_cast<std::uint8_t>(bits & line_mask_);
  if (reported != 0) answer_octet(ComPort::notify_linestate, reported);
}

void ComPortServer::ask_suspend(bool suspend) { answer(suspend ? ComPort::flow_suspend : ComPort::flow_resume, {}); }

void ComPortServer::on_negotiation(Verb verb, std::uint8_t option) {
  options_.receive(verb, option, out_);
  decoder_.set_binary(options_.theirs(kBinary) == Options::Side::on);
  if (option != kComPort) return;
  if (options_.theirs(kComPort) == Options::Side::on) return accept();
  offered_ = false;
}

void ComPortServer::accept() {
  if (std::exchange(offered_, true)) return;
  answer_octet(ComPort::notify_modemstate, static_cast<std::uint8_t>(modem_ & modem_mask_));
}

void ComPortServer::on_baud(std::span<const std::uint8_t> value) {
  if (value.size() == 4) {
    std::uint32_t baud = 0;
    for (const std::uint8_t octet : value) baud = baud << 8U | octet;
    if (baud != 0) port_.baud = baud;
  }
  const std::array<std::uint8_t, 4> effect = {
      static_cast<std::uint8_t>(port_.baud >> 24U), static_cast<std::uint8_t>(port_.baud >> 16U),
      static_cast<std::uint8_t>(port_.baud >> 8U), static_cast<std::uint8_t>(port_.baud)};
  answer(ComPort::set_baudrate, effect);
}

// Each group of values has its own state; the answer is the value of the group that is in effect.
void ComPortServer::on_control(std::uint8_t value) {
  const auto answer = [this](std::uint8_t effect) { answer_octet(ComPort::set_control, effect); };
  if (value <= control::kFlowHardware) {
    if (value != control::kAskFlow) port_.flow = value;
    return answer(port_.flow);
  }
  if (value <= control::kBreakOff) {
    if (value != control::kAskBreak) port_.break_on = value == control::kBreakOn;
    return answer(port_.break_on ? control::kBreakOn : control::kBreakOff);
  }
  if (value <= control::kDtrOff) {
    if (value != control::kAskDtr) port_.dtr = value == control::kDtrOn;
    return answer(port_.dtr ? control::kDtrOn : control::kDtrOff);
  }
  if (value <= control::kRtsOff) {
    if (value != control::kAskRts) port_.rts = value == control::kRtsOn;
    return answer(port_.rts ? control::kRtsOn : control::kRtsOff);
  }
  if (value <= control::kLast) return answer(port_.inbound_flow);  // only "none" is done
}

void ComPortServer::on_subnegotiation(std::uint8_t option, std::span<const std::uint8_t> parameters) {
  if (option != kComPort || parameters.empty()) return;
  // A client that takes our DO for the answer to a WILL that it never sent uses the option all the same.
  if (options_.theirs(kComPort) == Options::Side::asked) accept();
  if (!offered_) return;
  const auto command = static_cast<ComPort>(parameters[0]);
  const std::span<const std::uint8_t> value = parameters.subspan(1);
  for (const OctetRow& row : kOctetRows) {
    if (row.command != command || value.empty()) continue;
    if (value[0] >= row.least && value[0] <= row.most) port_.*row.value = value[0];
    return answer_octet(command, port_.*row.value);
  }
  switch (command) {
    case ComPort::signature:
      if (value.empty()) answer(command, kSignature);
      return;
    case ComPort::set_baudrate: return on_baud(value);
    case ComPort::set_control: return value.empty() ? void() : on_control(value[0]);
    case ComPort::flow_suspend: suspended_ = true; return;
    case ComPort::flow_resume: suspended_ = false; return;
    case ComPort::set_linestate_mask:
      if (!value.empty()) line_mask_ = value[0];
      return answer_octet(command, line_mask_);
    case ComPort::set_modemstate_mask:
      if (!value.empty()) modem_mask_ = value[0];
      return answer_octet(command, modem_mask_);
    case ComPort::purge_data:
      if (value.empty() || value[0] < 1 || value[0] > kPurgeBoth) return;
      purge_ = purge_ || value[0] != 1;
      return answer_octet(command, value[0]);
    case ComPort::set_datasize:
    case ComPort::set_parity:
    case ComPort::set_stopsize:
    case ComPort::notify_linestate:
    case ComPort::notify_modemstate: return;
  }
}

}  // namespace dripfeed::telnet
