// Facts are copied at the statements that need them: calls, and blocks that a modal call follows.
#include "dialects/macro_b/writer/drill_place.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "dialects/facts/spindle.h"
#include "dialects/passes/refusal.h"

namespace dripfeed::macro_b {

namespace {

using facts::Kept;
using facts::Mode;
using facts::Number;
using ir::Function;
using ir::StatementKind;

bool is_distance(const ir::Code& c) { return facts::mode_of(c) == Mode::distance; }

std::optional<double> certain(const facts::Known<double>& fact) {
  const double* number = fact.certain();
  return number == nullptr ? std::nullopt : std::optional(*number);
}

}  // namespace

DrillPlace::DrillPlace(const ir::Program& program, const ir::Control& from, const ir::Control& to)
    : program_(program),
      to_(to),
      facts_(program, from),
      power_on_plane_(from.semantics.power_on_plane),
      incremental_(from.semantics.power_on_distance == Function::incremental) {}

void DrillPlace::move_to(std::uint32_t index) {
  index_ = index;
  const facts::Facts* before = facts_.before(index);
  here_ = before == nullptr ? std::nullopt : std::optional(*before);
  load();
}

void DrillPlace::take_block() {
  for (const ir::Code& code : program_.codes_of(program_.blocks[statement().payload]))
    if (is_distance(code)) incremental_ = code.function == Function::incremental;
  here_ = facts_.at(index_);
  load();
}

void DrillPlace::load() {
  height_ = std::nullopt;
  turning_ = {};
  if (!here_) return;
  height_ = certain((*here_)[Number::z]);
  turning_.spindle = facts::stated_spindle(program_, *here_);
  const bool turns = turning_.spindle == Function::spindle_cw || turning_.spindle == Function::spindle_ccw;
  if (!turns) turning_.spindle.reset();
  if (!(*here_)[Mode::surface_speed].is({.function = Function::surface_speed_off})) return;
  if (const facts::Setting* mode = (*here_)[Mode::feed].certain()) turning_.feed_mode = mode->function;
  turning_.feed = number(Kept::feed);
  turning_.speed = number(Kept::speed);
}

std::optional<double> DrillPlace::number(Kept word) const {
  const facts::Written* written = (*here_)[word].certain();
  const bool is_number = written != nullptr && written->is_stated && written->is_number;
  return is_number ? std::optional(written->number) : std::nullopt;
}

Function DrillPlace::plane() const {
  const bool is_stated = here_ && (*here_)[Mode::plane].origin != facts::kNoStatement;
  return is_stated ? (*here_)[Mode::plane].value.function : power_on_plane_;
}

std::optional<Function> DrillPlace::motion() const {
  const facts::Setting* motion = here_ ? (*here_)[Mode::motion].certain() : nullptr;
  return motion == nullptr ? std::nullopt : std::optional(motion->function);
}

std::optional<ir::PlanePoint> DrillPlace::in_plane() const {
  if (!here_) return std::nullopt;
  const std::optional<double> x = certain((*here_)[Number::x]);
  const std::optional<double> y = certain((*here_)[Number::y]);
  return x && y ? std::optional(ir::PlanePoint{*x, *y}) : std::nullopt;
}

// --- what is reported

void DrillPlace::state_plane() {
  if (here_) (void)is_known("the plane", (*here_)[Mode::plane]);
}

std::optional<Function> DrillPlace::state_distance() {
  if (!here_) return std::nullopt;
  if (statement().kind == StatementKind::block &&
      std::ranges::any_of(program_.codes_of(program_.blocks[statement().payload]), is_distance))
    return std::nullopt;
  const facts::Known<facts::Setting>& fact = (*here_)[Mode::distance];
  if (!is_known("absolute or incremental", fact) || (fact.value.function == Function::incremental) == incremental_)
    return std::nullopt;
  incremental_ = !incremental_;
  return fact.value.function;
}

bool DrillPlace::is_known(std::string_view what, const facts::Known<facts::Setting>& fact) {
  const bool differs =
      fact.other_origin != facts::kNoStatement || (fact.origin == facts::kNoStatement && !fact.inherited);
  const bool is_certain = fact.is_certain();
  if (!is_certain && reported_.insert({std::string(what), differs}).second) {
    std::string paths = fmt::format("{}", fmt::join(facts_.paths(fact), ", or "));
    if (fact.changer < program_.statements.size())
      paths +=
          fmt::format(", which what line {} calls or does may have changed", program_.statements[fact.changer].line);
    diagnostics_.push_back(text::make_diagnostic(text::DiagnosticId::unknown_modal_state, statement().span,
                                                 {std::string(what), std::move(paths)}));
    if (!differs) diagnostics_.back().severity = text::Severity::warning;
  }
  return !differs && fact.origin != facts::kNoStatement;
}

void DrillPlace::warn(passes::Refusal what) {
  cannot(std::move(what));
  diagnostics_.back().severity = text::Severity::warning;
}

void DrillPlace::cannot(passes::Refusal what) {
  diagnostics_.push_back(passes::diagnose(std::move(what), statement().span, to_.title));
}

}  // namespace dripfeed::macro_b
