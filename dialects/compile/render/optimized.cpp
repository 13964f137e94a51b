// The rules work on the program that a run begins with, before or after the calls in it are replaced; the programs that
// follow it in the text keep their bytes. Every text that comes out is proved as a whole against the given one.
#include "dialects/compile/render/optimized.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/render/merged_blocks.h"
#include "dialects/compile/render/optimize_base.h"
#include "dialects/compile/render/optimize_proof.h"
#include "dialects/compile/render/same_moves.h"
#include "dialects/text/number.h"

namespace dripfeed::compile {

namespace {

class Optimization {
 public:
  explicit Optimization(const OptimizeRequest& request)
      : request_(request),
        dialect_(*find_dialect(request.control.dialect)),
        own_library_(request.control, [](std::string_view) { return std::nullopt; }),
        given_(dialect_.read(request.source, request.control)) {}

  OptimizeResult run() {
    OptimizeResult result;
    result.text = request_.source.text();
    if (!text::has_error(given_.diagnostics)) {
      proof_.emplace(given_, dialect_, request_.control, request_.cost, library());
      run_exact(result);
      const optimize::Rules& rules = request_.settings.rules;
      const MergeWishes wishes{.lines = rules.has(optimize::Rule::lines),
                               .arcs = rules.has(optimize::Rule::arcs),
                               .tolerance_mm = request_.settings.tolerance_mm};
      if ((wishes.lines || wishes.arcs) && wishes.tolerance_mm > 0.0) merge(wishes, result);
      if (result.before && result.after) result.saved = saving_between(*result.before, *result.after, request_.cost);
    }
    result.diagnostics = std::move(given_.diagnostics);
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
    return proof_->cost_of_text(text::Source(request_.source.name(), made));
  }

  void run_exact(OptimizeResult& result) {
    result.obstacle = take_bases(result);
    if (!result.obstacle.empty()) return;
    optimize::Rules best = request_.settings.rules;
    take_best(best, result);
    if (!result.obstacle.empty() && inlined_) {
      for (const optimize::Change& change : inlined_->changes)
        result.not_inlined.push_back({change.line, {}, result.obstacle});
      inlined_.reset();
      tried_.clear();
      best = request_.settings.rules;
      take_best(best, result);
    }
    if (result.after && result.after->total_ms > result.before->total_ms) {
      result.text = request_.source.text();
      result.changes.clear();
      result.origin_lines.clear();
      result.after = result.before;
    }
    if (best.has(optimize::Rule::table) && request_.settings.tolerance_mm > 0.0) tabulate(best, result);
    attribute(result);
  }

  // Why nothing can be done; empty where something can.
  std::string take_bases(OptimizeResult& result) {
    if (std::string why = obstacle_after_main(given_.program); !why.empty()) return why;
    plain_ = plain_base(given_.program, dialect_, request_.control, request_.settings);
    if (!request_.settings.rules.has(optimize::Rule::inlined)) return {};
    InlinedText inlined = inline_calls(given_.program, dialect_, request_.control, library());
    result.not_inlined = std::move(inlined.kept);
    if (inlined.inlined.empty()) return {};
    inlined_ = inlined_base(given_.program, inlined, dialect_, request_.control, request_.settings);
    proof_->also_give(inlined_->main);
    return {};
  }

  // What these rules lead to, or some of them where that is faster.
  void take_best(optimize::Rules& best, OptimizeResult& result) {
    bool is_first = true;
    for (const optimize::Rules& rules : rules_to_try()) {
      std::optional<Attempt> tried = try_rules(rules);
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
  }

  // Tables with more and more spans, until the moves are near enough to those of the program.
  void tabulate(const optimize::Rules& rules, OptimizeResult& result) {
    result.not_tabulated = "its run is not known";
    if (!result.after || !result.not_verified.empty()) return;
    const RecordedRun old_run = proof_->run(given_.program, 0);
    if (proof_->takes_values() && first_difference(old_run, proof_->run(given_.program, 1))) {
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
        const std::optional<double> off = try_table(old_run, rules, result);
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
  std::optional<double> try_table(const RecordedRun& old_run, const optimize::Rules& rules, OptimizeResult& result) {
    WrittenText made = written_by(rules);
    const auto is_table = [](const optimize::Change& change) { return change.rule == optimize::Rule::table; };
    if (std::ranges::none_of(made.changes, is_table)) return {};
    const text::Source text(request_.source.name(), std::move(made.text));
    const ir::ReadResult read = dialect_.read(text, request_.control);
    result.not_tabulated = proof_->new_fault(read);
    if (!result.not_tabulated.empty()) return {};
    const RecordedRun new_run = proof_->run(read.program, 0);
    const std::optional<double> off = distance_apart(old_run, new_run);
    if (!OptimizeProof::input_of(new_run).empty() || old_run.result.ended != new_run.result.ended || !off) {
      result.not_tabulated = "with a table the program would make other moves";
      return {};
    }
    if (*off > request_.settings.tolerance_mm) {
      result.not_tabulated =
          fmt::format("a table of {} rows is {} mm off", table_.spans + 1, text::format_fixed(*off, 6));
      return off;
    }
    const ComputeCost cost = proof_->cost_of(new_run);
    if (cost.total_ms >= result.after->total_ms) {
      result.not_tabulated = "a table saves no time";
      return {};
    }
    for (optimize::Change& change : made.changes)
      if (is_table(change)) change.what += fmt::format(", {} mm off at most", text::format_fixed(*off, 6));
    result.not_tabulated.clear();
    result.after = cost;
    result.changes = std::move(made.changes);
    result.origin_lines = std::move(made.origin_lines);
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

  // A whole text; empty with an obstacle.
  struct WrittenText {
    std::string text;
    std::vector<std::uint32_t> origin_lines;
    std::vector<optimize::Change> changes;
    std::string obstacle;
  };
  [[nodiscard]] WrittenText written_by(const optimize::Rules& rules) const {
    const OptimizeBase& base = rules.has(optimize::Rule::inlined) && inlined_ ? *inlined_ : plain_;
    ir::Program changed = base.main;
    optimize::Settings settings = base.settings;
    settings.rules = rules;
    settings.table = table_;
    optimize::Result report = optimize::optimize(changed, request_.control, request_.cost, settings);
    WrittenText out;
    out.obstacle = std::move(report.obstacle);
    if (!out.obstacle.empty()) return out;
    const KeptText kept{.comments = !rules.has(optimize::Rule::comments),
                        .numbers = !rules.has(optimize::Rule::numbers)};
    ChangedText text = changed_text(base.main, changed, report.made, dialect_, request_.control, kept);
    for (optimize::Change& change : report.changes) change.line = base.given_line(change.line);
    out.changes = base.changes;
    out.changes.insert(out.changes.end(), std::make_move_iterator(report.changes.begin()),
                       std::make_move_iterator(report.changes.end()));
    for (std::uint32_t& line : text.origin_lines) line = base.given_line(line);
    out.text = std::move(text.text) + base.rest;
    out.origin_lines = std::move(text.origin_lines);
    for (std::uint32_t i = 0; i < base.rest_lines; ++i) out.origin_lines.push_back(base.rest_line + i);
    return out;
  }

  // Nothing where rules that change nothing more lead to the text that was tried before.
  std::optional<Attempt> try_rules(const optimize::Rules& rules) {
    Attempt attempt;
    WrittenText written = written_by(rules);
    attempt.obstacle = std::move(written.obstacle);
    if (!attempt.obstacle.empty()) return attempt;
    if (written.text == tried_) return {};
    tried_ = written.text;
    const text::Source text(request_.source.name(), std::move(written.text));
    OptimizeProof::Verdict verdict = proof_->prove(text);
    attempt.obstacle = std::move(verdict.obstacle);
    if (!attempt.obstacle.empty()) return attempt;
    attempt.not_verified = std::move(verdict.not_verified);
    attempt.before = verdict.before;
    attempt.after = verdict.after;
    attempt.changes = std::move(written.changes);
    attempt.text = text.text();
    attempt.origin_lines = std::move(written.origin_lines);
    return attempt;
  }

  [[nodiscard]] ProgramLibrary& library() { return request_.library == nullptr ? own_library_ : *request_.library; }

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

  void attribute(OptimizeResult& result) {
    if (!result.before || !result.after || result.text == request_.source.text()) return;
    optimize::Rules rules = optimize::Rules::none();
    ComputeCost last = *result.before;
    std::string last_text(request_.source.text());
    for (const optimize::Rule rule : applied(result)) {
      rules.set(rule, true);
      WrittenText made = written_by(rules);
      if (made.text == last_text) continue;
      const ComputeCost cost = made.text == result.text ? *result.after : cost_of_text(made.text);
      // Figures of another run are of other work.
      if (cost.moves != result.before->moves) return result.savings.clear();
      add_saving(rule, last, cost, result);
      last = cost;
      last_text = std::move(made.text);
    }
    if (last_text != result.text) result.savings.clear();
  }

  const OptimizeRequest& request_;
  const Dialect& dialect_;
  ProgramLibrary own_library_;
  ir::ReadResult given_;
  std::optional<OptimizeProof> proof_;
  OptimizeBase plain_;
  std::optional<OptimizeBase> inlined_;
  optimize::TableWish table_;  // none while exact rules are tried
  std::string tried_;          // the text of the attempt before
};

}  // namespace

OptimizeResult optimize_text(const OptimizeRequest& request) { return Optimization(request).run(); }

}  // namespace dripfeed::compile
