// Values of a cycle become words where it is written; taps end before a path that may come back to them.
#include "dialects/family/drill_writer.h"

#include <algorithm>
#include <cmath>

#include "dialects/family/evaluate.h"
#include "dialects/ir/cycle.h"

namespace dripfeed::family {

namespace {

using ir::Address;
using ir::ExpressionId;
using ir::Function;

constexpr double kMillisecondsPerSecond = 1000.0;

bool opens(StepKind kind) {
  return kind == StepKind::for_begin || kind == StepKind::for_in_begin || kind == StepKind::while_begin ||
         kind == StepKind::if_begin;
}

std::string_view stem_of(Address address) {
  if (address == Address::r) return "hole_top";
  return address == Address::z ? "hole_bottom" : "peck_depth";
}

}  // namespace

bool DrillWriter::taps() const { return step_ != nullptr && begins_taps(*step_); }

void DrillWriter::begin(const Step& step) {
  step_ = &step;
  words_.clear();
  is_in_effect_ = false;
  depth_ = 0;
  for (std::uint32_t i = 0; i < step.word_count; ++i) {
    const StepWord& word = bound_.family->words[step.first_word + i];
    ValueWriter::Bound value;
    if (is_number_of_cycle(word.address))
      value.value = evaluate(bound_.family->arena, word.value, bound_.values).value;
    else
      value = values_.bound(word.value, stem_of(word.address));
    words_.emplace_back(word.address, value);
  }
  if (step.values[0] != ExpressionId::none) return_level_ = values_.bound(step.values[0], "hole_return");
}

// In the order in which people write them.
std::vector<EmittedWord> DrillWriter::cycle_words() {
  std::vector<EmittedWord> out;
  for (const Address address : {Address::z, Address::r, Address::q, Address::p, Address::f}) {
    const auto word = std::ranges::find(words_, address, &std::pair<Address, ValueWriter::Bound>::first);
    if (word == words_.end()) continue;
    const ValueWriter::Bound& value = word->second;
    const bool is_dwell = address == Address::p;
    out.push_back(
        {address, is_dwell ? values_.whole(std::round(value.value * kMillisecondsPerSecond)) : values_.say(value)});
  }
  return out;
}

void DrillWriter::hole(std::vector<EmittedWord> place, const std::vector<EmittedWord>& feed) {
  std::vector<EmittedCode> codes;
  if (!is_in_effect_) {
    if (taps()) codes.push_back({Function::feed_per_rev});
    codes.push_back({step_->values[0] == ExpressionId::none ? Function::return_to_r : Function::return_to_initial});
    codes.push_back({Function::drill, static_cast<std::int16_t>(step_->number)});
    for (const EmittedWord& word : cycle_words()) place.push_back(word);
  }
  place.insert(place.end(), feed.begin(), feed.end());
  emit_.block(codes, place);
  is_in_effect_ = true;
  // The word that makes a tap rigid must not come while one is in effect (Fanuc M29).
  if (taps() && depth_ > 0) cancel();
}

void DrillWriter::fork(StepKind kind) {
  if (taps() && is_in_effect_) cancel();
  is_in_effect_ = false;
  if (opens(kind)) ++depth_;
  if (kind != StepKind::if_else && !opens(kind)) --depth_;
}

void DrillWriter::end() {
  if (!taps() || is_in_effect_) cancel();
  step_ = nullptr;
}

void DrillWriter::cancel() {
  emit_.block({Function::rapid, Function::cycle_off}, {});
  is_in_effect_ = false;
}

}  // namespace dripfeed::family
