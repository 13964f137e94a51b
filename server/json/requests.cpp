// Each body is an object with known members. One function reads it and describes it.
#include "server/json/requests.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "protocol/feed/feed.h"
#include "server/app/base/names.h"
#include "server/json/bodies.h"
#include "server/json/enumerators.h"
#include "server/json/object_reader.h"

namespace dripfeed::json {

namespace {

void read_id(ObjectReader& object, std::string_view name, store::Id& into) {
  object.integer(name, into, 1, kMaxId, true);
}

void read_delivery(ObjectReader& object, store::Delivery& into) {
  if (const auto delivery = object.choice("delivery", store::kNames<store::Delivery>))
    into = static_cast<store::Delivery>(*delivery);
}

void read_values_of(ObjectReader& object, std::string_view name, app::Values& into) {
  const Document* values = object.member(name, map_of(text_or_number("a value with its unit, or a plain number"), ""));
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
  static const Words kModes = names_of<compile::RenderMode>(compile::name_of);
  if (const auto mode = o.choice("mode", kModes)) into = static_cast<compile::RenderMode>(*mode);
}

// One function a body: it reads, and it describes (see object_reader.h).

void read_members(ObjectReader& o, TextBody& into) { o.text("text", into.text, true); }

void read_members(ObjectReader& o, ProgramBody& into) {
  o.proper_name("name", into.name);
  o.text("dialect", into.dialect, true);
  o.text("text", into.text, true);
}

// As app::why_no_name, and short enough to stand next to others.
void read_tags(ObjectReader& o, std::optional<std::vector<std::string>>& into) {
  constexpr std::size_t kMostTags = 32;
  constexpr std::size_t kLongest = 64;
  const Document* tags = o.member("tags", list_of(text("a word or a few"), ""));
  if (tags == nullptr) return;
  if (!tags->is_array() || tags->size() > kMostTags) return o.fault("tags", "must be a list of 32 texts at most");
  into.emplace();
  for (const Document& one : *tags) {
    const std::string tag = one.is_string() ? one.get<std::string>() : std::string();
    const std::string why = tag.size() > kLongest ? "has a tag of more than 64 bytes" : app::why_no_name(tag);
    if (!why.empty()) return o.fault("tags", tag.size() > kLongest ? why : "has a tag that " + why);
    into->push_back(tag);
  }
}

// Names with slashes between; "" is no folder.
void read_folder(ObjectReader& o, std::optional<std::string>& into) {
  if (!o.has("folder") && o.member("folder", text("")) == nullptr) return;
  std::string folder;
  o.text("folder", folder);
  if (std::string why = app::why_no_folder(folder); !why.empty()) return o.fault("folder", std::move(why));
  into = std::move(folder);
}

void read_members(ObjectReader& o, store::ProgramLabels& into) {
  read_tags(o, into.tags);
  read_folder(o, into.folder);
}

void read_new_part(ObjectReader& o, PartBody& into) {
  o.proper_name("number", into.number);
  o.text("family", into.family, true);
  read_values_of(o, "values", into.values);
}
void read_part_change(ObjectReader& o, PartBody& into) { read_values_of(o, "values", into.values); }

void read_members(ObjectReader& o, app::RenderOrder& into) {
  o.text("part", into.part);
  o.text("family", into.family);
  read_values_of(o, "values", into.values);
  o.text("machine", into.machine, true);
  o.proper_name("name", into.name, false);
  read_delivery(o, into.delivery);
  read_mode(o, into.mode);
  o.flag("optimize", into.optimize);
}

// What a check and a release both name.
template <class Body>
void read_subject(ObjectReader& o, Body& into) {
  read_id(o, "program", into.program);
  o.integer("revision", into.revision, 1, kMaxId);
  o.text("machine", into.machine, true);
  read_delivery(o, into.delivery);
}

void read_members(ObjectReader& o, DiagnoseBody& into) {
  o.text("text", into.text);
  o.text("dialect", into.dialect);
  o.text("machine", into.machine);
  read_delivery(o, into.delivery);
}

void read_members(ObjectReader& o, RewriteBody& into) {
  read_members(o, into.of);
  if (const auto how = o.choice("how", app::kRewritingNames, true)) into.how = static_cast<app::Rewriting>(*how);
  if (const auto numbering = o.choice("numbering", compile::kNumberingNames))
    into.numbering = static_cast<compile::Numbering>(*numbering);
  o.integer("first", into.first, 1, app::kMostNumberStep);
  o.integer("step", into.step, 1, app::kMostNumberStep);
}

void read_members(ObjectReader& o, CompareTextBody& into) {
  o.text("text", into.text);
  o.integer("revision", into.revision, 1, kMaxId);
  o.text("machine", into.machine);
}

void read_members(ObjectReader& o, ConvertBody& into) {
  o.text("text", into.text);
  o.integer("program", into.program, 1, kMaxId);
  o.integer("revision", into.revision, 1, kMaxId);
  o.text("dialect", into.dialect);
  o.text("machine", into.machine);
  o.text("to", into.to);
  o.text("to_machine", into.to_machine);
  if (const auto mode = o.choice("mode", compile::kConvertModeNames))
    into.mode = static_cast<compile::ConvertMode>(*mode);
  if (o.has("text") == o.has("program")) o.fault("text", "either text or program");
  if (into.to.empty() == into.to_machine.empty()) o.fault("to", "either to, a dialect, or to_machine");
}

// Names of rules, or of variables.
void read_words(ObjectReader& o, std::string_view name, std::vector<std::string>& into) {
  constexpr std::size_t kMostWords = 64;
  const Document* const words = o.member(name, list_of(text("one of them"), ""));
  if (words == nullptr) return;
  const bool are_texts =
      words->is_array() && std::ranges::all_of(*words, [](const Document& one) { return one.is_string(); });
  if (!are_texts || words->size() > kMostWords) return o.fault(name, "must be a list of 64 texts at most");
  for (const Document& one : *words) into.push_back(one.get<std::string>());
}

void read_members(ObjectReader& o, OptimizeBody& into) {
  constexpr double kMostTolerance_mm = 1.0;
  o.text("text", into.text);
  o.integer("program", into.program, 1, kMaxId);
  o.integer("revision", into.revision, 1, kMaxId);
  o.text("dialect", into.dialect);
  o.text("machine", into.machine);
  read_words(o, "with", into.words.with);
  read_words(o, "without", into.words.without);
  read_words(o, "own", into.words.own);
  read_words(o, "free", into.words.free);
  o.number("tolerance_mm", into.words.tolerance_mm, 0.0, kMostTolerance_mm);
  if (o.has("text") == o.has("program")) o.fault("text", "either text or program");
}

void read_members(ObjectReader& o, ReleaseBody& into) { read_subject(o, into); }

void read_restart(ObjectReader& o, RestartBody& into) {
  constexpr double kLeastClearance_mm = 0.1;
  constexpr double kMostClearance_mm = 1000.0;
  o.integer("line", into.line, 1, UINT32_MAX, true);
  o.number("clearance_mm", into.clearance_mm, kLeastClearance_mm, kMostClearance_mm);
}
void read_shown_restart(ObjectReader& o, RestartBody& into) {
  read_restart(o, into);
  o.text("shown_sha256", into.shown_sha256, true);
}

void read_nominal(ObjectReader& o, std::optional<app::NominalOrder>& into) {
  o.object("nominal", [&](ObjectReader& nominal) {
    into.emplace();
    nominal.text("family", into->family, true);
    read_values_of(nominal, "values", into->values);
  });
}

void read_members(ObjectReader& o, PathBody& into) {
  read_members(o, into.of);
  read_nominal(o, into.nominal);
  o.text("stock", into.stock);
}

void read_members(ObjectReader& o, app::CheckOrder& into) {
  read_subject(o, into);
  read_nominal(o, into.nominal);
  std::string profile;
  o.text("profile", profile);
  if (const auto lines = app::read_line_ranges(profile)) {
    into.profile_lines = *lines;
  } else {
    o.fault("profile", "must name lines as \"12-60,70-71\"");
  }
}

void read_accuracy(ObjectReader& o, MeasureBody& into) {
  read_members(o, into.order.of);
  o.text("cmm", into.cmm);
  o.flag("best_fit", into.best_fit);
}
void read_gouge(ObjectReader& o, MeasureBody& into) { read_members(o, into.order.of); }
void read_timing(ObjectReader& o, MeasureBody& into) {
  constexpr std::int64_t kLeastBaud = 50;
  constexpr std::int64_t kMostBaud = 4'000'000;
  read_members(o, into.order.of);
  o.integer("baud", into.order.wishes.baud, kLeastBaud, kMostBaud);
}

using ReadMeasure = void (*)(ObjectReader&, MeasureBody&);
constexpr std::array<ReadMeasure, 3> kMeasures = {read_accuracy, read_gouge, read_timing};  // in the order of Measure

void read_members(ObjectReader& o, app::SweepOrder& into) {
  constexpr std::int64_t kMostSamples = 1000;  // a pool thread is busy as long
  o.text("family", into.family, true);
  read_values_of(o, "values", into.values);
  o.text("machine", into.machine, true);
  read_mode(o, into.mode);
  read_delivery(o, into.delivery);
  o.integer("seed", into.settings.seed, 0, UINT32_MAX);
  o.integer("samples", into.settings.samples, 0, kMostSamples);
}

void read_reason(ObjectReader& o, ReasonBody& into) { o.words("reason", into.reason, true); }
void read_optional_reason(ObjectReader& o, ReasonBody& into) { o.words("reason", into.reason); }

void read_members(ObjectReader& o, HandOverBody& into) {
  o.text("node", into.node, true);
  o.words("reason", into.reason, true);
}

void read_members(ObjectReader& o, store::NewWaiver& into) {
  o.words("reason", into.reason, true);
  o.text("point", into.point);
  o.integer("expires_at_ms", into.expires_at_ms, 1, kMaxId);
}

void read_members(ObjectReader& o, store::ReleaseMove& into) {
  constexpr std::int64_t kMostTransfers = 1'000'000;
  if (const auto to = o.choice("to", store::kNames<store::ReleaseState>, true))
    into.to = static_cast<store::ReleaseState>(*to);
  o.words("note", into.note);
  o.integer("transfers", into.transfers, 1, kMostTransfers);
  o.text("shown_sha256", into.shown_sha256);
  if (into.to == store::ReleaseState::proving && !o.has("transfers")) o.fault("transfers", "is missing");
}

void read_members(ObjectReader& o, app::AcceptOrder& into) {
  o.integer("program", into.program, 1, kMaxId);
  o.integer("revision", into.revision, 1, kMaxId);
  o.proper_name("name", into.name, false);
  o.words("reason", into.reason);
  if (into.revision != 0 && into.program == 0) o.fault("revision", "is of a program: state which");
  if (!into.name.empty() && into.program != 0) o.fault("name", "a program has its name");
}

void read_members(ObjectReader& o, SignOffBody& into) { o.words("note", into.note, true); }

void read_members(ObjectReader& o, ShelveBody& into) {
  constexpr std::int64_t kLongest_min = 480;  // a shift
  o.integer("minutes", into.minutes, 1, kLongest_min, true);
  o.words("reason", into.reason, true);
}

void read_types(ObjectReader& o, std::vector<std::string>& into, bool required) {
  constexpr std::size_t kMostTypes = 64;
  const Document* const types = o.member("types", list_of(text("a type, \"job.*\" or \"*\""), ""), required);
  if (types == nullptr) return;
  if (!types->is_array() || types->size() > kMostTypes) return o.fault("types", "must be a list of 64 texts at most");
  into.clear();
  for (const Document& one : *types) {
    if (!one.is_string()) return o.fault("types", "must be a list of texts");
    into.push_back(one.get<std::string>());
  }
}

void read_webhook(ObjectReader& o, store::WebhookSettings& into, bool is_new) {
  constexpr std::size_t kLongest = 2000;
  o.text("url", into.url, is_new);
  read_types(o, into.types, is_new);
  o.text("description", into.description);
  o.flag("enabled", into.enabled);
  o.flag("local", into.local);
  if (into.url.size() > kLongest) o.fault("url", "must not be longer than 2000 bytes");
  if (into.description.size() > kLongest) o.fault("description", "must not be longer than 2000 bytes");
}
void read_new_webhook(ObjectReader& o, store::WebhookSettings& into) { read_webhook(o, into, true); }
void read_webhook_changes(ObjectReader& o, store::WebhookSettings& into) { read_webhook(o, into, false); }

void read_members(ObjectReader& o, RotateBody& into) {
  o.integer("keep_hours", into.keep_hours, 0, app::Webhooks::kOldSecretAtMost_h);
}

void read_members(ObjectReader& o, ReplayBody& into) { o.integer("since_ms", into.since_ms, 0, kMaxId, true); }

template <class Body>
app::Result<Body> read_body(std::string_view body) {
  return read_by<Body>(read_members, body);
}

}  // namespace

app::Result<TextBody> read_text_body(std::string_view body) { return read_body<TextBody>(body); }
app::Result<ProgramBody> read_program_body(std::string_view body) { return read_body<ProgramBody>(body); }
app::Result<store::ProgramLabels> read_labels_body(std::string_view body) {
  return read_body<store::ProgramLabels>(body);
}
app::Result<PartBody> read_part_body(std::string_view body, bool is_new) {
  return read_by<PartBody>(is_new ? read_new_part : read_part_change, body);
}
app::Result<app::RenderOrder> read_render_body(std::string_view body) { return read_body<app::RenderOrder>(body); }
app::Result<app::CheckOrder> read_check_body(std::string_view body) { return read_body<app::CheckOrder>(body); }
app::Result<ConvertBody> read_convert_body(std::string_view body) { return read_body<ConvertBody>(body); }
app::Result<OptimizeBody> read_optimize_body(std::string_view body) { return read_body<OptimizeBody>(body); }
app::Result<DiagnoseBody> read_diagnose_body(std::string_view body) { return read_body<DiagnoseBody>(body); }
app::Result<PathBody> read_path_body(std::string_view body) { return read_body<PathBody>(body); }
app::Result<RewriteBody> read_rewrite_body(std::string_view body) { return read_body<RewriteBody>(body); }
app::Result<CompareTextBody> read_compare_text_body(std::string_view body) { return read_body<CompareTextBody>(body); }
app::Result<MeasureBody> read_measure_body(std::string_view body, Measure what) {
  return read_by<MeasureBody>(kMeasures[static_cast<std::size_t>(what)], body);
}
app::Result<app::SweepOrder> read_sweep_body(std::string_view body) { return read_body<app::SweepOrder>(body); }
app::Result<ReleaseBody> read_release_body(std::string_view body) { return read_body<ReleaseBody>(body); }
app::Result<RestartBody> read_restart_body(std::string_view body, bool makes) {
  return read_by<RestartBody>(makes ? read_shown_restart : read_restart, body);
}
app::Result<SignOffBody> read_sign_off_body(std::string_view body) { return read_by<SignOffBody>(read_members, body); }

app::Result<ReasonBody> read_reason_body(std::string_view body, bool required) {
  return read_by<ReasonBody>(required ? read_reason : read_optional_reason, or_empty(body));
}
app::Result<HandOverBody> read_hand_over_body(std::string_view body) { return read_body<HandOverBody>(body); }
app::Result<store::NewWaiver> read_waiver_body(std::string_view body) { return read_body<store::NewWaiver>(body); }
app::Result<store::ReleaseMove> read_transition_body(std::string_view body) {
  return read_body<store::ReleaseMove>(body);
}
app::Result<app::AcceptOrder> read_accept_body(std::string_view body) {
  return read_body<app::AcceptOrder>(or_empty(body));
}
app::Result<ShelveBody> read_shelve_body(std::string_view body) { return read_body<ShelveBody>(body); }

std::optional<std::string> machine_in_body(std::string_view body) {
  const auto document = parse(body);
  if (!document || !document->is_object()) return std::nullopt;
  const auto found = document->find("machine");
  return found != document->end() && found->is_string() ? std::optional(found->get<std::string>()) : std::nullopt;
}
app::Result<store::WebhookSettings> read_webhook_body(std::string_view body) {
  return read_by<store::WebhookSettings>(read_new_webhook, body);
}
app::Result<store::WebhookSettings> read_webhook_change(std::string_view body, store::WebhookSettings known) {
  const auto done = read_object(body, "request", [&](ObjectReader& o) { read_webhook_changes(o, known); });
  if (!done) return std::unexpected(done.error());
  return known;
}
app::Result<RotateBody> read_rotate_body(std::string_view body) { return read_body<RotateBody>(or_empty(body)); }
app::Result<ReplayBody> read_replay_body(std::string_view body) { return read_body<ReplayBody>(body); }

Schemas request_schemas() {
  return {
      described<TextBody>("NewText", read_members, "a text as a whole"),
      described<ProgramBody>("NewProgram", read_members, "a program by its text"),
      described<store::ProgramLabels>("ProgramLabels", read_members, "how a program is filed; what is not given stays"),
      described<PartBody>("NewPart", read_new_part, "a part: a family with values"),
      described<PartBody>("PartChange", read_part_change, "all values of a part's new revision"),
      described<app::RenderOrder>("RenderOrder", read_members, "what is rendered, and for which machine"),
      described<app::CheckOrder>("CheckOrder", read_members, "what is checked, and for which machine"),
      described<ConvertBody>("ConvertOrder", read_members, "a text and the control that it is translated for"),
      described<OptimizeBody>("OptimizeOrder", read_members, "a text, and how it is made faster for its control"),
      described<DiagnoseBody>("DiagnoseOrder", read_members, "a text that is being written; it is not stored"),
      described<PathBody>("PathOrder", read_members, "a text that is being written, and what it should make"),
      described<RewriteBody>("RewriteOrder", read_members, "a text that is being written, and how it is rewritten"),
      described<CompareTextBody>("CompareText", read_members,
                                 "a text that is being written, and what it is compared with"),
      described<MeasureBody>("AccuracyOrder", read_accuracy, "a program, and what it is compared with"),
      described<MeasureBody>("GougeOrder", read_gouge, "a program, and what it is compared with"),
      described<MeasureBody>("TimingOrder", read_timing, "a program, its machine and line"),
      described<app::SweepOrder>("SweepOrder", read_members, "a family, and how it is tried"),
      described<ReleaseBody>("NewRelease", read_members, "what a release binds"),
      described<store::ReleaseMove>("ReleaseMove", read_members, "one step of a release"),
      described<RestartBody>("RestartOrder", read_restart, "where a program is to be restarted"),
      described<RestartBody>("NewRestart", read_shown_restart, "a restart that was shown"),
      described<ShelveBody>("Shelve", read_members, "for how long an alarm asks for no person"),
      described<store::NewWaiver>("NewWaiver", read_members, "a person answers for a verdict, or for a point of it"),
      described<HandOverBody>("HandOver", read_members, "which server gets a machine's line, and why"),
      described<SignOffBody>("SignOff", read_members, "what an operator states of a proving"),
      described<ReasonBody>("Reason", read_reason, "why a person does it"),
      described<ReasonBody>("OptionalReason", read_optional_reason, "why a person does it, where they state it"),
      described<store::WebhookSettings>("NewWebhook", read_new_webhook, "who receives which events"),
      described<store::WebhookSettings>("ChangedWebhook", read_webhook_changes, "what is not given stays unchanged"),
      described<RotateBody>("Rotate", read_members, "how a secret is changed"),
      described<ReplayBody>("Replay", read_members, "which dead deliveries are tried again"),
      described<app::AcceptOrder>("AcceptOrder", read_members, "what a receipt becomes; nothing: a new program"),
  };
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
