// The options of a server as a file: what it says is taken, what is wrong has its line and column, and a refused file
// changes nothing.
#include "server/json/server_options.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/json/place_in_text.h"

namespace dripfeed::json {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(ServerOptions, WhatIsNamedIsTakenAndTheRestStays) {
  ServerOptions options;
  options.web = "page";
  ASSERT_TRUE(read_server_options(R"({"data": "/srv/d", "insecure": true, "proxy": ["10.0.0.1", "::1"],
      "modbus_unit": {"lathe": 1, "mill=2": 247}, "check_memory": 64, "tls_key": null})",
                                  options));
  EXPECT_EQ(options.data, "/srv/d");
  EXPECT_EQ(options.web, "page");
  EXPECT_EQ(options.listen, "127.0.0.1:8840");
  EXPECT_TRUE(options.insecure);
  EXPECT_THAT(options.proxy, ElementsAre("10.0.0.1", "::1"));
  EXPECT_THAT(options.modbus_unit, ElementsAre("lathe=1", "mill=2=247"));
  EXPECT_EQ(options.check_memory, 64U);
  ASSERT_TRUE(read_server_options("{}", options));
  EXPECT_EQ(options.data, "/srv/d");
}

TEST(ServerOptions, EachFaultHasItsLineAndColumn) {
  ServerOptions options;
  const auto refused = read_server_options(
      "{\n  \"data\": \"/srv/d\",\n  \"listn\": \":80\",\n  \"insecure\": 1,\n\t\"proxy\": [\"::1\",\n 7],\n"
      "  \"modbus_unit\": {\"lathe\": 0}, \"check_seconds\": 86401\n}\n",
      options);
  ASSERT_FALSE(refused);
  std::vector<std::string> places;
  for (const app::ErrorPlace& one : refused.error().places)
    places.push_back(std::to_string(one.line) + ":" + std::to_string(one.column) + " " +
                     one.text.substr(0, one.text.find(' ')));
  EXPECT_THAT(places,
              ElementsAre("3:3 /listn", "4:3 /insecure", "5:2 /proxy", "7:3 /modbus_unit", "7:32 /check_seconds"));
  EXPECT_EQ(options, ServerOptions{}) << "a refused file changes nothing";
}

TEST(ServerOptions, WhatIsNoJsonHasThePlaceOfTheParser) {
  ServerOptions options;
  const auto refused = read_server_options("{\n  \"data\": \"d\",\n}\n", options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().places.at(0).line, 3U);
  EXPECT_FALSE(read_server_options("[]", options));
  EXPECT_FALSE(read_server_options(R"({"data": "a", "data": "b"})", options)) << "which of both?";
}

TEST(ServerOptions, TheSchemaNamesEveryMember) {
  const std::string schema = server_options_schema();
  for (const char* name : {"data", "listen", "web", "insecure", "tls_cert", "tls_key", "proxy", "modbus_listen",
                           "modbus_allow", "modbus_unit", "check_seconds", "check_memory"})
    EXPECT_THAT(schema, HasSubstr(std::string("\"") + name + "\":{")) << name;
  EXPECT_THAT(schema, HasSubstr("\"additionalProperties\":false"));
  EXPECT_THAT(schema, HasSubstr("json-schema.org/draft/2020-12"));
}

TEST(PlaceInText, FindsMembersAfterAllKindsOfValues) {
  constexpr std::string_view kText =
      R"({"a": "}\"]", "b": [[1, {"x": "]"}], -1.5e3, null], "c~/d": {"e": true}, "\u0066": 2})";
  const auto at = [&](std::string_view pointer) { return place_in_text(kText, pointer).column - 1; };
  EXPECT_EQ(at(""), 0U);
  EXPECT_EQ(at("/a"), kText.find("\"a\""));
  EXPECT_EQ(at("/b/0/1/x"), kText.find("\"x\""));
  EXPECT_EQ(at("/b/1"), kText.find("-1.5"));
  EXPECT_EQ(at("/b/2"), kText.find("null"));
  EXPECT_EQ(at("/c~0~1d/e"), kText.find("\"e\""));
  EXPECT_EQ(at("/f"), 0U) << "written with an escape";
  EXPECT_EQ(at("/b/7"), kText.find("\"b\"")) << "missing: what should have it";
  EXPECT_EQ(place_in_text("\n\n {\n\"a\":1}", "/a"), (TextPlace{.line = 4, .column = 1}));
}

}  // namespace
}  // namespace dripfeed::json
