// Nothing is certain where no path leads.
#include "dialects/facts/in_effect.h"

namespace dripfeed::facts {

void InEffect::at(std::uint32_t statement) {
  here_ = facts_.before(statement);
  statement_ = statement;
  taken_.reset();
}

void InEffect::take(const ir::Code& code) {
  const std::optional<Mode> mode = mode_of(code);
  if (!mode) return;
  const std::size_t m = index_of(*mode);
  taken_[m] = true;
  own_[m] = {.function = code.function, .argument = code.argument};
  own_spans_[m] = code.span;
}

std::optional<Setting> InEffect::certain(Mode mode) const {
  if (is_stated_here(mode)) return own_[index_of(mode)];
  if (here_ == nullptr || !is_known((*here_)[mode])) return std::nullopt;
  return (*here_)[mode].value;
}

std::optional<Setting> InEffect::stated(Mode mode) const {
  if (is_stated_here(mode)) return own_[index_of(mode)];
  const bool in_text = here_ != nullptr && (*here_)[mode].origin < program_.statements.size();
  return in_text ? certain(mode) : std::nullopt;
}

std::optional<Setting> InEffect::agreed(Mode mode) const {
  if (is_stated_here(mode)) return own_[index_of(mode)];
  if (here_ == nullptr || !(*here_)[mode].agrees()) return std::nullopt;
  return (*here_)[mode].value;
}

std::uint32_t InEffect::origin(Mode mode) const {
  if (is_stated_here(mode)) return statement_;
  return certain(mode) ? (*here_)[mode].origin : kNoStatement;
}

text::Span InEffect::span(Mode mode) const {
  if (is_stated_here(mode)) return own_spans_[index_of(mode)];
  if (!stated(mode)) return {};
  const ir::Statement& s = program_.statements[(*here_)[mode].origin];
  if (s.kind != ir::StatementKind::block) return {};
  text::Span found;
  for (const ir::Code& code : program_.codes_of(program_.blocks[s.payload]))
    if (mode_of(code) == mode) found = code.span;
  return found;
}

State InEffect::state_against(Mode mode, ir::Function off) const {
  const std::optional<Setting> setting = certain(mode);
  if (!setting) return State::uncertain;
  return setting->function == off ? State::off : State::on;
}

bool InEffect::may_be_unstated(Mode mode) const {
  return !is_stated_here(mode) && here_ != nullptr && begins_ && (*here_)[mode].may_be_unstated();
}

const Written* InEffect::certain(Kept word) const {
  return here_ != nullptr && is_known((*here_)[word]) ? &(*here_)[word].value : nullptr;
}

bool InEffect::lacks(Kept word) const {
  const Written* written = certain(word);
  return written != nullptr && !written->is_stated;
}

bool InEffect::lacks(Number number) const {
  if (here_ == nullptr || !begins_) return false;
  const Known<double>& fact = (*here_)[number];
  return fact.origin == kNoStatement && fact.may_be_unstated();
}

std::uint32_t InEffect::origin(Kept word) const {
  return certain(word) != nullptr ? (*here_)[word].origin : kNoStatement;
}

}  // namespace dripfeed::facts
