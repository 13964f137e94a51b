// Every block says its motion code, so that none depends on the one before it.
#include "dialects/compile/translate/plain_moves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "dialects/compile/dialect/motion_codes.h"

namespace dripfeed::compile {

namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;
using ir::MotionKind;

// Events that come of a code or word of the block itself, which stays.
struct EventRow {
  MotionKind kind;
  ModalGroup group;
  Address word;
};
constexpr auto kEvents = std::to_array<EventRow>({
    {MotionKind::spindle, ModalGroup::spindle, Address::s},
    {MotionKind::coolant, ModalGroup::coolant, Address::other},
    {MotionKind::tool, ModalGroup::none, Address::t},
    {MotionKind::comp, ModalGroup::comp, Address::other},
});

bool is_length(std::size_t axis) { return axis < 3 || axis > 5; }

std::unexpected<std::string> cannot(std::string_view what) { return std::unexpected(std::string(what)); }

}  // namespace

ir::Code motion_code(Function function) { return code_of(function, ModalGroup::motion); }

double PlainMoves::rounded(double value_mm) const {
  const double places = std::pow(10.0, terms_.decimals) * (terms_.unit_mm == 1.0 ? 1.0 : 10.0);
  return std::nearbyint(value_mm / terms_.unit_mm * places) / places + 0.0;
}

ir::Word PlainMoves::position(std::size_t axis, double value) {
  const double places = std::pow(10.0, terms_.decimals);
  const double scaled = axis == 0 ? value * terms_.x_scale : value;
  const double stated = is_length(axis) ? rounded(scaled) : std::nearbyint(scaled * places) / places + 0.0;
  ir::Word made = ir::word(kAxisAddresses[axis], program_.add_constant(stated));
  made.mode = terms_.mode;
  return made;
}

ir::Word PlainMoves::feed_word(double feed) {
  const double unit = terms_.feed_mode == ir::FeedMode::inverse_time ? 1.0 : terms_.unit_mm;
  return ir::word(Address::f, program_.add_constant(feed / unit));
}

std::expected<void, std::string> PlainMoves::write(std::span<const ir::Motion> motions, BlockRest rest) {
  if (!rest.before.empty()) out_.emit_block(std::exchange(rest.before, {}), {});
  for (const ir::Motion& motion : motions) {
    const auto done = ir::is_move(motion.kind) ? move(motion, rest) : event(motion, rest);
    if (!done) return done;
  }
  if (comp_ != Function::none) return cannot("a compensation that changes after its last move");
  flush(rest);
  if (!rest.after.empty()) out_.emit_block(rest.after, {});
  return {};
}

// What waited for a move that does not come.
void PlainMoves::flush(BlockRest& rest) {
  if (rest.codes.empty() && rest.words.empty()) return;
  out_.emit_block(std::exchange(rest.codes, {}), std::exchange(rest.words, {}));
}

std::expected<void, std::string> PlainMoves::event(const ir::Motion& motion, const BlockRest& rest) {
  if (motion.kind == MotionKind::dwell) {
    dwell(motion.feed);
    return {};
  }
  const auto row = std::ranges::find(kEvents, motion.kind, &EventRow::kind);
  if (row == kEvents.end()) return cannot("an event within it");
  const auto of_group = [&](const ir::Code& c) { return c.group == row->group && row->group != ModalGroup::none; };
  const bool stated = std::ranges::any_of(rest.codes, of_group) || std::ranges::any_of(rest.after, of_group) ||
                      std::ranges::any_of(rest.words, [&](const ir::Word& w) { return w.address == row->word; });
  if (stated) return {};
  if (motion.kind == MotionKind::comp) {
    comp_ = function_of(motion.comp);
    return {};
  }
  // A spindle that is stopped, oriented or turned back at the bottom of a hole: plain blocks would not wait for it.
  return cannot(motion.kind == MotionKind::spindle ? "a spindle that stops or turns back within it"
                                                   : "a change of tool or coolant within it");
}

void PlainMoves::dwell(double seconds) {
  const double value = terms_.dwell_p_is_ms ? seconds * 1000.0 : seconds;
  out_.emit_block({code_of(Function::dwell, ModalGroup::non_modal)},
                  {ir::word(terms_.dwell_p_is_ms ? Address::p : Address::f, program_.add_constant(value))});
}

std::expected<void, std::string> PlainMoves::move(const ir::Motion& motion, BlockRest& rest) {
  const std::optional<Function> function = plain_function_of(motion.kind);
  if (!function) return cannot("a thread within it");
  if (motion.machine_coordinates || (motion.gaps & ir::kEndUnknown) != 0)
    return cannot("a position that is not known here");
  const bool arc = is_arc(motion.kind);
  const bool feeds = motion.kind != MotionKind::rapid;
  if (arc && motion.plane != terms_.plane) return cannot("an arc in another plane");
  if (feeds && motion.feed_mode != terms_.feed_mode) return cannot("another kind of feed within it");
  std::vector<ir::Code> codes = {motion_code(*function)};
  codes.insert(codes.end(), rest.codes.begin(), rest.codes.end());
  rest.codes.clear();
  if (const Function comp = std::exchange(comp_, Function::none); comp != Function::none)
    codes.push_back(code_of(comp, ModalGroup::comp));
  std::vector<ir::Word> words;
  for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) {
    const bool named = (axes_to_name(motion) & (1U << axis)) != 0;
    if (named || (arc && is_in_plane(motion.plane, axis))) words.push_back(position(axis, motion.end[axis]));
  }
  for (std::size_t axis = 0; arc && axis < kCenterAddresses.size(); ++axis)
    if (is_in_plane(motion.plane, axis))
      words.push_back(ir::word(kCenterAddresses[axis], program_.add_constant(rounded(motion.center[axis]))));
  if (feeds && feed_ != motion.feed) words.push_back(feed_word(motion.feed));
  if (feeds) feed_ = motion.feed;
  words.insert(words.end(), rest.words.begin(), rest.words.end());
  rest.words.clear();
  out_.emit_block(codes, words);
  return {};
}

}  // namespace dripfeed::compile
