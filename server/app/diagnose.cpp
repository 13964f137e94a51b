// The first half of a check.
#include "server/app/diagnose.h"

#include <utility>

#include <fmt/format.h>

#include "server/app/catalog.h"
#include "server/app/workers.h"

namespace dripfeed::app {

namespace {

Result<void> take_machine(const DiagnoseOrder& order, machine::Profile& profile, Examination& e) {
  const auto control = control_of(profile);
  if (!control) return std::unexpected(control.error());
  if (!order.dialect.empty() && order.dialect != profile.control.dialect)
    return fail(ErrorCode::invalid,
                fmt::format("the text is {}, the machine is {}", order.dialect, profile.control.dialect));
  e.dialect = compile::find_dialect(profile.control.dialect);
  e.control = *control;
  e.profile = &profile;
  return {};
}

}  // namespace

Result<Diagnosed> diagnose_text(const DiagnoseOrder& order, const Documents& documents) {
  Examination e{.source = text::Source("", order.text),
                .control = {},
                .delivery = delivery_of(order.delivery),
                .find_called = {},
                .geometry = {},
                .profile_lines = {}};
  machine::Profile profile;
  if (!order.profile.empty()) {
    auto known = documents.read_profile(order.profile);
    if (!known) return std::unexpected(known.error());
    profile = std::move(*known);
    if (auto fits = take_machine(order, profile, e); !fits) return std::unexpected(fits.error());
  } else {
    e.dialect = order.dialect.empty() ? &compile::infer_dialect(e.source) : compile::find_dialect(order.dialect);
    if (e.dialect == nullptr)
      return fail(ErrorCode::invalid, fmt::format("dialect \"{}\" is not known", order.dialect));
    e.control = e.dialect->infer_control(e.source);
    e.inferred = true;
  }
  TextReading text = read_text(e);
  return Diagnosed{.report = std::move(text.report), .outline = compile::outline_of(text.read)};
}

}  // namespace dripfeed::app
