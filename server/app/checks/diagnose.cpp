// The first half of a check.
#include "server/app/checks/diagnose.h"

#include <utility>

#include <fmt/format.h>

#include "server/app/shop/catalog.h"

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

Result<std::unique_ptr<OpenCase>> open_text(const DiagnoseOrder& order, const Documents& documents) {
  auto one = std::make_unique<OpenCase>();
  Examination& e = one->examination;
  e.source = text::Source("", order.text);
  e.delivery = delivery_of(order.delivery);
  e.profile_lines = order.profile_lines;
  if (order.nominal)
    if (auto known = take_geometry(*order.nominal, e); !known) return std::unexpected(known.error());
  if (!order.profile.empty()) {
    auto known = documents.read_profile(order.profile);
    if (!known) return std::unexpected(known.error());
    one->profile = std::move(*known);
    if (auto fits = take_machine(order, one->profile, e); !fits) return std::unexpected(fits.error());
    return one;
  }
  e.dialect = order.dialect.empty() ? &compile::infer_dialect(e.source) : compile::find_dialect(order.dialect);
  if (e.dialect == nullptr) return fail(ErrorCode::invalid, fmt::format("dialect \"{}\" is not known", order.dialect));
  e.control = e.dialect->infer_control(e.source);
  e.inferred = true;
  return one;
}

Result<Diagnosed> diagnose_text(const DiagnoseOrder& order, const Documents& documents) {
  const auto opened = open_text(order, documents);
  if (!opened) return std::unexpected(opened.error());
  TextReading text = read_text((*opened)->examination);
  return Diagnosed{.report = std::move(text.report), .outline = compile::outline_of(text.read)};
}

}  // namespace dripfeed::app
