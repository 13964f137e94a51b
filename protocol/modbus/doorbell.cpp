// The doorbell's table, one cell for every state and input, and the registers of the answer.
#include "protocol/modbus/doorbell.h"

namespace dripfeed::modbus {
namespace {

using A = BellAction;
using S = BellState;

constexpr BellCell kNever{A::never, S::unmet};
// One row a state, one cell an input, both in the order of the enums.
constexpr std::array<std::array<BellCell, kBellInputs>, kBellStates> kTable{{
    // unmet
    {{kNever, kNever, {A::note, S::quiet}, {A::note, S::checking}, kNever, kNever, {A::none, S::unmet}, kNever}},
    // checking
    {{{A::none, S::checking},
      {A::note, S::checking},
      {A::note, S::quiet},
      {A::note, S::checking},
      {A::none, S::quiet},
      {A::miss, S::answering},
      {A::none, S::checking},
      kNever}},
    // quiet
    {{{A::none, S::quiet},
      {A::note, S::rung},
      {A::note, S::quiet},
      {A::note, S::checking},
      kNever,
      kNever,
      {A::none, S::quiet},
      kNever}},
    // rung
    {{{A::none, S::rung},
      {A::note, S::rung},
      {A::note, S::quiet},
      {A::note, S::checking},
      kNever,
      kNever,
      {A::keep, S::answering},
      kNever}},
    // answering
    {{{A::none, S::answering},
      {A::note, S::rung},
      {A::note, S::quiet},
      {A::note, S::checking},
      kNever,
      kNever,
      {A::none, S::answering},
      {A::none, S::quiet}}},
}};

constexpr std::array<std::string_view, 7> kRequestNames{"nothing", "load", "drip", "cancel", "call", "parts", "scrap"};
constexpr std::array<std::string_view, 5> kOutcomeNames{"none", "answered", "armed", "queued", "refused"};
constexpr std::array<std::string_view, 9> kReasonNames{
    "none", "not found", "for DNC only", "protected", "not allowed", "busy", "missed", "unknown request", "no order"};

constexpr std::size_t kAnswerCrc = 5;

}  // namespace

BellCell cell(BellState state, BellInput input) {
  return kTable[static_cast<std::size_t>(state)][static_cast<std::size_t>(input)];
}

std::string_view name(BellRequest request) { return kRequestNames[static_cast<std::size_t>(request)]; }
std::string_view name(BellOutcome outcome) { return kOutcomeNames[static_cast<std::size_t>(outcome)]; }
std::string_view name(BellReason reason) { return kReasonNames[static_cast<std::size_t>(reason)]; }

void encode(const BellAnswer& answer, AnswerImage& out) {
  out = {answer.bell, static_cast<std::uint16_t>(answer.outcome), static_cast<std::uint16_t>(answer.reason),
         static_cast<std::uint16_t>(answer.job >> 16U), static_cast<std::uint16_t>(answer.job & 0xFFFFU)};
  const std::uint32_t crc = crc32(0, std::span<const std::uint16_t>(out).first(kAnswerCrc));
  out[kAnswerCrc] = static_cast<std::uint16_t>(crc >> 16U);
  out[kAnswerCrc + 1] = static_cast<std::uint16_t>(crc & 0xFFFFU);
}

std::optional<std::uint16_t> answered_bell(std::span<const std::uint16_t> registers) {
  if (registers.size() < kAnswerRegisters) return std::nullopt;
  const std::uint32_t crc = (std::uint32_t{registers[kAnswerCrc]} << 16U) | registers[kAnswerCrc + 1];
  if (crc != crc32(0, registers.first(kAnswerCrc))) return std::nullopt;
  return registers[0];
}

BellInput Doorbell::judge(std::uint16_t boot_counter, const MachineWords& words, Time now) const {
  if (words.bell == 0) return BellInput::zero;
  const bool met = state_ != BellState::unmet && boot_counter == boot_;
  if (met && words.bell == ring_.bell) return BellInput::same;
  return met && now - seen_at_ <= kFresh ? BellInput::rang : BellInput::strange;
}

void Doorbell::seen(std::uint16_t boot_counter, const MachineWords& words, Time now) {
  const BellInput input = judge(boot_counter, words, now);
  seen_ = {.bell = words.bell, .request = words.request, .program = words.requested};
  boot_ = boot_counter;
  seen_at_ = now;
  react(input);
}

std::optional<Ring> Doorbell::take_ring() {
  if (state_ != BellState::rung || is_reported_) return std::nullopt;
  is_reported_ = true;
  return ring_;
}

void Doorbell::answer(const BellAnswer& answer) {
  if (answer.bell != ring_.bell) return;
  given_ = answer;
  react(BellInput::decided);
}

Doorbell::Want Doorbell::want() const {
  if (state_ == BellState::checking) return Want::read_answer;
  return state_ == BellState::answering ? Want::write_answer : Want::nothing;
}

void Doorbell::answer_read(std::span<const std::uint16_t> registers) {
  if (state_ != BellState::checking) return;
  react(answered_bell(registers) == ring_.bell ? BellInput::shown : BellInput::differs);
}

AnswerImage Doorbell::image() const {
  AnswerImage image{};
  encode(answer_, image);
  return image;
}

void Doorbell::answer_written() {
  if (state_ == BellState::answering) react(BellInput::written);
}

void Doorbell::react(BellInput input) {
  const BellCell next = cell(state_, input);
  if (cell_taken_ != nullptr) cell_taken_(cell_context_, state_, input);
  switch (next.action) {
    case BellAction::never:
    case BellAction::none: break;
    case BellAction::note:
      ring_ = seen_;
      is_reported_ = false;
      break;
    case BellAction::miss:
      answer_ = {.bell = ring_.bell, .outcome = BellOutcome::refused, .reason = BellReason::missed};
      break;
    case BellAction::keep: answer_ = given_; break;
  }
  state_ = next.to;
}

}  // namespace dripfeed::modbus
