// Machine profiles: the presets are read, every wrong member has its own place, and a text that is no document says
// where it stops being one.
#include "server/json/profile_document.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

namespace dripfeed::json {
namespace {

std::string file_text(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

const std::filesystem::path kPresets = DRIPFEED_SOURCE_DIR "/deploy/machines";

// A small profile in which each row of a test changes one thing.
constexpr std::string_view kProfile = R"({
  "name": "mill-1", "title": "Mill", "dialect": "fanuc", "kind": "mill",
  "axes": [{"name": "X", "min_mm": -10, "max_mm": 500, "rapid_mm_min": 10000, "acceleration_mm_s2": 2000}],
  "feed_limit_mm_min": 5000, "spindle": {"min_rpm": 10, "max_rpm": 4000},
  "tools": [{"number": 1, "offset": 1, "nose_radius_mm": 0.8, "tip": 3, "insert": {"angle_deg": 80, "entering_angle_deg": 95, "edge_mm": 12}},
            {"number": 2, "diameter_mm": 10, "length_mm": 100, "holder": [{"from_mm": 40, "diameter_mm": 32}, {"from_mm": 70, "diameter_mm": 63}]}],
  "work_offsets": [{"number": 1, "X_mm": 5.5}, {"number": 2}],
  "control": {"decimal_mode": "calculator", "g_system": "B", "increment_mm": 0.001, "block_length_bytes": 128, "axes_at_once": 3,
              "arcs": {"tolerance_mm": 0.03, "tolerance_factor": 0.002}, "splines_confirmed": true,
              "iso_mode": {"decimal_mode": "least-increment", "decimal_mode_confirmed": true, "from_start": true}, "reference_fixed_point": 2, "arc_without_center": "alarm",
              "power_on": {"unit": "inch", "plane": "yz"},
              "variables": [{"bank": "#", "first": 100, "last": 199, "use": "common", "writable": true}]},
  "timing": {"sample_time_ms": 8, "look_ahead_blocks": 20, "cost": {"block_ms": 1.5, "function_ms": 0.25}},
  "buffer": {"bytes": 2048, "blocks": 10},
  "link": {"url": "serial:/dev/ttyS0", "baud": 4800, "framing": "7E2", "code": "iso", "eob": "lf-cr-cr", "leader": 5,
           "trailer": 6, "start": "at-once", "end_by_dc3": false, "end_by_character": 4, "end_by_quiet_s": 2.5,
           "overrun_budget": 12, "unsent": 3, "latency_chars": 6, "watch_cts": true, "arming_minutes": 5,
           "flow": "both", "xon": 14, "xoff": 15, "char_delay_ms": 0.5, "line_delay_ms": 20, "xoff_by": "host"}})";

std::string with(std::string_view from, std::string_view to) {
  std::string text(kProfile);
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(ProfileDocument, ReadsEveryPreset) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kPresets)) {
    const auto profile = read_profile(file_text(entry.path()));
    ASSERT_TRUE(profile) << entry.path() << profile.error().text;
    EXPECT_EQ(profile->name, entry.path().stem());
    ++count;
  }
  EXPECT_GE(count, 5);
}

// An older profile names neither source nor round: its cost model is reported as assumed, and the end of a loop still
// costs a block.
TEST(ProfileDocument, ACostModelOfUnknownSourceIsAnAssumption) {
  const auto profile = read_profile(kProfile);
  ASSERT_TRUE(profile);
  const ir::CostModel& cost = profile->machine.timing.cost.value();
  EXPECT_EQ(cost.source, ir::CostSource::assumed);
  EXPECT_EQ(cost.spread, ir::kAssumedSpread);
  EXPECT_EQ(cost.round_ms, 1.5);
  EXPECT_EQ(cost.number_write_ms, 0.0);
  EXPECT_EQ(profile->machine.timing.cost_origin, "");
  EXPECT_FALSE(read_profile(with(R"("block_ms": 1.5)", R"("block_ms": 1.5, "source": "measured")")));
  EXPECT_FALSE(read_profile(with(R"("block_ms": 1.5)", R"("block_ms": 1.5, "spread": 0.5)")));
}

TEST(ProfileDocument, CalibratedIsReadBack) {
  ir::CostModel cost;
  double ms = 0.25;
  for (const ir::CostTerm& term : ir::kCostTerms) cost.*term.ms = ms += 0.5;
  cost.spread = 1.25;
  cost.source = ir::CostSource::calibrated;
  const auto text = calibrated_profile(kProfile, cost, "DRIPFEED TIMING, 2020-02-03", 0.5);
  ASSERT_TRUE(text) << text.error().text;
  const auto profile = read_profile(*text);
  ASSERT_TRUE(profile) << profile.error().text;
  const ir::CostModel& read = profile->machine.timing.cost.value();
  for (const ir::CostTerm& term : ir::kCostTerms) EXPECT_EQ(read.*term.ms, cost.*term.ms) << term.name;
  EXPECT_EQ(read.spread, 1.25);
  EXPECT_EQ(read.source, ir::CostSource::calibrated);
  EXPECT_EQ(profile->machine.timing.cost_origin, "DRIPFEED TIMING, 2020-02-03");
  EXPECT_EQ(profile->machine.axes.at(0).acceleration_mm_s2, 1000);
}

TEST(ProfileDocument, EveryMemberArrives) {
  const auto read = read_profile(kProfile);
  ASSERT_TRUE(read) << read.error().text;
  const machine::Profile& p = *read;
  EXPECT_EQ(p.name, "mill-1");
  EXPECT_EQ(p.title, "Mill");
  EXPECT_EQ(p.control.dialect, "fanuc");
  EXPECT_EQ(p.control.kind, ir::MachineKind::mill);
  EXPECT_EQ(p.control.g_system, ir::GSystem::b);
  EXPECT_EQ(p.control.decimal_mode, ir::DecimalMode::calculator);
  EXPECT_EQ(p.control.increment_mm, 0.001);
  EXPECT_EQ(p.control.block_length_bytes, 128U);
  EXPECT_EQ(p.control.axes_at_once, 3U);
  EXPECT_EQ(p.control.arc_tolerance_mm, 0.03);
  EXPECT_EQ(p.control.arc_tolerance_factor, 0.002);
  EXPECT_TRUE(p.control.splines_confirmed);
  EXPECT_EQ(p.control.iso_decimal_mode, ir::DecimalMode::least_increment);
  EXPECT_TRUE(p.control.iso_decimal_mode_confirmed);
  EXPECT_TRUE(p.control.starts_in_iso_mode);
  EXPECT_EQ(p.control.reference_fixed_point, 2U);
  EXPECT_EQ(p.control.arc_without_center_is_line, false);
  EXPECT_EQ(p.control.power_on_unit, ir::Function::unit_inch);
  EXPECT_EQ(p.control.power_on_plane, ir::Function::plane_yz);
  EXPECT_FALSE(p.control.power_on_confirmed);
  ASSERT_EQ(p.control.variables.size(), 1U);
  EXPECT_EQ(p.control.variables[0].last, 199U);
  ASSERT_EQ(p.machine.axes.size(), 1U);
  EXPECT_EQ(p.machine.axes[0].max, 500.0);
  EXPECT_EQ(p.machine.spindle_max_rpm, 4000.0);
  EXPECT_EQ(p.machine.tools.at(0).tip, 3);
  EXPECT_TRUE(p.machine.tools.at(0).holder.empty());
  ASSERT_TRUE(p.machine.tools.at(0).insert);
  EXPECT_EQ(p.machine.tools.at(0).insert->entering_angle_deg, 95.0);
  ASSERT_EQ(p.machine.tools.at(1).holder.size(), 2U);
  EXPECT_EQ(p.machine.tools.at(1).holder.at(1).from_mm, 70.0);
  EXPECT_EQ(p.machine.tools.at(1).holder.at(1).diameter_mm, 63.0);
  EXPECT_EQ(p.machine.work_offsets.at(0).zero[0], 5.5);
  EXPECT_EQ(p.machine.timing.look_ahead_blocks, 20U);
  ASSERT_TRUE(p.machine.timing.cost);
  EXPECT_EQ(p.machine.timing.cost->function_ms, 0.25);
  EXPECT_EQ(p.machine.buffer.bytes, 2048U);
  EXPECT_EQ(p.line.baud, 4800U);
  EXPECT_EQ(p.line.framing.data_bits, 7);
  EXPECT_EQ(p.line.eob, tape_code::Eob::lf_cr_cr);
  EXPECT_EQ(p.line.leader_chars, 5U);
  EXPECT_EQ(p.line.trailer_chars, 6U);
  EXPECT_EQ(p.line.start, feed::Start::at_once);
  EXPECT_FALSE(p.line.end_by_dc3);
  EXPECT_EQ(p.line.end_by_character, 4);
  EXPECT_EQ(p.line.end_by_quiet_s, 2.5);
  EXPECT_EQ(p.line.overrun_budget, 12U);
  EXPECT_EQ(p.line.flow, feed::Flow::both);
  EXPECT_EQ(p.line.xon, 14U);
  EXPECT_EQ(p.line.xoff, 15U);
  EXPECT_EQ(p.line.char_delay_ms, 0.5);
  EXPECT_EQ(p.line.line_delay_ms, 20.0);
  EXPECT_EQ(p.line.unsent, 3U);
  EXPECT_EQ(p.line.latency_chars, 6U);
  EXPECT_TRUE(p.line.watch_cts);
  EXPECT_FALSE(p.line.watch_dsr);
  EXPECT_EQ(p.line.arming_minutes, 5.0);
}

TEST(ProfileDocument, TheCodeOfTheTapeArrives) {
  const auto read = read_profile(with(R"("framing": "7E2", "code": "iso", "eob": "lf-cr-cr")",
                                      R"("framing": "8N2", "code": "eia", "eob": "cr-lf-lf", "filler": "del",
                                         "pad_tv": true, "eia_specials": {"[": 76, "#": 94})"));
  ASSERT_TRUE(read) << read.error().text;
  EXPECT_EQ(read->line.code, tape_code::Code::eia);
  EXPECT_EQ(tape_code::name(read->line.eob), "CR LF LF");
  EXPECT_EQ(read->line.filler, tape_code::Filler::del);
  EXPECT_TRUE(read->line.pad_tv);
  EXPECT_EQ(read->line.eia_specials.codes[0], 76);
  EXPECT_EQ(read->line.eia_specials.codes[2], 94);
  EXPECT_EQ(read->line.eia_specials.codes[1], 0);
}

struct Wrong {
  std::string_view from;
  std::string_view to;
  std::string_view pointer;
};

TEST(ProfileDocument, APacketProtocolBringsItsLineAlong) {
  const auto link = [](std::string_view members) {
    const std::string text(kProfile);
    const std::size_t at = text.find("\"link\":");
    return text.substr(0, at) + "\"link\": {\"url\": \"serial:/dev/ttyS0\", " + std::string(members) + "}}";
  };
  const auto read = read_profile(
      link(R"("protocol": "3964r", "answer_s": 60, "payload_bytes": 64, "counted_frames": true, "gives_way": false)"));
  ASSERT_TRUE(read) << read.error().text;
  const machine::LineSettings& line = read->line;
  EXPECT_EQ(line.protocol, machine::LineProtocol::s3964r);
  EXPECT_EQ(tape_code::format_framing(line.framing), "8N1");
  EXPECT_EQ(line.code, tape_code::Code::ascii);
  EXPECT_EQ(line.flow, feed::Flow::none);
  EXPECT_EQ(line.answer_s, 60.0);
  EXPECT_EQ(line.payload_bytes, 64U);
  EXPECT_TRUE(line.counted_frames);
  EXPECT_FALSE(line.yields_on_collision);

  const auto seven = read_profile(link(R"("protocol": "xmodem", "framing": "7E2")"));
  ASSERT_FALSE(seven);
  EXPECT_NE(seven.error().text.find("8 data bits"), std::string::npos) << seven.error().text;
  const auto held = read_profile(link(R"("protocol": "xmodem", "flow": "xonxoff")"));
  ASSERT_FALSE(held);
  EXPECT_NE(held.error().text.find("XON"), std::string::npos) << held.error().text;
  const auto both =
      read_profile(link(R"("protocol": "remote-buffer-a", "messages_end_with_cr": true, "eob": "cr-lf")"));
  ASSERT_FALSE(both);
  EXPECT_NE(both.error().text.find("ETX"), std::string::npos) << both.error().text;
  EXPECT_FALSE(read_profile(link(R"("protocol": "kermit")")));
}

TEST(ProfileDocument, EveryWrongMemberHasItsPlace) {
  const Wrong rows[] = {
      // missing
      {R"("name": "mill-1", )", "", "/name"},
      {R"("name": "mill-1")", R"("name": "")", "/name"},
      {R"("dialect": "fanuc", )", "", "/dialect"},
      {R"("kind": "mill")", R"("kind": null)", "/kind"},
      {R"("url": "serial:/dev/ttyS0", )", "", "/link/url"},
      {R"("rapid_mm_min": 10000, )", "", "/axes/0/rapid_mm_min"},
      {R"(, "acceleration_mm_s2": 2000)", "", "/axes/0/acceleration_mm_s2"},
      {R"({"number": 1, "offset")", R"({"offset")", "/tools/0/number"},
      {R"({"number": 2})", "{}", "/work_offsets/1/number"},
      {R"("block_ms": 1.5, )", "", "/timing/cost/block_ms"},
      {R"(, "max_rpm": 4000)", "", "/spindle/max_rpm"},
      // of another type
      {R"("title": "Mill")", R"("title": 5)", "/title"},
      {R"("axes": [)", R"("axes": 7, "axis": [)", "/axes"},
      {R"([{"name": "X")", R"([3, {"name": "X")", "/axes/0"},
      {R"("feed_limit_mm_min": 5000)", R"("feed_limit_mm_min": "5000")", "/feed_limit_mm_min"},
      {R"("spindle": {"min_rpm": 10, "max_rpm": 4000})", R"("spindle": [])", "/spindle"},
      {R"("watch_cts": true)", R"("watch_cts": 1)", "/link/watch_cts"},
      {R"("baud": 4800)", R"("baud": 4800.5)", "/link/baud"},
      {R"("baud": 4800)", R"("baud": "4800")", "/link/baud"},
      {R"("power_on": {"unit": "inch")", R"("power_on": {"unit": 1)", "/control/power_on/unit"},
      // out of range, or out of a list
      {R"("kind": "mill")", R"("kind": "drill")", "/kind"},
      {R"("name": "X")", R"("name": "Q")", "/axes/0/name"},
      {R"("name": "X")", R"("name": "XY")", "/axes/0/name"},
      {R"("max_mm": 500)", R"("max_mm": -10)", "/axes/0/max_mm"},
      {R"("max_mm": 500)", R"("max_mm": 1e7)", "/axes/0/max_mm"},
      {R"("rapid_mm_min": 10000)", R"("rapid_mm_min": 0)", "/axes/0/rapid_mm_min"},
      {R"("max_rpm": 4000)", R"("max_rpm": 5)", "/spindle/max_rpm"},
      {R"("tip": 3,)", R"("tip": 10,)", "/tools/0/tip"},
      {R"("angle_deg": 80, )", "", "/tools/0/insert/angle_deg"},
      {R"("edge_mm": 12)", R"("edge_mm": 0)", "/tools/0/insert/edge_mm"},
      {R"("from_mm": 70)", R"("from_mm": 40)", "/tools/1/holder/1/from_mm"},
      {R"("from_mm": 70)", R"("from_mm": 100)", "/tools/1/holder"},
      {R"("from_mm": 40, )", "", "/tools/1/holder/0/from_mm"},
      {R"("diameter_mm": 32)", R"("diameter_mm": 0)", "/tools/1/holder/0/diameter_mm"},
      {R"({"number": 2})", R"({"number": 1})", "/work_offsets/1/number"},
      {R"("increment_mm": 0.001)", R"("increment_mm": -0.001)", "/control/increment_mm"},
      {R"("g_system": "B")", R"("g_system": "D")", "/control/g_system"},
      {R"("last": 199)", R"("last": 99)", "/control/variables/0/last"},
      {R"("url": "serial:/dev/ttyS0")", R"("url": "ftp://x")", "/link/url"},
      {R"("baud": 4800)", R"("baud": 0)", "/link/baud"},
      {R"("baud": 4800)", R"("baud": 18446744073709551615)", "/link/baud"},
      {R"("baud": 4800)", R"("baud": -4800)", "/link/baud"},
      {R"("framing": "7E2")", R"("framing": "9E1")", "/link/framing"},
      {R"("eob": "lf-cr-cr")", R"("eob": "crlf")", "/link/eob"},
      {R"("code": "iso")", R"("code": "bcd")", "/link/code"},
      {R"("code": "iso")", R"("filler": "blank")", "/link/filler"},
      {R"("code": "iso")", R"("eia_specials": {"[": 97})", "/link/eia_specials/["},
      {R"("code": "iso")", R"("eia_specials": {"#": 3})", "/link/eia_specials/#"},
      {R"("end_by_character": 4)", R"("end_by_character": 128)", "/link/end_by_character"},
      {R"("end_by_quiet_s": 2.5)", R"("end_by_quiet_s": 0)", "/link/end_by_quiet_s"},
      {R"("unsent": 3)", R"("unsent": 257)", "/link/unsent"},
      {R"("arming_minutes": 5)", R"("arming_minutes": 61)", "/link/arming_minutes"},
      {R"("arming_minutes": 5)", R"("arming_minutes": 5, "character_set": "klingon")", "/link/character_set"},
      {R"("name": "mill-1")", R"("name": "..")", "/name"},
      {R"("name": "mill-1")", R"("name": "a\u0000b")", "/name"},
      // absurd, and each by its own name
      {R"("acceleration_mm_s2": 2000)", R"("acceleration_mm_s2": 0)", "/axes/0/acceleration_mm_s2"},
      {R"("acceleration_mm_s2": 2000)", R"("acceleration_mm_s2": -2000)", "/axes/0/acceleration_mm_s2"},
      {R"("acceleration_mm_s2": 2000)", R"("acceleration_mm_s2": 1e300)", "/axes/0/acceleration_mm_s2"},
      {R"("acceleration_mm_s2": 2000)", R"("acceleration_mm_s2": 2000, "jerk_mm_s3": -1)", "/axes/0/jerk_mm_s3"},
      {R"("acceleration_mm_s2": 2000)", R"("acceleration_mm_s2": 2000, "feed_limit_mm_min": 0)",
       "/axes/0/feed_limit_mm_min"},
      {R"("min_mm": -10)", R"("min_mm": 500)", "/axes/0/max_mm"},
      {R"("min_mm": -10)", R"("min_mm": -1e300)", "/axes/0/min_mm"},
      {R"("feed_limit_mm_min": 5000)", R"("feed_limit_mm_min": 0)", "/feed_limit_mm_min"},
      {R"("feed_limit_mm_min": 5000)", R"("feed_limit_mm_min": -5000)", "/feed_limit_mm_min"},
      {R"("max_rpm": 4000)", R"("max_rpm": 0)", "/spindle/max_rpm"},
      {R"("min_rpm": 10)", R"("min_rpm": -10)", "/spindle/min_rpm"},
      {R"("bytes": 2048, "blocks": 10)", R"("bytes": 0, "blocks": 0)", "/buffer/bytes"},
      {R"("bytes": 2048)", R"("bytes": -1)", "/buffer/bytes"},
      {R"("block_ms": 1.5)", R"("block_ms": -1.5)", "/timing/cost/block_ms"},
      {R"("sample_time_ms": 8)", R"("sample_time_ms": -8)", "/timing/sample_time_ms"},
      {R"("look_ahead_blocks": 20)", R"("look_ahead_blocks": -1)", "/timing/look_ahead_blocks"},
      {R"("tip": 3)", R"("tip": 3, "length_mm": -1)", "/tools/0/length_mm"},
      {R"("tip": 3)", R"("tip": 3, "length_x_mm": 1e9)", "/tools/0/length_x_mm"},
      {R"("tip": 3)", R"("tip": 3, "diameter_mm": 4, "corner_radius_mm": 3)", "/tools/0/corner_radius_mm"},
      {R"("edge_mm": 12}})", R"("edge_mm": 12}}, {"number": 1, "offset": 1})", "/tools/1/number"},
      {R"("tip": 3)", R"("tip": 3, "name": "A\"B")", "/tools/0/name"},
      {R"("tip": 3)", R"("tip": 3, "name": "123456789012345678901234567890123")", "/tools/0/name"},
      {R"("edge_mm": 12}})", R"("edge_mm": 12}, "name": "A"}, {"number": 8, "name": "A"})", "/tools/1/name"},
      {R"("edge_mm": 12}})", R"("edge_mm": 12}, "name": "A"}, {"number": 1, "offset": 2, "name": "B"})",
       "/tools/1/name"},
      {R"("title": "Mill")", R"("origin": {"X_mm": 1e9})", "/origin/X_mm"},
      {R"("title": "Mill")", R"("origin": {"Q_mm": 1})", "/origin/Q_mm"},
      {R"("title": "Mill")", R"("origin": [1, 2, 3])", "/origin"},
      // unknown
      {R"("title": "Mill")", R"("titel": "Mill")", "/titel"},
      {R"("unsent": 3)", R"("unset": 3)", "/link/unset"},
      {R"("X_mm": 5.5)", R"("x_mm": 5.5)", "/work_offsets/0/x_mm"},
      {R"("title": "Mill")", R"("a/b~c": 1)", "/a~1b~0c"},
      // the sum that the line must keep
      {R"("latency_chars": 6)", R"("latency_chars": 10)", "/link"},
      // given twice
      {R"("title": "Mill")", R"("name": "mill-2")", "/name"},
      {R"("unsent": 3)", R"("baud": 9600)", "/link/baud"},
  };
  for (const Wrong& row : rows) {
    const auto read = read_profile(with(row.from, row.to));
    ASSERT_FALSE(read) << row.to;
    const bool found = std::ranges::any_of(read.error().places,
                                           [&](const app::ErrorPlace& place) { return place.pointer == row.pointer; });
    EXPECT_TRUE(found) << row.to << ": " << read.error().text;
  }
}

TEST(ProfileDocument, EdgesOfOneToolShareItsName) {
  const auto read = read_profile(with(
      R"("edge_mm": 12}})",
      R"("edge_mm": 12}, "name": "Rough 80"}, {"number": 1, "offset": 2, "name": "Rough 80"}, {"number": 1, "offset": 3})"));
  ASSERT_TRUE(read) << read.error().text;
  EXPECT_EQ(read->machine.tools[0].name, "Rough 80");
  EXPECT_EQ(read->machine.tools[1].name, "Rough 80");
  EXPECT_EQ(read->machine.tools[2].name, "");
}

TEST(ProfileDocument, AFaultNamesTheValue) {
  const auto read = read_profile(with(R"("acceleration_mm_s2": 2000)", R"("acceleration_mm_s2": -2.5)"));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().text,
            "machine profile: /axes/0/acceleration_mm_s2 must be from 0.001 to 1000000000, and is -2.5");
  const auto narrow = read_profile(with(R"("max_mm": 500)", R"("max_mm": -11)"));
  ASSERT_FALSE(narrow);
  EXPECT_EQ(narrow.error().text, "machine profile: /axes/0/max_mm must be above min_mm -10, and is -11");
  const auto baud = read_profile(with(R"("baud": 4800)", R"("baud": 0)"));
  ASSERT_FALSE(baud);
  EXPECT_EQ(baud.error().text, "machine profile: /link/baud must be from 50 to 4000000, and is 0");
  EXPECT_FALSE(read_profile(with(R"("rapid_mm_min": 10000)", R"("rapid_mm_min": 1e999)")));
  EXPECT_FALSE(read_profile(with(R"("rapid_mm_min": 10000)", R"("rapid_mm_min": NaN)")));
}

TEST(ProfileDocument, OriginAndToolLengthsArrive) {
  std::string text = with(R"("title": "Mill")", R"("origin": {"X_mm": 100, "Z_mm": -350.5})");
  text.replace(text.find(R"("tip": 3)"), 8, R"("tip": 3, "length_mm": 0, "length_x_mm": -12.5)");
  const auto read = read_profile(text);
  ASSERT_TRUE(read) << read.error().text;
  const checks::Machine& machine = read->machine;
  EXPECT_EQ(machine.origin[0], 100.0);
  EXPECT_FALSE(machine.origin[1]);
  EXPECT_EQ(machine.origin[2], -350.5);
  EXPECT_EQ(machine.tools[0].length_mm, 0.0) << "said to be nothing, which is not unknown";
  EXPECT_EQ(machine.tools[0].length_x_mm, -12.5);
  EXPECT_FALSE(machine.tools[0].length_z_mm);
}

TEST(ProfileDocument, AllFaultsAreReportedAtOnce) {
  std::string text = with(R"("baud": 4800)", R"("baud": "fast")");
  text.replace(text.find(R"("tip": 3)"), 8, R"("tip": -1)");
  const auto read = read_profile(text);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().places.size(), 2U);
  EXPECT_NE(read.error().text.find("(and 1 more)"), std::string::npos) << read.error().text;
}

TEST(ProfileDocument, ATextThatIsNoDocumentSaysWhere) {
  struct Row {
    std::string text;
    std::uint32_t line;
    std::uint32_t column;
    std::string pointer;
  };
  const Row rows[] = {
      {"", 1, 1, ""},
      {"{", 1, 2, ""},
      {"{\n  \"name\": NaN}", 2, 11, "/name"},
      {"{\n\"a\": {\"b\": [1, 2, Infinity]}}", 2, 19, "/a/b/1"},
      {"{\"a\": 1e999}", 1, 11, "/a"},
      {"{\"a\": -1e400}", 1, 12, "/a"},
      {"{\"a\": 01}", 1, 8, "/a"},
      {"{\"a\": \"\xC3\x28\"}", 1, 9, "/a"},
      {"{\"a\": \"\xFF\"}", 1, 8, "/a"},
      {"{\"a\": \"\xED\xA0\x80\"}", 1, 9, "/a"},
      {"{\"a\": \"\\ud800\"}", 1, 14, "/a"},
      {"{\"a\": \"line\nbreak\"}", 1, 12, "/a"},
      {"{\"a\": 1,}", 1, 9, "/a"},
      {"{} {}", 1, 4, ""},
  };
  for (const Row& row : rows) {
    const auto read = read_profile(row.text);
    ASSERT_FALSE(read) << row.text;
    EXPECT_EQ(read.error().code, app::ErrorCode::malformed);
    ASSERT_EQ(read.error().places.size(), 1U) << row.text << read.error().text;
    const app::ErrorPlace& place = read.error().places.front();
    EXPECT_EQ(place.line, row.line) << row.text << read.error().text;
    EXPECT_EQ(place.column, row.column) << row.text << read.error().text;
    EXPECT_EQ(place.pointer, row.pointer) << row.text;
    EXPECT_TRUE(read.error().text.starts_with("this is not JSON: line ")) << read.error().text;
  }
}

TEST(ProfileDocument, NestingHasAnEnd) {
  const std::string open(1'000'000, '[');
  const auto arrays = read_profile("{\"a\":" + open);
  ASSERT_FALSE(arrays);
  EXPECT_NE(arrays.error().text.find("is nested deeper than 64 levels"), std::string::npos) << arrays.error().text;
  std::string objects;
  for (int i = 0; i < 65; ++i) objects += "{\"a\":";
  const auto deep = read_profile(objects + "1" + std::string(65, '}'));
  ASSERT_FALSE(deep);
  EXPECT_NE(deep.error().text.find("is nested deeper"), std::string::npos) << deep.error().text;
  const auto fits = read_profile(objects.substr(5) + "1" + std::string(64, '}'));
  ASSERT_FALSE(fits);
  EXPECT_EQ(fits.error().text.find("is nested deeper"), std::string::npos) << fits.error().text;
}

TEST(ProfileDocument, OnlyAnObjectIsAProfile) {
  for (const char* text : {"[]", "null", "5", "\"x\"", "true"}) EXPECT_FALSE(read_profile(text)) << text;
}

}  // namespace
}  // namespace dripfeed::json
