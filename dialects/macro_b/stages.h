// The stages of a '#'-variable control from text to text, given its grammar and its usual control. A dialect whose
// tables hold all that is its own is Stages of them and nothing else.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/plain_batch.h"
#include "dialects/ir/program.h"
#include "dialects/ir/stage.h"
#include "dialects/macro_b/reader/infer.h"
#include "dialects/macro_b/reader/scan.h"
#include "dialects/macro_b/tables/grammar.h"
#include "dialects/macro_b/writer/print.h"
#include "dialects/macro_b/writer/raise.h"
#include "dialects/text/diagnostic.h"
#include "dialects/text/source.h"

namespace dripfeed::macro_b {

// Lexes, parses and lowers. Never fails: what cannot be understood is a diagnostic and a Native statement. The tokens
// tile the text. Diagnostics are those of the syntax.
ir::ReadResult read(const text::Source& source, const ir::Control& control, const Grammar& grammar);
// All checks of validate.h, in the order of the text.
std::vector<text::Diagnostic> validate(const ir::Program& program, const ir::Control& control, ir::Delivery delivery,
                                       const Grammar& grammar);
// A raised program: '%', O number, one block a line, '%'.
ir::PrintResult print(const ir::Program& program, const ir::Control& control, const Grammar& grammar);

template <UsualControl control, const Grammar& (*grammar)()>
struct Stages {
  static ir::Control infer_control(const text::Source& source) {
    return macro_b::infer_control(source, grammar(), control);
  }
  static ir::ReadResult read(const text::Source& source, const ir::Control& its) {
    return macro_b::read(source, its, grammar());
  }
  // `its` must outlive the scanner.
  static std::unique_ptr<ir::PlainScanner> plain_scanner(const ir::Control& its) {
    return make_scanner(its, grammar());
  }
  static std::vector<text::Diagnostic> validate(const ir::Program& program, const ir::Control& its,
                                                ir::Delivery delivery) {
    return macro_b::validate(program, its, delivery, grammar());
  }
  // Makes a program of the control `from`, or a built one, legal for `to`, a control of this dialect: variables
  // numbered, structures that it lacks turned into jumps, codes mapped by what they do. What cannot be written is the
  // error of passes/refusal.h (cannot_translate, translation_…) with its place.
  static ir::RaiseResult raise(const ir::Program& program, const ir::Control& from, const ir::Control& to) {
    return macro_b::raise(program, from, to, grammar());
  }
  static ir::PrintResult print(const ir::Program& program, const ir::Control& its) {
    return macro_b::print(program, its, grammar());
  }
  static void append_position(std::string& out, ir::Address axis, double value, const ir::Control& its) {
    macro_b::append_position(out, axis, value, its);
  }
};

}  // namespace dripfeed::macro_b
