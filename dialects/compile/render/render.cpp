// Read, bind, build; then either raise and print what was built, or run it first and print the plain blocks.
#include "dialects/compile/render/render.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/print_for.h"
#include "dialects/compile/dialect/printed_lines.h"
#include "dialects/compile/dialect/try_out.h"
#include "dialects/compile/dialect/wire_frame.h"
#include "dialects/compile/plain/explicit_program.h"
#include "dialects/compile/plain/index_places.h"
#include "dialects/compile/render/annotate.h"
#include "dialects/compile/render/faces.h"
#include "dialects/compile/render/family_lines.h"
#include "dialects/compile/render/named_tools.h"
#include "dialects/compile/render/native_verbs.h"
#include "dialects/compile/render/streamed_render.h"
#include "dialects/compile/render/wrapped_family.h"
#include "dialects/compile/translate/cone_leads.h"
#include "dialects/compile/translate/thread_leads.h"
#include "dialects/compile/translate/translate_faces.h"
#include "dialects/family/build.h"
#include "dialects/family/native_text.h"
#include "dialects/family/read.h"
#include "dialects/ir/axis_letters.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/rigid_taps.h"

namespace dripfeed::compile {

namespace {

constexpr std::array<std::pair<std::string_view, RenderMode>, 3> kModes = {
    {{"macro", RenderMode::macro}, {"explicit", RenderMode::explicit_blocks}, {"auto", RenderMode::automatic}}};

constexpr std::string_view kAsked = "it was asked for";
constexpr std::string_view kDrip = "the control is fed block by block and then rejects jumps and loops";
constexpr std::string_view kMemory = "the program is loaded into the control's memory, and its variables suffice";

bool jumps(const ir::Program& program) {
  return std::ranges::any_of(program.statements, [](const ir::Statement& s) {
    return s.kind == ir::StatementKind::go_to || s.kind == ir::StatementKind::while_begin ||
           s.kind == ir::StatementKind::repeat_begin || s.kind == ir::StatementKind::for_begin ||
           s.kind == ir::StatementKind::loop_begin;
  });
}

class Renderer {
 public:
  Renderer(const RenderRequest& request, const Dialect& dialect, PositionRuns* runs = nullptr)
      : request_(request), dialect_(dialect), runs_(runs) {}

  RenderResult render() {
    family::ReadFamilyResult read = family::read_family(request_.family);
    result_.diagnostics = std::move(read.diagnostics);
    if (text::has_error(result_.diagnostics)) return std::move(result_);
    report(number_tools(read.family, request_.target));
    family_ = std::make_shared<const family::Family>(std::move(read.family));
    if (auto fault = fault_of_machine(family_->machine, request_.target)) {
      fault->span = family_->machine_span;
      result_.diagnostics.push_back(std::move(*fault));
      return std::move(result_);
    }
    family::BindResult bound = family::bind_family(family_, request_.values);
    report(bound.diagnostics);
    if (text::has_error(result_.diagnostics)) return std::move(result_);
    bound_ = std::move(bound.bound);
    result_.geometry = family::geometry(bound_);
    result_.drawing = family::drawing(bound_);
    if (family_->native) return render_wrapped(request_, dialect_, bound_, std::move(result_));
    built_ = family::build(bound_);
    if (!request_.program_name.empty()) built_.name = request_.program_name;
    control_ = neutral_control(family_->machine, family_->x_is_diameter);
    control_.semantics.chip_break_retract_mm = request_.target.semantics.chip_break_retract_mm;
    control_.semantics.peck_clearance_mm = request_.target.semantics.peck_clearance_mm;
    admit_natives(*family_, control_);
    report(faults_of_natives(*family_, dialect_, request_.target));
    if (request_.target.from_profile) refuse_missing_axes();
    refuse_unset_numbers();
    refuse_hidden_texts();
    show_messages();
    if (!text::has_error(result_.diagnostics)) choose();
    if (!text::has_error(result_.diagnostics)) describe_text();
    return std::move(result_);
  }

  [[nodiscard]] std::vector<Splice> take_splices() { return std::move(splices_); }
  // After render() of a family that is rewritten: by line of the text, the family's.
  [[nodiscard]] std::vector<std::uint32_t> take_lines() { return std::move(printed_.origin_lines); }

 private:
  void report(const std::vector<text::Diagnostic>& diagnostics) {
    result_.diagnostics.insert(result_.diagnostics.end(), diagnostics.begin(), diagnostics.end());
  }

  // A machine that a person described has the axes that are described.
  void refuse_missing_axes() {
    std::string refused;
    for (const family::Step& step : family_->steps) {
      for (std::uint32_t i = 0; i < step.word_count; ++i) {
        const ir::Address address = family_->words[step.first_word + i].address;
        const char letter = address <= ir::Address::z ? ir::letter_of(address) : 0;
        const bool is_turned = letter == 'Y' && family_->machine == ir::MachineKind::lathe;  // by C
        const bool is_axis = letter != 0 && !is_turned && control_.axes.contains(letter);
        if (!is_axis || request_.target.axes.contains(letter) || refused.contains(letter)) continue;
        refused.push_back(letter);
        report(
            {passes::diagnose(passes::of_axis(std::string("the axis ") + letter), step.span, request_.target.title)});
      }
    }
  }

  // A name of a part that the control would show as another one.
  void refuse_hidden_texts() {
    for (const family::Parameter& parameter : family_->parameters) {
      const auto text = bound_.texts.find(parameter.symbol);
      if (text == bound_.texts.end()) continue;
      const auto hidden = std::ranges::find_if(text->second, [this](char c) { return !shows(c, dialect_.comments); });
      if (hidden == text->second.end()) continue;
      report({text::make_diagnostic(
          text::DiagnosticId::cannot_translate, parameter.span,
          {fmt::format("the character '{}' of the text {}", *hidden, parameter.name), request_.target.title})});
    }
  }

  // In letters that the control shows.
  void show_messages() {
    for (const ir::Message& message : built_.messages) {
      if (message.text == ir::ExpressionId::none) continue;
      ir::Expression& text = built_.expressions[static_cast<std::size_t>(message.text)];
      text.string = built_.strings.add(shown(built_.strings.at(text.string), dialect_.comments));
    }
  }

  // An index that the control computes and that is none of its list's would be another variable there: a macro is run
  // here to see whether there is one.
  void try_lists() {
    const auto computed = [this](const ir::Variable& v) {
      return v.index != ir::ExpressionId::none && built_.at(v.index).op != ir::Operator::constant;
    };
    if (std::ranges::none_of(built_.variables, computed)) return;
    report_lists(tried_ ? tried_->run : try_out(built_, control_));
  }

  void refuse_unset_numbers() {
    if (is_asked_for_blocks() && runs_ != nullptr) return;  // the run that writes them shows it
    tried_ = try_set_lists(family_->lists, built_, control_);
    if (tried_) report_unset(tried_->lines);
  }
  void report_unset(const std::set<std::uint32_t>& lines) {
    for (const std::uint32_t line : lines)
      report({text::make_diagnostic(text::DiagnosticId::family_syntax, span_of_line(line),
                                    {"this takes a number of a list that the program has not set"})});
  }
  [[nodiscard]] bool is_asked_for_blocks() const {
    return request_.mode == RenderMode::explicit_blocks ||
           (request_.mode == RenderMode::automatic && request_.delivery == ir::Delivery::drip);
  }

  // At the family's line.
  void report_lists(const interpreter::RunResult& run) {
    for (const interpreter::RunDiagnostic& one : run.diagnostics) {
      if (one.diagnostic.id != text::DiagnosticId::variable_out_of_range) continue;
      text::Diagnostic found = one.diagnostic;
      found.span = span_of_line(one.line);
      report({std::move(found)});
    }
  }

  [[nodiscard]] text::Span span_of_line(std::uint32_t line) const {
    const std::string_view text = family_->source.line(line);
    const auto begin = static_cast<std::uint32_t>(text.data() - family_->source.text().data());
    return {begin, begin + static_cast<std::uint32_t>(text.size())};
  }

  void choose() {
    if (request_.mode == RenderMode::macro) return macro(kAsked, true);
    if (request_.mode == RenderMode::explicit_blocks) return explicit_blocks(kAsked);
    if (request_.delivery == ir::Delivery::drip) return explicit_blocks(kDrip);
    macro(kMemory, false);
  }

  // `only`: there is no other mode, faults are errors; otherwise a fault is why it is rendered explicitly.
  void macro(std::string_view because, bool only) {
    try_lists();
    if (text::has_error(result_.diagnostics)) return;
    ir::RaiseResult raised = raise(built_, control_);
    raise_cone_leads(raised);
    if (request_.delivery == ir::Delivery::drip && jumps(raised.program)) {
      raised.diagnostics.push_back(ir::diagnose(request_.target, text::DiagnosticId::not_in_drip_mode, {}, {"a loop"}));
    }
    if (text::has_error(raised.diagnostics) && !only) {
      const auto error = std::ranges::find(raised.diagnostics, text::Severity::error, &text::Diagnostic::severity);
      return explicit_blocks(fmt::format("it cannot be a macro: {}", text::message_of(*error)));
    }
    report(raised.diagnostics);
    if (text::has_error(raised.diagnostics)) return;
    result_.mode = RenderMode::macro;
    result_.because = because;
    std::vector<LegendEntry> legend = legend_of(bound_, raised);
    print(raised.program, names_of_variables(legend));
    const std::size_t longest = longest_line(printed_.text);
    const std::size_t most = request_.target.limits.block_length_bytes;
    if (most == 0 || longest <= most) {
      result_.legend = std::move(legend);
      return;
    }
    if (!only)
      return explicit_blocks(fmt::format("as a macro a block has {} bytes, the control takes {}", longest, most));
    report({ir::diagnose(request_.target, text::DiagnosticId::block_too_long, {},
                         {std::to_string(longest), std::to_string(most)})});
  }

  void raise_cone_leads(ir::RaiseResult& raised) {
    const auto threads = [](const family::Step& one) { return one.kind == family::StepKind::thread; };
    const bool has_threads =
        std::ranges::any_of(family_->steps, threads) || std::ranges::any_of(family_->subprograms, [&](const auto& sub) {
          return std::ranges::any_of(sub.steps, threads);
        });
    if (!has_threads || !leads_by_letters(request_.target)) return;
    const std::map<std::uint32_t, ConeLead> leads = cone_leads(built_, control_);
    for (const auto& [line, lead] : leads) {
      if (lead != ConeLead::either) continue;
      raised.diagnostics.push_back(
          ir::diagnose(request_.target, text::DiagnosticId::cannot_translate, span_of_line(line),
                       {"a thread that is now longer along X and now along Z", request_.target.title}));
    }
    name_cone_leads(raised.program, leads);
  }

  static std::size_t longest_line(std::string_view text) {
    std::size_t longest = 0;
    for_each_line(text, [&](const PrintedLine& line) { longest = std::max(longest, line.text.size()); });
    return longest;
  }

  // With runs, blocks in great number are no matter of memory.
  ExplicitProgram run_built() {
    HiddenFaces faces;
    if (has_faces(built_)) {
      runs_ = nullptr;
      faces.hide(built_, control_);
    }
    const bool watches = runs_ != nullptr && !tried_ && are_set_by_steps(family_->lists);
    ir::Control watching = control_;
    watching.semantics.unset_is_unknown = watches;
    ExplicitProgram made = explicit_program(watches ? with_unknown_lists(family_->lists, built_) : built_, watching,
                                            interpreter::no_programs(),
                                            {.limits = runs_ == nullptr ? kWrittenLimits : kStreamedLimits,
                                             .initial_values = {},
                                             .want_changes = runs_ == nullptr,
                                             .keep_taps = true,
                                             .keep_skips = true,
                                             .runs = runs_});
    faces.show(made);
    if (!watches) return made;
    made.control.semantics.unset_is_unknown = control_.semantics.unset_is_unknown;
    report_unset(lines_with_unset(made.run));
    return made;
  }

  void explicit_blocks(std::string_view because) {
    const std::size_t reported = result_.diagnostics.size();
    ExplicitProgram made = run_built();
    report_lists(made.run);
    if (text::has_error(result_.diagnostics)) return;
    ProgramLibrary none(control_, {});
    report(run_faults(made, RunTexts(built_, none)));
    ir::RaiseResult raised = raise(made.program, made.control);
    report(raised.diagnostics);
    if (text::has_error(result_.diagnostics)) return;
    result_.mode = RenderMode::explicit_blocks;
    result_.because = because;
    print(raised.program);
    if (runs_ == nullptr) return index_places(made);
    if (std::optional<std::vector<Splice>> found = runs_->splices(printed_)) {
      splices_ = std::move(*found);
      return printed_.origin_lines.clear();
    }
    runs_ = nullptr;
    result_.diagnostics.resize(reported);
    refuse_unset_numbers();
    explicit_blocks(because);
  }

  // Of a program that is written for `from`.
  ir::RaiseResult raise(ir::Program program, const ir::Control& from) {
    std::vector<text::Diagnostic> faults = passes::translate_taps(program, from, request_.target);
    if (has_faces(program))
      std::ranges::move(translate_faces(program, from, request_.target), std::back_inserter(faults));
    ir::RaiseResult raised = dialect_.raise(program, from, request_.target);
    raised.diagnostics.insert(raised.diagnostics.begin(), faults.begin(), faults.end());
    return raised;
  }

  void print(ir::Program& raised, std::map<std::string, std::string> names = {}) {
    name_tools(*family_, request_.target, raised);
    printed_ = print_for(dialect_, raised, request_.target);
    put_natives(*family_, dialect_, printed_);
    Annotation annotation = annotation_of(bound_, request_.heading, result_.mode == RenderMode::macro);
    annotation.names = std::move(names);
    annotate(printed_, annotation, request_.target, dialect_.comments);
    if (request_.delivery == ir::Delivery::drip) wrap_for_wire(printed_, dialect_.name, built_.name);
  }

  // From numbers of explicit blocks to lines of the family.
  void index_places(const ExplicitProgram& made) {
    std::set<std::string> own_names;
    for (const ir::Symbol& symbol : family_->arena.symbols) {
      own_names.emplace(family_->arena.strings.at(symbol.name));
    }
    result_.places = compile::index_places(printed_, made, own_names);
    for (std::uint32_t& line : printed_.origin_lines) {
      if (line != 0) line = made.origins[line - 1].line;
    }
  }

  void describe_text() {
    result_.text = std::move(printed_.text);
    const bool has_runs = !splices_.empty();
    result_.bytes = result_.text.size() + (has_runs ? runs_->bytes() : 0);
    result_.blocks = count_blocks(result_.text) + (has_runs ? runs_->blocks() : 0);
    result_.variables = printed_.variables;
    for (std::uint32_t i = 0; i < printed_.origin_lines.size(); ++i) {
      if (in_profile(printed_.origin_lines[i])) add_profile_line(i + 1);
    }
  }

  [[nodiscard]] bool in_profile(std::uint32_t line) const {
    return std::ranges::any_of(family_->profiles,
                               [line](const family::LineRange& r) { return r.first <= line && line <= r.last; });
  }

  void add_profile_line(std::uint32_t line) {
    std::vector<family::LineRange>& ranges = result_.profile_lines;
    if (!ranges.empty() && ranges.back().last + 1 == line) {
      ranges.back().last = line;
    } else {
      ranges.push_back({line, line});
    }
  }

  const RenderRequest& request_;
  const Dialect& dialect_;
  PositionRuns* runs_;  // nullptr: all blocks are of the program
  std::vector<Splice> splices_;
  std::shared_ptr<const family::Family> family_;
  family::BoundFamily bound_;
  ir::Program built_;
  ir::Control control_;  // that built_ is written for
  std::optional<TriedLists> tried_;
  ir::PrintResult printed_;
  RenderResult result_;
};

}  // namespace

std::string_view name_of(RenderMode mode) {
  return std::ranges::find(kModes, mode, &std::pair<std::string_view, RenderMode>::second)->first;
}

std::optional<RenderMode> find_render_mode(std::string_view name) {
  const auto row = std::ranges::find(kModes, name, &std::pair<std::string_view, RenderMode>::first);
  return row == kModes.end() ? std::nullopt : std::optional(row->second);
}

std::optional<text::Diagnostic> fault_of_machine(ir::MachineKind wanted, const ir::Control& control) {
  if (ir::serves(control.kind, wanted)) return std::nullopt;
  return text::make_diagnostic(text::DiagnosticId::family_other_machine, {},
                               {std::string(ir::name_of(wanted)), std::string(ir::name_of(control.kind))});
}

namespace {

// The native program is kept line by line after the family's declarations.
std::vector<std::uint32_t> lines_of_kept(const text::Source& family, std::string_view text) {
  const std::uint32_t head = family.position(family::native_begin(family.text())).line - 1;
  std::vector<std::uint32_t> lines;
  for_each_line(text, [&](const PrintedLine& line) { lines.push_back(head + line.number); });
  return lines;
}

}  // namespace

std::vector<std::uint32_t> family_lines(const RenderRequest& request, const RenderResult& made) {
  if (made.is_kept) return lines_of_kept(request.family, made.text);
  std::vector<std::uint32_t> lines;
  if (made.mode == RenderMode::explicit_blocks) {
    for (const PlaceEntry& one : made.places.entries) {
      lines.resize(std::max<std::size_t>(lines.size(), one.line), 0);
      lines[one.line - 1] = one.origin;
    }
    return lines;
  }
  const Dialect* dialect = find_dialect(request.target.dialect);
  if (dialect == nullptr) return lines;
  RenderRequest as_macro = request;
  as_macro.mode = RenderMode::macro;
  Renderer renderer(as_macro, *dialect);
  (void)renderer.render();
  return renderer.take_lines();
}

namespace {

RenderResult without_dialect(const ir::Control& target) {
  RenderResult out;
  out.diagnostics.push_back(passes::diagnose("the family", {}, fmt::format("'{}'", target.dialect)));
  return out;
}

}  // namespace

RenderResult render(const RenderRequest& request) {
  const Dialect* dialect = find_dialect(request.target.dialect);
  return dialect == nullptr ? without_dialect(request.target) : Renderer(request, *dialect).render();
}

StreamedRendering render_streamed(const RenderRequest& request, TextSink& sink) {
  const Dialect* dialect = find_dialect(request.target.dialect);
  if (dialect == nullptr) return {without_dialect(request.target), {}};
  PositionRuns runs(*dialect, request.target, sink);
  Renderer renderer(request, *dialect, &runs);
  StreamedRendering out{renderer.render(), {}};
  out.splices = renderer.take_splices();
  return out;
}

}  // namespace dripfeed::compile
