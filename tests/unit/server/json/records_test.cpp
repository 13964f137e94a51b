// What is shown of the store and of the lines: member by member, and as JSON whatever bytes people put into names.
#include "server/json/records.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/json/openapi.h"
#include "server/json/reports.h"
#include "server/json/requests.h"
#include "server/json/verdict_records.h"

namespace dripfeed::json {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// Whether a text is one JSON document: the reader of values embeds it and takes texts and numbers alone, so a fault is
// about the members, never about the form.
bool is_json(const std::string& text) {
  const auto read = read_values(text);
  return read || read.error().text.find("this is not JSON") == std::string::npos;
}

store::Job a_job() {
  store::Job job;
  job.id = 7;
  job.release = 3;
  job.program = 2;
  job.revision = 1;
  job.text_sha256 = "ab";
  job.machine = "mill";
  job.link = "serial:/dev/ttyS0";
  job.bytes_total = 100;
  job.state = store::JobState::failed;
  job.reason = "syn: between wire byte 3 and 9";
  job.created_by = "anna";
  job.created_at_ms = 10;
  job.armed_by = "olga";
  job.armed_at_ms = 20;
  job.expires_at_ms = 25;
  job.torn = true;
  return job;
}

TEST(Records, AJobSaysWhatAPersonMustDo) {
  const std::string text = job(a_job());
  EXPECT_TRUE(is_json(text));
  EXPECT_THAT(text, HasSubstr(R"("id":7,"state":"failed","machine":"mill","release":3)"));
  EXPECT_THAT(
      text,
      HasSubstr(
          R"("armed_at_ms":20,"expires_at_ms":25,"started_at_ms":null,"ended_at_ms":null,"torn":true,"needs_confirmation":true)"));
  EXPECT_THAT(text, HasSubstr(R"("confirmed_by":null)"));
  store::Job confirmed = a_job();
  confirmed.confirmed_at_ms = 30;
  confirmed.confirmed_by = "olga";
  EXPECT_THAT(job(confirmed), HasSubstr(R"("needs_confirmation":false,"confirmed_by":"olga")"));
}

TEST(Records, BytesThatAreNoUtf8AreShownAndStayJson) {
  store::Job odd = a_job();
  odd.reason = "quote \" back\\slash \x01 \xFF\xC3";
  const std::string text = job(odd);
  EXPECT_TRUE(is_json(text)) << text;
  EXPECT_THAT(text, HasSubstr("quote \\\" back\\\\slash \\u0001 "));
  EXPECT_THAT(text, Not(HasSubstr("\xFF")));
  const app::Error error{app::ErrorCode::invalid, "\xFE", {{.pointer = "\xFE", .text = "\xFE"}}};
  EXPECT_TRUE(is_json(problem(problem_code(error), error)));
}

TEST(Records, AMachineWithAProfileThatCannotBeReadIsListedAllTheSame) {
  for (const char* profile : {"", "nonsense", "5", "[]", R"({"title":5,"link":7})"}) {
    const store::Machine row{.name = "m", .revision = 2, .profile = profile, .changed_by = "a", .changed_at_ms = 1};
    const std::string text = machine_summary(row, profile_head(row.profile), {});
    EXPECT_THAT(text, HasSubstr(R"("name":"m","revision":2,"title":"","dialect":"","kind":"","link":"")")) << profile;
    EXPECT_TRUE(is_json(machine(row, {})));
  }
  const store::Machine row{.name = "m",
                           .revision = 2,
                           .profile = R"({"title":"T","kind":"mill","link":{"url":"pty:/x"}})",
                           .changed_by = "a"};
  EXPECT_THAT(machine_summary(row, profile_head(row.profile), {}),
              HasSubstr(R"("title":"T","dialect":"","kind":"mill","link":"pty:/x")"));
}

TEST(Records, TheStateOfALine) {
  app::MachineStatus status;
  status.report.state = app::LineState::held;
  status.report.stall = "held by DC3";
  status.report.job = 7;
  status.report.handed = 50;
  status.report.clocked = 40;
  status.report.known = {.from = 40, .to = 50, .from_line = 3, .to_line = 4, .to_text = 50};
  status.program = "O1";
  status.block_text = "G1X1.";
  const std::string text = machine_status(status);
  EXPECT_THAT(
      text,
      HasSubstr(
          R"("line":"held","stall":"held by DC3","stop_wanted":false,"link_error":null,"link_error_id":null,"link_error_said":null,)"
          R"("link_note":null,"link_note_id":null,)"
          R"("line_errors":{"parity":0,"framing":0,"overrun":0,"breaks":0},"asks_since_ms":null,"asks":0,"job":7,"handed":50)"));
  EXPECT_THAT(text, HasSubstr(R"("block_from":3,"block":4)"));
  EXPECT_THAT(text, HasSubstr(R"("program":"O1","block_text":"G1X1.","needs_confirmation":null)"));
  EXPECT_THAT(text, HasSubstr(R"("plc":null,)"));
  status.report.machine = {.state = "alarm", .program = 42, .line = 17, .alarm = 1010};
  EXPECT_THAT(machine_status(status),
              HasSubstr(R"("plc":{"state":"alarm","program":42,"line":17,"alarm":1010},"program":"O1")"));
  status.needs_confirmation = app::TornBlock{7, a_job().reason, "syn"};
  status.report.link_note = "doorbell 3 was missed";
  EXPECT_THAT(machine_status(status), HasSubstr(R"("link_note":"doorbell 3 was missed","link_note_id":"link_note")"));
  status.report.link_note = app::kFloodNote;
  EXPECT_THAT(machine_status(status), HasSubstr(R"("link_note_id":"line_flooded")"));
  EXPECT_THAT(machine_status(status), HasSubstr(R"("needs_confirmation":{"job":7,"text":"syn: between)"));
}

TEST(Records, ALedgerNamesWhatItsIntervalRestsOn) {
  const store::LedgerRow rows[] = {{.seq = 1, .at_ms = 5, .counts = {10, 8, 0, 64}, .note = "armed"}};
  const store::LedgerInterval interval{.low = 8, .high = 64, .seq = 1, .at_ms = 5, .last = rows[0].counts};
  EXPECT_EQ(ledger(rows, "", interval, false),
            R"({"items":[{"seq":1,"at_ms":5,"handed":10,"clocked":8,"confirmed":0,"reserve":64,"note":"armed"}],)"
            R"("next":null,"interval":{"low":8,"high":64,"known":"clocked"}})");
  EXPECT_THAT(ledger({}, "9", interval, true),
              HasSubstr(R"("next":"9","interval":{"low":8,"high":64,"known":"confirmed"})"));
}

TEST(Records, AVerdictIsItsRowWithTheReportsMembers) {
  store::Verdict row;
  row.id = 4;
  row.of.outcome = store::Outcome::unknown;
  row.of.report = R"({"id":99,"verdict":"pass","blocks":12,"not_checked":["a"]})";
  row.waivers = {{.name = "boris", .reason = "seen", .at_ms = 3}};
  const std::string text = verdict(row);
  EXPECT_THAT(text, HasSubstr(R"("id":4,)"));
  EXPECT_THAT(text, HasSubstr(R"("verdict":"unknown")"));
  EXPECT_THAT(text, Not(HasSubstr("99"))) << "what the row says counts";
  EXPECT_THAT(
      text,
      HasSubstr(
          R"("blocks":12,"not_checked":["a"],"calls":[],"points":[],"waivers":[{"name":"boris","reason":"seen","at_ms":3,)"
          R"("point":null,"expires_at_ms":null}])"));
  row.of.report = "not a document";
  EXPECT_TRUE(is_json(verdict(row)));
}

TEST(Records, EventsAndProgress) {
  app::Event event;
  event.kind = app::EventKind::alarm;
  event.machine = "mill";
  event.alarm = {.id = 12, .machine = "mill", .kind = "torn_block", .text = "torn", .count = 3, .raised_at_ms = 5};
  EXPECT_EQ(event_name(event.kind), "alarm");
  EXPECT_EQ(event_data(event), alarm(event.alarm));
  EXPECT_EQ(
      event_data(event),
      R"({"id":12,"machine":"mill","kind":"torn_block","text":"torn","said":null,"count":3,"severity":"critical",)"
      R"("raised_at_ms":5,"last_at_ms":0,"cleared_at_ms":null,"acknowledged_by":null,)"
      R"("acknowledged_at_ms":null,"shelved_by":null,"shelved_until_ms":null,"shelf_reason":null,"job":null})");
  event.kind = app::EventKind::receipt;
  event.text = "DC1";
  EXPECT_EQ(event_data(event), R"({"machine":"mill","text":"DC1"})");
  event.kind = app::EventKind::machine;
  EXPECT_EQ(event_data(event), R"({"name":"mill","stall":"DC1"})");
  event.text.clear();
  EXPECT_EQ(event_data(event), R"({"name":"mill"})");
  event.text = "DC1";
  event.kind = app::EventKind::verdict;
  event.verdict = 5;
  EXPECT_EQ(event_data(event), R"({"id":5,"verdict":"unknown","machine":"mill","text":"DC1"})");
  event.kind = app::EventKind::job;
  event.job = a_job();
  EXPECT_EQ(event_data(event), job(a_job()));
  EXPECT_EQ(event_data(event).find('\n'), std::string::npos) << "one data line";
  app::MachineStatus status;
  status.report.handed = 12;
  status.program = "O1";
  EXPECT_THAT(progress("mill", status), HasSubstr(R"({"machine":"mill","line":"disconnected",)"));
  EXPECT_THAT(progress("mill", status), HasSubstr(R"("handed":12)"));
  EXPECT_THAT(progress("mill", status), HasSubstr(R"("program":"O1","block_text":""})"));
}

TEST(Records, ProblemsNameTheirPlaces) {
  const app::Error error{app::ErrorCode::invalid,
                         "wrong",
                         {{.pointer = "/a/0", .text = "x"}, {.pointer = {}, .line = 3, .column = 4, .text = "y"}}};
  EXPECT_EQ(problem(problem_code(error), error),
            R"({"type":"about:blank","title":"invalid","status":422,"code":"invalid","detail":"wrong","said":null,)"
            R"("errors":[{"pointer":"/a/0","text":"x"},{"line":3,"column":4,"text":"y"}]})");
  const app::Error none{app::ErrorCode::not_found, "none", {}};
  EXPECT_EQ(
      problem(problem_code(none), none),
      R"({"type":"about:blank","title":"not found","status":404,"code":"not_found","detail":"none","said":null})");
  const app::Error nine{app::ErrorCode::not_found, "it does not exist (9)", {}};
  const std::string sentence = problem(problem_code(nine), nine);
  EXPECT_THAT(sentence,
              HasSubstr(R"x("said":{"id":"store_not_found","values":{"detail":{"text":"9","said":null}}}})x"));
}

TEST(Records, AStatusNamesWhyItsLinkIsDown) {
  app::MachineStatus status;
  status.report.link_error = "the line is being tested by anna";
  EXPECT_THAT(machine_status(status),
              HasSubstr(R"("link_error_id":"line_tested","link_error_said":{"id":"line_tested","values":{"name":)"));
  status.report.link_error = "No such file or directory";
  EXPECT_THAT(machine_status(status), HasSubstr(R"("link_error_id":"system","link_error_said":null)"));
}

TEST(Records, AForecastIsOfAWholeProgramOrOfNone) {
  store::Verdict row;
  row.id = 4;
  row.of.report = R"({"timing":{"whole":true,"cycle_s":12.5,"course":[[1,0.0],[9,4.25]]}})";
  EXPECT_EQ(job_forecast(a_job(), row, {.bytes = 2048, .blocks = 0}),
            R"({"job":7,"verdict":4,"stale":false,"cycle_s":12.5,"course":[[1,0.0],[9,4.25]],"buffer_bytes":2048,)"
            R"("buffer_blocks":null})");
  const std::string_view nothing = R"("cycle_s":null,"course":[],)";
  EXPECT_THAT(job_forecast(a_job(), std::nullopt, {}), HasSubstr(nothing));
  for (const char* report : {"", "no document", R"({"timing":null})", R"({"timing":{"cycle_s":3}})",
                             R"({"timing":{"whole":false,"cycle_s":3,"course":[[1,0]]}})"}) {
    row.of.report = report;
    EXPECT_THAT(job_forecast(a_job(), row, {}), HasSubstr(nothing)) << report;
  }
}

// `check --json` and the report of a verdict: null where the control has no alarm.
TEST(Records, AFindingHasTheControlsAlarm) {
  app::CheckReport report;
  envelope::Report& travel = report.checks.envelope.emplace();
  const auto arguments = [] { return std::vector<std::string>{"Z", "0.0100", "-500.0000 to 0.0000"}; };
  travel.findings.add(text::DiagnosticId::travel_exceeded, ir::Place{.line = 4}, 0.01, 0.0, arguments);
  EXPECT_THAT(check_report(report), HasSubstr(R"("alarm":null)"));
  travel.findings.name_alarms([](const checks::Finding& one) { return one.value > one.limit ? "OT0500" : "OT0501"; });
  EXPECT_THAT(check_report(report), HasSubstr(R"("alarm":"OT0500")"));
  EXPECT_TRUE(is_json(check_report(report)));
}

TEST(Records, ListsAndOpenApi) {
  const std::string items[] = {"1", "{\"a\":2}"};
  EXPECT_EQ(list(items, ""), R"({"items":[1,{"a":2}],"next":null})");
  EXPECT_EQ(list({}, "x\"y"), R"({"items":[],"next":"x\"y"})");
  const OpenApiRoute routes[] = {{.method = "GET", .path = "/a/{id}/b/{name}", .summary = "s", .right = "viewer"},
                                 {.method = "POST",
                                  .path = "/a/{id}/b/{name}",
                                  .summary = "t",
                                  .right = "admin",
                                  .body = "ArmOrder",
                                  .status = 201,
                                  .answer = "Job",
                                  .lists = true,
                                  .types = {"image/svg+xml"}},
                                 {.method = "GET", .path = "/open", .summary = "u", .right = "anybody", .open = true}};
  const std::string text = openapi(routes, "1.2");
  EXPECT_TRUE(is_json(text));
  EXPECT_THAT(text, HasSubstr(R"("openapi":"3.1.0")"));
  EXPECT_THAT(text, HasSubstr(R"({"name":"id","in":"path","required":true)"));
  EXPECT_THAT(
      text,
      HasSubstr(R"("post":{"operationId":"post_a_id_b_name","summary":"t","description":"Needs the role `admin`.")"));
  EXPECT_THAT(text, HasSubstr(R"("requestBody":{"required":false,"content":{"application/json":)"
                              R"({"schema":{"$ref":"#/components/schemas/ArmOrder"}}}})"));
  EXPECT_THAT(
      text,
      HasSubstr(
          R"("201":{"description":"t","headers":{"Location":{"description":"the path of what was made",)"
          R"("required":true,"schema":{"type":"string","pattern":"^/"}}},"content":{"application/json":{"schema":)"
          R"({"$ref":"#/components/schemas/JobPage"}},"image/svg+xml":{"schema":{"type":"string"}}}})"));
  EXPECT_THAT(text, HasSubstr(R"("JobPage":{"type":"object",)"));
  EXPECT_THAT(text,
              HasSubstr(R"("ArmOrder":{"type":"object","description":"how a job is armed","properties":{"minutes":)"
                        R"({"type":["number","null"],)"));
  EXPECT_THAT(text, HasSubstr(R"("minimum":0.01,"maximum":60},"rounds":)"));
  EXPECT_THAT(
      text,
      HasSubstr(
          R"("/open":{"get":{"operationId":"get_open","summary":"u","description":"Needs no token.","tags":["Server"],)"
          R"("parameters":[],"x-role":"anybody","security":[])"));
}

}  // namespace
}  // namespace dripfeed::json
