// What the glossary states of a member that is not given is what its reader takes: for each "not given: VALUE" of a
// profile's link and receive, a profile with that value is the same as one without.
#include <algorithm>
#include <map>
#include <regex>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "server/json/profile_document.h"
#include "server/json/schemas.h"

namespace dripfeed::json {
namespace {

using machine::LineSettings;

LineSettings line_with(std::string_view link, std::string_view receive) {
  const auto profile = read_profile(fmt::format(R"({{"name": "m", "dialect": "fanuc", "kind": "mill",
    "axes": [{{"name": "X", "rapid_mm_min": 10000, "acceleration_mm_s2": 2000}}],
    "link": {{"url": "serial:/dev/ttyS0"{}}}, "receive": {{{}}}}})",
                                                link, receive));
  EXPECT_TRUE(profile) << link << receive << profile.error().text;
  return profile ? profile->line : LineSettings{};
}

// Every setting of the line that a member of the link changes.
std::string settings_of(const LineSettings& line) {
  const auto bits = [](auto value) { return static_cast<unsigned>(value); };
  return fmt::format("{} {} {} {} {} ", bits(line.protocol), line.baud, tape_code::format_framing(line.framing),
                     bits(line.code), tape_code::name(line.eob)) +
         fmt::format("{} {} {} {} {} {} {} ", line.leader_chars, line.trailer_chars, bits(line.filler), line.pad_tv,
                     bits(line.start), line.start_trigger, bits(line.flow)) +
         fmt::format("{} {} {} {} {} {} {} {} ", line.xon, line.xoff, bits(line.xoff_by), line.char_delay_ms,
                     line.line_delay_ms, line.end_by_dc3, line.end_by_character.value_or(0),
                     line.end_by_quiet_s.value_or(-1.0)) +
         fmt::format("{} {} {} {} {} {} {} ", line.overrun_budget, line.unsent, line.latency_chars, line.watch_cts,
                     line.watch_dsr, line.arming_minutes, line.answer_s.value_or(-1.0)) +
         fmt::format("{} {} {} {} {}", line.payload_bytes, line.counted_frames, line.yields_on_collision,
                     line.messages_end_with_cr, line.character_set);
}

const Schema* section_of(const Schema& schema, std::string_view name) {
  const auto found = std::ranges::find(schema.members, name, &Member::name);
  return found == schema.members.end() ? nullptr : &found->schema;
}

// By name, the value as JSON.
std::map<std::string, std::string> stated_values(const Schema& section) {
  static const std::regex kStated("; not given: ([^ ,;]+)(,|$)");
  static const std::regex kBare("true|false|-?[0-9.]+");
  std::map<std::string, std::string> values;
  for (const Member& member : section.members) {
    std::smatch found;
    if (!std::regex_search(member.schema.about, found, kStated)) continue;
    const std::string value = found[1];
    values[member.name] = std::regex_match(value, kBare) ? value : '"' + value + '"';
  }
  return values;
}

TEST(ProfileDefaults, AreWhatTheGlossaryStates) {
  const Schemas all = all_schemas();
  const Schema& profile = std::ranges::find(all, "Profile", &NamedSchema::name)->schema;
  const std::string usual = settings_of(line_with("", ""));
  const auto link = stated_values(*section_of(profile, "link"));
  EXPECT_GE(link.size(), 29U);
  for (const auto& [name, value] : link)
    EXPECT_EQ(settings_of(line_with(fmt::format(R"(, "{}": {})", name, value), "")), usual) << name;
  const auto receive = stated_values(*section_of(profile, "receive"));
  EXPECT_GE(receive.size(), 13U);
  for (const auto& [name, value] : receive)
    EXPECT_EQ(line_with("", fmt::format(R"("{}": {})", name, value)).receive, machine::ReceiveSettings{}) << name;
}

// The comparison sees a member that has another value.
TEST(ProfileDefaults, AnotherValueIsSeen) {
  const std::string usual = settings_of(line_with("", ""));
  for (const std::string_view other :
       {R"(, "baud": 4800)", R"(, "eob": "cr-lf")", R"(, "gives_way": false)", R"(, "character_set": "fanuc-iso")"})
    EXPECT_NE(settings_of(line_with(other, "")), usual) << other;
}

}  // namespace
}  // namespace dripfeed::json
