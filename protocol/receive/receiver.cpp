// The machine of a reception: characters and time to rows of the table.
#include "protocol/receive/receiver.h"

#include <algorithm>
#include <utility>

#include "protocol/tape_code/parity.h"

namespace dripfeed::receive {
namespace {

using tape_code::EighthBit;

constexpr std::uint8_t kDel = 0x7F;

struct SignRow {
  std::uint8_t character;
  Input input;
};
// Characters of 7 bits that are no text.
constexpr std::array<SignRow, 9> kSigns{{
    {0x00, Input::filler},
    {kDel, Input::filler},
    {'\n', Input::eob},
    {'\r', Input::eob},
    {'%', Input::percent},
    {0x12, Input::punch_on},
    {0x14, Input::punch_off},
    {0x15, Input::reset},
    {0x16, Input::reset},
}};
// The same of EIA, whose 13, 15 and 16 are the digits 3, 5 and 6.
constexpr std::array<SignRow, 6> kEiaSigns{{
    {0x00, Input::filler},
    {kDel, Input::filler},
    {kEiaEob, Input::eob},
    {kEiaStop, Input::percent},
    {0x12, Input::punch_on},
    {0x14, Input::punch_off},
}};

struct EndRow {
  Input input;
  EndedBy by;
};
constexpr std::array<EndRow, 6> kEnds{{
    {Input::punch_off, EndedBy::punch_off},
    {Input::end_code, EndedBy::end_code},
    {Input::reader_on, EndedBy::reader_on},
    {Input::reset, EndedBy::reset},
    {Input::link_lost, EndedBy::link_lost},
    {Input::punch_on, EndedBy::renewed},
}};

struct ConditionRow {
  Condition condition;
  EndedBy by;
};
constexpr std::array<ConditionRow, 3> kConditionEnds{{
    {Condition::quiet, EndedBy::quiet},
    {Condition::short_quiet, EndedBy::percent},
    {Condition::too_long, EndedBy::too_long},
}};

constexpr std::array<std::string_view, 9> kEndNames{"punch_off", "percent",   "end_code", "quiet",  "reader_on",
                                                    "reset",     "link_lost", "too_long", "renewed"};

}  // namespace

std::string_view name(EndedBy ended_by) { return kEndNames[static_cast<std::size_t>(ended_by)]; }

// The code up to and with this byte. A line that is known to be EIA, or not to look for it, has nothing to find; where
// it is looked for the stop code or the EOB of EIA says so, and any EOB or byte above 80h of the others. Until then
// nothing but what has one meaning in all codes is taken for a sign.
Receiver::Looks Receiver::look(std::uint8_t byte) const {
  if (settings_.eia_known) return settings_.eia ? Looks::eia : Looks::other;
  if (!at_rest() && looks_ != Looks::open) return looks_;
  if (byte == kEiaStop) return Looks::eia;
  if (!settings_.find_code) return Looks::other;
  if (byte == kEiaEob) return Looks::eia;
  const bool eob = byte == '\n' || byte == '\r';
  const bool leader = byte == 0xFF;
  if (eob || (byte > kEiaEob && !leader) || (at_rest() && byte == '%')) return Looks::other;
  return Looks::open;
}

// EIA's own characters have an odd number of ones, so a flow character that has an even one is a sign there.
Input Receiver::classify_eia(std::uint8_t byte) const {
  if (byte == settings_.xon && !tape_code::odd_ones(byte)) return Input::reader_on;
  for (const SignRow& row : kEiaSigns) {
    if (row.character == byte) return row.input;
  }
  return Input::text;
}

// The sign that a character of 7 bits is, by the line's own flow characters. DC1 and DC3 mean nothing where the line
// has others.
std::optional<Input> Receiver::sign_of(std::uint8_t character) const {
  if (character == settings_.xon) return Input::reader_on;
  if (character == settings_.xoff) return Input::reader_off;
  for (const SignRow& row : kSigns) {
    if (row.character == character) return row.input;
  }
  return std::nullopt;
}

// A sign is believed with the bit 7 that this line's characters have; a damaged one is text, and the parity of the
// whole shows. DC3, SYN and NAK stop, so they are believed in either parity, as the feed does.
Input Receiver::classify(std::uint8_t byte) const {
  if (looks_ == Looks::eia || (looks_ == Looks::open && !at_rest())) return classify_eia(byte);
  const auto character = static_cast<std::uint8_t>(byte & tape_code::kLowSevenBits);
  if (settings_.end_character && character == *settings_.end_character) return Input::end_code;
  const bool plain = byte == character;
  const bool even = !tape_code::odd_ones(byte);
  const bool fits = settings_.eighth_bit == EighthBit::odd ? !even : (plain || even);
  if (const auto sign = sign_of(character)) {
    return fits || *sign == Input::reader_off || *sign == Input::reset ? *sign : Input::text;
  }
  return character >= 0x20 || character == '\t' ? Input::text : Input::other;
}

std::size_t Receiver::receive(std::span<const std::byte> bytes, Time now) {
  if (update(now)) return 0;
  std::size_t taken = 0;
  while (taken < bytes.size() && piece_size_ < kMaxPiece && !ended_) {
    const auto byte = std::to_integer<std::uint8_t>(bytes[taken++]);
    last_input_ = now_;
    looks_ = look(byte);
    react(classify(byte), byte);
    static_cast<void>(progress_by(Condition::too_long));
  }
  return taken;
}

void Receiver::react(Input input, std::uint8_t byte) {
  const std::span<const Reaction> rows = reactions();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Reaction& row = rows[i];
    if (row.from != state_ || row.input != input) continue;
    if (row.guard == Guard::first_percent && percent_seen_) continue;
    if (row.guard == Guard::later_percent && !percent_seen_) continue;
    if (row_taken_ != nullptr) row_taken_(row_context_, i);
    perform(row.action, input, byte, row.to);
    return;
  }
}

void Receiver::perform(Action action, Input input, std::uint8_t byte, State to) {
  switch (action) {
    case Action::none:
    case Action::skip: break;
    case Action::begin:
      begin(false);
      keep(input, byte);
      break;
    case Action::open: begin(true); break;
    case Action::keep: keep(input, byte); break;
    case Action::end:
    case Action::renew:
      for (const EndRow& row : kEnds) {
        if (row.input == input) end(row.by);
      }
      if (action == Action::renew) begin(true);
      break;
    case Action::spoil: break;  // only by a condition
  }
  state_ = to;
}

void Receiver::begin(bool punch_signs) {
  began_at_ = now_;
  bytes_ = 0;
  percent_seen_ = false;
  punch_signs_ = punch_signs;
}

void Receiver::keep(Input input, std::uint8_t byte) {
  percent_seen_ = percent_seen_ || input == Input::percent;
  piece_[piece_size_++] = static_cast<std::byte>(byte);
  ++bytes_;
}

void Receiver::end(EndedBy by) {
  ended_ = Ending{.by = by,
                  .punch_signs = punch_signs_,
                  .eia = looks_ == Looks::eia,
                  .bytes = bytes_,
                  .began_at = began_at_,
                  .at = now_};
}

std::optional<Ending> Receiver::ended() { return std::exchange(ended_, std::nullopt); }

void Receiver::link_lost(Time now) {
  if (update(now)) return;
  react(Input::link_lost, 0);
  holding_ = false;
  out_size_ = 0;
}

void Receiver::tick(Time now) { update(now); }

// True where a reception ended by time and waits to be taken: nothing may come before that.
bool Receiver::update(Time now) {
  now_ = std::max(now_, now);
  if (ended_) return true;
  return progress_by(Condition::quiet) || progress_by(Condition::short_quiet);
}

// True where the reception ended by it.
bool Receiver::progress_by(Condition condition) {
  const std::span<const Progress> rows = progress();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Progress& row = rows[i];
    if (row.from != state_ || row.condition != condition || !holds(condition)) continue;
    if (row_taken_ != nullptr) row_taken_(row_context_, reactions().size() + i);
    for (const ConditionRow& by : kConditionEnds) {
      if (by.condition == condition && row.action != Action::none) end(by.by);
    }
    state_ = row.to;
    return ended_.has_value();
  }
  return false;
}

bool Receiver::holds(Condition condition) const {
  if (condition == Condition::too_long) return bytes_ > settings_.max_bytes;
  const auto at = ends_at(condition);
  return at && now_ >= *at;
}

std::optional<Time> Receiver::ends_at(Condition condition) const {
  if (holding_) return std::nullopt;
  return last_input_ + (condition == Condition::quiet ? settings_.quiet : settings_.short_quiet);
}

std::optional<Time> Receiver::deadline() const {
  for (const Progress& row : progress()) {
    if (row.from == state_ && row.condition != Condition::too_long) return ends_at(row.condition);
  }
  return std::nullopt;
}

void Receiver::can_take(bool more, Time now) {
  static_cast<void>(update(now));
  const bool on = state_ != State::idle;
  const bool hold = !more && on && settings_.hold != Hold::none;
  if (hold == holding_) return;
  holding_ = hold;
  if (!hold) last_input_ = now_;
  if (settings_.hold == Hold::dc3) put_out(hold ? settings_.xoff : settings_.xon);
}

void Receiver::put_out(std::uint8_t character) {
  // A hold that was not sent yet is taken back instead of followed.
  if (out_size_ > 0) {
    out_size_ = 0;
    return;
  }
  out_[0] = static_cast<std::byte>(looks_ == Looks::eia ? character
                                                        : tape_code::with_parity(character, settings_.eighth_bit));
  out_size_ = 1;
}

}  // namespace dripfeed::receive
