// REPEAT and REPEATB, for controls that know jumps only. A counter for each REPEAT says how often its part is still to
// run; 0 while another runs through it:
//
//            REPEAT A B P=3                    #c = 3
//            …                                 IF [#c LT 1] GOTO back
//        A:  …                                 GOTO first
//        B:  G0 X5                      back:  …
//            …                          first: …
//                                              G0 X5
//                                              IF [#c LT 1] GOTO on
//                                              #c = #c - 1
//                                              IF [#c GE 1] GOTO first
//                                              GOTO back
//                                       on:    …
//
// A part that ends at its own REPEAT is a loop: there the counter is set when it is reached for the first time.
#include <algorithm>
#include <string>
#include <utility>

#include "dialects/ir/repetition.h"
#include "dialects/passes/rewrite.h"
#include "dialects/passes/structure_parts.h"
#include "dialects/passes/structures.h"

namespace dripfeed::passes {

namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::RepeatedPart;
using ir::StatementKind;

// A part with what its jumps need.
struct Loop {
  RepeatedPart part;
  ir::SymbolId counter = ir::SymbolId::none;
  std::uint32_t first_number = 0;
  std::uint32_t back_number = 0;  // after the REPEAT
  bool can_be_repeated = false;

  // The statement after which the run goes back.
  [[nodiscard]] std::uint32_t end() const { return part.last == ir::kNoIndex ? part.repeat : part.last; }
  [[nodiscard]] bool ends_at_repeat() const { return part.last == ir::kNoIndex; }
  [[nodiscard]] bool holds(std::uint32_t statement) const { return part.first <= statement && statement <= end(); }
};

class RepeatedParts {
 public:
  RepeatedParts(ir::Program& program, FreeNumbers& numbers) : program_(program), numbers_(numbers), out_(program) {}

  StructureReport run() {
    find();
    if (loops_.empty()) return std::move(report_);
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      out_.at(i);
      if (i == first_block_) start_counters();
      for (const Loop& loop : loops_)
        if (loop.can_be_repeated && loop.part.first == i) out_.label_next(loop.first_number);
      statement(i);
      for (const Loop& loop : loops_)
        if (loop.can_be_repeated && !loop.ends_at_repeat() && loop.part.last == i) end_part(loop);
    }
    out_.finish();
    return std::move(report_);
  }

 private:
  void find() {
    for (const RepeatedPart& part : ir::repeated_parts(program_)) loops_.push_back({.part = part});
    if (loops_.empty()) return;
    find_loop_levels();
    find_first_block();
    for (Loop& loop : loops_) {
      loop.can_be_repeated = can_be_repeated(loop);
      if (!loop.can_be_repeated) continue;
      loop.counter = new_counter();
      loop.first_number = numbers_.next();
      loop.back_number = numbers_.next();
    }
  }

  // Heads stay in front.
  void find_first_block() {
    const auto is_head = [](const ir::Statement& s) {
      return s.kind == StatementKind::procedure || s.kind == StatementKind::declaration ||
             s.kind == StatementKind::define || s.kind == StatementKind::empty;
    };
    first_block_ = static_cast<std::uint32_t>(std::ranges::find_if_not(program_.statements, is_head) -
                                              program_.statements.begin());
  }

  // Which loop each statement stands in: no control jumps into one.
  void find_loop_levels() {
    std::vector<std::uint32_t> open = {ir::kNoIndex};
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      const StatementKind kind = program_.statements[i].kind;
      if (ends_loop(kind) && open.size() > 1) open.pop_back();
      loop_of_.push_back(open.back());
      if (begins_loop(kind)) open.push_back(i);
    }
  }

  [[nodiscard]] bool can_be_repeated(const Loop& loop) const {
    const RepeatedPart& part = loop.part;
    if (!part.is_found() || part.first > loop.end()) return false;
    const std::uint32_t inside = loop_of_[part.repeat];
    if (loop_of_[part.first] != inside || loop_of_[loop.end()] != inside) return false;
    if (!loop.ends_at_repeat() && runs(loop, part.repeat)) return false;  // it would begin again for ever
    // Another REPEAT that runs over this part's end while this part runs would be taken for its end.
    return std::ranges::none_of(loops_, [&](const Loop& other) {
      return &other != &loop && other.part.is_found() && runs(loop, other.part.repeat) && runs(other, loop.end());
    });
  }

  // Whether the statement is in the part, or in a part that is repeated from there.
  [[nodiscard]] bool runs(const Loop& loop, std::uint32_t statement) const {
    std::vector<bool> seen(loops_.size(), false);
    std::vector<const Loop*> work = {&loop};
    while (!work.empty()) {
      const Loop& at = *work.back();
      work.pop_back();
      if (at.holds(statement)) return true;
      for (std::size_t i = 0; i < loops_.size(); ++i) {
        if (seen[i] || !loops_[i].part.is_found() || !at.holds(loops_[i].part.repeat)) continue;
        seen[i] = true;
        work.push_back(&loops_[i]);
      }
    }
    return false;
  }

  // Once: a jump back to the first block leaves the repetitions that are on as they are, and a switch that passes over
  // the first block does not pass over this.
  void start_counters() {
    for (const Loop& loop : loops_) {
      if (!loop.can_be_repeated) continue;
      assign(loop, program_.add_constant(0.0));
      out_.last().skip_level = 0;
    }
    out_.labels_from_here();
  }

  void statement(std::uint32_t i) {
    if (program_.statements[i].kind != StatementKind::repeat_section) return out_.keep();
    const auto loop = std::ranges::find(loops_, i, [](const Loop& one) { return one.part.repeat; });
    if (!loop->can_be_repeated) return out_.keep();  // the control that has no REPEAT says so
    ++report_.changed;
    if (loop->ends_at_repeat()) return loop_back(*loop, i);
    assign(*loop, times_of(i));
    out_.emit_jump(jump_to(loop->back_number, is_done(*loop)));
    out_.emit_jump(jump_to(loop->first_number));
    out_.label_next(loop->back_number);
  }

  // REPEAT at the end of its own part.
  void loop_back(const Loop& loop, std::uint32_t i) {
    const std::uint32_t begin = numbers_.next();
    const std::uint32_t test = numbers_.next();
    out_.emit_jump(jump_to(begin, is_done(loop)));
    assign(loop, one_less(loop));
    out_.emit_jump(jump_to(test));
    out_.label_next(begin);
    assign(loop, times_of(i));
    out_.label_next(test);
    out_.emit_jump(jump_to(loop.first_number, is_left(loop)));
  }

  // The operator's switch may leave out the last block of the part, not its end.
  void end_part(const Loop& loop) {
    const std::uint32_t on = is_last(loop) ? 0 : numbers_.next();
    if (on != 0) {
      out_.emit_jump(jump_to(on, is_done(loop)));
      out_.last().skip_level = 0;
    }
    assign(loop, one_less(loop));
    out_.last().skip_level = 0;
    out_.emit_jump(jump_to(loop.first_number, is_left(loop)));
    out_.last().skip_level = 0;
    out_.emit_jump(jump_to(loop.back_number));
    out_.last().skip_level = 0;
    if (on != 0) out_.label_next(on);
  }

  // No one but its REPEAT runs into a part that the text ends with: that would be the missing end of the program.
  [[nodiscard]] bool is_last(const Loop& loop) const {
    const bool another = std::any_of(&loop + 1, loops_.data() + loops_.size(), [&](const Loop& other) {
      return other.can_be_repeated && other.part.last == loop.part.last;
    });
    return !another && std::all_of(program_.statements.begin() + loop.part.last + 1, program_.statements.end(),
                                   [](const ir::Statement& s) { return s.kind == StatementKind::empty; });
  }

  // P as a whole number; 1 without it.
  ExpressionId times_of(std::uint32_t i) {
    const ExpressionId times = program_.repeats[program_.statements[i].payload].times;
    if (times == ExpressionId::none) return program_.add_constant(1.0);
    if (program_.at(times).op == Operator::constant) return times;
    return program_.add_operator(Operator::round, times, ExpressionId::none);
  }

  ir::SymbolId new_counter() {
    ir::Symbol symbol;
    symbol.name = program_.strings.add("repetitions " + std::to_string(++made_));
    return program_.add(symbol);
  }
  ir::Variable counter(const Loop& loop) {
    ir::Variable variable;
    variable.bank = ir::Bank::named;
    variable.symbol = loop.counter;
    return variable;
  }
  ExpressionId count(const Loop& loop) { return program_.add_variable(counter(loop)); }
  ExpressionId one_less(const Loop& loop) {
    return program_.add_operator(Operator::subtract, count(loop), program_.add_constant(1.0));
  }
  ExpressionId is_done(const Loop& loop) {
    return program_.add_operator(Operator::less, count(loop), program_.add_constant(1.0));
  }
  ExpressionId is_left(const Loop& loop) {
    return program_.add_operator(Operator::greater_equal, count(loop), program_.add_constant(1.0));
  }
  void assign(const Loop& loop, ExpressionId value) { out_.emit_assign(program_.add(counter(loop)), value); }

  ir::Program& program_;
  FreeNumbers& numbers_;
  Rewrite out_;
  StructureReport report_;
  std::vector<Loop> loops_;
  std::vector<std::uint32_t> loop_of_;  // of each statement: the loop around it, or none
  std::uint32_t first_block_ = 0;
  std::uint32_t made_ = 0;
};

}  // namespace

StructureReport lower_repeated_parts(ir::Program& program, FreeNumbers& numbers) {
  return RepeatedParts(program, numbers).run();
}

}  // namespace dripfeed::passes
