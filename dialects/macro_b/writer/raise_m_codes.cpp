// Several M functions of a block: one of them stays, the others get blocks of their own around it.
#include <algorithm>
#include <iterator>
#include <optional>

#include "dialects/macro_b/writer/raise_block.h"

namespace dripfeed::macro_b {

using ir::Address;
using ir::Function;

// One M code a block: the others follow in blocks of their own. Of a block that moves, what starts the spindle or the
// coolant comes before it, unless it also stops one.
void BlockRaiser::split_m_codes() {
  const auto turns = [](const ir::Code& c) {
    return c.function == Function::spindle_cw || c.function == Function::spindle_ccw;
  };
  const auto starts = [&](const ir::Code& c) {
    return turns(c) || c.function == Function::coolant_mist || c.function == Function::coolant_flood;
  };
  const auto stops = [](const ir::Code& c) {
    return c.function == Function::spindle_stop || c.function == Function::coolant_off;
  };
  const auto is_m = [](const ir::Code& c) { return c.letter == 'M'; };
  const bool in_front =
      std::ranges::any_of(draft_.words, ir::is_axis, &ir::Word::address) && std::ranges::none_of(draft_.codes, stops);
  // M0 and M1 hold when all else is done.
  const auto holds_program = [](const ir::Code& c) {
    return c.function == Function::program_stop || c.function == Function::optional_stop;
  };
  std::ranges::stable_sort(draft_.codes, {}, holds_program);
  // The last one that starts something stays with the move, those ahead of it go in front: the spindle with its S.
  auto kept = draft_.codes.end();
  for (auto code = draft_.codes.begin(); in_front && code != draft_.codes.end(); ++code)
    if (starts(*code)) kept = code;
  if (kept == draft_.codes.end()) kept = std::ranges::find_if(draft_.codes, is_m);
  std::vector<ir::Code> codes;
  std::vector<Draft> last;
  std::optional<std::size_t> turn_in_front;
  for (auto code = draft_.codes.begin(); code != draft_.codes.end(); ++code) {
    if (code == kept || !is_m(*code)) {
      codes.push_back(*code);
    } else if (in_front && starts(*code)) {
      before_.push_back({{*code}, {}});
      if (turns(*code)) turn_in_front = before_.size() - 1;
    } else {
      last.push_back({{*code}, {}});
    }
  }
  draft_.codes = std::move(codes);
  if (turn_in_front) write_speed(before_[*turn_in_front]);
  after_.insert(after_.begin(), last.begin(), last.end());
}

// S goes with the spindle, and with S what it counts: G96 or G97, with the axis (P) of G96.
void BlockRaiser::write_speed(Draft& turn) {
  const auto counts_speed = [](const ir::Code& c) {
    return c.function == Function::surface_speed_on || c.function == Function::surface_speed_off;
  };
  const bool counts = std::ranges::any_of(draft_.codes, counts_speed);
  std::ranges::copy_if(draft_.codes, std::inserter(turn.codes, turn.codes.begin()), counts_speed);
  std::erase_if(draft_.codes, counts_speed);
  move_words(Address::s, draft_, turn);
  if (counts) move_words(Address::p, draft_, turn);
}

void BlockRaiser::move_words(Address address, Draft& from, Draft& to) {
  const auto is_one = [address](const ir::Word& w) { return w.address == address; };
  std::ranges::copy_if(from.words, std::back_inserter(to.words), is_one);
  std::erase_if(from.words, is_one);
}

}  // namespace dripfeed::macro_b
