// Machines and what their lines report.
#include <algorithm>

#include "dialects/ir/control.h"
#include "protocol/modbus/machine_words.h"
#include "protocol/packet/event.h"
#include "server/app/lines/line.h"
#include "server/app/lines/link_test.h"
#include "server/app/lines/wire_tap.h"
#include "server/json/enumerators.h"
#include "server/json/profile_words.h"
#include "server/json/schemas.h"

namespace dripfeed::json {

namespace {

// Why a line stands still. Feeds and packets name theirs in tables; the rest are words of mailboxes, folders and
// punches (server/app/*_line.cpp, machine_watch.cpp).
Words stall_words() {
  static constexpr std::string_view kOthers[] = {
      "waiting for credit",     "waiting for receiver",
      "stopped by a fault",     "machine held",
      "machine alarm",          "machine in emergency stop",
      "folder does not answer", "holding the control: what it sent before is not taken yet",
      "waiting for the sender",
  };
  Words words = names_of<feed::Stall>(app::name_of);
  const auto add = [&](std::string_view word) {
    if (std::ranges::find(words, word) == words.end()) words.push_back(word);
  };
  std::ranges::for_each(names_of<packet::Stall>(packet::name), add);
  std::ranges::for_each(kOthers, add);
  return words;
}

Schema bytes(std::string about) { return integer(std::move(about) + ", in bytes on the wire"); }

Schema line_errors() {
  return object("what the UART counted since the link is up", {{"parity", integer("characters with wrong parity")},
                                                               {"framing", integer("characters without a stop bit")},
                                                               {"overrun", integer("characters that were lost")},
                                                               {"breaks", integer("breaks of the line")}});
}

Schema plc_report() {
  return object("what the machine's PLC reports of it; null where the link has no such words",
                {{"state", one_of(names_of<modbus::MachineState>(modbus::name), "of the machine")},
                 {"program", integer("its number; 0: none, or not known")},
                 {"line", integer("being executed, from 1; 0: not known")},
                 {"alarm", integer("the control's own number; 0: none")}});
}

// All that changes while a program goes out.
Members line_report() {
  return {
      {"line", one_of(names_of<app::LineState>(app::name_of), "state of the line")},
      {"stall", or_null(reference("Stall"))},
      {"stop_wanted", flag("a person's stop is in force, reached or not")},
      {"link_error", or_null(text("why the link is down"))},
      {"link_error_id", or_null(text("the same as the id of a sentence; `system`: in the system's own words"))},
      {"link_error_said", or_null(reference("Said"))},
      {"link_note", or_null(text("of a link that is up: what its device server did not confirm"))},
      {"link_note_id", or_null(text("which kind of note it is"))},
      {"line_errors", line_errors()},
      {"asks_since_ms", or_null(time_ms("since when the control asks for a program while nothing is armed"))},
      {"asks", integer("how often it has asked since then")},
      {"job", or_null(integer("the last job that was armed here since the server's start"))},
      {"handed", bytes("given to the system's port")},
      {"clocked", bytes("that have left, by line time")},
      {"confirmed", bytes("that the protocol acknowledged")},
      {"confirms", flag("the protocol acknowledges; without, `confirmed` stays 0")},
      {"estimated", flag("a blind link: how much is in transit is an estimate")},
      {"total", bytes("of the job")},
      {"block_from", integer("first line of the text where the control may be; 0: not known")},
      {"block", integer("last line of the text where the control may be; 0: not known")},
      {"holds", integer("how often the control held the line in this job")},
      {"hold_s", number("how long it held it, in seconds")},
      {"line_use", number("share of line time used while not held, 0 to 1")},
      {"plc", or_null(plc_report())},
      {"program", text("name of the job's program; empty: no job")},
      {"block_text", text("the line `block` of the text; empty: not known")},
  };
}

Schema torn_block() {
  return object("a block that broke off: nothing is sent until a person confirms that the control was reset",
                {{"job", or_null(integer("whose block it is; null: of an answer, or of another program on the line"))},
                 {"text", text("one sentence for a person")},
                 {"said", or_null(reference("Said"))},
                 {"reason_id", or_null(text("which kind of reason it is; null: none is known"))}});
}

Schema line_test_result() {
  const auto median_and_worst = [](std::string about) {
    return object(about + ", in milliseconds", {{"median", number("of all")}, {"worst", number("of all")}});
  };
  return object(
      "what was measured; null where the test has a fault",
      {{"char_ms", number("time of one character on the line, in milliseconds")},
       {"latency_ms", median_and_worst("time of a character to the plug and back, in addition to its own line time")},
       {"latency_chars", integer("the worst of it as characters: what the profile's latency_chars should cover")},
       {"after_dc3", object("characters that still came after a DC3", {{"holds", integer("how often it was tried")},
                                                                       {"median", integer("of all")},
                                                                       {"worst", integer("of all")}})},
       {"characters", integer("that were sent")},
       {"wrong", integer("that came back as something else")},
       {"uart", line_errors()},
       {"budget",
        object("by the machine's profile", {{"overrun", integer("characters that the control takes after its DC3")},
                                            {"unsent", integer("characters that are given to the port ahead")},
                                            {"latency_chars", integer("characters that the latency may cost")}})},
       {"kept", flag("nothing came back wrong, and no more after a DC3 than the control takes")}});
}

Schema wire_run() {
  return object("what passed in one direction without a pause, up to the end of a block; or what the link did",
                {{"kind", one_of(names_of<app::WireKind>(app::name_of), "of what passed")},
                 {"at_ms", time_ms("its first character")},
                 {"to_ms", time_ms("its last character")},
                 {"text", text("one character each; controls as their Unicode pictures (\u2400 to \u2421)")},
                 {"hex", text("the bytes on the wire, two digits each")},
                 {"wrong", integer("characters with wrong parity, or that the line's code does not have")}});
}

Members head() { return {{"name", text("of the machine")}, {"revision", integer("of its profile, from 1")}}; }

}  // namespace

Schemas machine_schemas() {
  return {
      {"Stall", one_of(stall_words(), "why a line waits; `stopped`: a person stopped it at a block end")},
      {"MachineStatus", object("where a machine's line stands now",
                               line_report() + Members{{"needs_confirmation", or_null(torn_block())}})},
      {"Machine", object("a machine with its whole profile",
                         head() + Members{{"profile", reference("Profile")}, {"status", reference("MachineStatus")}})},
      {"MachineSummary",
       object("a machine as a list shows it", head() + Members{{"title", text("for people; empty: none")},
                                                               {"dialect", text("of its control")},
                                                               {"kind", one_of(ir::kMachineKindNames, "of machine")},
                                                               {"link", text("URL of its line")},
                                                               {"status", reference("MachineStatus")}})},
      {"Utilisation",
       object("how a machine's line was used",
              {{"days", list_of(object("a day by the server's clock",
                                       {{"day", text("as 2026-11-24")},
                                        {"from_ms", time_ms("its start")},
                                        {"to_ms", time_ms("its end")},
                                        {"feeding_s", number("while a job was on the line, in seconds")},
                                        {"held_s", or_null(number("of it, held by the control; null: not known"))},
                                        {"jobs_done", integer("that ended on this day")},
                                        {"jobs_failed", integer("that ended on this day")},
                                        {"jobs_cancelled", integer("that ended on this day")},
                                        {"bytes", bytes("of jobs that ended on this day")}}),
                                "oldest first")}})},
      {"Node",
       object("a server that shares the store with others",
              {{"name", text("of the server")},
               {"this", flag("it is the one that answers")},
               {"url", or_null(text("where people and programs reach it; null: not known yet"))},
               {"version", or_null(text("of its program"))},
               {"answers", flag("it was heard of within the last ten seconds")},
               {"started_at_ms", time_ms("when, by the database's clock")},
               {"seen_at_ms", time_ms("when it was heard of last, by the database's clock")},
               {"machines", list_of(object("a machine whose line it has",
                                           {{"name", text("of the machine")},
                                            {"lease", integer("number of the lease: one more with each new holder")},
                                            {"since_ms", time_ms("when the server got the line")},
                                            {"given_by", text("who gave it")},
                                            {"reason", or_null(text("what they wrote"))}}),
                                    "by name")}})},
      {"LineTest", object("a test of a line with a loopback plug in the control's place",
                          {{"fault", or_null(text("what was seen instead of a result; null: nothing"))},
                           {"fault_id", or_null(one_of(app::kLinkTestFaults, "kind of fault; null: none"))},
                           {"result", or_null(line_test_result())}})},
      {"EventWire", object("what passed on a line; only in the stream of its machine's wire",
                           {{"from", integer("number of the first character or change, counted by the line")},
                            {"lost", integer("characters before it that this watcher was too slow for")},
                            {"runs", list_of(wire_run(), "in their order")}})},
      {"EventMachine", object("a machine's profile or the stall of its line has changed",
                              {{"name", text("of the machine")}, {"stall", reference("Stall"), kOptional}})},
      {"EventProgress", object("where a machine's line stands; at most five times a second",
                               Members{{"machine", text("its name")}} + line_report())},
  };
}

}  // namespace dripfeed::json
