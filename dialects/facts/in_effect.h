// What is in effect before a statement, as checks ask for it: what all paths agree on, what a block of the text has
// stated, what only the state of the machine decides.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <string_view>

#include "dialects/facts/resolved.h"
#include "dialects/ir/program.h"

namespace dripfeed::facts {

// Whether something is in effect.
enum class State : std::uint8_t { off, on, uncertain };

class InEffect {
 public:
  // `begins`: the text begins where the control does, so that what it has at power-on holds until something states
  // another. Both must outlive it.
  InEffect(const ir::Program& program, const Resolved& facts, bool begins = true)
      : program_(program), facts_(facts), begins_(begins) {}

  // On to the statement.
  void at(std::uint32_t statement);
  // A code of the block there takes effect: what it states holds from now on.
  void take(const ir::Code& code);

  // nullptr where no path leads.
  [[nodiscard]] const Facts* here() const { return here_; }

  // Where all paths agree, by a block of the text or at power-on.
  [[nodiscard]] std::optional<Setting> certain(Mode mode) const;
  // … by a block of the text.
  [[nodiscard]] std::optional<Setting> stated(Mode mode) const;
  // … whatever a called program may have made of it.
  [[nodiscard]] std::optional<Setting> agreed(Mode mode) const;
  // The statement that set it, or kPowerOn; kNobody where that is not certain.
  [[nodiscard]] std::uint32_t origin(Mode mode) const;
  [[nodiscard]] bool is_stated_here(Mode mode) const { return taken_[index_of(mode)]; }
  // The code that stated it; an empty span where none did.
  [[nodiscard]] text::Span span(Mode mode) const;
  // … as it is written.
  [[nodiscard]] std::string_view written(Mode mode) const { return span(mode).in(program_.source.text()); }
  // off: certainly the function; on: certainly another.
  [[nodiscard]] State state_against(Mode mode, ir::Function off) const;
  // On some path the machine's state decides.
  [[nodiscard]] bool may_be_unstated(Mode mode) const;

  // nullptr where paths disagree, or something unknown may have changed it.
  [[nodiscard]] const Written* certain(Kept word) const;
  // No path has stated it.
  [[nodiscard]] bool lacks(Kept word) const;
  [[nodiscard]] bool lacks(Number number) const;
  // The statement that wrote it; kNobody where that is not certain.
  [[nodiscard]] std::uint32_t origin(Kept word) const;

 private:
  template <class T>
  [[nodiscard]] bool is_known(const Known<T>& fact) const {
    return fact.is_certain() && (begins_ || fact.origin != kPowerOn);
  }

  const ir::Program& program_;
  const Resolved& facts_;
  bool begins_;
  const Facts* here_ = nullptr;  // nullptr: no path leads there
  std::uint32_t statement_ = ir::kNoIndex;
  // By the block's own codes.
  std::bitset<kModes> taken_;
  std::array<Setting, kModes> own_;
  std::array<text::Span, kModes> own_spans_;
};

}  // namespace dripfeed::facts
