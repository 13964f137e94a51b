// Machines, families and parts.
#include <fmt/format.h>

#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/http/list_response.h"
#include "server/json/records.h"
#include "server/json/requests.h"

namespace dripfeed::http {

namespace {

std::string machine_json(app::Application& app, const store::Machine& machine, bool whole) {
  return json::machine(machine, app.status(machine.name), whole);
}

std::string family_json(const store::Family& family) {
  return json::family(family, compile::describe_family(text::Source(family.name, family.text)));
}

}  // namespace

Response list_machines(const Call& call) {
  const auto page = page_of(call.request);
  if (!page) return page.error();
  app::Application& app = call.api.application();
  return list_response(app.store().machines().list(*page),
                       [&](const store::Machine& m) { return machine_json(app, m, false); });
}

Response add_machine(const Call& call) {
  app::Application& app = call.api.application();
  const auto machine = app.catalog().add_machine(call.request.body, call.user);
  if (!machine) return problem_response(machine.error());
  return with_revision(
      created(fmt::format("/api/v1/machines/{}", escape_segment(machine->name)), machine_json(app, *machine, true)),
      machine->revision);
}

Response get_machine(const Call& call) {
  app::Application& app = call.api.application();
  const auto machine = app.store().machines().get(call.parameters[0]);
  if (!machine) return problem_response(app::from_store(machine.error()));
  return with_revision(json_response(200, machine_json(app, *machine, true)), machine->revision);
}

Response change_machine(const Call& call) {
  const auto expected = expected_revision(call.request);
  if (!expected) return expected.error();
  app::Application& app = call.api.application();
  const auto machine = app.catalog().change_machine(call.parameters[0], *expected, call.request.body, call.user);
  if (!machine) return problem_response(machine.error());
  return with_revision(json_response(200, machine_json(app, *machine, true)), machine->revision);
}

Response confirm_reset(const Call& call) {
  const auto body = json::read_reason_body(call.request.body, true);
  if (!body) return problem_response(body.error());
  app::Application& app = call.api.application();
  const auto machine = app.store().machines().get(call.parameters[0]);
  if (!machine) return problem_response(app::from_store(machine.error()));
  const app::MachineStatus before = app.status(call.parameters[0]);
  if (!before.needs_confirmation && before.report.state != app::LineState::torn)
    return problem_response(409, "no torn block waits for a confirmation on this machine");
  const auto job = app.jobs().confirm_reset(call.parameters[0], body->reason, call.user);
  if (!job) return problem_response(job.error());
  return json_response(200, json::machine_status(app.status(call.parameters[0])));
}

Response list_families(const Call& call) {
  const auto page = page_of(call.request);
  if (!page) return page.error();
  FamilyTitles& titles = call.api.family_titles();
  return list_response(call.api.application().store().families().list(*page),
                       [&](const store::Family& f) { return json::family_summary(f, titles.of(f)); });
}

Response add_family(const Call& call) {
  const auto body = json::read_text_body(call.request.body);
  if (!body) return problem_response(body.error());
  const auto family = call.api.application().catalog().add_family(body->text, call.user);
  if (!family) return problem_response(family.error());
  return with_revision(created(fmt::format("/api/v1/families/{}", escape_segment(family->name)), family_json(*family)),
                       family->revision);
}

Response get_family(const Call& call) {
  const auto family = call.api.application().store().families().get(call.parameters[0]);
  if (!family) return problem_response(app::from_store(family.error()));
  return with_revision(json_response(200, family_json(*family)), family->revision);
}

Response change_family(const Call& call) {
  const auto expected = expected_revision(call.request);
  if (!expected) return expected.error();
  const auto body = json::read_text_body(call.request.body);
  if (!body) return problem_response(body.error());
  const auto family =
      call.api.application().catalog().change_family(call.parameters[0], *expected, body->text, call.user);
  if (!family) return problem_response(family.error());
  return with_revision(json_response(200, family_json(*family)), family->revision);
}

Response list_parts(const Call& call) {
  const auto page = page_of(call.request);
  if (!page) return page.error();
  const auto family = call.request.query.find("family");
  const std::string of = family == call.request.query.end() ? std::string() : family->second;
  return list_response(call.api.application().store().parts().list(*page, of),
                       [](const store::Part& p) { return json::part(p); });
}

Response add_part(const Call& call) {
  const auto body = json::read_part_body(call.request.body, true);
  if (!body) return problem_response(body.error());
  const auto part = call.api.application().catalog().add_part(body->number, body->family, body->values, call.user);
  if (!part) return problem_response(part.error());
  return with_revision(created(fmt::format("/api/v1/parts/{}", escape_segment(part->number)), json::part(*part)),
                       part->revision);
}

Response get_part(const Call& call) {
  const auto part = call.api.application().store().parts().get(call.parameters[0]);
  if (!part) return problem_response(app::from_store(part.error()));
  return with_revision(json_response(200, json::part(*part)), part->revision);
}

Response change_part(const Call& call) {
  const auto expected = expected_revision(call.request);
  if (!expected) return expected.error();
  const auto body = json::read_part_body(call.request.body, false);
  if (!body) return problem_response(body.error());
  const auto part =
      call.api.application().catalog().change_part(call.parameters[0], *expected, body->values, call.user);
  if (!part) return problem_response(part.error());
  return with_revision(json_response(200, json::part(*part)), part->revision);
}

}  // namespace dripfeed::http
