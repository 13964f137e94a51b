// cut along NAME from VALUE [down] to VALUE AXIS VALUE ... (steps COUNT | within LENGTH): a curve by its parameter. It
// becomes loops of the language itself.
#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "dialects/family/body_reader.h"

namespace dripfeed::family {

using ir::ExpressionId;
using ir::Operator;

void BodyReader::cut_along() {
  if (skip_level_ != 0) return cursor_.syntax(verb_, "a curve is many blocks: only a single move may be skipped");
  if (!may_cut()) return;
  if (cursor_.accept_word("bezier")) return cut_along_points(true);
  if (cursor_.accept_word("nurbs")) return cut_along_points(false);
  compensation_waits_ = false;
  Along along{.loop = step(StepKind::for_begin), .cut = {}, .dimension = {}};
  const std::optional<NewName> name = expect_new_name(cursor_, scope_);
  if (!name || !cursor_.expect_word("from")) return;
  const Typed from = expressions_.value();
  along.loop.values[0] = from.id;
  along.dimension = from.dimension;
  along.loop.down = !cursor_.line_failed() && cursor_.accept_word("down");
  if (cursor_.line_failed() || !cursor_.expect_word("to")) return;
  along.loop.values[1] = expressions_.value_of(from.dimension).id;
  if (cursor_.line_failed()) return;
  scope_.open();
  along.loop.target = scope_.define(family_.arena, name->name, from.dimension, name->span);
  along.cut = step(StepKind::cut);
  axis_words(along.cut);
  if (cursor_.line_failed()) return scope_.seal();
  const auto words = std::span(family_.words).subspan(along.cut.first_word);
  if (std::ranges::any_of(words, &StepWord::is_step)) {
    cursor_.syntax(verb_, "the points of a curve are not steps: axes without 'by'");
  } else if (cursor_.accept_word("steps")) {
    equal_steps(along, expressions_.value_of(kRatio).id);
  } else if (!cursor_.at_word("within")) {
    cursor_.expected("steps or within");
  } else if (std::ranges::any_of(words, [](const StepWord& one) { return ir::is_rotary_axis(one.address); })) {
    cursor_.syntax(cursor_.peek().span, "an error is a length, and this curve turns an axis: use 'steps'");
  } else {
    cursor_.advance();
    chords(along, expressions_.value_of(kLength).id);
  }
  scope_.seal();
}

// From the loop's first value to its last, as a positive value.
ExpressionId BodyReader::span_of(const Step& loop) {
  return calculated(Operator::subtract, loop.values[loop.down ? 0 : 1], loop.values[loop.down ? 1 : 0]);
}

// As many as `count`, and the first point.
void BodyReader::equal_steps(const Along& along, ExpressionId count) {
  Step loop = along.loop;
  loop.values[2] = calculated(Operator::divide, span_of(loop), count);
  add(std::move(loop));
  add(along.cut);
  add(step(StepKind::for_end));
}

// let t = from;  cut;  let part = (to - from)/pieces;  for piece from 0 to pieces - 1 step 1
//   for chord from 1 to counts[piece] step 1;  let t = from + (piece + chord/counts[piece])*part;  cut;  end;  end
void BodyReader::chords(const Along& along, ExpressionId error) {
  if (cursor_.line_failed()) return;
  const Step& whole = along.loop;
  const ir::SymbolId counts = chord_list(along, error);
  const auto number = [&](double value) { return family_.arena.add_constant(value, verb_); };
  const auto set_place = [&](ExpressionId value) {
    Step out = step(StepKind::let);
    out.target = whole.target;
    out.values[0] = value;
    add(std::move(out));
    add(along.cut);
  };
  set_place(whole.values[0]);
  const ExpressionId part =
      kept("part", calculated(Operator::divide, span_of(whole), number(kCurvePieces)), along.dimension);
  const ExpressionId piece = count_hidden("piece", 0.0, number(kCurvePieces - 1));
  const ExpressionId chord = count_hidden("chord", 1.0, name_of(counts, piece));
  const ExpressionId parts =
      calculated(Operator::add, piece, calculated(Operator::divide, chord, name_of(counts, piece)));
  set_place(calculated(whole.down ? Operator::subtract : Operator::add, whole.values[0],
                       calculated(Operator::multiply, parts, part)));
  end_hidden_loop();
  end_hidden_loop();
}

// The list of how many chords each piece has, and the curve that they are counted for.
ir::SymbolId BodyReader::chord_list(const Along& along, ExpressionId error) {
  List list{.symbol = scope_.define(family_.arena, unused_name("chords"), kRatio, verb_, NameKind::list),
            .count = scope_.define(family_.arena, unused_name("chord_counts"), kRatio, verb_),
            .dimension = kRatio,
            .elements = {},
            .line = line_,
            .counts_chords = true};
  family_.chorded.push_back({.parameter = along.loop.target,
                             .t = {along.loop.values[0], along.loop.values[1]},
                             .error = error,
                             .counts = list.symbol,
                             .first_word = along.cut.first_word,
                             .word_count = along.cut.word_count,
                             .span = {verb_.begin, cursor_.last_span().end}});
  const ir::SymbolId symbol = list.symbol;
  family_.lists.push_back(std::move(list));
  return symbol;
}

}  // namespace dripfeed::family
