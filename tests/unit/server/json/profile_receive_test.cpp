// The section "receive" of a profile.
#include <gtest/gtest.h>

#include "server/json/profile_document.h"

namespace dripfeed::json {
namespace {

app::Result<machine::Profile> with(const std::string& receive) {
  return read_profile(R"({"name": "m", "dialect": "fanuc", "kind": "mill",
    "axes": [{"name": "X", "rapid_mm_min": 10000, "acceleration_mm_s2": 2000}],
    "link": {"url": "serial:/dev/ttyS0"})" +
                      (receive.empty() ? "" : ", \"receive\": " + receive) + "}");
}

TEST(ProfileReceive, IsOnByItself) {
  const auto profile = with("");
  ASSERT_TRUE(profile) << profile.error().text;
  EXPECT_EQ(profile->line.receive, machine::ReceiveSettings{});
  EXPECT_TRUE(profile->line.receive.enabled);
  EXPECT_FALSE(profile->line.receive.remote_drip) << "a request starts no drip-feed unless the profile says so";
  EXPECT_FALSE(profile->line.receive.remote_arm);
}

TEST(ProfileReceive, EveryMemberArrives) {
  const auto profile = with(
      R"({"enabled": true, "quiet_s": 3, "quiet_after_end_s": 0.25, "end_character": 4, "hold": "dc3", "code": "auto",
    "answer_number": 8998, "read_back_minutes": 15, "read_back": true, "requests": true, "request_number": 8999, "request_marker": "ASK", "scan_lines": 7,
    "request_delay_s": 12, "remote_drip": true, "remote_arm": true})");
  ASSERT_TRUE(profile) << profile.error().text;
  const machine::ReceiveSettings& r = profile->line.receive;
  EXPECT_EQ(r.quiet_s, 3.0);
  EXPECT_EQ(r.quiet_after_end_s, 0.25);
  EXPECT_EQ(r.end_character, 4);
  EXPECT_EQ(r.hold, receive::Hold::dc3);
  EXPECT_TRUE(r.read_back && r.remote_drip && r.remote_arm);
  EXPECT_EQ(r.request_number, 8999U);
  EXPECT_EQ(r.request_marker, "ASK");
  EXPECT_EQ(r.scan_lines, 7U);
  EXPECT_EQ(r.request_delay_s, 12.0);
  EXPECT_EQ(r.answer_number, 8998U);
  EXPECT_EQ(r.read_back_minutes, 15.0);
  EXPECT_TRUE(r.find_code);
  const receive::Settings settings = machine::receive_settings_of(profile->line);
  EXPECT_EQ(settings.quiet, std::chrono::seconds(3));
  EXPECT_EQ(settings.end_character, 4);
  EXPECT_TRUE(settings.find_code);
  EXPECT_EQ(machine::request_grammar_of(r).program_number, 8999U);
}

TEST(ProfileReceive, NamesItsFaults) {
  for (const char* wrong : {R"({"quiet": 3})", R"({"hold": "cts"})", R"({"quiet_s": 0})", R"({"request_number": 0})",
                            R"({"end_character": 65})", R"({"remote_arm": true})"}) {
    const auto profile = with(wrong);
    ASSERT_FALSE(profile) << wrong;
    EXPECT_NE(profile.error().text.find("/receive"), std::string::npos) << profile.error().text;
  }
}

app::Result<machine::Profile> on(const std::string& link, const std::string& receive = "{}") {
  return read_profile(R"({"name": "m", "dialect": "fanuc", "kind": "mill",
    "axes": [{"name": "X", "rapid_mm_min": 10000, "acceleration_mm_s2": 2000}],
    "link": )" + link +
                      R"(, "receive": )" + receive + "}");
}

std::string refusal_of(const app::Result<machine::Profile>& profile) {
  return profile ? "it is not refused" : profile.error().text;
}

TEST(ProfileReceive, TheFlowCharactersOfTheLineAreTheReceivers) {
  const auto profile = on(R"({"url": "serial:/dev/ttyS0", "xon": 5, "xoff": 6})");
  ASSERT_TRUE(profile) << profile.error().text;
  const receive::Settings settings = machine::receive_settings_of(profile->line);
  EXPECT_EQ(settings.xon, 5);
  EXPECT_EQ(settings.xoff, 6);
  EXPECT_FALSE(settings.flow_below);
}

TEST(ProfileReceive, WhatALineCannotReceiveIsRefusedInASentence) {
  const std::string eia = R"("code": "eia", "framing": "8N2")";
  EXPECT_NE(
      refusal_of(on(R"({"url": "serial:/dev/ttyS0", "flow": "xonxoff", "xoff_by": "kernel", "start": "at-once", )" +
                    eia + "}"))
          .find("the digit 3 of a punch is DC3"),
      std::string::npos);
  EXPECT_TRUE(on(R"({"url": "serial:/dev/ttyS0", "flow": "xonxoff", )" + eia + "}"));
  EXPECT_NE(refusal_of(on(R"({"url": "serial:/dev/ttyS0", )" + eia + "}", R"({"hold": "dc3"})")).find("hold by RTS"),
            std::string::npos);
  EXPECT_NE(refusal_of(on(R"({"url": "tcp://server:4001"})", R"({"hold": "rts"})")).find("no RTS"), std::string::npos);
  EXPECT_TRUE(on(R"({"url": "rfc2217://server:2217"})", R"({"hold": "rts"})"));
  EXPECT_NE(refusal_of(on(R"({"url": "dir:/srv/dnc"})", R"({"read_back": true})")).find("receive.read_back"),
            std::string::npos);
}

TEST(ProfileReceive, TheUrlMayAskForTheCodeToBeFound) {
  const auto profile = on(R"({"url": "serial:/dev/ttyS0?framing=8N1&code=auto"})");
  ASSERT_TRUE(profile) << profile.error().text;
  const auto line = machine::effective_line(profile->line);
  ASSERT_TRUE(line);
  EXPECT_TRUE(machine::receive_settings_of(*line).find_code);
  EXPECT_EQ(line->code, tape_code::Code::ascii) << "what goes out keeps its code";
}

}  // namespace
}  // namespace dripfeed::json
