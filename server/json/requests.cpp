// Each body is an object with known members.
#include "server/json/requests.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "protocol/feed/feed.h"
#include "server/json/object_reader.h"

namespace dripfeed::json {

namespace {

constexpr std::int64_t kMaxId = std::int64_t{1} << 53U;  // what JavaScript keeps exactly
constexpr std::array<std::string_view, 2> kDeliveries = {"drip", "memory"};
constexpr std::array<std::string_view, 5> kReleaseStates = {"draft", "in_review", "proving", "approved", "obsolete"};

void read_id(ObjectReader& object, std::string_view name, store::Id& into) {
  object.integer(name, into, 1, kMaxId);
  if (!object.has(name)) object.fault(name, "is missing");
}

void read_delivery(ObjectReader& object, store::Delivery& into) {
  if (const auto delivery = object.choice("delivery", kDeliveries)) into = static_cast<store::Delivery>(*delivery);
}

void read_values_of(ObjectReader& object, std::string_view name, app::Values& into) {
  const Document* values = object.member(name);
  if (values == nullptr) return;
  if (!values->is_object()) return object.fault(name, "must be an object of texts such as \"120 mm\"");
  for (const auto& [parameter, value] : values->items()) {
    if (value.is_string()) {
      into[parameter] = value.get<std::string>();
    } else if (value.is_number()) {
      into[parameter] = value.dump();
    } else {
      object.fault(name, fmt::format("\"{}\" must be a text such as \"120 mm\" or a plain number", parameter));
    }
  }
}

void read_mode(ObjectReader& o, compile::RenderMode& into) {
  std::string mode = "auto";
  o.text("mode", mode);
  if (const auto found = compile::find_render_mode(mode)) {
    into = *found;
  } else {
    o.fault("mode", "must be \"auto\", \"macro\" or \"explicit\"");
  }
}

}  // namespace

app::Result<TextBody> read_text_body(std::string_view body) {
  TextBody read;
  const auto done = read_object(body, "request", [&](ObjectReader& o) { o.text("text", read.text, true); });
  if (!done) return std::unexpected(done.error());
  return read;
}

app::Result<ProgramBody> read_program_body(std::string_view body) {
  ProgramBody read;
  const auto done = read_object(body, "request", [&](ObjectReader& o) {
    o.proper_name("name", read.name);
    o.text("dialect", read.dialect, true);
    o.text("text", read.text, true);
  });
  if (!done) return std::unexpected(done.error());
  return read;
}

app::Result<PartBody> read_part_body(std::string_view body, bool is_new) {
  PartBody read;
  const auto done = read_object(body, "request", [&](ObjectReader& o) {
    if (is_new) {
      o.proper_name("number", read.number);
      o.text("family", read.family, true);
    }
    read_values_of(o, "values", read.values);
  });
  if (!done) return std::unexpected(done.error());
  return read;
}

app::Result<app::RenderOrder> read_render_body(std::string_view body) {
  app::RenderOrder order;
  const auto done = read_object(body, "request", [&](ObjectReader& o) {
    o.text("part", order.part);
    o.text("family", order.family);
    read_values_of(o, "values", order.values);
    o.text("machine", order.machine, true);
    o.proper_name("name", order.name, false);
    read_delivery(o, order.delivery);
    read_mode(o, order.mode);
  });
  if (!done) return std::unexpected(done.error());
  return order;
}

namespace {

// What a check and a release both name.
template <class Body>
void read_subject(ObjectReader& o, Body& into) {
  read_id(o, "program", into.program);
  o.integer("revision", into.revision, 1, kMaxId);
  o.text("machine", into.machine, true);
  read_delivery(o, into.delivery);
}

void read_order(ObjectReader& o, app::CheckOrder& into) {
  read_subject(o, into);
  if (o.has("nominal")) {
    into.nominal.emplace();
    o.object("nominal", [&](ObjectReader& nominal) {
      nominal.text("family", into.nominal->family, true);
      read_values_of(nominal, "values", into.nominal->values);
    });
  }
  std::string profile;
  o.text("profile", profile);
  if (const auto lines = app::read_line_ranges(profile)) {
    into.profile_lines = *lines;
  } else {
    o.fault("profile", "must name lines as \"12-60,70-71\"");
  }
}

}  // namespace

app::Result<app::CheckOrder> read_check_body(std::string_view body) {
  app::CheckOrder order;
  const auto done = read_object(body, "request", [&](ObjectReader& o) { read_order(o, order); });
  if (!done) return std::unexpected(done.error());
  return order;
}

app::Result<MeasureBody> read_measure_body(std::string_view body, Measure what) {
  constexpr std::int64_t kLeastBaud = 50;
  constexpr std::int64_t kMostBaud = 4'000'000;
  MeasureBody read;
  const auto done = read_object(body, "request", [&](ObjectReader& o) {
    read_order(o, read.order.of);
    if (what == Measure::timing) o.integer("baud", read.order.wishes.baud, kLeastBaud, kMostBaud);
    if (what != Measure::accuracy) return;
    o.text("cmm", read.cmm);
    o.flag("best_fit", read.best_fit);
  });
  if (!done) return std::unexpected(done.error());
  return read;
}

app::Result<app::SweepOrder> read_sweep_body(std::string_view body) {
  constexpr std::int64_t kMostSamples = 1000;  // a pool thread is busy as long
  app::SweepOrder order;
  const auto done = read_object(body, "request", [&](ObjectReader& o) {
    o.text("family", order.family, true);
    read_values_of(o, "values", order.values);
    o.text("machine", order.machine, true);
    read_mode(o, order.mode);
    read_delivery(o, order.delivery);
    o.integer("seed", order.settings.seed, 0, UINT32_MAX);
    o.integer("samples", order.settings.samples, 0, kMostSamples);
  });
  if (!done) return std::unexpected(done.error());
  return order;
}

app::Result<ReleaseBody> read_release_body(std::string_view body) {
  ReleaseBody read;
  const auto done = read_object(body, "request", [&](ObjectReader& o) { read_subject(o, read); });
  if (!done) return std::unexpected(done.error());
  return read;
}

app::Result<ReasonBody> read_reason_body(std::string_view body, bool required) {
  ReasonBody read;
  const auto done = read_object(body.empty() ? "{}" : body, "request",
                                [&](ObjectReader& o) { o.text("reason", read.reason, required); });
  if (!done) return std::unexpected(done.error());
  return read;
}

app::Result<store::ReleaseMove> read_transition_body(std::string_view body) {
  store::ReleaseMove move;
  const auto done = read_object(body, "request", [&](ObjectReader& o) {
    if (const auto to = o.choice("to", kReleaseStates)) move.to = static_cast<store::ReleaseState>(*to);
    if (!o.has("to")) o.fault("to", "is missing");
    o.text("note", move.note);
    o.integer("transfers", move.transfers, 1, 1'000'000);
    if (move.to == store::ReleaseState::proving && !o.has("transfers")) o.fault("transfers", "is missing");
  });
  if (!done) return std::unexpected(done.error());
  return move;
}

app::Result<app::AcceptOrder> read_accept_body(std::string_view body) {
  app::AcceptOrder order;
  const auto done = read_object(body.empty() ? "{}" : body, "request", [&](ObjectReader& o) {
    o.integer("program", order.program, 1, kMaxId);
    o.integer("revision", order.revision, 1, kMaxId);
    o.proper_name("name", order.name, false);
    o.text("reason", order.reason);
    if (order.revision != 0 && order.program == 0) o.fault("revision", "is of a program: say which");
    if (!order.name.empty() && order.program != 0) o.fault("name", "a program has its name");
  });
  if (!done) return std::unexpected(done.error());
  return order;
}

app::Result<JobBody> read_job_body(std::string_view body) {
  JobBody read;
  const auto done = read_object(body, "request", [&](ObjectReader& o) { read_id(o, "release", read.release); });
  if (!done) return std::unexpected(done.error());
  return read;
}

app::Result<ArmBody> read_arm_body(std::string_view body) {
  ArmBody read;
  if (body.empty()) return read;
  const auto done = read_object(body, "request", [&](ObjectReader& o) {
    o.number("minutes", read.minutes, 0.01, 60.0);
    o.integer("rounds", read.rounds, 1, feed::kMaxRounds);
  });
  if (!done) return std::unexpected(done.error());
  return read;
}

app::Result<SessionBody> read_session_body(std::string_view body) {
  SessionBody read;
  const auto done = read_object(body, "request", [&](ObjectReader& o) { o.text("token", read.token, true); });
  if (!done) return std::unexpected(done.error());
  return read;
}

app::Result<app::Values> read_values(std::string_view document) {
  app::Values values;
  const auto done = read_object(fmt::format("{{\"values\":{}}}", document), "values",
                                [&](ObjectReader& o) { read_values_of(o, "values", values); });
  if (!done) return std::unexpected(done.error());
  return values;
}

std::string write_values(const app::Values& values) {
  Document document = Document::object();
  for (const auto& [name, value] : values) document[name] = value;
  return dump(document);
}

}  // namespace dripfeed::json
