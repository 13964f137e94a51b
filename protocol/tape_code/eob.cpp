// The four forms of an end of block.
#include "protocol/tape_code/eob.h"

#include <array>

namespace dripfeed::tape_code {
namespace {

struct EobRow {
  Eob eob;
  std::string_view name;
  std::string_view characters;
};
constexpr std::array<EobRow, 4> kEobs{{
    {Eob::lf, "LF", "\n"},
    {Eob::cr_lf, "CR LF", "\r\n"},
    {Eob::lf_cr_cr, "LF CR CR", "\n\r\r"},
    {Eob::cr, "CR", "\r"},
}};

}  // namespace

std::string_view characters(Eob eob) { return kEobs[static_cast<std::size_t>(eob)].characters; }

std::string_view name(Eob eob) { return kEobs[static_cast<std::size_t>(eob)].name; }

std::optional<Eob> parse_eob(std::string_view name) {
  for (const EobRow& row : kEobs) {
    if (row.name == name) return row.eob;
  }
  return std::nullopt;
}

// LF gives its EOB at once and may take CR CR with it; a lone CR after it was an EOB of its own (or the CR of a CR LF).
// A CR gives its EOB when the next character shows whether an LF belongs to it.
void EobReader::put(char character, std::string& out) {
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
  finish(out);
  out += character;
}

void EobReader::finish(std::string& out) {
  if (seen_ == Seen::cr || seen_ == Seen::lf_cr) out += '\n';
  seen_ = Seen::plain;
}

}  // namespace dripfeed::tape_code
