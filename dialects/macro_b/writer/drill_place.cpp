// What is not plainly known is asked of all paths to the place, and reported where they differ.
#include "dialects/macro_b/writer/drill_place.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "dialects/facts/axis_words.h"
#include "dialects/facts/flow_graph.h"
#include "dialects/macro_b/writer/called_hole.h"
#include "dialects/passes/refusal.h"

namespace dripfeed::macro_b {

namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;
using ir::StatementKind;

// After them the numbers of a place are another place.
constexpr ModalGroup kOtherPlaces[] = {ModalGroup::frame, ModalGroup::work_offset, ModalGroup::unit, ModalGroup::plane,
                                       ModalGroup::length_offset};

bool changes_place(const ir::Code& c) {
  const bool stays = c.function == Function::dwell || c.function == Function::exact_stop_once;
  return (c.group == ModalGroup::non_modal && !stays) || c.function == Function::cycle_off ||
         std::ranges::find(kOtherPlaces, c.group) != std::end(kOtherPlaces);
}

// Words by which a block names its end without its letter.
bool is_by_angle(Address a) {
  return a == Address::polar_angle || a == Address::polar_radius || a == Address::opening_angle ||
         a == Address::direct_angle;
}

bool is_distance(const ir::Code& c) { return facts::mode_of(c) == facts::Mode::distance; }

bool joins_paths(StatementKind kind) { return kind >= StatementKind::if_begin && kind <= StatementKind::loop_end; }

}  // namespace

DrillPlace::DrillPlace(const ir::Program& program, const ir::Control& from, const ir::Control& to)
    : program_(program),
      to_(to),
      is_target_(facts::jump_targets(program)),
      modes_(program, from),
      plane_(from.semantics.power_on_plane),
      incremental_(from.semantics.power_on_distance == Function::incremental) {
  state.turning.feed_mode = from.semantics.power_on_feed;
}

void DrillPlace::move_to(std::uint32_t index) {
  index_ = index;
  const std::optional<facts::Setting> motion = modes_.certain(facts::Mode::motion, index);
  motion_ = motion ? std::optional(motion->function) : std::nullopt;
  if (is_target_[index] || joins_paths(statement().kind)) forget();
}

// --- over all paths

void DrillPlace::state_plane() {
  const facts::Facts* facts = modes_.before(index_);
  if (facts == nullptr) return;
  const facts::Known<facts::Setting>& fact = (*facts)[facts::Mode::plane];
  if (is_known("the plane", fact)) plane_ = fact.value.function;
}

std::optional<Function> DrillPlace::state_distance() {
  const facts::Facts* facts = modes_.before(index_);
  if (facts == nullptr) return std::nullopt;
  if (statement().kind == StatementKind::block &&
      std::ranges::any_of(program_.codes_of(program_.blocks[statement().payload]), is_distance))
    return std::nullopt;
  const facts::Known<facts::Setting>& fact = (*facts)[facts::Mode::distance];
  if (!is_known("absolute or incremental", fact) || (fact.value.function == Function::incremental) == incremental_)
    return std::nullopt;
  incremental_ = !incremental_;
  return fact.value.function;
}

bool DrillPlace::is_known(std::string_view what, const facts::Known<facts::Setting>& fact) {
  const bool differs = fact.other_origin != facts::kNobody || (fact.origin == facts::kNobody && !fact.inherited);
  const bool is_certain = fact.is_certain();
  if (!is_certain && reported_.insert({std::string(what), differs}).second) {
    std::string ways = fmt::format("{}", fmt::join(modes_.paths(fact), ", or "));
    if (fact.changer != ir::kNoIndex)
      ways +=
          fmt::format(", which what line {} calls or does may have changed", program_.statements[fact.changer].line);
    diagnostics_.push_back(text::make_diagnostic(text::DiagnosticId::unknown_modal_state, statement().span,
                                                 {std::string(what), std::move(ways)}));
    if (!differs) diagnostics_.back().severity = text::Severity::warning;
  }
  return !differs && fact.origin != facts::kNobody;
}

std::optional<bool> DrillPlace::is_incremental(std::span<const ir::Code> codes) const {
  const auto said = std::ranges::find_if(codes, is_distance);
  if (said != codes.end()) return said->function == Function::incremental;
  const facts::Facts* facts = modes_.before(index_);
  if (facts == nullptr) return std::nullopt;
  const facts::Known<facts::Setting>& fact = (*facts)[facts::Mode::distance];
  if (fact.other_origin != facts::kNobody) return std::nullopt;
  return fact.origin == facts::kNobody ? incremental_ : fact.value.function == Function::incremental;
}

// --- in the order of the text

void DrillPlace::take_block() {
  const ir::Block& block = program_.blocks[statement().payload];
  for (const ir::Code& c : program_.codes_of(block)) take_code(c);
  if (in_cycle_ || statement().skip_level != 0 || block.rest_level != 0)
    lose_position();
  else if (!facts::has_own_words(program_, block))
    take_position(block);
  take_turning(block);
}

void DrillPlace::take_code(const ir::Code& c) {
  if (c.group == ModalGroup::motion) motion_ = c.function;
  if (c.group == ModalGroup::motion || c.group == ModalGroup::cycle) in_cycle_ = c.group == ModalGroup::cycle;
  if (c.function == Function::cycle_off) in_cycle_ = false;
  if (c.group == ModalGroup::plane) plane_ = c.function;
  if (c.function == Function::absolute || c.function == Function::incremental)
    incremental_ = c.function == Function::incremental;
  if (changes_place(c)) lose_position();
}

void DrillPlace::lose_position() {
  state.height.reset();
  state.in_plane = {};
}

void DrillPlace::take_position(const ir::Block& block) {
  const std::optional<bool> incremental = is_incremental(program_.codes_of(block));
  for (const ir::Word& w : program_.words_of(block)) {
    if (w.address == Address::d || w.address == Address::t) state.height.reset();
    const bool is_absolute =
        w.mode == ir::WordMode::absolute || (w.mode == ir::WordMode::as_modal && incremental == false);
    const std::optional<double> value = is_absolute ? constant_value(program_, w.value) : std::nullopt;
    if (w.address == Address::z) state.height = value;
    if (w.address == Address::x || w.address == Address::y) state.in_plane[w.address == Address::x ? 0 : 1] = value;
    if (is_by_angle(w.address)) state.in_plane = {};
  }
}

void DrillPlace::take_turning(const ir::Block& block) {
  Turning& turning = state.turning;
  for (const ir::Code& c : program_.codes_of(block)) {
    if (c.function == Function::dwell) return;  // its F and S are times
    if (c.group == ModalGroup::feed) turning.feed_mode = c.function;
    if (c.group == ModalGroup::surface_speed) turning = {};
    if (c.function == Function::spindle_cw || c.function == Function::spindle_ccw) turning.spindle = c.function;
    if (c.function == Function::spindle_stop || c.function == Function::spindle_orient) turning.spindle.reset();
  }
  for (const ir::Word& w : program_.words_of(block)) {
    if (w.address == Address::f) turning.feed = constant_value(program_, w.value);
    if (w.address == Address::s) turning.speed = w.extension > 1 ? std::nullopt : constant_value(program_, w.value);
  }
}

// --- what is reported

void DrillPlace::warn(passes::Refusal what) {
  cannot(std::move(what));
  diagnostics_.back().severity = text::Severity::warning;
}

void DrillPlace::cannot(passes::Refusal what) {
  diagnostics_.push_back(passes::diagnose(std::move(what), statement().span, to_.title));
}

}  // namespace dripfeed::macro_b
