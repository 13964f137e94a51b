// The end that asks.
#include "server/json/workers.h"

#include <utility>

#include "server/json/records.h"
#include "server/json/work_package.h"

namespace dripfeed::json {

namespace {

app::ErrorCode code_of(app::WorkFault fault) {
  switch (fault) {
    case app::WorkFault::busy:
    case app::WorkFault::abandoned:
    case app::WorkFault::not_begun: return app::ErrorCode::unavailable;
    case app::WorkFault::cancelled:
    case app::WorkFault::time:
    case app::WorkFault::memory: return app::ErrorCode::refused;
    case app::WorkFault::ended: break;
  }
  return app::ErrorCode::internal;
}

// The reply's package, which may be one of an error.
app::Result<WorkPackage> send(app::Workplace& workplace, const WorkPackage& request, std::uint32_t seconds,
                              const app::Waiter& waiter) {
  const auto reply = workplace.carry_out(write_package(request), seconds, waiter);
  if (!reply) return app::fail(code_of(reply.error().fault), reply.error().text);
  return read_package(*reply);
}

app::Result<WorkPackage> without_error(app::Result<WorkPackage> package) {
  if (!package) return package;
  if (const auto error = package->head.find("error"); error != package->head.end())
    return std::unexpected(read_work_error(*error));
  return package;
}

app::Result<WorkPackage> ask(app::Workplace& workplace, const WorkPackage& request, std::uint32_t seconds,
                             const app::Waiter& waiter) {
  return without_error(send(workplace, request, seconds, waiter));
}

app::Caller caller_of(const app::CaseOrder& order) {
  return {.dialect = order.dialect, .machine = order.machine, .folder = order.folder};
}

}  // namespace

// True: there are more texts to run it with than before.
app::Result<bool> DocumentWorkers::find_missing(const app::Caller& caller, std::vector<app::CalledText>& called,
                                                const WorkPackage& reply) {
  if (!called_) return false;
  bool has_more = false;
  for (const std::string& name : read_names(reply.head.at("missing"), reply)) {
    auto found = called_->find(caller, name);
    if (!found) return std::unexpected(found.error());
    if (found->program == 0 && found->why_not.empty()) continue;
    has_more = true;
    called.push_back(std::move(*found));
  }
  return has_more;
}

// A called program may call others: each round is one level deeper, as it is not known before what a text calls.
app::Result<WorkPackage> DocumentWorkers::ask_with_called(const app::Caller& caller,
                                                          std::vector<app::CalledText>& called, const MakeRequest& make,
                                                          const app::Waiter& waiter) {
  constexpr int kMostRounds = 20;
  auto reply = send(workplace_, make(called), seconds_.load(), waiter);
  for (int round = 1; reply && round < kMostRounds; ++round) {
    const auto has_more = find_missing(caller, called, *reply);
    if (!has_more) return std::unexpected(has_more.error());
    if (!*has_more) break;
    reply = send(workplace_, make(called), seconds_.load(), waiter);
  }
  return without_error(std::move(reply));
}

app::Result<app::CheckDone> DocumentWorkers::check(const app::CaseOrder& order, const app::Waiter& waiter) {
  std::vector<app::CalledText> called;
  const auto make = [&](const std::vector<app::CalledText>& known) {
    WorkPackage request;
    request.head = {{"kind", "check"}, {"seconds", seconds_.load()}, {"case", write_case(order, request)}};
    request.head["called"] = write_called(known, request);
    return request;
  };
  auto reply = ask_with_called(caller_of(order), called, make, waiter);
  if (!reply) return std::unexpected(reply.error());
  std::vector<std::string> points = read_texts(reply->head.at("points"), *reply);
  return app::CheckDone{static_cast<store::Outcome>(reply->head.at("outcome").get<int>()),
                        std::move(reply->texts.at(0)), std::move(called), std::move(points)};
}

app::Result<app::RenderDone> DocumentWorkers::render(const app::RenderWork& work, const app::Waiter& waiter) {
  WorkPackage request;
  request.head = {{"kind", "render"}, {"seconds", seconds_.load()}, {"family", write_family(work, request)}};
  auto reply = ask(workplace_, request, seconds_.load(), waiter);
  if (!reply) return std::unexpected(reply.error());
  const Document& head = reply->head;
  app::RenderDone done{.result = {}, .places = std::move(reply->texts.at(1)), .drawing = std::move(reply->texts.at(2))};
  done.result.text = std::move(reply->texts.at(0));
  done.result.mode = static_cast<compile::RenderMode>(head.at("mode").get<int>());
  done.result.because = head.at("because").get<std::string>();
  done.result.blocks = head.at("blocks").get<std::uint64_t>();
  done.result.bytes = head.at("bytes").get<std::uint64_t>();
  done.result.variables = head.at("variables").get<std::uint32_t>();
  for (const Document& one : head.at("profile_lines"))
    done.result.profile_lines.push_back({one.at(0).get<std::uint32_t>(), one.at(1).get<std::uint32_t>()});
  done.result.legend = read_legend(reply->texts.at(3));
  done.result.diagnostics = read_diagnostics(head.at("diagnostics"));
  return done;
}

app::Result<std::vector<app::ProgramDigest>> DocumentWorkers::digest(const std::vector<app::DigestOrder>& orders,
                                                                     const app::Waiter& waiter) {
  // A caller waits for all other work.
  if (!workplace_.works().empty()) return app::fail(app::ErrorCode::unavailable, "other work comes first");
  if (orders.empty()) return std::vector<app::ProgramDigest>{};
  WorkPackage request;
  request.head = {{"kind", "index"}, {"seconds", seconds_.load()}, {"orders", write_digest_orders(orders, request)}};
  const auto reply = ask(workplace_, request, seconds_.load(), waiter);
  if (!reply) return std::unexpected(reply.error());
  return read_digests(reply->head.at("digests"), *reply);
}

app::Result<Figures> DocumentWorkers::figures(const FiguresWork& work, const app::Waiter& waiter) {
  const std::uint32_t seconds = work.sweep ? seconds_.load() * kSweepChecks : seconds_.load();
  const auto base = [&] {
    WorkPackage request;
    request.head = {{"kind", work.kind},
                    {"seconds", seconds_.load()},
                    {"plot", request.add(work.plot)},
                    {"body", request.add(work.body)}};
    return request;
  };
  app::Result<WorkPackage> reply = WorkPackage{};
  if (work.of) {
    std::vector<app::CalledText> called;
    const auto make = [&](const std::vector<app::CalledText>& known) {
      WorkPackage request = base();
      request.head["case"] = write_case(*work.of, request);
      request.head["called"] = write_called(known, request);
      return request;
    };
    reply = ask_with_called(caller_of(*work.of), called, make, waiter);
  } else {
    WorkPackage request = base();
    if (work.sweep) request.head["family"] = write_family(*work.sweep, request);
    reply = ask(workplace_, request, seconds, waiter);
  }
  if (!reply) return std::unexpected(reply.error());
  return Figures{reply->head.at("is_picture").get<bool>(), std::move(reply->texts.at(0))};
}

app::Result<std::string> DocumentWorkers::compare(const app::CompareOrder& order, const app::Waiter& waiter) {
  WorkPackage request;
  request.head = {{"kind", "compare"},
                  {"seconds", seconds_.load()},
                  {"first_name", request.add(order.first.name)},
                  {"first_dialect", request.add(order.first.dialect)},
                  {"first_text", request.add(order.first.text)},
                  {"second_name", request.add(order.second.name)},
                  {"second_dialect", request.add(order.second.dialect)},
                  {"second_text", request.add(order.second.text)},
                  {"profile", request.add(order.profile)}};
  auto reply = ask(workplace_, request, seconds_.load(), waiter);
  if (!reply) return std::unexpected(reply.error());
  return std::move(reply->texts.at(0));
}

app::Result<std::string> DocumentWorkers::convert(const app::TranslationOrder& order, const app::Waiter& waiter) {
  std::vector<app::CalledText> called;
  const auto make = [&](const std::vector<app::CalledText>& known) {
    WorkPackage request;
    request.head = {{"kind", "convert"},
                    {"seconds", seconds_.load()},
                    {"name", request.add(order.name)},
                    {"text", request.add(order.text)},
                    {"from_dialect", request.add(order.from.dialect)},
                    {"from_profile", request.add(order.from.profile)},
                    {"to_dialect", request.add(order.to.dialect)},
                    {"to_profile", request.add(order.to.profile)},
                    {"mode", static_cast<int>(order.mode)},
                    {"called", write_called(known, request)}};
    return request;
  };
  auto reply = ask_with_called(order.caller, called, make, waiter);
  if (!reply) return std::unexpected(reply.error());
  return std::move(reply->texts.at(0));
}

app::Result<std::string> DocumentWorkers::optimize(const app::OptimizeOrder& order, const app::Waiter& waiter) {
  std::vector<app::CalledText> called;
  const auto make = [&](const std::vector<app::CalledText>& known) {
    WorkPackage request;
    request.head = {{"kind", "optimize"},
                    {"seconds", seconds_.load()},
                    {"name", request.add(order.name)},
                    {"text", request.add(order.text)},
                    {"dialect", request.add(order.dialect)},
                    {"profile", request.add(order.profile)},
                    {"with", write_texts(order.words.with, request)},
                    {"without", write_texts(order.words.without, request)},
                    {"own", write_texts(order.words.own, request)},
                    {"free", write_texts(order.words.free, request)},
                    {"tolerance_mm", order.words.tolerance_mm},
                    {"called", write_called(known, request)}};
    return request;
  };
  auto reply = ask_with_called(order.caller, called, make, waiter);
  if (!reply) return std::unexpected(reply.error());
  return std::move(reply->texts.at(0));
}

app::Result<std::string> DocumentWorkers::diagnose(const app::DiagnoseOrder& order, const app::Waiter& waiter) {
  return of_text("diagnose", order, waiter);
}

app::Result<std::string> DocumentWorkers::path(const app::DiagnoseOrder& order, const app::Waiter& waiter) {
  return of_text("path", order, waiter);
}

app::Result<std::string> DocumentWorkers::picture(const app::DiagnoseOrder& order, const app::Waiter& waiter) {
  return of_text("picture", order, waiter);
}

app::Result<std::string> DocumentWorkers::stock(const app::DiagnoseOrder& order, const app::Waiter& waiter) {
  return of_text("stock", order, waiter);
}

app::Result<std::string> DocumentWorkers::statistics(const app::DiagnoseOrder& order, const app::Waiter& waiter) {
  return of_text("statistics", order, waiter);
}

app::Result<std::string> DocumentWorkers::rewrite(const app::RewriteOrder& order, const app::Waiter& waiter) {
  WorkPackage request;
  request.head = write_text_order("rewrite", order.of, request);
  request.head["seconds"] = seconds_.load();
  request.head["how"] = static_cast<int>(order.how);
  request.head["numbering"] = static_cast<int>(order.numbering);
  request.head["first"] = order.first;
  request.head["step"] = order.step;
  auto reply = ask(workplace_, request, seconds_.load(), waiter);
  if (!reply) return std::unexpected(reply.error());
  return std::move(reply->texts.at(0));
}

app::Result<std::string> DocumentWorkers::explain(const app::ValueOrder& order, const app::Waiter& waiter) {
  WorkPackage request;
  request.head = {{"kind", "explain"},
                  {"seconds", seconds_.load()},
                  {"family", write_family(order.work, request)},
                  {"stored", request.add(order.stored)},
                  {"received", request.add(order.received)}};
  auto reply = ask(workplace_, request, seconds_.load(), waiter);
  if (!reply) return std::unexpected(reply.error());
  return std::move(reply->texts.at(0));
}

app::Result<std::string> DocumentWorkers::of_text(std::string_view kind, const app::DiagnoseOrder& order,
                                                  const app::Waiter& waiter) {
  WorkPackage request;
  request.head = write_text_order(kind, order, request);
  request.head["seconds"] = seconds_.load();
  auto reply = ask(workplace_, request, seconds_.load(), waiter);
  if (!reply) return std::unexpected(reply.error());
  return std::move(reply->texts.at(0));
}

app::Result<DocumentWorkers::Restart> DocumentWorkers::restart(const app::RestartOrder& order,
                                                               const app::Waiter& waiter) {
  std::vector<app::CalledText> called;
  const auto make = [&](const std::vector<app::CalledText>& known) {
    WorkPackage request;
    request.head = {{"kind", "restart"},
                    {"seconds", seconds_.load()},
                    {"case", write_case(order.of, request)},
                    {"line", order.line},
                    {"clearance_mm", order.clearance_mm}};
    request.head["called"] = write_called(known, request);
    return request;
  };
  auto reply = ask_with_called(caller_of(order.of), called, make, waiter);
  if (!reply) return std::unexpected(reply.error());
  return Restart{.is_possible = reply->head.at("is_possible").get<bool>(),
                 .text = std::move(reply->texts.at(0)),
                 .document = std::move(reply->texts.at(1))};
}

}  // namespace dripfeed::json
