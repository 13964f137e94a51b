// A formula in a loop becomes a table: before the loops its values are computed at a few rounds of the outer loop (of
// the only one, where there is one), in all rounds of the inner one; in the loops each value lies on the straight line
// between two of the table. What computed the value in the loops is computed no longer. Only the shape of the program
// is looked at here: whether the moves stay within a tolerance, who asks finds out by running it.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dialects/ir/axis_letters.h"
#include "dialects/optimize/edit.h"
#include "dialects/optimize/table_nest.h"
#include "dialects/optimize/work.h"
#include "dialects/passes/structure_parts.h"

namespace dripfeed::optimize {

namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::StatementKind;

class Tabulating {
 public:
  Tabulating(Work& work, const TableWish& wish)
      : work_(work),
        wish_(wish),
        program_(work.program),
        places_(program_, work.control, work.own),
        accesses_(accesses_of(program_, places_)),
        around_(heads_around(program_)) {}

  bool run() {
    const NestSearch search(work_, wish_, places_, accesses_);
    const std::optional<Nest> nest = search.dearest();
    if (!nest || !take_numbers(*nest)) return false;
    const ir::Program before = program_;
    const Slice filling = search.slice_of(*nest, nest->words);
    replace_words(*nest);
    drop_what_no_block_needs(*nest);
    if (!may_fill_before(*nest, filling)) {
      program_ = before;
      return false;
    }
    write(*nest, filling, before);
    for (const TabulatedWord& word : nest->words) say(*nest, word, before);
    return true;
  }

 private:
  // --- the numbers of the table

  bool take_numbers(const Nest& nest) {
    stride_ = nest.inner ? nest.inner->rounds + 1 : 1;  // the counter may be one more at the block
    rows_ = wish_.spans + 1;
    const std::size_t size = nest.words.size() * stride_ * rows_;
    constexpr std::uint32_t kOthers = 3;
    const std::optional<NumberRange> range = free_range(work_, size + kOthers);
    if (!range) return false;
    const auto place = [&](std::uint32_t n) {
      return PlaceFacts{.bank = range->bank, .number = range->first + n, .is_own = true, .is_plain = true};
    };
    row_ = place(0), part_ = place(1), line_ = place(2);
    table_ = place(kOthers);
    return true;
  }

  // --- expressions

  ExpressionId number(double value) {
    const ExpressionId positive = program_.add_constant(std::abs(value), {}, std::trunc(value) != value);
    return value < 0.0 ? program_.add_operator(Operator::negate, positive) : positive;
  }
  ExpressionId plus(ExpressionId a, double b) {
    if (b == 0.0) return a;
    return program_.add_operator(b < 0.0 ? Operator::subtract : Operator::add, a, number(std::abs(b)));
  }
  ExpressionId times(ExpressionId a, double b) {
    return b == 1.0 ? a : program_.add_operator(Operator::multiply, a, number(b));
  }
  ExpressionId read(const PlaceFacts& place) { return read_of(program_, place); }
  ir::VariableId element(ExpressionId index) {
    ir::Variable v;
    v.bank = table_.bank;
    v.index = index;
    return program_.add(v);
  }
  ExpressionId read_element(ExpressionId index) {
    ExpressionId made = program_.add_constant(0.0);
    program_.expressions[static_cast<std::uint32_t>(made)].op = Operator::variable;
    const ir::VariableId variable = element(index);
    program_.expressions[static_cast<std::uint32_t>(made)].variable = variable;
    return made;
  }

  // Where the values of a word begin, so that the number of a row and the inner counter lead to one of them.
  [[nodiscard]] double base_of(const Nest& nest, std::size_t word) const {
    return table_.number + static_cast<double>(word * stride_ * rows_) - (nest.inner ? nest.inner->start : 0.0);
  }
  ExpressionId index_of(const Nest& nest, std::optional<ExpressionId> rows, double base) {
    std::optional<ExpressionId> index = rows;
    if (nest.inner) {
      const ExpressionId counter = read(places_.at(nest.inner->counter));
      index = index ? program_.add_operator(Operator::add, *index, counter) : counter;
    }
    return index ? plus(*index, base) : number(base);
  }

  // The value on the line between two rows.
  ExpressionId looked_up(const Nest& nest, std::size_t word) {
    const auto row = [&](double more) {
      const std::optional<ExpressionId> first = is_one_span() ? std::nullopt : std::optional(read(line_));
      return read_element(index_of(nest, first, base_of(nest, word) + more));
    };
    const ExpressionId low = row(0.0);
    const ExpressionId rise = program_.add_operator(Operator::subtract, row(stride_), row(0.0));
    const ExpressionId part = program_.add_operator(Operator::multiply, read(part_), rise);
    return program_.add_operator(Operator::add, low, part);
  }
  [[nodiscard]] bool is_one_span() const { return wish_.spans == 1; }

  // Rows that the counter has passed, with its part of the next one. A little less where there are several, so that the
  // last round lies in the last span.
  ExpressionId passed(const Nest& nest) {
    const ExpressionId since = plus(read(places_.at(nest.outer.counter)), -nest.outer.start);
    const double span = nest.outer.span();
    if (is_one_span()) return span == 1.0 ? since : program_.add_operator(Operator::divide, since, number(span));
    constexpr int kDigits = 8;
    const double rate = wish_.spans / span;
    const double scale = std::pow(10.0, kDigits - 1 - std::floor(std::log10(rate)));
    return times(since, (std::ceil(rate * scale) - 1.0) / scale);
  }

  // --- the new loops

  void replace_words(const Nest& nest) {
    passes::Rewrite out(program_);
    const auto count = static_cast<std::uint32_t>(accesses_.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      out.at(i);
      const bool is_changed = std::ranges::find(nest.words, i, &TabulatedWord::block) != nest.words.end();
      if (!is_changed) {
        out.keep();
        continue;
      }
      keep_with(program_, i, out, [&](ExpressionId value) {
        for (std::size_t w = 0; w < nest.words.size(); ++w)
          if (nest.words[w].block == i && nest.words[w].value == value) return looked_up(nest, w);
        return value;
      });
    }
    out.finish();
    accesses_ = accesses_of(program_, places_);
    for (const TabulatedWord& word : nest.words) accesses_[word.block].reads_shared = false;  // the table alone
  }

  // Backwards from what moves or is read after the loop, however often it goes round.
  void drop_what_no_block_needs(const Nest& nest) {
    const Liveness liveness(program_, places_, accesses_);
    std::vector<bool> needed(places_.count(), false);
    for (Place p = 0; p < places_.count(); ++p)
      needed[p] = nest.outer.last + 1 >= accesses_.size() || liveness.before(nest.outer.last + 1, p);
    is_dropped_.assign(accesses_.size(), false);
    for (std::uint32_t i = nest.outer.first + 1; i < nest.outer.last; ++i) is_dropped_[i] = may_drop(i);
    const auto keep = [&](std::uint32_t i) {
      is_dropped_[i] = false;
      for (const Place p : accesses_[i].reads) needed[p] = true;
    };
    for (bool changed = true; changed;) {
      changed = false;
      for (std::uint32_t i = nest.outer.first; i <= nest.outer.last; ++i) {
        const Access& access = accesses_[i];
        if (is_dropped_[i] && std::ranges::any_of(access.sets, [&](Place p) { return needed[p]; }))
          keep(i), changed = true;
        if (is_dropped_[i]) continue;
        for (const Place p : access.reads) changed = changed || !needed[p], needed[p] = true;
        if (const std::uint32_t head = around_[i]; head != ir::kNoIndex && is_dropped_[head])
          for (std::uint32_t part = head; is_dropped_[part]; part = passes::structure_at(program_, part).partner)
            keep(part), changed = true;
      }
    }
    for (std::uint32_t i = 0; i < is_dropped_.size(); ++i)
      if (is_dropped_[i]) accesses_[i] = {};
    // No jump leads to them.
    std::erase_if(program_.labels, [this](const ir::Label& label) { return is_dropped_[label.statement]; });
  }
  [[nodiscard]] bool may_drop(std::uint32_t i) const {
    const ir::Statement& s = program_.statements[i];
    if (s.kind == StatementKind::if_begin || s.kind == StatementKind::else_begin || s.kind == StatementKind::if_end)
      return !accesses_[i].reads_outside;
    return s.kind == StatementKind::assign && !accesses_[i].is_fixed && !accesses_[i].reads_outside &&
           accesses_[i].sets.size() == 1 && places_.at(accesses_[i].sets.front()).is_plain;
  }

  // What the filling changes is set again before anything reads it.
  [[nodiscard]] bool may_fill_before(const Nest& nest, const Slice& filling) const {
    const Liveness liveness(program_, places_, accesses_);
    for (Place p = 0; p < places_.count(); ++p)
      if (filling.computes[p] && p != nest.outer.counter && liveness.before(nest.outer.first, p)) return false;
    return true;
  }

  void write(const Nest& nest, const Slice& filling, const ir::Program& before) {
    passes::Rewrite out(program_);
    for (std::uint32_t i = 0; i < accesses_.size(); ++i) {
      out.at(i);
      if (i == nest.outer.first) {
        fill(nest, filling, before, out);
        out.labels_from_here();
      }
      if (!is_dropped_[i]) out.keep();
      if (i == nest.outer.first) find_rows(nest, out);
    }
    out.finish();
  }

  void made(std::uint32_t of, passes::Rewrite& out) { out.last().line = work_.new_line(program_.statements[of].line); }

  void fill(const Nest& nest, const Slice& filling, const ir::Program& before, passes::Rewrite& out) {
    const std::uint32_t first = nest.outer.first;
    out.emit_assign(variable_of(program_, row_), number(0.0));
    made(first, out);
    ir::Structure head;
    head.loop_number = passes::structure_at(before, first).loop_number;
    head.condition = program_.add_operator(Operator::less, read(row_), number(rows_));
    out.emit_structure(StatementKind::while_begin, head);
    made(first, out);
    out.emit_assign(variable_of(program_, places_.at(nest.outer.counter)), counter_of_row(nest));
    made(first, out);
    for (std::uint32_t i = first + 1; i < nest.outer.last; ++i) copy(nest, filling, before, i, out);
    out.emit_assign(variable_of(program_, row_), plus(read(row_), 1.0));
    made(first, out);
    head.condition = ExpressionId::none;
    out.emit_structure(StatementKind::while_end, head);
    made(first, out);
    if (nest.outer.init == ir::kNoIndex) return;
    out.emit_assign(variable_of(program_, places_.at(nest.outer.counter)), number(nest.outer.start));
    made(first, out);
  }

  ExpressionId counter_of_row(const Nest& nest) {
    ExpressionId along = times(read(row_), nest.outer.span());
    if (!is_one_span()) along = program_.add_operator(Operator::divide, along, number(wish_.spans));
    return plus(along, nest.outer.start);
  }

  void copy(const Nest& nest, const Slice& filling, const ir::Program& before, std::uint32_t i, passes::Rewrite& out) {
    const ir::Statement& s = before.statements[i];
    if (filling.has[i] && s.kind == StatementKind::assign) {
      const ir::Assign assign = before.assigns[s.payload];
      out.emit_assign(assign.target, assign.value);
      made(i, out);
    } else if (filling.has[i]) {
      out.emit_structure(s.kind, before.structures[s.payload]);
      made(i, out);
    }
    for (std::size_t w = 0; w < nest.words.size(); ++w) {
      if (nest.words[w].block != i) continue;
      const ExpressionId rows = times(read(row_), stride_);
      out.emit_assign(element(index_of(nest, rows, base_of(nest, w))), nest.words[w].value);
      made(i, out);
    }
  }

  // At the start of a round of the outer loop.
  void find_rows(const Nest& nest, passes::Rewrite& out) {
    if (!is_one_span()) {
      const ExpressionId whole = program_.add_operator(Operator::truncate, passed(nest));
      out.emit_assign(variable_of(program_, part_), whole);
      made(nest.outer.first, out);
      out.emit_assign(variable_of(program_, line_), times(read(part_), stride_));
      made(nest.outer.first, out);
    }
    ExpressionId part = passed(nest);
    if (!is_one_span()) part = program_.add_operator(Operator::subtract, part, read(part_));
    out.emit_assign(variable_of(program_, part_), part);
    made(nest.outer.first, out);
  }

  void say(const Nest& nest, const TabulatedWord& word, const ir::Program& before) {
    const char letter = table_.bank == ir::Bank::r ? 'R' : '#';
    const auto last = table_.number + nest.words.size() * stride_ * rows_ - 1;
    work_.report(Rule::table, before.statements[word.block].line,
                 fmt::format("{} is from a table of {} rows of {}, in {}{} to {}{}", ir::letter_of(word.address), rows_,
                             stride_, letter, table_.number, letter, last));
  }

  Work& work_;
  TableWish wish_;
  ir::Program& program_;
  Places places_;
  std::vector<Access> accesses_;
  std::vector<std::uint32_t> around_;
  std::vector<bool> is_dropped_;
  std::uint32_t stride_ = 1;
  std::uint32_t rows_ = 2;
  PlaceFacts row_, part_, line_;  // of the filling; how far between two rows; where the first of them begins
  PlaceFacts table_;
};

}  // namespace

bool tabulate(Work& work, const TableWish& wish) { return Tabulating(work, wish).run(); }

}  // namespace dripfeed::optimize
