// An MTConnect agent's requests. It is read-only, and answers in XML, its own faults too; without a right to read it is
// refused as any other.
#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "server/http/api.h"
#include "server/http/handlers.h"
#include "server/json/mtconnect.h"

namespace dripfeed::http {

namespace {

constexpr std::uint32_t kMostFiles = 1000;
constexpr std::uint64_t kUsualCount = 100;

json::MtconnectAgent agent_of(const Call& call) {
  app::Application& application = call.api.application();
  return {.sender = call.request.host.empty() ? "dripfeed" : call.request.host,
          .source = application.event_source(),
          .instance = application.observations().instance(),
          .now_ms = application.clock().wall_ms()};
}

Response xml_response(unsigned status, std::string body) {
  Response response;
  response.status = status;
  response.content_type = "application/xml";
  response.headers.emplace_back("Cache-Control", "no-store");
  response.body = std::move(body);
  return response;
}

Response fault(const Call& call, unsigned status, std::string_view code, std::string_view text) {
  return xml_response(status, json::mtconnect_error(agent_of(call), code, text));
}

// What agents may offer and this one does not.
std::optional<Response> refuse_unsupported(const Call& call) {
  for (const char* const name : {"path", "at", "interval", "heartbeat"})
    if (call.request.query.contains(name))
      return fault(call, 400, "UNSUPPORTED", fmt::format("\"{}\" is not supported: ask again from nextSequence", name));
  return std::nullopt;
}

// The machine in the path, "" for all; or the answer that there is none.
std::expected<std::string, Response> machine_of(const Call& call) {
  if (call.parameters.empty()) return std::string();
  const auto machines = call.api.application().observations().machines();
  if (std::ranges::find(machines, call.parameters[0]) != machines.end()) return call.parameters[0];
  return std::unexpected(fault(call, 404, "NO_DEVICE", fmt::format("there is no machine {}", call.parameters[0])));
}

// Nothing where the query does not say; an error where it is not a number.
std::expected<std::optional<std::uint64_t>, Response> count_of(const Call& call, const char* name) {
  const std::string text = query_text(call.request, name);
  if (text.empty()) return std::nullopt;
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc{} && end == text.data() + text.size()) return value;
  return std::unexpected(fault(call, 400, "INVALID_REQUEST", fmt::format("{}={} is not a number", name, text)));
}

// Those that may go to a machine, or are being sent there.
store::Result<std::vector<json::MtconnectFile>> released_files(const Call& call) {
  store::Store& store = call.api.application().store();
  const auto releases = store.releases().list({.limit = kMostFiles, .after = {}}, {});
  if (!releases) return std::unexpected(releases.error());
  std::vector<json::MtconnectFile> files;
  for (const store::Release& release : releases->items) {
    if (release.state == store::ReleaseState::obsolete) continue;
    const auto program = store.programs().get(release.of.program);
    const auto revision = store.programs().get_revision(release.of.program, release.of.revision);
    if (!program || !revision) continue;
    files.push_back({.release = release,
                     .name = program->name,
                     .bytes = revision->bytes,
                     .made_at_ms = revision->created_at_ms,
                     .href = fmt::format("/api/v1/programs/{}/text?revision={}", program->id, revision->revision)});
  }
  return files;
}

}  // namespace

Response mtconnect_probe(const Call& call) {
  const auto machine = machine_of(call);
  if (!machine) return machine.error();
  auto machines = call.api.application().observations().machines();
  if (!machine->empty()) machines = {*machine};
  const auto files = released_files(call);
  if (!files) return problem_response(app::from_store(files.error()));
  return xml_response(200, json::mtconnect_devices(agent_of(call), machines, files->size()));
}

Response mtconnect_current(const Call& call) {
  if (auto refused = refuse_unsupported(call)) return std::move(*refused);
  const auto machine = machine_of(call);
  if (!machine) return machine.error();
  return xml_response(200,
                      json::mtconnect_streams(agent_of(call), call.api.application().observations().current(*machine)));
}

Response mtconnect_sample(const Call& call) {
  if (auto refused = refuse_unsupported(call)) return std::move(*refused);
  const auto machine = machine_of(call);
  if (!machine) return machine.error();
  const auto from = count_of(call, "from");
  if (!from) return from.error();
  const auto count = count_of(call, "count");
  if (!count) return count.error();
  const std::uint64_t most = count->value_or(kUsualCount);
  if (most < 1 || most > app::Observations::kKept)
    return fault(call, 400, "OUT_OF_RANGE", fmt::format("count is 1 to {}", app::Observations::kKept));
  const auto batch = call.api.application().observations().sample(*machine, *from, most);
  if (!batch) return fault(call, 400, "OUT_OF_RANGE", "from is not kept any more, or was never given: ask for current");
  return xml_response(200, json::mtconnect_streams(agent_of(call), *batch));
}

Response mtconnect_assets(const Call& call) {
  const auto files = released_files(call);
  if (!files) return problem_response(app::from_store(files.error()));
  return xml_response(200, json::mtconnect_assets(agent_of(call), *files));
}

}  // namespace dripfeed::http
