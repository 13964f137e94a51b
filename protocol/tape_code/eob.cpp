// The forms of an end of block: names, and reading.
#include "protocol/tape_code/eob.h"

namespace dripfeed::tape_code {
namespace {

constexpr std::string_view kHexDigits = "0123456789ABCDEF";

// A word of an EOB's name; nothing for what is no control character or means something on a line.
std::optional<char> parse_word(std::string_view word) {
  if (word == "LF") return '\n';
  if (word == "CR") return '\r';
  if (word.size() != 2) return std::nullopt;
  const std::size_t high = kHexDigits.find(word[0]);
  const std::size_t low = kHexDigits.find(word[1]);
  if (high > 1 || low == std::string_view::npos) return std::nullopt;
  const std::size_t code = high * 16 + low;
  if (code == 0 || (code >= 0x11 && code <= 0x16)) return std::nullopt;
  return static_cast<char>(code);
}

bool is_usual(const Eob& eob) { return eob == Eob::lf || eob == Eob::cr_lf || eob == Eob::lf_cr_cr || eob == Eob::cr; }

}  // namespace

std::string name(const Eob& eob) {
  std::string text;
  for (const char c : characters(eob)) {
    if (!text.empty()) text += ' ';
    if (c == '\n') {
      text += "LF";
    } else if (c == '\r') {
      text += "CR";
    } else {
      text += kHexDigits[static_cast<std::uint8_t>(c) / 16U];
      text += kHexDigits[static_cast<std::uint8_t>(c) % 16U];
    }
  }
  return text;
}

std::optional<Eob> parse_eob(std::string_view name) {
  std::array<char, Eob::kMaxCharacters> found{};
  std::size_t count = 0;
  for (;;) {
    const std::string_view word = name.substr(0, name.find(' '));
    const std::optional<char> character = parse_word(word);
    if (!character || count == found.size()) return std::nullopt;
    found[count++] = *character;
    if (word.size() == name.size()) return Eob(std::string_view(found.data(), count));
    name.remove_prefix(word.size() + 1);
  }
}

// What is held is always the beginning of the own EOB. A character that breaks it off sends the first held one as
// usual, and the rest is looked at again.
void EobReader::put(char character, std::string& out) {
  if (is_usual(own_)) return put_usual(character, out);
  held_[held_count_++] = character;
  while (held_count_ > 0 && !characters(own_).starts_with(std::string_view(held_.data(), held_count_))) {
    put_usual(held_[0], out);
    std::copy(held_.begin() + 1, held_.begin() + static_cast<std::ptrdiff_t>(held_count_), held_.begin());
    --held_count_;
  }
  if (held_count_ < characters(own_).size()) return;
  held_count_ = 0;
  finish_usual(out);
  out += '\n';
}

void EobReader::finish(std::string& out) {
  for (std::size_t i = 0; i < held_count_; ++i) put_usual(held_[i], out);
  held_count_ = 0;
  finish_usual(out);
}

// LF gives its EOB at once and may take CR CR with it; a lone CR after it was an EOB of its own (or the CR of a CR LF).
// A CR gives its EOB when the next character shows whether an LF belongs to it.
void EobReader::put_usual(char character, std::string& out) {
  const Seen before = seen_;
  if (character == '\n') {
    out += '\n';
    seen_ = before == Seen::cr || before == Seen::lf_cr ? Seen::plain : Seen::lf;
    return;
  }
  if (character == '\r') {
    if (before == Seen::cr) out += '\n';
    seen_ = before == Seen::lf ? Seen::lf_cr : before == Seen::lf_cr ? Seen::plain : Seen::cr;
    return;
  }
  finish_usual(out);
  out += character;
}

void EobReader::finish_usual(std::string& out) {
  if (seen_ == Seen::cr || seen_ == Seen::lf_cr) out += '\n';
  seen_ = Seen::plain;
}

}  // namespace dripfeed::tape_code
