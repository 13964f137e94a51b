// Carrying out what workers.h describes, in whatever process this is.
#include "server/app/checks/workers.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/text/number.h"
#include "server/app/checks/timed_rendering.h"
#include "server/app/checks/verdict_points.h"
#include "server/app/shop/catalog.h"

namespace dripfeed::app {

namespace {

store::Outcome outcome_of(checks::Verdict verdict) {
  switch (verdict) {
    case checks::Verdict::pass: return store::Outcome::pass;
    case checks::Verdict::warn: return store::Outcome::warn;
    case checks::Verdict::unknown: return store::Outcome::unknown;
    case checks::Verdict::fail: return store::Outcome::fail;
  }
  return store::Outcome::unknown;
}

// One line an entry, tab between the columns: text offset, printed line, family line, then name=value of what is set.
std::string write_places(const compile::PlaceIndex& places) {
  std::string out;
  for (std::size_t i = 0; i < places.entries.size(); ++i) {
    const compile::PlaceEntry& entry = places.entries[i];
    out += fmt::format("{}\t{}\t{}", entry.offset, entry.line, entry.origin);
    const auto values = places.values_of(i);
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (values[k] == values[k]) out += fmt::format("\t{}={}", places.names[k], text::format_shortest(values[k]));
    }
    out += '\n';
  }
  return out;
}

// What is not known of the control's memory.
std::vector<std::string> assumed_of(const std::vector<CalledText>& called) {
  std::vector<std::string> all;
  std::string held;
  for (const CalledText& one : called) {
    if (!one.why_not.empty())
      all.push_back(one.why_not);
    else
      held += fmt::format("{}{} as revision {} of program {}", held.empty() ? "" : ", ", one.key, one.revision,
                          one.program);
  }
  if (!held.empty()) all.push_back(fmt::format("whether the control holds {}: it was run as the library has it", held));
  return all;
}

}  // namespace

Result<void> take_geometry(const NominalCase& nominal, Examination& e) {
  const text::Source source(nominal.family, nominal.text);
  auto made = compile::family_geometry(source, overrides_of(nominal.values));
  e.geometry = std::move(made.geometry);
  if (!nominal.is_from_request) return {};
  if (auto fine = refuse_errors(made.diagnostics, source, fmt::format("family {}", nominal.family)); !fine) return fine;
  std::string values;
  for (const auto& [name, value] : nominal.values) values += fmt::format(" {}={}", name, value);
  e.assumed.push_back(fmt::format("whether the part is that of family {}, revision {}{}: it was stated to be",
                                  nominal.family, nominal.revision, values));
  return {};
}

ir::Delivery delivery_of(store::Delivery delivery) {
  return delivery == store::Delivery::drip ? ir::Delivery::drip : ir::Delivery::memory;
}

Result<std::unique_ptr<OpenCase>> open_case(CaseOrder order, const Documents& documents, CalledBy& called) {
  auto profile = documents.read_profile(order.profile);
  if (!profile) return std::unexpected(profile.error());
  const auto control = control_of(*profile);
  if (!control) return std::unexpected(control.error());
  auto one = std::make_unique<OpenCase>(OpenCase{.profile = std::move(*profile), .examination = {}});
  Examination& e = one->examination;
  e.source = text::Source(order.name, std::move(order.text));
  e.dialect = compile::find_dialect(order.dialect);
  if (e.dialect == nullptr) return fail(ErrorCode::invalid, fmt::format("dialect \"{}\" is not known", order.dialect));
  e.control = *control;
  e.profile = &one->profile;
  e.delivery = delivery_of(order.delivery);
  e.profile_lines = std::move(order.profile_lines);
  e.find_called = [&called](std::string_view name) { return called.find(name); };
  e.assumed = assumed_of(called.texts);
  if (!order.nominal) return one;
  if (auto known = take_geometry(*order.nominal, e); !known) return std::unexpected(known.error());
  return one;
}

Result<CheckDone> check_case(CaseOrder order, const Documents& documents, const CheckBudget& budget, CalledBy& called) {
  const auto one = open_case(std::move(order), documents, called);
  if (!one) return std::unexpected(one.error());
  (*one)->examination.used_up = time_budget(budget.seconds);
  const CheckReport report = examine((*one)->examination);
  return CheckDone{outcome_of(report.verdict), documents.write_report(report), {}, points_of(report)};
}

Result<RenderDone> render_family(const RenderWork& work, const Documents& documents) {
  const auto profile = documents.read_profile(work.profile);
  if (!profile) return std::unexpected(profile.error());
  const auto control = control_of(*profile);
  if (!control) return std::unexpected(control.error());
  const compile::RenderRequest request{.family = text::Source(work.family, work.text),
                                       .values = overrides_of(work.values),
                                       .target = *control,
                                       .mode = work.mode,
                                       .delivery = delivery_of(work.delivery),
                                       .program_name = work.name,
                                       .heading = work.heading};
  RenderDone done{.result = render_for(request, &*profile), .places = {}};
  const auto fine = refuse_errors(done.result.diagnostics, request.family, fmt::format("family {}", work.family));
  if (!fine) return std::unexpected(fine.error());
  if (work.optimize) optimize_for(done.result, *control, *profile);
  done.places = write_places(done.result.places);
  done.drawing = documents.write_drawing(done.result.drawing);
  return done;
}

Result<std::vector<ProgramDigest>> digest_programs(const std::vector<DigestOrder>& orders) {
  std::vector<ProgramDigest> all;
  for (const DigestOrder& order : orders) {
    const compile::Dialect* dialect = compile::find_dialect(order.dialect);
    if (dialect == nullptr) {
      all.push_back(undigested(order, fmt::format("dialect \"{}\" is not known", order.dialect)));
      continue;
    }
    const text::Source source(order.name, order.text);
    all.push_back(compile::digest_of(dialect->read(source, dialect->infer_control(source))));
    if (order.is_whole) continue;
    all.back().is_cut = true;
    if (all.back().not_read.empty()) all.back().not_read = "it is so long that only its beginning was read";
  }
  return all;
}

ProgramDigest undigested(const DigestOrder& order, std::string why) {
  constexpr std::size_t kMost = std::size_t{64} * 1024;
  ProgramDigest digest;
  digest.words = compile::as_utf8(std::string_view(order.text).substr(0, kMost));
  digest.is_cut = !order.is_whole || order.text.size() > kMost;
  digest.not_read = std::move(why);
  return digest;
}

}  // namespace dripfeed::app
