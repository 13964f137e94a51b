// One variable of a program by its name, and the statements that set or read it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

class NativeVariable {
 public:
  // `name` in upper case: "#100", "R10", "DIA". Nothing where the control has no such kind of variable.
  static std::optional<NativeVariable> named(const ir::Program& program, const ir::Control& control,
                                             std::string_view name);
  // A parameter of a program of the text.
  static NativeVariable of_symbol(ir::SymbolId symbol);

  [[nodiscard]] bool is(const ir::Program& program, ir::VariableId variable) const;
  [[nodiscard]] ir::Bank bank() const { return bank_; }
  [[nodiscard]] std::uint32_t number() const { return number_; }
  [[nodiscard]] const std::vector<ir::SymbolId>& symbols() const { return symbols_; }

  // As uses of it are written.
  [[nodiscard]] std::vector<ir::Variable> uses() const;

  struct Setting {
    std::uint32_t statement = 0;
    ir::ExpressionId value = ir::ExpressionId::none;  // none: set otherwise, by a loop or through a reference
    bool is_integer = false;                          // DEF INT
  };
  // In the order of the text.
  [[nodiscard]] std::vector<Setting> settings(const ir::Program& program) const;
  [[nodiscard]] bool is_read_by(const ir::Program& program, std::uint32_t statement) const;

 private:
  [[nodiscard]] bool is_passed_back(const ir::Program& program, const ir::Statement& call) const;

  ir::Bank bank_ = ir::Bank::named;
  std::uint32_t number_ = 0;
  std::vector<ir::SymbolId> symbols_;  // bank named: those that are one variable
};

// The head of a program of the text, by the name that calls have; nullptr when it is not there.
const ir::Structure* procedure_named(const ir::Program& program, ir::StringId name);

}  // namespace dripfeed::compile
