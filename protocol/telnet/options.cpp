// Answers by the state of each option, on each side.
#include "protocol/telnet/options.h"

#include <algorithm>

namespace dripfeed::telnet {

namespace {

using Side = Options::Side;

// The other side says that it does (or wants us to do) something: `yes` and `no` are our answers.
void turned_on(Side& side, bool wanted, Verb yes, Verb no, std::uint8_t option, Output& out) {
  if (side == Side::on) return;
  if (side == Side::asked) {
    side = Side::on;  // it answers what we asked
    return;
  }
  if (wanted) side = Side::on;
  out.negotiate(wanted ? yes : no, option);
}

void turned_off(Side& side, Verb no, std::uint8_t option, Output& out) {
  if (side == Side::on) out.negotiate(no, option);
  side = Side::refused;
}

}  // namespace

Options::Options(std::span<const OptionRow> rows) : count_(std::min(rows.size(), kMaxRows)) {
  for (std::size_t i = 0; i < count_; ++i) entries_[i].row = rows[i];
}

void Options::ask(Output& out) {
  for (Entry& entry : std::span(entries_).first(count_)) {
    if (entry.row.ours && entry.ours == Side::off) {
      entry.ours = Side::asked;
      out.negotiate(Verb::will, entry.row.option);
    }
    if (entry.row.theirs && entry.theirs == Side::off) {
      entry.theirs = Side::asked;
      out.negotiate(Verb::do_it, entry.row.option);
    }
  }
}

void Options::receive(Verb verb, std::uint8_t option, Output& out) {
  Entry unknown{.row = {.option = option, .ours = false, .theirs = false}};
  const auto known = std::ranges::find(entries_.begin(), entries_.begin() + static_cast<std::ptrdiff_t>(count_), option,
                                       [](const Entry& e) { return e.row.option; });
  Entry& entry = known == entries_.begin() + static_cast<std::ptrdiff_t>(count_) ? unknown : *known;
  switch (verb) {
    case Verb::do_it: turned_on(entry.ours, entry.row.ours, Verb::will, Verb::wont, option, out); break;
    case Verb::dont: turned_off(entry.ours, Verb::wont, option, out); break;
    case Verb::will: turned_on(entry.theirs, entry.row.theirs, Verb::do_it, Verb::dont, option, out); break;
    case Verb::wont: turned_off(entry.theirs, Verb::dont, option, out); break;
  }
}

const Options::Entry* Options::find(std::uint8_t option) const {
  for (const Entry& entry : std::span(entries_).first(count_)) {
    if (entry.row.option == option) return &entry;
  }
  return nullptr;
}

Options::Side Options::ours(std::uint8_t option) const {
  const Entry* entry = find(option);
  return entry == nullptr ? Side::off : entry->ours;
}

Options::Side Options::theirs(std::uint8_t option) const {
  const Entry* entry = find(option);
  return entry == nullptr ? Side::off : entry->theirs;
}

}  // namespace dripfeed::telnet
