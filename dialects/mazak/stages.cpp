// The stages of macro_b with this control's grammar.
#include "dialects/macro_b/stages.h"

#include <array>

#include "dialects/macro_b/infer.h"
#include "dialects/macro_b/raise.h"
#include "dialects/macro_b/scan.h"
#include "dialects/mazak/mazak.h"
#include "dialects/mazak/tables.h"

namespace dripfeed::mazak {

ir::Control infer_control(const text::Source& source) {
  // Ten times the codes that an Integrex has and the others have not.
  static constexpr auto kMillTurn = std::to_array<std::int32_t>({1221, 1231, 2700, 2710, 2760, 2900, 2920, 2940});
  return macro_b::infer_control(source, grammar(), control, kMillTurn);
}

ir::ReadResult read(const text::Source& source, const ir::Control& control) {
  return macro_b::read(source, control, grammar());
}

std::unique_ptr<ir::PlainScanner> plain_scanner(const ir::Control& control) {
  return macro_b::make_scanner(control, grammar());
}

std::vector<text::Diagnostic> validate(const ir::Program& program, const ir::Control& control, ir::Delivery delivery) {
  return macro_b::validate(program, control, delivery, grammar());
}

ir::RaiseResult raise(const ir::Program& program, const ir::Control& from, const ir::Control& to) {
  return macro_b::raise(program, from, to, grammar());
}

ir::PrintResult print(const ir::Program& program, const ir::Control& control) {
  return macro_b::print(program, control, grammar());
}

}  // namespace dripfeed::mazak
