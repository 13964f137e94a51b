// Machines, families and parts.
#include <fmt/format.h>

#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/http/list_response.h"
#include "server/json/records.h"
#include "server/json/requests.h"

namespace dripfeed::http {

namespace {

std::string machine_json(app::Application& app, const store::Machine& machine) {
  return json::machine(machine, app.status(machine.name));
}

}  // namespace

Response list_machines(const Call& call) {
  const auto page = page_of(call.request);
  if (!page) return page.error();
  if (call.version) return call.api.machine_list().answer(*page, *call.version);
  app::Application& app = call.api.application();
  Titles& titles = call.api.titles();
  return list_response(app.store().machines().list(*page), [&](const store::Machine& m) {
    return json::machine_summary(m, titles.of(m), app.status(m.name));
  });
}

Response add_machine(const Call& call) {
  app::Application& app = call.api.application();
  const auto machine = app.catalog().add_machine(call.request.body, call.user);
  if (!machine) return problem_response(machine.error());
  return with_revision(
      created(fmt::format("/api/v1/machines/{}", escape_segment(machine->name)), machine_json(app, *machine)),
      machine->revision);
}

Response get_machine(const Call& call) {
  app::Application& app = call.api.application();
  const auto machine = app.store().machines().get(call.parameters[0]);
  if (!machine) return problem_response(app::from_store(machine.error()));
  return with_revision(json_response(200, machine_json(app, *machine)), machine->revision);
}

Response change_machine(const Call& call) {
  const auto expected = expected_revision(call.request);
  if (!expected) return expected.error();
  app::Application& app = call.api.application();
  const auto machine = app.catalog().change_machine(call.parameters[0], *expected, call.request.body, call.user);
  if (!machine) return problem_response(machine.error());
  return with_revision(json_response(200, machine_json(app, *machine)), machine->revision);
}

Response get_utilisation(const Call& call) {
  constexpr std::uint64_t kMostDays = 90;
  const auto days = number_of(call.request, "days", 7, 1, kMostDays);
  if (!days) return days.error();
  app::Application& app = call.api.application();
  const auto used =
      app::utilisation(app.store(), call.parameters[0], static_cast<std::uint32_t>(*days), app.clock().wall_ms());
  if (!used) return problem_response(used.error());
  return json_response(200, json::utilisation(*used));
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
  Titles& titles = call.api.titles();
  return list_response(call.api.application().store().families().list(*page),
                       [&](const store::Family& f) { return json::family_summary(f, titles.of(f)); });
}

namespace {

Response family_response(unsigned status, const app::Result<store::Family>& family,
                         const compile::FamilyDescription& description) {
  if (!family) return problem_response(family.error());
  std::string body = json::family(*family, description);
  return with_revision(status == 201
                           ? created(fmt::format("/api/v1/families/{}", escape_segment(family->name)), std::move(body))
                           : json_response(status, std::move(body)),
                       family->revision);
}

Response part_response(unsigned status, const app::Result<store::Part>& part) {
  if (!part) return problem_response(part.error());
  std::string body = json::part(*part);
  return with_revision(status == 201
                           ? created(fmt::format("/api/v1/parts/{}", escape_segment(part->number)), std::move(body))
                           : json_response(status, std::move(body)),
                       part->revision);
}

}  // namespace

Response add_family(const Call& call) {
  const auto body = json::read_text_body(call.request.body);
  if (!body) return problem_response(body.error());
  app::Catalog& catalog = call.api.application().catalog();
  const auto checked = catalog.check_family(body->text);
  if (!checked) return problem_response(checked.error());
  return call.commit(
      [&] { return family_response(201, catalog.add_checked_family(checked->name, body->text, call.user), *checked); });
}

Response get_family(const Call& call) {
  const auto family = call.api.application().store().families().get(call.parameters[0]);
  if (!family) return problem_response(app::from_store(family.error()));
  return family_response(200, *family, compile::describe_family(text::Source(family->name, family->text)));
}

Response change_family(const Call& call) {
  const auto expected = expected_revision(call.request);
  if (!expected) return expected.error();
  const auto body = json::read_text_body(call.request.body);
  if (!body) return problem_response(body.error());
  const std::string& name = call.parameters[0];
  app::Catalog& catalog = call.api.application().catalog();
  const auto checked = catalog.check_family(body->text, name);
  if (!checked) return problem_response(checked.error());
  return call.commit([&] {
    return family_response(200, catalog.change_checked_family(name, *expected, body->text, call.user), *checked);
  });
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
  app::Catalog& catalog = call.api.application().catalog();
  const auto values = catalog.check_values(body->family, body->values);
  if (!values) return problem_response(values.error());
  return call.commit([&] { return part_response(201, catalog.add_checked_part(body->number, *values, call.user)); });
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
  const std::string& number = call.parameters[0];
  app::Catalog& catalog = call.api.application().catalog();
  const auto values = catalog.check_values_of(number, body->values);
  if (!values) return problem_response(values.error());
  return call.commit(
      [&] { return part_response(200, catalog.change_checked_part(number, *expected, *values, call.user)); });
}

}  // namespace dripfeed::http
