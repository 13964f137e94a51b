// What is in effect before a statement, as the checks ask facts for it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "dialects/facts/resolved.h"
#include "dialects/ir/program.h"

namespace dripfeed::macro_b {

// Whether something is in effect.
enum class State : std::uint8_t { off, on, uncertain };

class InEffect {
 public:
  // Both must outlive it.
  InEffect(const ir::Program& program, const facts::Resolved& facts) : program_(program), facts_(facts) {}

  // On to the statement.
  void at(std::uint32_t statement) { here_ = facts_.before(statement); }

  // Where all paths agree, by a block of the text or at power-on.
  [[nodiscard]] std::optional<facts::Setting> certain(facts::Mode mode) const;
  // … by a block of the text.
  [[nodiscard]] std::optional<facts::Setting> stated(facts::Mode mode) const;
  // The code that stated it, as it is written.
  [[nodiscard]] std::string_view written(facts::Mode mode) const;
  // off: certainly the function; on: certainly another.
  [[nodiscard]] State beside(facts::Mode mode, ir::Function off) const;
  // No F was given on any path.
  [[nodiscard]] bool lacks_feed() const;

 private:
  const ir::Program& program_;
  const facts::Resolved& facts_;
  const facts::Facts* here_ = nullptr;  // nullptr: no path leads there
};

}  // namespace dripfeed::macro_b
