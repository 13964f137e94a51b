// Statement by statement; what cannot be looked into counts for what it may do.
#include "dialects/compile/native/native_other_uses.h"

#include <algorithm>
#include <optional>

#include "dialects/compile/native/native_mention.h"
#include "dialects/facts/calls.h"
#include "dialects/ir/sections.h"
#include "dialects/passes/walk.h"
#include "dialects/sinumerik/reader/declared_programs.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;

class Search {
 public:
  Search(const ir::Program& program, const NativeVariable& variable, std::string_view target, SeenBy seen_by)
      : program_(program), variable_(variable), target_(target), seen_by_(seen_by) {}

  OtherUses run(const std::vector<bool>& scope) {
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i)
      if (scope[i]) look_at(i);
    return std::move(out_);
  }

 private:
  void look_at(std::uint32_t i) {
    const ir::Statement& s = program_.statements[i];
    if (s.kind == StatementKind::native) return native(i);
    if (s.kind == StatementKind::execute_text) return executed_text(i);
    if (facts::is_call(s.kind) && is_elsewhere(i)) out_.calls.push_back(i);
    if (facts::is_call(s.kind) && variable_.bank() != ir::Bank::hash) external_call(i);
    bool reads = false;
    bool writes = false;
    for (const passes::VariableUseAt& use : passes::variables_of(program_, s))
      if (may_be(program_.at(use.variable))) (use.set ? writes : reads) = true;
    if (reads) out_.reads.push_back(i);
    if (writes) out_.writes.push_back(i);
  }

  // A number of the same bank that is computed.
  [[nodiscard]] bool may_be(const ir::Variable& v) const {
    if (v.bank != variable_.bank() || v.bank == ir::Bank::named || v.bank == ir::Bank::system) return false;
    return v.index != ir::ExpressionId::none && program_.at(v.index).op != ir::Operator::constant;
  }

  void native(std::uint32_t i) {
    const Mention mention = mention_of(program_.statements[i].span.in(program_.source.text()), target_);
    if (mention == Mention::sets) out_.actions.push_back(i);
    if (mention != Mention::reads) return;
    const bool returned = is_given_back(program_.statements[i].span.in(program_.source.text()), target_);
    (returned ? out_.returns : out_.reads).push_back(i);
  }

  // A call that hands the variable itself to a program which is not here: EXTERN says whether that gives it back; where
  // it does not, is not known.
  void external_call(std::uint32_t i) {
    const ir::Call& call = program_.calls[program_.statements[i].payload];
    if (call.name == ir::StringId::none || facts::is_standard_cycle(program_, program_.statements[i]) ||
        procedure_named(program_, call.name) != nullptr)
      return;
    const auto declared = declaration_of(program_.strings.at(call.name));
    for (std::uint32_t k = 0; k < call.argument_count; ++k) {
      const ir::ExpressionId value = program_.arguments[call.first_argument + k].value;
      if (value == ir::ExpressionId::none || program_.at(value).op != ir::Operator::variable ||
          !variable_.is(program_, program_.at(value).variable))
        continue;
      if (!declared && variable_.bank() == ir::Bank::named)
        out_.calls.push_back(i);
      else if (declared && k < declared->parameters.size() && declared->parameters[k].by_reference)
        out_.returns.push_back(i);
    }
  }

  [[nodiscard]] std::optional<sinumerik::DeclaredProgram> declaration_of(std::string_view name) const {
    for (const ir::Statement& s : program_.statements) {
      if (s.kind != StatementKind::declaration) continue;
      auto declared = sinumerik::declared_program(program_, s);
      if (declared && declared->name == text::upper_case(name)) return declared;
    }
    return std::nullopt;
  }

  void executed_text(std::uint32_t i) {
    const ir::ExpressionId id = program_.messages[program_.statements[i].payload].text;
    if (id == ir::ExpressionId::none) return;
    const ir::Expression& text = program_.at(id);
    if (text.op != ir::Operator::string) {
      out_.writes.push_back(i);
      out_.reads.push_back(i);
      return;
    }
    const std::string_view block = program_.strings.at(text.string);
    const Mention mention = mention_of(block, target_);
    if (mention == Mention::sets) out_.writes.push_back(i);
    if (mention == Mention::reads) out_.reads.push_back(i);
    if (seen_by_ == SeenBy::all && mention == Mention::none && may_call(block)) out_.calls.push_back(i);
  }

  // L100, GROOVE, GROOVE(1): neither words nor an assignment.
  [[nodiscard]] static bool may_call(std::string_view block) {
    block.remove_prefix(std::min(block.find_first_not_of(" \t"), block.size()));
    if (block.empty() || block.contains('=')) return false;
    const bool word = block.size() > 1 && block[1] >= '0' && block[1] <= '9';
    return !word || block[0] == 'L' || block[0] == 'l';
  }

  [[nodiscard]] bool is_elsewhere(std::uint32_t i) const {
    const ir::Statement& s = program_.statements[i];
    const ir::Call& call = program_.calls[s.payload];
    if (seen_by_ == SeenBy::own_program) return false;
    if (seen_by_ == SeenBy::called_with_m98 && call.kind == ir::CallKind::macro) return false;
    const std::string_view name = program_.strings.at(call.name);
    if (name.empty()) return call.number != ir::ExpressionId::none || call.computed != ir::ExpressionId::none;
    return !facts::is_standard_cycle(program_, s) && name != program_.name && !ir::section_named(program_, name);
  }

  const ir::Program& program_;
  const NativeVariable& variable_;
  std::string_view target_;
  SeenBy seen_by_;
  OtherUses out_;
};

}  // namespace

OtherUses other_uses(const ir::Program& program, const NativeVariable& variable, std::string_view target,
                     SeenBy seen_by, const std::vector<bool>& scope) {
  return Search(program, variable, target, seen_by).run(scope);
}

}  // namespace dripfeed::compile
