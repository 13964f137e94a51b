// The text is read by its language's reader; nothing of it is written again.
#include "dialects/compile/render/native_verbs.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/printed_lines.h"
#include "dialects/passes/refusal.h"
#include "dialects/text/number.h"

namespace dripfeed::compile {

namespace {

using ir::Function;
using ir::StatementKind;

// Codes that move, or shift what positions mean, without an axis being named.
constexpr Function kMoving[] = {Function::reference_return, Function::leave_reference, Function::approach,
                                Function::skip_move,        Function::measure_tool,    Function::work_offset,
                                Function::local_shift,      Function::set_coordinates, Function::extended_offset};

// A block that names an axis, begins a motion, or leaves the program's order.
bool moves(const ir::Program& program) {
  return std::ranges::any_of(program.statements, [&](const ir::Statement& s) {
    if (s.kind == StatementKind::empty || s.kind == StatementKind::assign || s.kind == StatementKind::message ||
        s.kind == StatementKind::native)
      return false;
    if (s.kind != StatementKind::block) return true;
    const ir::Block& block = program.blocks[s.payload];
    return std::ranges::any_of(program.words_of(block), [](const ir::Word& w) { return ir::is_axis(w.address); }) ||
           std::ranges::any_of(program.codes_of(block), [](const ir::Code& c) {
             return c.group == ir::ModalGroup::motion || c.number != ir::ExpressionId::none ||
                    std::ranges::find(kMoving, c.function) != std::ranges::end(kMoving);
           });
  });
}

// The row that the M function at `at` stands for, and how many bytes it has.
struct Placeholder {
  std::size_t row = 0;
  std::size_t bytes = 0;
};
std::optional<Placeholder> placeholder_at(std::string_view line, std::size_t at, std::size_t rows) {
  const std::size_t end = std::min(line.find_first_not_of("0123456789", at + 1), line.size());
  const auto number = text::parse_integer(line.substr(at + 1, end - at - 1));
  if (!number || *number < family::kFirstNativeFunction) return std::nullopt;
  const auto row = static_cast<std::size_t>(*number - family::kFirstNativeFunction);
  return row < rows ? std::optional(Placeholder{row, end - at}) : std::nullopt;
}

}  // namespace

std::vector<text::Diagnostic> faults_of_natives(const family::Family& family, const Dialect& dialect,
                                                const ir::Control& target) {
  std::vector<text::Diagnostic> out;
  const auto fault = [&](const family::NativeVerb& verb, std::string sentence) {
    out.push_back(text::make_diagnostic(text::DiagnosticId::family_syntax, verb.span, {std::move(sentence)}));
  };
  for (const family::NativeVerb& verb : family.natives) {
    const family::NativeVerb::Row* row = verb.find(dialect.name);
    if (row == nullptr) {
      out.push_back(passes::diagnose("native text of another language", verb.span, target.title));
      continue;
    }
    const ir::ReadResult read = dialect.read(text::Source("native", row->text + "\n"), target);
    const auto error = std::ranges::find(read.diagnostics, text::Severity::error, &text::Diagnostic::severity);
    if (error != read.diagnostics.end())
      fault(verb, fmt::format("the native text: {}", text::message_of(*error)));
    else if (moves(read.program))
      fault(verb, "native text moves no axis, jumps nowhere and calls nothing");
  }
  return out;
}

void admit_natives(const family::Family& family, ir::Control& control) {
  for (std::size_t i = 0; i < family.natives.size(); ++i)
    control.machine_functions.push_back(static_cast<std::uint16_t>(family::kFirstNativeFunction + i));
}

void put_natives(const family::Family& family, const Dialect& dialect, ir::PrintResult& printed) {
  if (family.natives.empty()) return;
  std::string text;
  for_each_line(printed.text, [&](const PrintedLine& line) {
    std::string out(line.text);
    for (std::size_t at = out.find('M'); at != std::string::npos; at = out.find('M', at + 1)) {
      const auto found = placeholder_at(out, at, family.natives.size());
      const family::NativeVerb::Row* row = found ? family.natives[found->row].find(dialect.name) : nullptr;
      if (row == nullptr) continue;
      out.replace(at, found->bytes, row->text);
      break;
    }
    text += out;
    text += '\n';
  });
  printed.text = std::move(text);
}

}  // namespace dripfeed::compile
