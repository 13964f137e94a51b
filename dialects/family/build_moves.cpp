// Moves and holes, and the feed and the compensation that wait for them.
#include <algorithm>
#include <utility>

#include "dialects/family/builder.h"

namespace dripfeed::family {

using ir::ExpressionId;
using ir::Function;
using ir::Operator;

std::vector<EmittedWord> Builder::words(const Step& step) {
  std::vector<EmittedWord> out;
  for (std::uint32_t i = 0; i < step.word_count; ++i) {
    const StepWord& word = family_.words[step.first_word + i];
    out.push_back(
        {word.address, values_.copy(word.value), word.is_step ? ir::WordMode::incremental : ir::WordMode::as_modal});
  }
  return out;
}

void Builder::move(Function motion, const Step& step) {
  std::vector<EmittedWord> to = words(step);  // may make statements of its own
  if (motion != Function::rapid) take_feed(to);
  std::vector<EmittedCode> codes;
  if (compensation_ != Function::none) codes.push_back({std::exchange(compensation_, Function::none)});
  take_motion(motion, codes);
  emit_.block(codes, to);
}

void Builder::arc(Function motion, const Step& step) {
  std::vector<EmittedWord> to = words(step);
  take_feed(to);
  std::vector<EmittedCode> codes;
  take_motion(motion, codes);
  emit_.block(codes, to);
}

void Builder::thread(const Step& step) {
  const std::vector<EmittedWord> to = words(step);
  std::vector<EmittedCode> codes;
  take_motion(Function::thread, codes);
  emit_.block(codes, to);
  feed_ = last_feed_;
}

void Builder::take_motion(Function motion, std::vector<EmittedCode>& codes) {
  if (std::exchange(motion_, motion) != motion) codes.push_back({motion});
}

void Builder::drill_begin(const Step& step) {
  drill_.begin(step);
  if (drill_.taps()) feed_ = nullptr;  // stated after the tap
  if (step.values[0] == ExpressionId::none) return;
  std::vector<EmittedCode> codes;
  take_motion(Function::rapid, codes);
  const std::vector<EmittedWord> to = {{ir::Address::z, values_.say(drill_.return_level())}};
  emit_.block(codes, to);
}

void Builder::hole(const Step& step) {
  std::vector<EmittedWord> to = words(step);
  std::vector<EmittedWord> feed;
  if (!drill_.taps()) take_feed(feed);
  drill_.hole(std::move(to), feed);
}

void Builder::drill_end() {
  const bool taps = drill_.taps();
  drill_.end();
  motion_ = Function::none;
  if (!taps) return;
  const bool per_rev = sets(StepKind::feed, kFeedPerRev);
  std::vector<EmittedWord> words;
  if (last_feed_ != nullptr) words.push_back({ir::Address::f, say_feed(*last_feed_)});
  feed_ = nullptr;
  if (!per_rev)
    emit_.block({Function::feed_per_min}, words);
  else if (!words.empty())
    emit_.block(std::span<const EmittedCode>(), words);
}

void Builder::feed(const Step& step) {
  write_feed();
  if (step.number == kFeedBefore) {
    feed_ = last_feed_;
  } else {
    feed_ = &step;
    if (step.number == 0) {
      if (feed_now_ != ir::SymbolId::none) values_.assign(feed_now_, step.values[0]);
      last_feed_ = &step;
    }
  }
  if (!has_one_feed_mode_) write_feed();
}

void Builder::take_feed(std::vector<EmittedWord>& words) {
  if (feed_ != nullptr) words.push_back({ir::Address::f, say_feed(*std::exchange(feed_, nullptr))});
}

bool Builder::keeps_feed() const {
  const auto passes = [](const Step& one) { return one.kind == StepKind::feed && one.number != 0; };
  if (std::ranges::none_of(family_.steps, takes_feed_away) && std::ranges::none_of(family_.steps, passes)) return false;
  const auto is_feed = [](const Step& one) { return one.kind == StepKind::feed && one.number == 0; };
  const auto first = std::ranges::find_if(family_.steps, is_feed);
  return first != family_.steps.end() &&
         (std::ranges::count_if(family_.steps, is_feed) > 1 || !is_declared(first->values[0]));
}

bool Builder::is_declared(ExpressionId id) const {
  const ir::Expression& e = family_.arena.at(id);
  if (e.op == Operator::constant) return true;
  if (e.op != Operator::variable || family_.arena.at(e.variable).index != ExpressionId::none) return false;
  const ir::SymbolId symbol = family_.arena.at(e.variable).symbol;
  return std::ranges::find(family_.parameters, symbol, &Parameter::symbol) != family_.parameters.end() ||
         std::ranges::find(family_.definitions, symbol, &Definition::symbol) != family_.definitions.end();
}

ExpressionId Builder::say_feed(const Step& step) {
  const bool is_kept = feed_now_ != ir::SymbolId::none && step.number == 0;
  return is_kept ? emit_.variable(feed_now_) : values_.copy(step.values[0]);
}

void Builder::write_feed() {
  if (feed_ == nullptr) return;
  const Step& step = *std::exchange(feed_, nullptr);
  const std::vector<EmittedWord> value = {{ir::Address::f, say_feed(step)}};
  if (has_one_feed_mode_) return emit_.block(std::span<const EmittedCode>(), value);
  emit_.block({step.dimension == kFeedPerRev ? Function::feed_per_rev : Function::feed_per_min}, value);
}

void Builder::write_compensation() {
  if (compensation_ != Function::none) emit_.block({std::exchange(compensation_, Function::none)}, {});
}

}  // namespace dripfeed::family
