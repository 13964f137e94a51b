// From a profile to the settings of a feed and of a control.
#include "server/machine/profile.h"

#include <array>

#include <gtest/gtest.h>

namespace dripfeed::machine {
namespace {

LineSettings line_at(std::string_view url) {
  LineSettings line;
  line.link = parse_link_url(url).value();
  return line;
}

TEST(Line, OptionsOfTheUrlWin) {
  LineSettings line = line_at(
      "serial:/dev/ttyS0?baud=19200&framing=8N1&latency_chars=3&budget=9&unsent=6&start=at-once&eob=cr-lf&flow="
      "xonxoff");
  line.baud = 4800;
  line.eob = tape_code::Eob::lf;
  const auto effective = effective_line(line);
  ASSERT_TRUE(effective) << effective.error();
  EXPECT_EQ(effective->baud, 19200U);
  EXPECT_EQ(effective->framing, (tape_code::Framing{8, tape_code::Parity::none, 1}));
  EXPECT_EQ(effective->code, tape_code::Code::ascii);
  EXPECT_EQ(effective->latency_chars, 3U);
  EXPECT_EQ(effective->overrun_budget, 9U);
  EXPECT_EQ(effective->unsent, 6U);
  EXPECT_EQ(effective->start, feed::Start::at_once);
  EXPECT_EQ(effective->eob, tape_code::Eob::cr_lf);

  const auto feed = feed_settings_of(line);
  ASSERT_TRUE(feed) << feed.error();
  EXPECT_EQ(feed->baud, 19200U);
  EXPECT_EQ(feed->wire.eob, tape_code::Eob::cr_lf);
  EXPECT_EQ(feed->wire.eighth_bit, tape_code::EighthBit::data);
  EXPECT_EQ(feed->start, feed::Start::at_once);
  EXPECT_EQ(feed->overrun_budget, 9U);
}

TEST(Line, WithoutOptionsTheProfileCounts) {
  LineSettings line = line_at("pty:/tmp/x");
  line.baud = 4800;
  line.leader_chars = 50;
  line.trailer_chars = 20;
  line.end_by_dc3 = false;
  line.end_by_character = 4;
  line.end_by_quiet_s = 2.5;
  line.watch_cts = true;
  const auto feed = feed_settings_of(line);
  ASSERT_TRUE(feed) << feed.error();
  EXPECT_EQ(feed->baud, 4800U);
  EXPECT_EQ(feed->wire.eighth_bit, tape_code::EighthBit::even);
  EXPECT_EQ(feed->wire.leader_chars, 50U);
  EXPECT_EQ(feed->wire.trailer_chars, 20U);
  EXPECT_FALSE(feed->end.dc3);
  EXPECT_EQ(feed->end.eot, 4);
  EXPECT_EQ(feed->end.quiet, feed::Time(2'500'000'000));
  EXPECT_TRUE(feed->watch_cts);
  EXPECT_FALSE(feed->watch_dsr);
  EXPECT_FALSE(feed->blind);
  EXPECT_TRUE(feed_settings_of(line_at("tcp://h:1"))->blind);
}

TEST(Line, RefusesTheBudgetWithItsSum) {
  LineSettings line = line_at("serial:/dev/ttyS0?unsent=8");
  line.latency_chars = 5;
  line.overrun_budget = 10;
  const auto feed = feed_settings_of(line);
  ASSERT_FALSE(feed);
  EXPECT_EQ(feed.error(), "8 unsent + 5 latency = 13 characters, more than the overrun budget of 10");
  line.overrun_budget = 13;
  EXPECT_TRUE(feed_settings_of(line));
}

struct Wrong {
  std::string_view option;
  std::string_view reported;
};

TEST(Line, NamesTheOptionThatIsWrong) {
  const std::array wrongs = {
      Wrong{"baud=fast", "baud \"fast\" is not a whole number"},
      Wrong{"baud=-1", "baud \"-1\" is not a whole number"},
      Wrong{"baud=96.5", "baud \"96.5\" is not a whole number"},
      Wrong{"unsent=99999999999", "unsent \"99999999999\" is not a whole number"},
      Wrong{"framing=9N1", "framing \"9N1\":"},
      Wrong{"start=now", "start \"now\" is none of dc1, at-once, trigger"},
      Wrong{"eob=crlf", "eob \"crlf\" is not lf, cr-lf, lf-cr-cr, cr"},
      Wrong{"flow=cts", "flow \"cts\" is none of xonxoff, rtscts, dtrdsr, both, none"},
      Wrong{"char_delay_ms=1.5", "char_delay_ms \"1.5\" is not a whole number"},
  };
  for (const Wrong& wrong : wrongs) {
    const LineSettings line = line_at("serial:/dev/ttyS0?" + std::string(wrong.option));
    const auto effective = effective_line(line);
    ASSERT_FALSE(effective) << wrong.option;
    EXPECT_NE(effective.error().find(wrong.reported), std::string::npos) << effective.error();
    EXPECT_EQ(feed_settings_of(line).error(), effective.error());
  }
  EXPECT_NE(feed_settings_of(line_at("serial:/dev/ttyS0?baud=0")).error().find("baud"), std::string::npos);
}

// A rate of 0 would divide by it, in packets and where a flow line is looked at, before anything else is asked.
TEST(Line, ABaudRateOfTheUrlIsWithinReason) {
  for (const char* url :
       {"serial:/dev/ttyS0?baud=0", "serial:/dev/ttyS0?baud=49", "serial:/dev/ttyS0?baud=4000001",
        "serial:/dev/ttyS0?protocol=xmodem&baud=0", "serial:/dev/ttyS0?flow=dtrdsr&baud=0", "tcp://host:1?baud=0"}) {
    const auto effective = effective_line(line_at(url));
    ASSERT_FALSE(effective) << url;
    EXPECT_TRUE(effective.error().starts_with("baud ")) << effective.error();
    EXPECT_TRUE(effective.error().ends_with(" is not from 50 to 4000000")) << effective.error();
    EXPECT_FALSE(feed_settings_of(line_at(url))) << url;
    EXPECT_FALSE(packet_settings_of(line_at(url))) << url;
  }
  EXPECT_TRUE(effective_line(line_at("serial:/dev/ttyS0?baud=50")));
  EXPECT_TRUE(effective_line(line_at("serial:/dev/ttyS0?baud=4000000")));
}

TEST(Line, AFlowIsAnOptionOfTheUrl) {
  const std::array<std::pair<std::string_view, feed::Flow>, 5> flows = {{{"none", feed::Flow::none},
                                                                         {"xonxoff", feed::Flow::xonxoff},
                                                                         {"rtscts", feed::Flow::rtscts},
                                                                         {"dtrdsr", feed::Flow::dtrdsr},
                                                                         {"both", feed::Flow::both}}};
  for (const auto& [name, flow] : flows) {
    const auto feed = feed_settings_of(line_at("serial:/dev/ttyS0?flow=" + std::string(name)));
    ASSERT_TRUE(feed) << feed.error();
    EXPECT_EQ(feed->flow, flow) << name;
  }
  const auto slow = feed_settings_of(line_at("serial:/dev/ttyS0?char_delay_ms=5&line_delay_ms=200"));
  ASSERT_TRUE(slow) << slow.error();
  EXPECT_EQ(slow->char_delay, feed::Time(5'000'000));
  EXPECT_EQ(slow->line_delay, feed::Time(200'000'000));
}

TEST(Line, AFlowThatCannotBeSeenOrCannotKeepTheBudgetIsRefused) {
  const auto raw = feed_settings_of(line_at("tcp://h:1?flow=rtscts"));
  ASSERT_FALSE(raw);
  EXPECT_NE(raw.error().find("CTS and DSR cannot be seen through a raw socket"), std::string::npos) << raw.error();
  LineSettings by_device = line_at("tcp://h:1?flow=rtscts&start=at-once");
  by_device.xoff_by = feed::XoffBy::device;
  EXPECT_TRUE(feed_settings_of(by_device));
  // DSR is looked at every 2 ms: 23 characters at 115200 baud and 8N1.
  EXPECT_TRUE(feed_settings_of(line_at("serial:/dev/ttyS0?flow=dtrdsr")));
  const auto fast = feed_settings_of(line_at("serial:/dev/ttyS0?flow=dtrdsr&baud=115200&framing=8N1"));
  ASSERT_FALSE(fast);
  EXPECT_EQ(fast.error(), "4 unsent + 24 latency = 28 characters, more than the overrun budget of 10");
  LineSettings kernel = line_at("serial:/dev/ttyS0");
  kernel.xoff_by = feed::XoffBy::kernel;
  const auto unseen = feed_settings_of(kernel);
  ASSERT_FALSE(unseen);
  EXPECT_NE(unseen.error().find("a start by DC1 would never be seen"), std::string::npos) << unseen.error();
}

TEST(Line, ReadsEveryEob) {
  const std::array<std::pair<std::string_view, tape_code::Eob>, 5> eobs = {{{"lf", tape_code::Eob::lf},
                                                                            {"cr-lf", tape_code::Eob::cr_lf},
                                                                            {"lf-cr-cr", tape_code::Eob::lf_cr_cr},
                                                                            {"cr", tape_code::Eob::cr},
                                                                            {"LF_CR_CR", tape_code::Eob::lf_cr_cr}}};
  for (const auto& [name, eob] : eobs) {
    EXPECT_EQ(effective_line(line_at("pty:/x?eob=" + std::string(name)))->eob, eob) << name;
  }
}

TEST(Line, ReadsTheCodeAndAnEobOfTheShop) {
  EXPECT_EQ(tape_code::name(effective_line(line_at("pty:/x?eob=cr-lf-lf"))->eob), "CR LF LF");
  EXPECT_FALSE(effective_line(line_at("pty:/x?eob=13")));
  EXPECT_FALSE(effective_line(line_at("pty:/x?code=bcd")));
  const auto eia = feed_settings_of(line_at("pty:/x?framing=8N2&code=eia"));
  ASSERT_TRUE(eia) << eia.error();
  EXPECT_TRUE(eia->wire.eia);
  EXPECT_EQ(eia->wire.eighth_bit, tape_code::EighthBit::data);
  const auto seven = feed_settings_of(line_at("pty:/x?framing=7E2&code=eia"));
  ASSERT_FALSE(seven);
  EXPECT_NE(seven.error().find("8N"), std::string::npos) << seven.error();
  EXPECT_EQ(feed_settings_of(line_at("pty:/x?framing=8N1&code=iso"))->wire.eighth_bit, tape_code::EighthBit::even);
  LineSettings line = *effective_line(line_at("pty:/x?framing=8N2&code=eia"));
  EXPECT_FALSE(characters_of(line).has('a'));
  EXPECT_FALSE(characters_of(line).has('#'));
  EXPECT_EQ(character_refusal(line, {.byte = '#'}), "EIA has no code for the character '#'");
  EXPECT_EQ(character_refusal(line, {.byte = 0xE4}), "the control does not take the character 0xE4");
  line.eia_specials.codes[2] = 0x5E;
  EXPECT_TRUE(characters_of(line).has('#'));
  line.eia_specials.codes[2] = 0x61;
  EXPECT_FALSE(feed_settings_of(line));
  // The framing of a URL does not make another code of a profile's EIA.
  LineSettings by_profile = line_at("pty:/x?framing=8N1");
  by_profile.code = tape_code::Code::eia;
  EXPECT_TRUE(feed_settings_of(by_profile)->wire.eia);
  by_profile.link = line_at("pty:/x?framing=7E2").link;
  EXPECT_FALSE(feed_settings_of(by_profile));
}

TEST(Control, TheProfileLiesOverTheUsualControl) {
  ir::Control usual;
  usual.title = "usual";
  usual.semantics.least_increment_mm = 0.001;
  usual.semantics.power_on_unit = ir::Function::unit_mm;
  usual.semantics.arc_without_center_is_line = true;
  Profile profile;
  const ir::Control same = control_of(profile, usual);
  EXPECT_EQ(same.title, "usual");
  EXPECT_EQ(same.semantics.least_increment_mm, 0.001);
  EXPECT_EQ(same.semantics.power_on_unit, ir::Function::unit_mm);
  EXPECT_TRUE(same.from_profile);
  EXPECT_FALSE(same.semantics.power_on_known);

  profile.control.title = "Fanuc 0i-TF";
  profile.control.increment_mm = 0.0001;
  profile.control.power_on_unit = ir::Function::unit_inch;
  profile.control.power_on_confirmed = true;
  profile.control.iso_decimal_mode = ir::DecimalMode::least_increment;
  profile.control.starts_in_iso_mode = true;
  profile.control.decimal_mode = ir::DecimalMode::calculator;
  profile.control.variables = {{.bank = ir::Bank::r, .first = 0, .last = 99}};
  profile.control.block_length_bytes = 80;
  profile.control.axes_at_once = 2;
  profile.control.arc_without_center_is_line = false;
  const ir::Control set = control_of(profile, usual);
  EXPECT_EQ(set.title, "Fanuc 0i-TF");
  EXPECT_EQ(set.semantics.least_increment_mm, 0.0001);
  EXPECT_EQ(set.semantics.power_on_unit, ir::Function::unit_inch);
  EXPECT_TRUE(set.semantics.power_on_known);
  EXPECT_EQ(set.semantics.iso_decimal_mode, ir::DecimalMode::least_increment);
  EXPECT_TRUE(set.semantics.starts_in_iso_mode);
  EXPECT_EQ(set.semantics.decimal_mode, ir::DecimalMode::calculator);
  ASSERT_EQ(set.variables.size(), 1U);
  EXPECT_EQ(set.variables.front().last, 99U);
  EXPECT_EQ(set.limits.block_length_bytes, 80U);
  EXPECT_EQ(set.limits.axes_at_once, 2U);
  EXPECT_FALSE(set.semantics.arc_without_center_is_line);
}

TEST(Syntax, FollowsTheDialectAndTheDelivery) {
  Profile profile;
  profile.control.dialect = "fanuc";
  EXPECT_EQ(program_syntax_of(profile, ir::Delivery::drip).comments[0].open, '(');
  EXPECT_TRUE(program_syntax_of(profile, ir::Delivery::drip).end_code);
  EXPECT_FALSE(program_syntax_of(profile, ir::Delivery::memory).end_code);
  profile.control.dialect = "sinumerik-840d";
  EXPECT_EQ(program_syntax_of(profile, ir::Delivery::drip).comments[0].open, ';');
}

TEST(Profile, TheAxesAreThoseOfTheMachine) {
  Profile profile;
  ir::Control usual;
  usual.axes = "XZ";
  EXPECT_EQ(control_of(profile, usual).axes, "XZ") << "a profile without axes";
  profile.machine.axes = {{.axis = ir::Axis::c}, {.axis = ir::Axis::z}, {.axis = ir::Axis::x}};
  EXPECT_EQ(control_of(profile, usual).axes, "XZC") << "in the order of the trace";
}

TEST(Profile, CuttersAreThoseOfTheMachine) {
  Profile profile;
  profile.machine.tools = {{.number = 1, .offset = 2, .diameter_mm = 10.0}, {.number = 3, .nose_radius_mm = 0.8}};
  const ir::Control control = control_of(profile, {});
  ASSERT_EQ(control.tool_radii.size(), 1U);
  EXPECT_EQ(control.tool_radii[0].tool, 1);
  EXPECT_EQ(control.tool_radii[0].offset, 2);
  EXPECT_EQ(control.tool_radii[0].radius_mm, 5.0);
}

TEST(Profile, ToolsAreFoundByTheirNames) {
  Profile profile;
  profile.machine.tools = {{.number = 4, .name = "MILL_D10", .offset = 1, .length_mm = 80.0},
                           {.number = 4, .offset = 2},
                           {.number = 9, .name = "DRILL 8.5"},
                           {.number = 3}};
  const ir::Control control = control_of(profile, {});
  EXPECT_EQ(ir::tool_of_name(control, "MILL_D10"), 4);
  EXPECT_EQ(ir::tool_of_name(control, "DRILL 8.5"), 9);
  EXPECT_EQ(ir::tool_of_name(control, "Mill_D10"), 0) << "capital letters count";
  EXPECT_EQ(ir::tool_of_name(control, ""), 0);
  EXPECT_EQ(ir::tool_of_name({}, "MILL_D10"), 0);
  ASSERT_EQ(control.tool_lengths.size(), 1U);
  EXPECT_EQ(control.tool_lengths[0].length_mm, 80.0);
}

}  // namespace
}  // namespace dripfeed::machine
