// A name is reported once, where it is used first.
#include "dialects/macro_b/writer/global_data.h"

#include <optional>
#include <set>
#include <string>

#include "dialects/macro_b/writer/raise_parameters.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/set_on_all_paths.h"
#include "dialects/passes/walk.h"

namespace dripfeed::macro_b {

namespace {

std::optional<std::uint32_t> global_of(const ir::Program& program, const ir::Variable& v) {
  if (v.bank != ir::Bank::named || v.symbol == ir::SymbolId::none) return std::nullopt;
  if (!program.at(v.symbol).is_global) return std::nullopt;
  return static_cast<std::uint32_t>(v.symbol);
}

class Refusal {
 public:
  Refusal(const ir::Program& program, const PlacedGlobals& placed, const ir::Control& to)
      : program_(program), placed_(placed), to_(to) {}

  std::vector<text::Diagnostic> run() {
    const bool company = has_company(program_);
    for (const ir::Statement& s : program_.statements) {
      for (const passes::VariableUseAt& use : passes::variables_of(program_, s)) {
        const ir::Variable& v = program_.at(use.variable);
        if (!watched(v)) continue;
        // The elements of an array are not followed one by one.
        const bool element = v.index != ir::ExpressionId::none;
        if (company) refuse(v, s, passes::kept_value(", which other programs share,"));
        if (element && !use.set) refuse(v, s, passes::not_known(", whose value is not known here,"));
      }
    }
    const auto scalar = [this](const ir::Variable& v) {
      return v.index == ir::ExpressionId::none ? watched(v) : std::nullopt;
    };
    for (const passes::UnsetRead& read : passes::reads_before_set(program_, scalar))
      refuse(program_.at(read.variable), program_.statements[read.statement],
             passes::not_known(", whose value is not known here,"));
    return std::move(out_);
  }

 private:
  // What a definition file declares has a place, or has been refused.
  [[nodiscard]] std::optional<std::uint32_t> watched(const ir::Variable& v) const {
    const auto global = global_of(program_, v);
    return global && placed_.defined.contains(v.symbol) ? std::nullopt : global;
  }

  // `why`: what is wrong with it, after its name.
  void refuse(const ir::Variable& v, const ir::Statement& s, passes::Refusal why) {
    if (!reported_.insert(v.symbol).second) return;
    why.what = "the global data " + std::string(program_.strings.at(program_.at(v.symbol).name)) + why.what;
    out_.push_back(passes::diagnose(std::move(why), v.span.empty() ? s.span : v.span, to_.title));
  }

  const ir::Program& program_;
  const PlacedGlobals& placed_;
  const ir::Control& to_;
  std::set<ir::SymbolId> reported_;
  std::vector<text::Diagnostic> out_;
};

}  // namespace

std::vector<text::Diagnostic> refuse_global_data(const ir::Program& program, const PlacedGlobals& placed,
                                                 const ir::Control& to) {
  return Refusal(program, placed, to).run();
}

}  // namespace dripfeed::macro_b
