// The stages of macro_b with this control's grammar.
#include "dialects/macro_b/stages.h"

#include "dialects/haas/haas.h"
#include "dialects/haas/tables.h"
#include "dialects/macro_b/infer.h"
#include "dialects/macro_b/raise.h"
#include "dialects/macro_b/scan.h"

namespace dripfeed::haas {

ir::Control infer_control(const text::Source& source) { return macro_b::infer_control(source, grammar(), control, {}); }

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

}  // namespace dripfeed::haas
