// Nothing is certain where no path leads.
#include "dialects/macro_b/validator/in_effect.h"

#include "dialects/macro_b/validator/findings.h"

namespace dripfeed::macro_b {

std::optional<facts::Setting> InEffect::certain(facts::Mode mode) const {
  const facts::Setting* setting = here_ == nullptr ? nullptr : (*here_)[mode].certain();
  return setting == nullptr ? std::nullopt : std::optional(*setting);
}

std::optional<facts::Setting> InEffect::stated(facts::Mode mode) const {
  const bool in_text = here_ != nullptr && (*here_)[mode].origin < program_.statements.size();
  return in_text ? certain(mode) : std::nullopt;
}

std::string_view InEffect::written(facts::Mode mode) const {
  if (!stated(mode)) return {};
  const ir::Statement& s = program_.statements[(*here_)[mode].origin];
  if (s.kind != ir::StatementKind::block) return {};
  std::string_view found;
  for (const ir::Code& code : program_.codes_of(program_.blocks[s.payload]))
    if (facts::mode_of(code) == mode) found = text_of(program_, code.span);
  return found;
}

State InEffect::beside(facts::Mode mode, ir::Function off) const {
  const std::optional<facts::Setting> setting = certain(mode);
  if (!setting) return State::uncertain;
  return setting->function == off ? State::off : State::on;
}

bool InEffect::lacks_feed() const {
  if (here_ == nullptr) return false;
  const facts::Written* feed = (*here_)[facts::Kept::feed].certain();
  return feed != nullptr && !feed->is_stated;
}

}  // namespace dripfeed::macro_b
