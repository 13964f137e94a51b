// The server itself. The names of the process are those that every program has in Prometheus.
#include <algorithm>
#include <array>
#include <chrono>
#include <limits>

#include <fmt/format.h>

#include "server/http/api.h"
#include "server/http/footprint.h"
#include "server/http/handlers.h"
#include "server/http/metrics.h"

namespace dripfeed::http {

namespace {

constexpr MetricType kCounter = MetricType::counter;
constexpr MetricType kGauge = MetricType::gauge;

double seconds(std::chrono::nanoseconds time) { return std::chrono::duration<double>(time).count(); }

constexpr std::array<std::string_view, kLanesAndHere> kLaneNames = {"here", "read",  "command", "arm",      "write",
                                                                    "bulk", "heavy", "secret",  "provider", "spool"};

void write_requests(Exposition& out, const Traffic& traffic) {
  constexpr std::array<std::string_view, Traffic::kClasses> kClassNames = {"1xx", "2xx", "3xx", "4xx", "5xx"};
  out.family(
      "dripfeed_http_requests_total", kCounter,
      "Requests by route and class of their answer's status; route \"none\": there is no such path, or no HTTP.");
  for (std::size_t route = 0; route <= traffic.routes(); ++route) {
    const Route* const row = route < routes().size() ? &routes()[route] : nullptr;
    for (std::size_t i = 0; i < Traffic::kClasses; ++i) {
      const std::uint64_t count = traffic.requests(route, i);
      if (count == 0) continue;
      out.sample({{"method", row == nullptr ? "none" : name_of(row->method)},
                  {"route", row == nullptr ? "none" : row->pattern},
                  {"status", kClassNames[i]}},
                 count);
    }
  }
}

void write_durations(Exposition& out, const Traffic& traffic) {
  out.family("dripfeed_http_request_duration_seconds", MetricType::histogram,
             "From the last byte of a request to its answer, by the lane of threads that answers it: its wait for the "
             "lane and its work, without what the network takes.");
  for (std::size_t i = 0; i < kLanesAndHere; ++i) {
    const Traffic::Durations& of = traffic.durations(static_cast<Lane>(i));
    std::uint64_t below = 0;
    for (std::size_t bucket = 0; bucket < of.buckets.size(); ++bucket) {
      below += of.buckets[bucket].load(std::memory_order_relaxed);
      const double end_s =
          bucket < Traffic::kBuckets_s.size() ? Traffic::kBuckets_s[bucket] : std::numeric_limits<double>::infinity();
      out.part("bucket", {{"lane", kLaneNames[i]}, {"le", exposition_number(end_s)}}, below);
    }
    out.part("sum", {{"lane", kLaneNames[i]}}, static_cast<double>(of.sum_ns.load(std::memory_order_relaxed)) / 1e9);
    out.part("count", {{"lane", kLaneNames[i]}}, below);
  }
}

struct Turn {
  std::string_view name;
  store::WriteUse store::StoreUse::* use;
};
// "ledger": what feeds wait for, which goes first.
constexpr std::array kTurns = {Turn{"ledger", &store::StoreUse::ledger}, Turn{"others", &store::StoreUse::others}};

void gauge(Exposition& out, std::string_view name, std::string_view help, std::uint64_t value) {
  out.family(name, kGauge, help);
  out.sample({}, value);
}

}  // namespace

void write_server_metrics(Exposition& out, std::string_view version) {
  out.family("dripfeed_build_info", kGauge, "1, with the version of the program and of its compiler.");
  out.sample({{"version", version}, {"compiler", __VERSION__}}, std::uint64_t{1});
  const auto use = footprint();
  if (!use) return;
  out.family("process_cpu_seconds_total", kCounter,
             "Processor time of the server's threads, without worker processes.");
  out.sample({}, use->cpu_s);
  gauge(out, "process_resident_memory_bytes", "Memory of the process that is in the computer's memory.",
        use->resident_bytes);
  gauge(out, "process_virtual_memory_bytes", "Addresses that the process has taken.", use->virtual_bytes);
  gauge(out, "process_threads", "Threads of the process.", use->threads);
  gauge(out, "process_open_fds", "Files, sockets and ports that the process has open.", use->open_files);
  gauge(out, "process_max_fds", "How many it may open.", use->most_files);
  out.family("process_start_time_seconds", kGauge, "When the process was started (Unix time).");
  out.sample({}, use->started_at_s);
}

void write_http_metrics(Exposition& out, Traffic& traffic) {
  write_requests(out, traffic);
  write_durations(out, traffic);
  out.family("dripfeed_http_requests_in_progress", kGauge,
             "Requests that wait for their answer, by lane: in its queue or being answered.");
  for (std::size_t i = 0; i < kLanesAndHere; ++i) {
    const auto lane = static_cast<Lane>(i);
    if (lane != Lane::spool) out.sample({{"lane", kLaneNames[i]}}, traffic.at_work(lane).load());
  }
  gauge(out, "dripfeed_http_connections", "Connections that are open.", traffic.connections);
  gauge(out, "dripfeed_http_body_bytes", "Memory reserved for bodies of requests.", traffic.body_bytes);
  gauge(out, "dripfeed_http_uploads", "Long bodies that are being received or answered.", traffic.uploads);
  gauge(out, "dripfeed_http_upload_bytes", "Disk reserved for them.", traffic.spooled_bytes);
}

void write_store_metrics(Exposition& out, const store::StoreUse& use) {
  out.family("dripfeed_store_waiting_writes", kGauge, "Changes that wait for their turn to be written.");
  for (const Turn& turn : kTurns) out.sample({{"turn", turn.name}}, (use.*turn.use).waiting);
  out.family("dripfeed_store_wait_seconds", MetricType::summary,
             "How long changes waited for their turn; \"ledger\" is what feeds wait for, and has precedence.");
  for (const Turn& turn : kTurns) {
    out.part("sum", {{"turn", turn.name}}, seconds((use.*turn.use).waited));
    out.part("count", {{"turn", turn.name}}, (use.*turn.use).begun);
  }
  out.family("dripfeed_store_write_seconds", MetricType::summary,
             "How long a turn took, its commit to the disk included; several changes may share one.");
  for (const Turn& turn : kTurns) {
    out.part("sum", {{"turn", turn.name}}, seconds((use.*turn.use).held));
    out.part("count", {{"turn", turn.name}}, (use.*turn.use).turns);
  }
}

void write_work_metrics(Exposition& out, LiveHub& live, app::Workplace& workplace) {
  gauge(out, "dripfeed_event_streams", "Watchers of live events.", live.watchers());
  const auto works = workplace.works();
  const auto running = static_cast<std::uint64_t>(
      std::ranges::count_if(works, [](const app::Work& work) { return work.running_since_ms != 0; }));
  out.family("dripfeed_work", kGauge, "Checks, renders, figures and sweeps, by what they do now.");
  out.sample({{"state", app::kWorkStates[0]}}, works.size() - running);
  out.sample({{"state", app::kWorkStates[1]}}, running);
}

Response get_metrics(const Call& call) {
  app::Application& application = call.api.application();
  Exposition out;
  write_line_metrics(out, application);
  write_alarm_metrics(out, application);
  write_store_metrics(out, application.store().use());
  write_http_metrics(out, *call.api.traffic());
  write_work_metrics(out, call.api.live(), call.api.workers().workplace());
  write_server_metrics(out, call.api.version());
  Response response;
  response.content_type = kExpositionType;
  response.body = out.take();
  return response;
}

}  // namespace dripfeed::http
