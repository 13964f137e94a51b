// The unit in which a native program writes a quantity: lengths and feeds by what is in effect where the number stands.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dialects/compile/native/variable_quantities.h"
#include "dialects/facts/resolved.h"
#include "dialects/family/unit.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

struct NativeUnit {
  std::optional<double> factor;                // stored units in one of the program's
  std::string why;                             // without one: why it is not known, or the same everywhere
  std::vector<std::uint32_t> statements = {};  // that show it
};

class NativeUnits {
 public:
  // All three must outlive it.
  NativeUnits(const ir::Program& program, const ir::Control& control, const facts::Resolved& resolved)
      : program_(program), control_(control), resolved_(resolved) {}

  // Of a number that stands in `statement` and is taken by the words `uses`, whose unit counts: where the number stands
  // another one may be in effect, and then it is an error. `written` is the unit of the default, in which times are
  // written, because seconds and milliseconds depend on the word that takes them.
  [[nodiscard]] NativeUnit of(family::Dimension dimension, const family::Unit* written, std::uint32_t statement,
                              const std::vector<WordUse>& uses) const;

 private:
  struct UseUnits;
  // Whether lengths, or feeds and surface speeds, are in inches there; nothing where it is not known.
  [[nodiscard]] std::optional<bool> inches(std::uint32_t statement, bool of_feeds) const;
  [[nodiscard]] UseUnits units_of(const std::vector<WordUse>& uses) const;
  [[nodiscard]] std::optional<NativeUnit> mixed(std::uint32_t statement, const UseUnits& uses, bool of_feeds) const;
  [[nodiscard]] std::optional<facts::Setting> stated(std::uint32_t statement) const;

  const ir::Program& program_;
  const ir::Control& control_;
  const facts::Resolved& resolved_;
};

}  // namespace dripfeed::compile
