// From a profile to what the receiver works with.
#include "server/machine/receive_settings.h"

#include "server/machine/profile.h"

namespace dripfeed::machine {

receive::Settings receive_settings_of(const LineSettings& line) {
  const ReceiveSettings& given = line.receive;
  receive::Settings settings;
  settings.eighth_bit = tape_code::eighth_bit(line.framing, line.code, tape_code::ParityBy::software);
  settings.eia = line.code == tape_code::Code::eia;
  settings.eia_known = settings.eia;
  settings.eia_specials = line.eia_specials;
  settings.quiet = receive::Time(static_cast<std::int64_t>(given.quiet_s * 1e9));
  settings.short_quiet = receive::Time(static_cast<std::int64_t>(given.quiet_after_end_s * 1e9));
  settings.end_character = given.end_character;
  settings.hold = given.hold;
  return settings;
}

receive::RequestGrammar request_grammar_of(const ReceiveSettings& settings) {
  return {
      .program_number = settings.request_number, .marker = settings.request_marker, .scan_lines = settings.scan_lines};
}

}  // namespace dripfeed::machine
