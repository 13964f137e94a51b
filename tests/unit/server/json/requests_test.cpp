// Bodies of requests: what they say arrives; missing, wrong and unknown members are refused with their pointers.
#include "server/json/requests.h"

#include <algorithm>
#include <chrono>
#include <functional>

#include <gtest/gtest.h>

#include "server/json/orders.h"
#include "server/json/people.h"

namespace dripfeed::json {
namespace {

template <class T>
std::optional<app::Error> error_of(const app::Result<T>& result) {
  if (result) return std::nullopt;
  return result.error();
}

struct Row {
  std::function<std::optional<app::Error>(std::string_view)> read;
  std::string_view body;
  std::string_view pointer;  // of the fault; "ok": there is none
};

void check(std::span<const Row> rows) {
  for (const Row& row : rows) {
    const auto error = row.read(row.body);
    if (row.pointer == "ok") {
      EXPECT_FALSE(error) << row.body << ": " << error->text;
      continue;
    }
    ASSERT_TRUE(error) << row.body;
    EXPECT_TRUE(error->code == app::ErrorCode::invalid || error->code == app::ErrorCode::malformed) << row.body;
    EXPECT_TRUE(std::ranges::any_of(error->places, [&](const auto& place) { return place.pointer == row.pointer; }))
        << row.body << ": " << error->text;
  }
}

TEST(Requests, TextsAndPrograms) {
  const auto text = [](std::string_view body) { return error_of(read_text_body(body)); };
  const auto program = [](std::string_view body) { return error_of(read_program_body(body)); };
  const Row rows[] = {
      {text, R"({"text":"family x"})", "ok"},
      {text, R"({})", "/text"},
      {text, R"({"text":""})", "/text"},
      {text, R"({"text":null})", "/text"},
      {text, R"({"text":["a"]})", "/text"},
      {text, R"({"text":"a","name":"b"})", "/name"},
      {text, R"({"text":"a","text":"b"})", "/text"},
      {program, R"({"name":"O1","dialect":"fanuc","text":"%"})", "ok"},
      {program, R"({"dialect":"fanuc","text":"%"})", "/name"},
      {program, R"({"name":"O1","text":"%"})", "/dialect"},
      {program, R"({"name":1,"dialect":"fanuc","text":"%"})", "/name"},
  };
  check(rows);
  EXPECT_EQ(read_text_body(R"({"text":"a\nb\u00e4"})")->text, "a\nb\xC3\xA4");
  EXPECT_FALSE(read_text_body(""));
  EXPECT_FALSE(read_text_body("[]"));
}

TEST(Requests, NamesHaveOneRule) {
  const auto program = [](std::string_view body) { return error_of(read_program_body(body)); };
  const auto part = [](std::string_view body) { return error_of(read_part_body(body, true)); };
  const auto render = [](std::string_view body) { return error_of(read_render_body(body)); };
  const auto accept = [](std::string_view body) { return error_of(read_accept_body(body)); };
  const std::string longest(200, 'x');
  for (const std::string& wrong : {longest + "x", std::string(65'520, 'x'), std::string(" a"), std::string("a\\u0007"),
                                   std::string("a\\n"), std::string("a\\u202e")}) {
    const std::string quoted = "\"" + wrong + "\"";
    const std::string bodies[] = {"{\"name\":" + quoted + R"(,"dialect":"fanuc","text":"%"})",
                                  "{\"number\":" + quoted + R"(,"family":"f"})",
                                  "{\"name\":" + quoted + R"(,"part":"p","machine":"m"})", "{\"name\":" + quoted + "}"};
    const Row rows[] = {{program, bodies[0], "/name"},
                        {part, bodies[1], "/number"},
                        {render, bodies[2], "/name"},
                        {accept, bodies[3], "/name"}};
    check(rows);
  }
  EXPECT_FALSE(program("{\"name\":\"" + longest + R"(","dialect":"fanuc","text":"%"})"));
  EXPECT_FALSE(accept("{\"name\":\"" + longest + "\"}"));
}

// Each member is looked for among all before it: without a limit 100,000 of them took 7.7 s.
TEST(Requests, AHundredThousandMembersAreRefusedAtOnce) {
  std::string members;
  for (int i = 0; i < 150'000; ++i) members += (i == 0 ? "" : ",") + ("\"m" + std::to_string(i) + "\":0");
  const auto begin = std::chrono::steady_clock::now();
  const auto top = read_text_body("{" + members + "}");
  const auto inner = read_part_body(R"({"number":"P","family":"f","values":{)" + members + "}}", true);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
  ASSERT_FALSE(top);
  EXPECT_EQ(top.error().text, "the document has more than 1024 members");
  ASSERT_FALSE(inner);
  EXPECT_EQ(inner.error().places.at(0).pointer, "/values");
  std::string list = "0";
  for (int i = 0; i < 250'000; ++i) list += ",0";
  const auto values = read_text_body(R"({"text":[)" + list + "]}");
  ASSERT_FALSE(values);
  EXPECT_NE(values.error().text.find("more than 200000 values"), std::string::npos) << values.error().text;
}

TEST(Requests, PartsAndValues) {
  const auto fresh = [](std::string_view body) { return error_of(read_part_body(body, true)); };
  const auto change = [](std::string_view body) { return error_of(read_part_body(body, false)); };
  const Row rows[] = {
      {fresh, R"({"number":"R1","family":"roll","values":{"a":"1 mm","b":2}})", "ok"},
      {fresh, R"({"family":"roll"})", "/number"},
      {fresh, R"({"number":".","family":"roll"})", "/number"},
      {fresh, R"({"number":"R1"})", "/family"},
      {fresh, R"({"number":"R1","family":"roll","values":[]})", "/values"},
      {fresh, R"({"number":"R1","family":"roll","values":{"a":true}})", "/values"},
      {fresh, R"({"number":"R1","family":"roll","values":{"a":{"b":1}}})", "/values"},
      {fresh, R"({"number":"R1","family":"roll","values":{"a":1,"a":2}})", "/values/a"},
      {change, R"({"values":{"a":"1 mm"}})", "ok"},
      {change, R"({"number":"R1","values":{}})", "/number"},
  };
  check(rows);
  const app::Values values = {{"length", "120 mm"}, {"odd \"name\"", "\\"}, {"x", "\xC3\xA4"}};
  EXPECT_EQ(*read_values(write_values(values)), values) << "what is written is read";
  EXPECT_EQ(*read_values(write_values({})), app::Values{});
  EXPECT_EQ(read_values(R"({"n":0.25,"m":-3})")->at("n"), "0.25");
  EXPECT_FALSE(read_values("5"));
  EXPECT_FALSE(read_values("{"));
}

TEST(Requests, RenderOrders) {
  const auto render = [](std::string_view body) { return error_of(read_render_body(body)); };
  const Row rows[] = {
      {render, R"({"part":"R1","machine":"m"})", "ok"},
      {render, R"({"part":"R1"})", "/machine"},
      {render, R"({"part":"R1","machine":"m","mode":"fast"})", "/mode"},
      {render, R"({"part":"R1","machine":"m","delivery":"mail"})", "/delivery"},
      {render, R"({"part":7,"machine":"m"})", "/part"},
      {render, R"({"part":"R1","machine":"m","modes":"auto"})", "/modes"},
  };
  check(rows);
  const auto order = read_render_body(
      R"({"family":"roll","values":{"a":"1 mm"},"machine":"m","mode":"explicit","delivery":"memory","name":"O7"})");
  ASSERT_TRUE(order);
  EXPECT_EQ(order->family, "roll");
  EXPECT_EQ(order->values.at("a"), "1 mm");
  EXPECT_EQ(order->mode, compile::RenderMode::explicit_blocks);
  EXPECT_EQ(order->delivery, store::Delivery::memory);
  EXPECT_EQ(order->name, "O7");
  EXPECT_EQ(read_render_body(R"({"part":"R1","machine":"m"})")->mode, compile::RenderMode::automatic);
}

TEST(Requests, ChecksReleasesAndJobs) {
  const auto checks = [](std::string_view body) { return error_of(read_check_body(body)); };
  const auto releases = [](std::string_view body) { return error_of(read_release_body(body)); };
  const auto moves = [](std::string_view body) { return error_of(read_transition_body(body)); };
  const auto jobs = [](std::string_view body) { return error_of(read_job_body(body)); };
  const Row rows[] = {
      {checks, R"({"program":3,"machine":"m"})", "ok"},
      {checks, R"({"machine":"m"})", "/program"},
      {checks, R"({"program":0,"machine":"m"})", "/program"},
      {checks, R"({"program":"3","machine":"m"})", "/program"},
      {checks, R"({"program":3.0,"machine":"m"})", "/program"},
      {checks, R"({"program":9007199254740993,"machine":"m"})", "/program"},
      {checks, R"({"program":18446744073709551615,"machine":"m"})", "/program"},
      {checks, R"({"program":3,"revision":0,"machine":"m"})", "/revision"},
      {checks, R"({"program":3,"machine":"m","nominal":{"family":"f","values":{"a":"1 mm"}},"profile":"2-9"})", "ok"},
      {checks, R"({"program":3,"machine":"m","nominal":{}})", "/nominal/family"},
      {checks, R"({"program":3,"machine":"m","nominal":"f"})", "/nominal"},
      {checks, R"({"program":3,"machine":"m","nominal":{"family":"f"},"profile":"9-2"})", "/profile"},
      {checks, R"({"program":3,"machine":"m","cmm":"x"})", "/cmm"},
      {releases, R"({"program":3,"machine":"m","delivery":"memory"})", "ok"},
      {releases, R"({"program":3,"machine":"m","nominal":{"family":"f"}})", "/nominal"},
      {moves, R"({"to":"approved","note":"measured"})", "ok"},
      {moves, R"({"note":"measured"})", "/to"},
      {moves, R"({"to":"sold"})", "/to"},
      {moves, R"({"to":"proving","transfers":0})", "/transfers"},
      {moves, R"({"to":"proving"})", "/transfers"},
      {moves, R"({"to":"proving","transfers":1000001})", "/transfers"},
      {jobs, R"({"release":4})", "ok"},
      {jobs, R"({})", "/release"},
      {jobs, R"({"release":-4})", "/release"},
  };
  check(rows);
  EXPECT_EQ(read_check_body(R"({"program":9007199254740992,"machine":"m"})")->program, 9007199254740992U);
  EXPECT_EQ(read_transition_body(R"({"to":"proving","transfers":3})")->transfers, 3U);
  EXPECT_EQ(read_transition_body(R"({"to":"obsolete"})")->to, store::ReleaseState::obsolete);
}

TEST(Requests, Measures) {
  const auto accuracy = [](std::string_view body) { return error_of(read_measure_body(body, Measure::accuracy)); };
  const auto gouge = [](std::string_view body) { return error_of(read_measure_body(body, Measure::gouge)); };
  const auto timing = [](std::string_view body) { return error_of(read_measure_body(body, Measure::timing)); };
  const auto sweeps = [](std::string_view body) { return error_of(read_sweep_body(body)); };
  const Row rows[] = {
      {accuracy, R"({"program":3,"machine":"m","cmm":"x,z\n1,2\n","best_fit":true})", "ok"},
      {accuracy, R"({"program":3,"machine":"m","best_fit":1})", "/best_fit"},
      {accuracy, R"({"program":3,"machine":"m","baud":9600})", "/baud"},
      {gouge, R"({"program":3,"machine":"m","cmm":""})", "/cmm"},
      {timing, R"({"program":3,"machine":"m","delivery":"drip","baud":9600})", "ok"},
      {timing, R"({"program":3,"machine":"m","baud":9})", "/baud"},
      {sweeps, R"({"family":"f","machine":"m","samples":0,"seed":7,"mode":"macro","values":{"a":1}})", "ok"},
      {sweeps, R"({"machine":"m"})", "/family"},
      {sweeps, R"({"family":"f","machine":"m","samples":1001})", "/samples"},
      {sweeps, R"({"family":"f","machine":"m","mode":"both"})", "/mode"},
  };
  check(rows);
  const auto read = read_measure_body(
      R"({"program":3,"machine":"m","nominal":{"family":"f","values":{"a":"1 mm"}},"profile":"2-9,12-12"})",
      Measure::gouge);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->order.of.nominal->family, "f");
  EXPECT_EQ(read->order.of.nominal->values.at("a"), "1 mm");
  ASSERT_EQ(read->order.of.profile_lines.size(), 2U);
  EXPECT_EQ(read->order.of.profile_lines[1].first, 12U);
}

TEST(Requests, WhatAPersonSaysAtTheMachine) {
  const auto minutes = [](std::string_view body) { return error_of(read_arm_body(body)); };
  const auto reason = [](std::string_view body) { return error_of(read_reason_body(body, false)); };
  const auto needed = [](std::string_view body) { return error_of(read_reason_body(body, true)); };
  const auto session = [](std::string_view body) { return error_of(read_session_body(body)); };
  const Row rows[] = {
      {minutes, "", "ok"},
      {minutes, "{}", "ok"},
      {minutes, R"({"minutes":5})", "ok"},
      {minutes, R"({"minutes":0})", "/minutes"},
      {minutes, R"({"minutes":61})", "/minutes"},
      {minutes, R"({"minutes":"5"})", "/minutes"},
      {minutes, R"({"minute":5})", "/minute"},
      {reason, "", "ok"},
      {reason, R"({"reason":"tool changed"})", "ok"},
      {reason, R"({"reason":1})", "/reason"},
      {needed, "", "/reason"},
      {needed, R"({"reason":""})", "/reason"},
      {needed, R"({"reason":"reset"})", "ok"},
      {session, R"({"token":"abc"})", "ok"},
      {session, R"({"name":"olga","pin":"4711"})", "ok"},
      {session, R"({"token":""})", "/token"},
      {session, R"({"token":"abc","name":"olga","pin":"4711"})", "/token"},
      {session, R"({"token":"abc","name":"olga"})", "/name"},
      {session, R"({"name":"olga","pin":""})", "/pin"},
      {session, R"({"name":"olga"})", "/token"},
      {session, R"({"pin":"4711"})", "/name"},
      {session, R"({})", "/token"},
  };
  check(rows);
  EXPECT_EQ(read_arm_body("")->minutes, std::nullopt);
  EXPECT_EQ(read_arm_body("")->rounds, 1U);
  EXPECT_EQ(read_arm_body(R"({"rounds":3})")->rounds, 3U);
  EXPECT_FALSE(read_arm_body(R"({"rounds":0})"));
  EXPECT_EQ(read_arm_body(R"({"minutes":2.5})")->minutes, 2.5);
  EXPECT_EQ(read_reason_body("", false)->reason, "");
}

}  // namespace
}  // namespace dripfeed::json
