// Runs before and after are compared whole. What the program takes from outside (variables that it reads before it sets
// them) is 0 in the first pair of runs, and arbitrary in two more.
#include "dialects/compile/render/optimized.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/render/merged_blocks.h"
#include "dialects/compile/render/same_moves.h"
#include "dialects/compile/translate/inline_moves.h"
#include "dialects/compile/translate/recorded_run.h"
#include "dialects/optimize/places.h"
#include "dialects/text/number.h"

namespace dripfeed::compile {

namespace {

class Optimization {
 public:
  explicit Optimization(const OptimizeRequest& request)
      : request_(request),
        dialect_(*find_dialect(request.control.dialect)),
        own_library_(request.control, [](std::string_view) { return std::nullopt; }) {}

  OptimizeResult run() {
    OptimizeResult result = run_exact();
    const optimize::Rules& rules = request_.settings.rules;
    const MergeWishes wishes{.lines = rules.has(optimize::Rule::lines),
                             .arcs = rules.has(optimize::Rule::arcs),
                             .tolerance_mm = request_.settings.tolerance_mm};
    if ((wishes.lines || wishes.arcs) && wishes.tolerance_mm > 0.0 && !text::has_error(result.diagnostics))
      merge(wishes, result);
    if (result.before && result.after) result.saved = saving_between(*result.before, *result.after, request_.cost);
    return result;
  }

 private:
  void merge(const MergeWishes& wishes, OptimizeResult& result) {
    const text::Source exact(request_.source.name(), result.text);
    MergedBlocks merged = merge_blocks(exact, request_.control, library(), wishes);
    result.not_merged = std::move(merged.obstacle);
    if (merged.groups.empty()) return;
    const auto line_before = [&](std::uint32_t line) {
      return result.origin_lines.empty()          ? line
             : line <= result.origin_lines.size() ? result.origin_lines[line - 1]
                                                  : 0;
    };
    for (const MergedGroup& group : merged.groups)
      result.changes.push_back(
          {group.is_arc ? optimize::Rule::arcs : optimize::Rule::lines, line_before(group.first_line),
           fmt::format("{} blocks are one, {} mm off at most", group.last_line - group.first_line + 1,
                       text::format_fixed(group.off_mm, 6))});
    const std::optional<ComputeCost> exact_cost = result.after;
    std::optional<ComputeCost> lines_cost;
    if (wishes.lines && wishes.arcs && exact_cost) lines_cost = cost_of_lines(exact, wishes);
    for (std::uint32_t& line : merged.origin_lines) line = line_before(line);
    result.off_mm = merged.most_mm;
    result.text = std::move(merged.text);
    result.origin_lines = std::move(merged.origin_lines);
    if (!exact_cost) return;
    result.after = cost_of_text(result.text);
    if (result.savings.empty() && exact.text() != request_.source.text()) return;  // part of the sum is not known
    const ComputeCost between = !wishes.arcs ? *result.after : lines_cost ? *lines_cost : *exact_cost;
    add_saving(optimize::Rule::lines, *exact_cost, between, result);
    add_saving(optimize::Rule::arcs, between, *result.after, result);
    std::erase_if(result.savings, [](const RuleSaving& one) {
      return one.edits == 0 && (one.rule == optimize::Rule::lines || one.rule == optimize::Rule::arcs);
    });
  }

  // Of the text with its lines merged and its arcs left.
  [[nodiscard]] ComputeCost cost_of_lines(const text::Source& exact, MergeWishes wishes) {
    wishes.arcs = false;
    return cost_of_text(merge_blocks(exact, request_.control, library(), wishes).text);
  }

  [[nodiscard]] ComputeCost cost_of_text(const std::string& made) {
    const text::Source source(request_.source.name(), made);
    return cost_of(run(dialect_.read(source, request_.control).program, 0));
  }

  OptimizeResult run_exact() {
    OptimizeResult result;
    result.text = request_.source.text();
    ir::ReadResult read = dialect_.read(request_.source, request_.control);
    result.diagnostics = std::move(read.diagnostics);
    if (text::has_error(result.diagnostics)) return result;
    read_faults_ = faults_of(result.diagnostics, read.program);
    if (read.program.sections.size() > 1) {
      result.obstacle = "several programs in one text";
      return result;
    }
    bool is_first = true;
    optimize::Rules best = request_.settings.rules;
    for (const optimize::Rules& rules : rules_to_try()) {
      std::optional<Attempt> tried = try_rules(read.program, rules);
      if (!tried) continue;
      Attempt& attempt = *tried;
      const bool is_better = attempt.after && result.after && attempt.after->total_ms < result.after->total_ms;
      if (!std::exchange(is_first, false) && !is_better) continue;
      best = rules;
      result.obstacle = std::move(attempt.obstacle);
      result.not_verified = std::move(attempt.not_verified);
      result.before = attempt.before;
      result.after = attempt.after;
      result.changes = std::move(attempt.changes);
      result.origin_lines = std::move(attempt.origin_lines);
      result.text = attempt.text.empty() ? request_.source.text() : std::move(attempt.text);
      if (!result.after) break;  // what cannot be compared cannot be made better
    }
    if (result.after && result.after->total_ms > result.before->total_ms) {
      result.text = request_.source.text();
      result.changes.clear();
      result.origin_lines.clear();
      result.after = result.before;
    }
    if (best.has(optimize::Rule::table) && request_.settings.tolerance_mm > 0.0) tabulate(read.program, best, result);
    attribute(read.program, result);
    return result;
  }

  // Tables with more and more spans, until the moves are near enough to those of the program.
  void tabulate(const ir::Program& before, const optimize::Rules& rules, OptimizeResult& result) {
    result.not_tabulated = "its run is not known";
    if (!result.after || !result.not_verified.empty()) return;
    const RecordedRun old_run = run(before, 0);
    if (takes_values(before) && first_difference(old_run, run(before, 1))) {
      result.not_tabulated = "its moves depend on values from outside";
      return;
    }
    const std::string none =
        "no loop that counts from number to number computes a place, or too few variables are free";
    std::string why = none;
    for (const bool nested : {true, false}) {
      table_ = {.spans = 1, .nested = nested};
      result.not_tabulated = none;
      for (int tries = 0; tries < kMostTables; ++tries) {
        const std::optional<double> off = try_table(before, old_run, rules, result);
        if (result.not_tabulated.empty()) return;
        if (!off) break;
        // Twice the spans leave a quarter.
        const double more = std::sqrt(*off / request_.settings.tolerance_mm);
        table_.spans =
            std::max(table_.spans + 1, static_cast<std::uint32_t>(std::min(table_.spans * more, kMostSpans)));
      }
      if (why == none) why = std::move(result.not_tabulated);
    }
    result.not_tabulated = std::move(why);
  }
  static constexpr int kMostTables = 12;
  static constexpr double kMostSpans = 1e5;

  // Takes the table into the result where it is within the tolerance and saves time. How far it is off where more spans
  // may be near enough.
  std::optional<double> try_table(const ir::Program& before, const RecordedRun& old_run, const optimize::Rules& rules,
                                  OptimizeResult& result) {
    WrittenText made = written_by(before, rules);
    const auto is_table = [](const optimize::Change& change) { return change.rule == optimize::Rule::table; };
    if (std::ranges::none_of(made.report.changes, is_table)) return {};
    const text::Source text(request_.source.name(), std::move(made.text.text));
    const ir::ReadResult read = dialect_.read(text, request_.control);
    result.not_tabulated = new_fault(read);
    if (!result.not_tabulated.empty()) return {};
    const RecordedRun new_run = run(read.program, 0);
    const std::optional<double> off = distance_apart(old_run, new_run);
    if (!input_of(new_run).empty() || old_run.result.ended != new_run.result.ended || !off) {
      result.not_tabulated = "with a table the program would make other moves";
      return {};
    }
    if (*off > request_.settings.tolerance_mm) {
      result.not_tabulated =
          fmt::format("a table of {} rows is {} mm off", table_.spans + 1, text::format_fixed(*off, 6));
      return off;
    }
    const ComputeCost cost = cost_of(new_run);
    if (cost.total_ms >= result.after->total_ms) {
      result.not_tabulated = "a table saves no time";
      return {};
    }
    for (optimize::Change& change : made.report.changes)
      if (is_table(change)) change.what += fmt::format(", {} mm off at most", text::format_fixed(*off, 6));
    result.not_tabulated.clear();
    result.after = cost;
    result.changes = std::move(made.report.changes);
    result.origin_lines = std::move(made.text.origin_lines);
    result.text = text.text();
    result.off_mm = off;
    return off;
  }

  struct Attempt {
    std::string text;  // empty: as it was
    std::vector<std::uint32_t> origin_lines;
    std::vector<optimize::Change> changes;
    std::string obstacle;
    std::string not_verified;
    std::optional<ComputeCost> before;
    std::optional<ComputeCost> after;
  };

  // Structures cost blocks of their own: which of them pay is seen by trying.
  [[nodiscard]] std::vector<optimize::Rules> rules_to_try() const {
    std::vector<optimize::Rules> out = {request_.settings.rules};
    for (const optimize::Rule left_out : {optimize::Rule::branches, optimize::Rule::loops}) {
      if (!out.back().has(left_out)) continue;
      out.push_back(out.back());
      out.back().set(left_out, false);
    }
    return out;
  }

  struct WrittenText {
    ChangedText text;  // none with an obstacle
    optimize::Result report;
  };
  [[nodiscard]] WrittenText written_by(const ir::Program& before, const optimize::Rules& rules) const {
    ir::Program changed = before;
    optimize::Settings settings = request_.settings;
    settings.rules = rules;
    settings.table = table_;
    WrittenText out;
    out.report = optimize::optimize(changed, request_.control, request_.cost, settings);
    if (!out.report.obstacle.empty()) return out;
    const KeptText kept{.comments = !rules.has(optimize::Rule::comments),
                        .numbers = !rules.has(optimize::Rule::numbers)};
    out.text = changed_text(before, changed, out.report.made, dialect_, request_.control, kept);
    return out;
  }

  // Nothing where rules that change nothing more lead to the text that was tried before.
  std::optional<Attempt> try_rules(const ir::Program& before, const optimize::Rules& rules) {
    Attempt attempt;
    WrittenText made = written_by(before, rules);
    ChangedText& written = made.text;
    attempt.obstacle = std::move(made.report.obstacle);
    if (!attempt.obstacle.empty()) return attempt;
    if (written.text == tried_) return {};
    tried_ = written.text;
    const text::Source text(request_.source.name(), std::move(written.text));
    attempt.obstacle = prove(before, text, attempt);
    if (!attempt.obstacle.empty()) return attempt;
    attempt.changes = std::move(made.report.changes);
    attempt.text = text.text();
    attempt.origin_lines = std::move(written.origin_lines);
    return attempt;
  }

  [[nodiscard]] ProgramLibrary& library() { return request_.library == nullptr ? own_library_ : *request_.library; }

  // Empty, or why the new text must not be used.
  std::string prove(const ir::Program& before, const text::Source& text, Attempt& attempt) {
    const ir::ReadResult read = dialect_.read(text, request_.control);
    if (std::string fault = new_fault(read); !fault.empty()) return fault;
    for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{2}}) {
      const RecordedRun old_run = run(before, seed);
      const RecordedRun new_run = run(read.program, seed);
      if (const std::string input = input_of(old_run); !input.empty()) {
        attempt.not_verified = "its run depends on " + input;
        return {};
      }
      if (old_run.result.ended != new_run.result.ended)
        return fmt::format("the faster program would end differently ({})", interpreter::name_of(new_run.result.ended));
      if (!old_run.is_whole || old_run.result.ended == interpreter::Ended::limit) {
        attempt.not_verified = "it runs too long to be compared whole";
        return {};
      }
      if (old_run.result.ended == interpreter::Ended::alarm) {
        if (seed == 0) attempt.not_verified = "its run ends by an alarm";
        continue;
      }
      if (const auto line = first_difference(old_run, new_run))
        return fmt::format("the faster program would make other moves (line {})", *line);
      if (seed == 0) {
        attempt.before = cost_of(old_run);
        attempt.after = cost_of(new_run);
      }
      if (!takes_values(before)) break;
    }
    return {};
  }

  // What decides in the run and is not known; empty where nothing is.
  static std::string input_of(const RecordedRun& run) {
    for (const interpreter::NotInterpreted& lost : run.result.not_interpreted)
      if (lost.is_input) return lost.name;
    return {};
  }

  // A finding of the control's own checks that the program did not have before.
  [[nodiscard]] std::string new_fault(const ir::ReadResult& read) const {
    for (const auto& [id, message] : faults_of(read.diagnostics, read.program))
      if (!read_faults_.contains(id)) return "the control would object to the faster program: " + message;
    return {};
  }
  [[nodiscard]] std::map<text::DiagnosticId, std::string> faults_of(const std::vector<text::Diagnostic>& of_reading,
                                                                    const ir::Program& program) const {
    std::map<text::DiagnosticId, std::string> out;
    const auto take = [&](const std::vector<text::Diagnostic>& diagnostics) {
      for (const text::Diagnostic& d : diagnostics)
        if (d.severity == text::Severity::error) out.try_emplace(d.id, text::message_of(d));
    };
    take(of_reading);
    take(dialect_.validate(program, request_.control, ir::Delivery::memory));
    return out;
  }

  [[nodiscard]] static bool takes_values(const ir::Program& program) {
    return std::ranges::any_of(program.variables, [](const ir::Variable& v) { return v.bank != ir::Bank::named; });
  }

  // Values for what the program may find in the control's memory: the same for both.
  [[nodiscard]] std::vector<interpreter::InitialValue> values(const ir::Program& program, std::uint64_t seed) const {
    std::vector<interpreter::InitialValue> out;
    // Where nothing is vacant a variable that was never set is 0; the value is given, so that the run knows it.
    if (seed == 0 && request_.control.semantics.has_vacant) return out;
    std::set<std::pair<ir::Bank, std::uint32_t>> given;
    for (const ir::Variable& v : program.variables) {
      if (v.bank != ir::Bank::hash && v.bank != ir::Bank::r) continue;
      if (v.index != ir::ExpressionId::none || !given.emplace(v.bank, v.number).second) continue;
      const ir::VariableRange* range = ir::find_variable(request_.control, v.bank, v.number);
      if (range == nullptr || !range->writable || range->use == ir::VariableUse::system) continue;
      const std::uint64_t state = (seed << 32U | v.number) * 0x9E3779B97F4A7C15ULL;
      out.push_back(
          {.bank = v.bank, .number = v.number, .value = seed == 0 ? 0.0 : static_cast<double>(state >> 40U) / 65536.0});
    }
    return out;
  }

  [[nodiscard]] RecordedRun run(const ir::Program& program, std::uint64_t seed) {
    interpreter::RunOptions options;
    options.limits = run_limits({});
    options.initial_values = values(program, seed);
    return record(program, request_.control, library(), options, {}, {});
  }

  [[nodiscard]] ComputeCost cost_of(const RecordedRun& run) const { return compute_cost(run, request_.cost); }

  // --- what each rule saves

  void add_saving(optimize::Rule rule, const ComputeCost& before, const ComputeCost& after, OptimizeResult& result) {
    const auto edits = std::ranges::count(result.changes, rule, &optimize::Change::rule);
    result.savings.push_back({rule, static_cast<std::size_t>(edits), saving_between(before, after, request_.cost)});
  }

  // Those that the text was made by, in their order. Dropping comments and numbers is not listed as changes.
  [[nodiscard]] std::vector<optimize::Rule> applied(const OptimizeResult& result) const {
    std::vector<optimize::Rule> out;
    for (std::size_t i = 0; i < optimize::kRules; ++i) {
      const auto rule = static_cast<optimize::Rule>(i);
      const bool is_of_text = rule == optimize::Rule::comments || rule == optimize::Rule::numbers;
      const bool listed = std::ranges::find(result.changes, rule, &optimize::Change::rule) != result.changes.end();
      if (listed || (is_of_text && request_.settings.rules.has(rule))) out.push_back(rule);
    }
    return out;
  }

  void attribute(const ir::Program& before, OptimizeResult& result) {
    if (!result.before || !result.after || result.text == request_.source.text()) return;
    optimize::Rules rules = optimize::Rules::none();
    ComputeCost last = *result.before;
    std::string last_text(request_.source.text());
    for (const optimize::Rule rule : applied(result)) {
      rules.set(rule, true);
      WrittenText made = written_by(before, rules);
      if (made.text.text == last_text) continue;
      const ComputeCost cost = made.text.text == result.text ? *result.after : cost_of_text(made.text.text);
      // Figures of another run are of other work.
      if (cost.moves != result.before->moves) return result.savings.clear();
      add_saving(rule, last, cost, result);
      last = cost;
      last_text = std::move(made.text.text);
    }
    if (last_text != result.text) result.savings.clear();
  }

  const OptimizeRequest& request_;
  const Dialect& dialect_;
  ProgramLibrary own_library_;
  optimize::TableWish table_;                              // none while exact rules are tried
  std::string tried_;                                      // the text of the attempt before
  std::map<text::DiagnosticId, std::string> read_faults_;  // errors that the program has
};

}  // namespace

OptimizeResult optimize_text(const OptimizeRequest& request) { return Optimization(request).run(); }

}  // namespace dripfeed::compile
