// What the control knows and a run does not: said once by each name, where it stands first.
#include <set>

#include "dialects/sinumerik/validator/validate.h"

namespace dripfeed::sinumerik {

namespace {

using ir::StatementKind;

class Unread {
 public:
  explicit Unread(const Check& check) : check_(check), is_data_(is_data_file(check.program)) {}

  void run() {
    for (const ir::Statement& s : check_.program.statements) {
      if (s.kind == StatementKind::native) native(s);
      if (s.kind == StatementKind::assign) write(check_.program.assigns[s.payload].target, s.span);
      if (s.kind == StatementKind::block) block(check_.block_of(s));
    }
  }

 private:
  text::Diagnostic* say(std::string_view name, text::Span span) {
    if (!seen_.insert(std::string(name)).second) return nullptr;
    return &check_.report(text::DiagnosticId::not_interpreted, span, {std::string(name)});
  }

  // Lines that could not be read have names in words, and their own diagnostic.
  void native(const ir::Statement& s) {
    const std::string_view name = check_.native_name(s);
    const ir::Native& native = check_.program.natives[s.payload];
    if (native.effects_known || name.find(' ') != std::string_view::npos || name == "UNREADABLE") return;
    text::Diagnostic* const found = say(name, s.span);
    if (found != nullptr && native.shifts)
      found->notes.push_back(
          {s.span,
           "where coordinates lie after it, the machine's kinematics or a measurement decides, which "
           "no profile states: from there on travel, gouges and accuracy are not checked"});
  }

  // What a system variable does when it is written is the control's; outputs, timers and counters do nothing here.
  void write(ir::VariableId target, text::Span span) {
    if (target == ir::VariableId::none || is_data_) return;
    const ir::Variable& v = check_.program.at(target);
    if (v.bank != ir::Bank::system || v.name == ir::StringId::none) return;
    const bool inert = v.number != 0 && check_.control.system_variables[v.number].inert;
    if (!inert) say(check_.program.strings.at(v.name), span);
  }

  void block(const ir::Block& block) {
    for (const ir::Code& code : check_.program.codes_of(block))
      if (code.function == ir::Function::not_modelled) say(check_.program.strings.at(code.name), code.span);
    for (const ir::Word& word : check_.program.words_of(block))
      if (word.address == ir::Address::other && word.extension == 0)
        say(check_.program.strings.at(word.name), word.span);
  }

  const Check& check_;
  bool is_data_;  // such a file is nothing but assignments to the control's data
  std::set<std::string> seen_;
};

}  // namespace

void check_interpreted(const Check& check) { Unread(check).run(); }

}  // namespace dripfeed::sinumerik
