// The targets are found in the program as the machine's control reads it; then the constants are replaced from the last
// to the first.
#include "dialects/compile/render/wrapped_family.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/printed_lines.h"
#include "dialects/compile/dialect/wire_frame.h"
#include "dialects/compile/native/native_number.h"
#include "dialects/compile/native/native_targets.h"
#include "dialects/compile/native/native_unit.h"
#include "dialects/compile/native/variable_quantities.h"
#include "dialects/compile/translate/convert.h"
#include "dialects/passes/walk.h"

namespace dripfeed::compile {

namespace {

constexpr std::string_view kKept = "the program is kept unchanged";

text::Diagnostic fault_at(const family::Binding& binding, std::string_view why) {
  return text::make_diagnostic(text::DiagnosticId::family_syntax, binding.span,
                               {fmt::format("{} does not take the value: {}", binding.target, why)});
}

text::Diagnostic doubt_at(const family::Binding& binding, std::string_view why) {
  text::Diagnostic out = text::make_diagnostic(text::DiagnosticId::family_syntax, binding.span,
                                               {fmt::format("{} may lose the value: {}", binding.target, why)});
  out.severity = text::Severity::warning;
  return out;
}

// The native program of a family by itself.
struct NativeProgram {
  text::Source source;
  ir::ReadResult read;
};

NativeProgram read_native(const family::Family& family, const Dialect& dialect, const ir::Control& control) {
  const std::string_view text = family.native->text.in(family.source.text());
  NativeProgram out{.source = text::Source(family.source.name(), std::string(text)), .read = {}};
  out.read = dialect.read(out.source, control);
  return out;
}

class TargetFinder {
 public:
  TargetFinder(const family::Family& family, const ir::Program& program, const ir::Control& control)
      : family_(family), program_(program), control_(control) {}

  // One a binding, in their order; where one has no constant there is an error.
  std::vector<NativeTarget> targets() {
    std::vector<NativeTarget> out;
    std::map<std::uint32_t, std::string_view> taken;  // by where the constant begins
    for (const family::Binding& binding : family_.bindings) {
      NativeTarget found = find_target(program_, control_, binding.target);
      if (!found.constant) {
        report(fault_at(binding, found.why), std::move(found.notes));
        continue;
      }
      if (!found.warning.empty()) report(doubt_at(binding, found.warning), std::move(found.notes));
      const auto [earlier, is_new] = taken.try_emplace(found.constant->span.begin, binding.target);
      if (!is_new)
        diagnostics.push_back(fault_at(binding, fmt::format("it is the number that {} names", earlier->second)));
      out.push_back(std::move(found));
    }
    return out;
  }

  std::vector<text::Diagnostic> diagnostics;

 private:
  void report(text::Diagnostic one, std::vector<text::DiagnosticNote> notes) {
    one.notes = std::move(notes);
    for (text::DiagnosticNote& note : one.notes) {
      note.span.begin += family_.native->text.begin;
      note.span.end += family_.native->text.begin;
    }
    diagnostics.push_back(std::move(one));
  }

  const family::Family& family_;
  const ir::Program& program_;
  const ir::Control& control_;
};

class WrappedRenderer {
 public:
  WrappedRenderer(const RenderRequest& request, const Dialect& dialect, const family::BoundFamily& bound,
                  RenderResult out)
      : request_(request), dialect_(dialect), bound_(bound), family_(*bound.family), result_(std::move(out)) {}

  RenderResult render() {
    if (dialect_.name != family_.native->dialect) {
      report(text::make_diagnostic(text::DiagnosticId::family_syntax, family_.native->dialect_span,
                                   {fmt::format("the program is in the language {}, and {} speaks {}: it is kept as "
                                                "it is written and not translated",
                                                family_.native->dialect, request_.target.title, dialect_.name)}));
      return std::move(result_);
    }
    const NativeProgram native = read_native(family_, dialect_, request_.target);
    TargetFinder finder(family_, native.read.program, request_.target);
    const std::vector<NativeTarget> targets = finder.targets();
    for (text::Diagnostic& one : finder.diagnostics) report(std::move(one));
    if (!failed()) put_values(native, targets);
    if (!failed()) choose();
    return std::move(result_);
  }

 private:
  void report(text::Diagnostic diagnostic) { result_.diagnostics.push_back(std::move(diagnostic)); }
  [[nodiscard]] bool failed() const { return text::has_error(result_.diagnostics); }

  // --- the program with its values

  void put_values(const NativeProgram& native, const std::vector<NativeTarget>& targets) {
    const facts::Resolved resolved(native.read.program, request_.target);
    const NativeUnits units(native.read.program, request_.target, resolved);
    const VariableQuantities quantities(native.read.program, request_.target, resolved);
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const family::Binding& binding = family_.bindings[i];
      const NativeConstant& constant = *targets[i].constant;
      const NativeUnit unit = units.of(binding.dimension, binding.unit, constant.statement,
                                       quantities.uses_of(targets[i].variables, targets[i].scope));
      if (!unit.factor) {
        report_unit(native.read.program, binding, unit);
        continue;
      }
      const double value = bound_.values[static_cast<std::size_t>(binding.symbol)] / *unit.factor;
      NativeNumber number =
          number_in_place(constant, constant.span.in(native.source.text()), value, request_.target.limits.digits);
      if (number.text)
        edits_.push_back({.replaced = constant.span, .text = std::move(*number.text)});
      else
        report(fault_at(binding, number.why));
    }
    if (failed()) return;
    std::ranges::sort(edits_, {}, [](const text::Edit& edit) { return edit.replaced.begin; });
    std::string out(native.source.text());
    for (auto edit = edits_.rbegin(); edit != edits_.rend(); ++edit)
      out.replace(edit->replaced.begin, edit->replaced.size(), edit->text);
    written_ = text::Source(family_.source.name(), std::move(out));
  }

  void report_unit(const ir::Program& program, const family::Binding& binding, const NativeUnit& unit) {
    text::Diagnostic fault = fault_at(binding, unit.why);
    const std::uint32_t begin = family_.native->text.begin;
    for (const std::uint32_t one : unit.statements) {
      const text::Span span = program.statements[one].span;
      fault.notes.push_back({.span = {begin + span.begin, begin + span.end}, .text = "here"});
    }
    report(std::move(fault));
  }

  // The place in the family of a place in the program with its values.
  [[nodiscard]] text::Span in_family(text::Span span) const { return {in_family(span.begin), in_family(span.end)}; }
  [[nodiscard]] std::uint32_t in_family(std::uint32_t at) const {
    std::uint32_t shift = 0;  // wraps round, as the difference of two lengths may be negative
    for (const text::Edit& edit : edits_) {
      if (edit.replaced.begin >= at + shift) break;
      shift += edit.replaced.size() - static_cast<std::uint32_t>(edit.text.size());
    }
    const std::uint32_t begin = family_.native->text.begin;
    return std::min(begin + at + shift, static_cast<std::uint32_t>(family_.source.text().size()));
  }

  // --- its form

  void choose() {
    const bool drip = request_.delivery == ir::Delivery::drip;
    if (request_.mode == RenderMode::explicit_blocks) return explicit_blocks("it was asked for");
    const ir::ReadResult read = dialect_.read(written_, request_.target);
    std::vector<text::Diagnostic> jumps;
    if (drip) jumps = dialect_.validate(read.program, request_.target, ir::Delivery::drip);
    std::erase_if(jumps, [](const text::Diagnostic& one) {
      return one.id != text::DiagnosticId::not_in_drip_mode || one.severity != text::Severity::error;
    });
    if (!jumps.empty() && request_.mode == RenderMode::automatic)
      return explicit_blocks("the control is fed block by block and then rejects jumps and loops");
    for (text::Diagnostic& one : jumps) report_of_program(std::move(one));
    if (!failed()) keep(read.program);
  }

  void keep(const ir::Program& program) {
    result_.mode = RenderMode::macro;
    result_.because = kKept;
    result_.is_kept = true;
    result_.legend = legend_of_bindings(bound_);
    result_.variables = user_variables(program);
    describe(std::string(written_.text()));
  }

  [[nodiscard]] static std::uint32_t user_variables(const ir::Program& program) {
    std::set<std::tuple<ir::Bank, std::uint32_t, ir::SymbolId>> found;
    for (const ir::Statement& s : program.statements) {
      for (const passes::VariableUseAt& use : passes::variables_of(program, s)) {
        const ir::Variable& v = program.at(use.variable);
        if (v.bank != ir::Bank::system) found.emplace(v.bank, v.number, v.symbol);
      }
    }
    return static_cast<std::uint32_t>(found.size());
  }

  void explicit_blocks(std::string_view because) {
    const ConvertRequest request{
        .source = written_, .from = request_.target, .to = request_.target, .mode = ConvertMode::explicit_blocks};
    ConvertResult made = convert(request);
    for (text::Diagnostic& one : made.diagnostics) report_of_program(std::move(one));
    if (failed()) return;
    if (!made.not_verified.empty()) {
      report(text::make_diagnostic(
          text::DiagnosticId::family_syntax, family_.native->dialect_span,
          {fmt::format("plain blocks of the program could not be verified by running it: {}", made.not_verified)}));
      return;
    }
    result_.mode = RenderMode::explicit_blocks;
    result_.because = because;
    ir::PrintResult printed{.text = std::move(made.text), .origin_lines = std::move(made.origin_lines)};
    if (request_.delivery == ir::Delivery::drip) wrap_for_wire(printed, dialect_.name, family_.name);
    index_places(printed);
    describe(std::move(printed.text));
  }

  // From blocks to lines of the family.
  void index_places(const ir::PrintResult& printed) {
    const std::uint32_t head = family_.source.position(family_.native->text.begin).line - 1;
    for_each_line(printed.text, [&](const PrintedLine& line) {
      if (!is_block(line.text)) return;
      const std::size_t row = line.number - 1;
      const std::uint32_t origin = row < printed.origin_lines.size() ? printed.origin_lines[row] : 0;
      result_.places.entries.push_back(
          {.offset = line.offset, .line = line.number, .origin = origin == 0 ? 0 : origin + head});
    });
  }

  void report_of_program(text::Diagnostic one) {
    if (one.elsewhere == nullptr) {
      one.span = in_family(one.span);
      for (text::DiagnosticNote& note : one.notes) note.span = in_family(note.span);
    }
    report(std::move(one));
  }

  void describe(std::string text) {
    result_.text = std::move(text);
    result_.bytes = result_.text.size();
    result_.blocks = count_blocks(result_.text);
  }

  const RenderRequest& request_;
  const Dialect& dialect_;
  const family::BoundFamily& bound_;
  const family::Family& family_;
  std::vector<text::Edit> edits_;  // in the order of the text
  text::Source written_;
  RenderResult result_;
};

}  // namespace

std::vector<text::Diagnostic> target_faults(const family::Family& family) {
  if (!family.native) return {};
  const Dialect* dialect = find_dialect(family.native->dialect);
  if (dialect == nullptr) {
    std::string known;
    for (const Dialect& one : dialects()) known += fmt::format("{}{}", known.empty() ? "" : ", ", one.name);
    return {text::make_diagnostic(
        text::DiagnosticId::family_syntax, family.native->dialect_span,
        {fmt::format("no control here has the language '{}'; known are {}", family.native->dialect, known)})};
  }
  const ir::Control control = dialect->control(family.machine, ir::GSystem::a);
  const NativeProgram native = read_native(family, *dialect, control);
  TargetFinder finder(family, native.read.program, control);
  (void)finder.targets();
  return std::move(finder.diagnostics);
}

RenderResult render_wrapped(const RenderRequest& request, const Dialect& dialect, const family::BoundFamily& bound,
                            RenderResult out) {
  return WrappedRenderer(request, dialect, bound, std::move(out)).render();
}

}  // namespace dripfeed::compile
