// Where the tool stood before does not matter: the cycle begins with a rapid move in both axes.
#include "dialects/compile/translate/thread_call.h"

#include <algorithm>
#include <optional>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/execute.h"
#include "dialects/compile/dialect/library.h"
#include "dialects/ir/called_cycle.h"
#include "dialects/text/number.h"

namespace dripfeed::compile {

namespace {

constexpr std::uint64_t kMostBlocks = 200'000;

std::optional<double> number(const ir::Program& program, ir::ExpressionId id) {
  const ir::Expression& e = program.at(id);
  if (e.op == ir::Operator::constant) return e.value;
  if (e.op != ir::Operator::negate) return std::nullopt;
  const std::optional<double> value = number(program, e.a);
  return value ? std::optional(-*value) : std::nullopt;
}

class Kept final : public ir::MotionSink {
 public:
  void consume(std::span<const ir::Motion> motions) override { all.insert(all.end(), motions.begin(), motions.end()); }
  std::vector<ir::Motion> all;
};

}  // namespace

bool is_thread_call(const ir::Call& call) { return ir::is_called(call, ir::CalledSort::thread); }

std::expected<std::vector<ir::Motion>, std::string> moves_of_thread(const ir::Program& program, const ir::Call& call,
                                                                    const ir::Control& control, bool inch) {
  const std::string name(program.strings.at(call.name));
  std::string written = std::string(inch ? "G700" : "G710") + " G90 G95\n" + name + "(";
  for (const ir::Argument& argument : program.arguments_of(call)) {
    if (written.back() != '(') written += ',';
    if (argument.value == ir::ExpressionId::none) {
      if (written.back() == '(') written += '0';
      continue;
    }
    const std::optional<double> value = number(program, argument.value);
    if (!value) return std::unexpected(name + " with computed arguments");
    written += text::format_shortest(*value);
  }
  written += ")\nM30\n";
  const Dialect* dialect = find_dialect(control.dialect);
  const text::Source source(name, written);
  const ir::ReadResult read = dialect->read(source, control);
  if (text::has_error(read.diagnostics)) return std::unexpected(name + " with such arguments");
  ProgramLibrary standard(control, [](std::string_view) { return std::nullopt; });
  Kept kept;
  const interpreter::RunResult run =
      execute(read.program, control, &standard, kept, {.limits = {.blocks = kMostBlocks}, .initial_values = {}});
  for (const interpreter::RunDiagnostic& d : run.diagnostics)
    if (d.diagnostic.severity == text::Severity::error)
      return std::unexpected(name + ": " + text::message_of(d.diagnostic) + ": which");
  const bool lost = std::ranges::any_of(run.not_interpreted, [](const auto& n) { return !n.effects_known; });
  if (run.ended != interpreter::Ended::end || lost) return std::unexpected(name + " with such arguments");
  return std::move(kept.all);
}

}  // namespace dripfeed::compile
