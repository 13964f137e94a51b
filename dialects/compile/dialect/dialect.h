// The one interface that every control language has here, and the list of those that are built in. What a dialect does
// for each function is its own folder's; the rest of the program knows this struct only.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/compile/dialect/comment_style.h"
#include "dialects/ir/control.h"
#include "dialects/ir/language_word.h"
#include "dialects/ir/plain_batch.h"
#include "dialects/ir/program.h"
#include "dialects/ir/stage.h"
#include "dialects/text/diagnostic.h"
#include "dialects/text/source.h"

namespace dripfeed::compile {

struct Dialect {
  std::string_view name;   // "fanuc", "sinumerik-840d"
  std::string_view title;  // "Fanuc Custom Macro B"
  // The usual control of that kind; the G-code system counts for lathes that have one.
  ir::Control (*control)(ir::MachineKind kind, ir::GSystem g_system);
  // The control that the text was most likely written for; Control::because_line says by which line.
  ir::Control (*infer_control)(const text::Source& source);
  // Never fails; tokens tile the text.
  ir::ReadResult (*read)(const text::Source& source, const ir::Control& control);
  // Plain blocks of a text in batches, for running it while it is read. `control` must outlive it.
  std::unique_ptr<ir::PlainScanner> (*plain_scanner)(const ir::Control& control);
  // What the control would alarm on, or what can be seen from the program to be wrong.
  std::vector<text::Diagnostic> (*validate)(const ir::Program& program, const ir::Control& control,
                                            ir::Delivery delivery);
  // Makes a program of `from` legal for `to`, a control of this dialect.
  ir::RaiseResult (*raise)(const ir::Program& program, const ir::Control& from, const ir::Control& to);
  ir::PrintResult (*print)(const ir::Program& program, const ir::Control& control);
  // The word of an axis with a computed position, as `print` writes it.
  void (*append_position)(std::string& out, ir::Address axis, double value, const ir::Control& control);
  // The words of the language that are no codes.
  std::vector<ir::LanguageWord> (*words)();
  CommentStyle comments = CommentStyle::brackets;
  // Text of a program that the control brings along (a standard cycle), empty without one; nullptr: it has none.
  std::string_view (*standard_program)(std::string_view name) = nullptr;
  // Adds what a definition file declares for every program of the control; nullptr: it has no such files.
  std::vector<std::string> (*add_definitions)(const text::Source& file, const ir::Control& control,
                                              ir::SharedDefinitions& into) = nullptr;
  // A return by a code alone in its block ends continuous-path mode there, one by a word does not (SINUMERIK
  // programming manual, "Parameterizable subprogram return": RET where G64 is not to be interrupted).
  bool return_code_rests = false;
};

std::span<const Dialect> dialects();
// nullptr when there is none of that name.
const Dialect* find_dialect(std::string_view name);
// The dialect whose text this most likely is, by what only one of them has; the first of the list when nothing shows.
const Dialect& infer_dialect(const text::Source& source);

// A control without quirks, in which a built family is run: calculator decimals, radius or diameter as given, all axes.
ir::Control neutral_control(ir::MachineKind kind, bool x_is_diameter);

}  // namespace dripfeed::compile
