// The texts of both sides are the caller's, and the controls are found as the command finds them.
#include "server/app/library/translation.h"

#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/shared_definitions.h"
#include "server/app/checks/diagnose.h"
#include "server/app/shop/catalog.h"

namespace dripfeed::app {

namespace {

struct Side {
  const compile::Dialect* dialect = nullptr;
  ir::Control control;
};

Result<Side> side_of_machine(const std::string& document, const Documents& documents) {
  const auto profile = documents.read_profile(document);
  if (!profile) return std::unexpected(profile.error());
  auto control = control_of(*profile);
  if (!control) return std::unexpected(control.error());
  return Side{compile::find_dialect(profile->control.dialect), std::move(*control)};
}

// A lathe's program goes to a lathe: what was found out about the source holds for the other side.
Result<Side> target_side(const TranslationOrder::Side& named, const Side& from, const Documents& documents) {
  if (!named.profile.empty()) return side_of_machine(named.profile, documents);
  if (named.dialect == from.dialect->name) return from;
  const compile::Dialect* dialect = compile::find_dialect(named.dialect);
  if (dialect == nullptr) return fail(ErrorCode::invalid, fmt::format("dialect \"{}\" is not known", named.dialect));
  const bool is_mill = from.control.kind == ir::MachineKind::mill;
  return Side{dialect, dialect->control(is_mill ? ir::MachineKind::mill : ir::MachineKind::lathe, {})};
}

}  // namespace

Result<void> refuse_contradiction(const text::Source& source, const ir::Control& control) {
  if (control.contradiction.empty()) return {};
  const ir::SystemEvidence& a = control.contradiction[0];
  const ir::SystemEvidence& b = control.contradiction[1];
  return fail(
      ErrorCode::invalid,
      fmt::format("{}: line {} has {} and line {} has {}, which are of different G-code "
                  "systems of a lathe: state which it is, by a machine or by --control kind=lathe,g_system=A (B, C)",
                  source.name(), a.line, a.code, b.line, b.code));
}

Result<Translation> translate_text(const TranslationOrder& order, const Documents& documents, CalledBy& called) {
  Translation out{.source = text::Source(order.name, order.text), .from = {}, .to = {}, .result = {}};
  const auto opened =
      open_text({.dialect = order.from.dialect, .text = order.text, .profile = order.from.profile}, documents);
  if (!opened) return std::unexpected(opened.error());
  const Side from{(*opened)->examination.dialect, (*opened)->examination.control};
  if (auto clear = refuse_contradiction(out.source, from.control); !clear) return std::unexpected(clear.error());
  const auto to = target_side(order.to, from, documents);
  if (!to) return std::unexpected(to.error());
  out.from = from.dialect->name;
  out.to = to->dialect->name;
  const compile::FindText find = [&called](std::string_view name) { return called.find(name); };
  const ir::Control control = compile::with_definitions(from.control, find);
  compile::ProgramLibrary library(control, find);
  out.result = compile::convert(
      {.source = out.source, .from = control, .to = to->control, .mode = order.mode, .library = &library});
  return out;
}

}  // namespace dripfeed::app
