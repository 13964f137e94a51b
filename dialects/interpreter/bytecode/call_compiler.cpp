// Arguments of macro calls: assignment I gives each letter its variable; I J K given more than once are assignment II,
// where the n-th triplet starts at #(4 + 3(n - 1)). Both may be mixed; a later word wins.
#include "dialects/interpreter/bytecode/call_compiler.h"

#include <array>

#include "dialects/ir/called_cycle.h"

namespace dripfeed::interpreter {

namespace {

using ir::Operator;
using text::DiagnosticId;

// By letter A to Z; 0: the letter is no argument.
constexpr std::array<std::uint8_t, 26> kLetterNumbers = {1, 2, 3, 7,  8,  9,  0,  11, 4,  5,  6,  0,  13,
                                                         0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
constexpr std::uint32_t kTriplets = 10;
// Letters that count least increments when they are written without a point.
constexpr std::string_view kLengthLetters = "ABCIJKQRUVWXYZ";

}  // namespace

std::optional<std::uint32_t> CallCompiler::compile_site(const ir::Call& call, text::Span span, bool keep) {
  CompiledProgram& out = builder_.out();
  const ir::Program& program = builder_.source();
  std::vector<CallArgument> arguments;
  for (const ir::Argument& argument : program.arguments_of(call)) arguments.push_back(compile_argument(argument, keep));

  CallSite site{.kind = call.kind, .name = std::string(program.strings.at(call.name))};
  site.in_other_language = call.in_other_language || out.is_foreign;
  site.cuts_contour = ir::is_called(call, ir::CalledSort::removal);
  site.milling = ir::is_called(call, ir::CalledSort::milling) ? call.cycle : nullptr;
  site.itself = call.name == ir::StringId::none && call.number == ir::ExpressionId::none &&
                call.computed == ir::ExpressionId::none;
  if (call.start != ir::ExpressionId::none) site.start = expressions_.compile_number(call.start).operand;
  if (call.number != ir::ExpressionId::none) site.number = expressions_.compile_number(call.number).operand;
  if (call.computed != ir::ExpressionId::none) site.text = expressions_.compile_string(call.computed).operand;
  if (call.first_label != ir::ExpressionId::none) {
    site.first_label = expressions_.compile_string(call.first_label).operand;
    site.last_label = expressions_.compile_string(call.last_label).operand;
  }
  site.first_argument = static_cast<std::uint32_t>(out.arguments.size());
  site.argument_count = static_cast<std::uint32_t>(arguments.size());
  out.arguments.insert(out.arguments.end(), arguments.begin(), arguments.end());
  if (call.kind == ir::CallKind::macro && !number_arguments(call, site.first_argument)) {
    builder_.emit_failure(span, DiagnosticId::wrong_argument_count,
                          {"the macro", std::to_string(kTriplets) + " groups of I J K and no G L N O P", "more"});
    return std::nullopt;
  }
  out.calls.push_back(site);
  return static_cast<std::uint32_t>(out.calls.size() - 1);
}

void CallCompiler::compile_modal(const ir::Call& call, text::Span span) {
  const auto site = compile_site(call, span, false);
  if (!site.has_value()) return;
  const bool repeats = call.repeats != ir::ExpressionId::none;
  const Operand times = repeats ? compile_repeats(call, span) : builder_.constant(1.0);
  builder_.emit(Opcode::modal_call, span, *site, raw_of(times));
}

void CallCompiler::compile(const ir::Call& call, text::Span span) {
  const bool repeats = call.repeats != ir::ExpressionId::none;
  const auto site = compile_site(call, span, repeats);
  if (!site.has_value()) return;
  const std::uint32_t index = *site;
  if (!repeats) {
    builder_.emit(Opcode::call, span, index);
    return;
  }
  const Operand left = compile_repeats(call, span);
  const Value one{builder_.constant(1.0), ir::ValueType::integer, 1.0};
  const Value count{left, ir::ValueType::integer, std::nullopt};
  const std::uint32_t again = builder_.here();
  const Value goes_on = expressions_.combine(Operator::greater_equal, count, one, span);
  const std::uint32_t leave = builder_.emit(Opcode::branch_false, span, raw_of(goes_on.operand));
  builder_.emit(Opcode::call, span, index);
  expressions_.combine(Operator::subtract, count, one, span, left);
  builder_.emit(Opcode::jump_back, span, again);
  builder_.at(leave).b = builder_.here();
}

Operand CallCompiler::compile_repeats(const ir::Call& call, text::Span span) {
  const Operand left = builder_.take();
  const Value times = expressions_.compile_number(call.repeats);
  // A vacant count is a word that is not there: once.
  builder_.emit(Opcode::copy, span, raw_of(left), raw_of(times.operand));
  if (builder_.context().control.semantics.has_vacant && !times.constant.has_value()) {
    const Value vacant = expressions_.combine(Operator::equal, times, {builder_.constant(kVacant), {}, {}}, span);
    const std::uint32_t given = builder_.emit(Opcode::branch_false, span, raw_of(vacant.operand));
    builder_.emit(Opcode::copy, span, raw_of(left), raw_of(builder_.constant(1.0)));
    builder_.at(given).b = builder_.here();
  }
  builder_.emit(Opcode::unary, span, raw_of(left), raw_of(left), 0, static_cast<std::uint8_t>(Operator::round));
  const ir::Semantics& semantics = builder_.context().control.semantics;
  if (semantics.unset_is_unknown && !semantics.has_vacant && !times.constant.has_value())
    builder_.emit(Opcode::passes, span, raw_of(left));
  return left;
}

CallArgument CallCompiler::compile_argument(const ir::Argument& argument, bool keep) {
  if (argument.value == ir::ExpressionId::none) return {};
  const ir::Expression& e = builder_.source().at(argument.value);
  Value value = expressions_.compile_word(argument.value);
  const ir::Expression* number = builder_.find_literal(argument.value);
  const bool counts = builder_.context().control.semantics.decimal_mode == ir::DecimalMode::least_increment &&
                      kLengthLetters.contains(argument.letter) && number != nullptr && !number->has_point;
  CallArgument result{.is_string = value.is_string()};
  if (counts) {
    const Operand to = builder_.take();
    builder_.emit(Opcode::count, e.span, raw_of(to), raw_of(value.operand));
    value.operand = to;
  } else if (keep && !value.is_string() && space_of(value.operand) != Space::constant) {
    const Operand to = builder_.take();
    builder_.emit(Opcode::copy, e.span, raw_of(to), raw_of(value.operand));
    value.operand = to;
  }
  result.value = value.operand;
  if (argument.letter == 0 && e.op == Operator::variable) {
    const ir::Variable& variable = builder_.source().at(e.variable);
    result.reference = expressions_.variables().refer(variable);
    if (!value.is_string() && expressions_.variables().is_shared(variable))
      result.text = expressions_.variables().load_shared_text(variable).operand;
  }
  return result;
}

bool CallCompiler::number_arguments(const ir::Call& call, std::uint32_t first) {
  CompiledProgram& out = builder_.out();
  const auto arguments = builder_.source().arguments_of(call);
  std::uint32_t triplets = 0;
  std::uint32_t next_in_triplet = 0;
  for (std::uint32_t i = 0; i < arguments.size(); ++i) {
    const char letter = arguments[i].letter;
    if (letter < 'A' || letter > 'Z' || kLetterNumbers[static_cast<std::size_t>(letter - 'A')] == 0) return false;
    std::uint32_t& local = out.arguments[first + i].local;
    local = kLetterNumbers[static_cast<std::size_t>(letter - 'A')];
    if (out.is_foreign || letter < 'I' || letter > 'K') continue;  // ISO mode knows them by their letters
    const auto place = static_cast<std::uint32_t>(letter - 'I');
    if (triplets == 0 || place < next_in_triplet) ++triplets;
    if (triplets > kTriplets) return false;
    next_in_triplet = place + 1;
    local = 4 + 3 * (triplets - 1) + place;
  }
  return true;
}

}  // namespace dripfeed::interpreter
