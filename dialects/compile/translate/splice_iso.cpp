// The parts are read as a program of their own, which has the lines and places of this one. Line by line its statements
// are copied over.
#include "dialects/compile/translate/splice_iso.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "dialects/compile/dialect/iso_mode.h"
#include "dialects/compile/translate/iso_increments.h"
#include "dialects/compile/translate/iso_words.h"
#include "dialects/facts/flow_graph.h"
#include "dialects/ir/cycle.h"
#include "dialects/ir/frame_use.h"
#include "dialects/macro_b/writer/drill_levels.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/rewrite.h"

namespace dripfeed::compile {

namespace {

using ir::ExpressionId;
using ir::Function;
using ir::StatementKind;
using ir::StringId;

// Expressions and texts of one program, put into another.
class Copier {
 public:
  Copier(const ir::Program& from, ir::Program& to) : from_(from), to_(to) {}

  // Numbers and their signs: a part has no variables.
  ExpressionId expression(ExpressionId id) {
    if (id == ExpressionId::none) return id;
    ir::Expression copy = from_.at(id);
    copy.a = expression(copy.a);
    copy.b = expression(copy.b);
    copy.c = expression(copy.c);
    copy.string = string(copy.string);
    return to_.add(copy);
  }
  StringId string(StringId id) { return id == StringId::none ? id : to_.strings.add(from_.strings.at(id)); }
  ir::Code code(ir::Code c) {
    c.number = expression(c.number);
    c.name = string(c.name);
    return c;
  }
  ir::Word word(ir::Word w) {
    w.value = expression(w.value);
    w.name = string(w.name);
    w.axis = expression(w.axis);
    return w;
  }
  ir::Jump jump(ir::Jump j) {
    j.condition = expression(j.condition);
    j.computed = expression(j.computed);
    j.label = string(j.label);
    return j;
  }
  // Without its arguments.
  ir::Call call(ir::Call c) {
    c.name = string(c.name);
    c.number = expression(c.number);
    c.computed = expression(c.computed);
    c.repeats = expression(c.repeats);
    c.start = expression(c.start);
    return c;
  }

 private:
  const ir::Program& from_;
  ir::Program& to_;
};

bool is_frame(const ir::Code& c) {
  constexpr Function kFrames[] = {Function::local_shift, Function::local_shift_add, Function::axial_shift,
                                  Function::rotate,      Function::scale,           Function::mirror};
  return std::ranges::find(kFrames, c.function) != std::end(kFrames) && !ir::ends_frame(c.function, c.argument);
}

bool is_polar(const ir::Word& w) {
  return w.address == ir::Address::polar_angle || w.address == ir::Address::polar_radius;
}
bool names_polar(const ir::Code& c) { return c.function == Function::polar_words_on; }

class Splicing {
 public:
  Splicing(ir::Program& program, const ir::Control& from, const ir::Control& to)
      : program_(program),
        from_(from),
        to_(to),
        iso_control_(iso_control(from)),
        iso_(read_iso_parts(program, iso_control_).program),
        copy_(iso_, program),
        words_(program, iso_control_, to),
        out_(program) {
    join_tokens();
  }

  std::vector<text::Diagnostic> run() {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      out_.at(i);
      if (const facts::StatementRange range = facts::section_of(program_, i); range.first == i) begin_program(range);
      if (is_in_part(i))
        iso_line(i);
      else
        siemens_statement(program_.statements[i]);
    }
    out_.finish();
    for (ir::Call& call : program_.calls) call.in_other_language = false;
    std::ranges::move(words_.take_diagnostics(), std::back_inserter(diagnostics_));
    if (text::has_error(diagnostics_)) return std::move(diagnostics_);
    std::ranges::move(translate_iso_increments(program_, from_, iso_control_, to_), std::back_inserter(diagnostics_));
    // Drilling cycles of Siemens mode are calls: each of these is one of ISO mode.
    std::ranges::move(macro_b::drill_levels(program_, iso_control_, to_), std::back_inserter(diagnostics_));
    return std::move(diagnostics_);
  }

 private:
  // What Siemens mode has of its own in the program that begins.
  void begin_program(facts::StatementRange range) {
    words_.begin_program();
    own_ = {};
    calls_each_move_ = iso_calls_each_move_ = reported_ = false;
    if (range.first == range.last) return;
    own_.first_line = program_.statements[range.first].line;
    own_.last_line = program_.statements[range.last - 1].line;
    for (std::uint32_t i = range.first; i < range.last; ++i) {
      if (program_.statements[i].kind != StatementKind::block) continue;
      const ir::Block& block = program_.blocks[program_.statements[i].payload];
      own_.frames |= std::ranges::any_of(program_.codes_of(block), is_frame);
      own_.poles |= std::ranges::any_of(program_.words_of(block), is_polar);
    }
    for (const ir::Label& label : program_.labels)
      if (label.statement >= range.first && label.statement < range.last) own_.numbers.insert(label.number);
  }

  // Parts are in order.
  bool is_in_part(std::uint32_t statement) {
    const auto& parts = program_.foreign_parts;
    while (part_ < parts.size() && parts[part_].last <= statement) ++part_;
    return part_ < parts.size() && parts[part_].first <= statement;
  }

  void siemens_statement(const ir::Statement& s) {
    follow_calls(s, calls_each_move_);
    if (s.kind == StatementKind::block) {
      const ir::Block& block = program_.blocks[s.payload];
      if (block.word_count != 0) refuse_in_effect(s);
      words_.follow(program_.codes_of(block));
    } else if (s.kind != StatementKind::empty && s.kind != StatementKind::program_end) {
      refuse_in_effect(s);
    }
    out_.keep();
  }

  // An end that a switch may leave out ends nothing for certain.
  static void follow_calls(const ir::Statement& s, bool& calls_each_move) {
    if (s.kind == StatementKind::modal_call) calls_each_move = true;
    if (s.kind == StatementKind::modal_call_end && s.skip_level == 0) calls_each_move = false;
  }

  // What goes on into the blocks of Siemens mode, is stated at the first one that it would matter to.
  void refuse_in_effect(const ir::Statement& s) {
    std::string what(words_.in_effect());
    if (iso_calls_each_move_) what = "G66 of ISO mode, which is in effect,";
    if (!what.empty() && !std::exchange(reported_, true)) cannot(what, s.span);
  }

  // The line's first statement stands for all of them.
  void iso_line(std::uint32_t index) {
    refuse_skipped_switch(index);
    const std::uint32_t line = program_.statements[index].line;
    for (; next_ < iso_.statements.size() && iso_.statements[next_].line <= line; ++next_) {
      const ir::Statement& s = iso_.statements[next_];
      if (s.line != line || !in_text_of_part(s.span.begin)) continue;  // of Siemens mode
      add_labels(next_);
      statement(s);
    }
  }

  // Which language the blocks are in, the switch of block skip would decide.
  void refuse_skipped_switch(std::uint32_t index) {
    const ir::ForeignPart& part = program_.foreign_parts[part_];
    const auto& statements = program_.statements;
    const bool begins = index == part.first;
    const bool ends = index + 1 == part.last && part.ends_by_switch && part.last < statements.size();
    for (const auto& [is_switch, at] : {std::pair(begins, index), std::pair(ends, index + 1)})
      if (is_switch && statements[at].skip_level != 0)
        cannot(passes::at_switch("a switch of the language that block skip may leave out"), statements[at].span);
  }

  // A number that a block of Siemens mode has, too, stays that block's: jumps to it are not to find another.
  void add_labels(std::uint32_t index) {
    auto label = std::ranges::lower_bound(iso_.labels, index, {}, &ir::Label::statement);
    for (; label != iso_.labels.end() && label->statement == index; ++label)
      if (!own_.numbers.contains(label->number)) out_.label_next(label->number);
  }

  void statement(const ir::Statement& s) {
    const std::uint32_t payload = copied_payload(s);
    follow_calls(s, iso_calls_each_move_);
    out_.emit(s.kind, payload);
    ir::Statement& made = out_.last();
    made.skip_level = s.skip_level;
    made.tokens = {iso_token_at_[s.tokens.first], iso_token_at_[s.tokens.last]};
    made.span = s.span;
  }

  // What has none keeps it.
  std::uint32_t copied_payload(const ir::Statement& s) {
    if (s.kind == StatementKind::block || s.kind == StatementKind::program_end) return block(s);
    if (s.kind == StatementKind::call || s.kind == StatementKind::modal_call) return call(s);
    if (s.kind == StatementKind::return_to) return add(program_.jumps, copy_.jump(iso_.jumps[s.payload]));
    if (s.kind == StatementKind::native) return native(s);
    return s.payload;
  }

  template <class Payload>
  static std::uint32_t add(std::vector<Payload>& arena, Payload payload) {
    arena.push_back(std::move(payload));
    return static_cast<std::uint32_t>(arena.size() - 1);
  }

  std::uint32_t block(const ir::Statement& s) {
    if (s.payload == ir::kNoIndex) return s.payload;
    const ir::Block old = iso_.blocks[s.payload];
    std::vector<ir::Code> codes;
    std::vector<ir::Word> words;
    for (const ir::Code& c : iso_.codes_of(old)) codes.push_back(copy_.code(c));
    for (const ir::Word& w : iso_.words_of(old)) words.push_back(copy_.word(w));
    words = words_.translate(codes, words, s.skip_level != 0 || old.rest_level != 0);
    if (own_.frames && std::ranges::any_of(codes, is_frame))
      cannot(passes::together("a frame of ISO mode together with one of Siemens mode"), s.span);
    if (own_.poles && std::ranges::any_of(codes, names_polar))
      cannot(passes::together("G16 of ISO mode together with poles of Siemens mode"), s.span);
    if (std::ranges::any_of(codes, ir::follows_shape)) refuse_shape_elsewhere(s, words);
    if (calls_each_move_) cannot("a block of ISO mode after MCALL", s.span);
    ir::Block made = old;
    made.first_code = static_cast<std::uint32_t>(program_.codes.size());
    made.first_word = static_cast<std::uint32_t>(program_.words.size());
    made.word_count = static_cast<std::uint32_t>(words.size());
    program_.codes.insert(program_.codes.end(), codes.begin(), codes.end());
    program_.words.insert(program_.words.end(), words.begin(), words.end());
    return add(program_.blocks, made);
  }

  // P and Q of G70 to G73 are looked for in this part; another control looks in the whole program.
  void refuse_shape_elsewhere(const ir::Statement& s, const std::vector<ir::Word>& words) {
    const text::Span here = program_.foreign_parts[part_].text;
    for (const ir::Word& w : words) {
      if ((w.address != ir::Address::p && w.address != ir::Address::q) || w.value == ExpressionId::none) continue;
      bool found = false;
      bool elsewhere = own_.numbers.contains(static_cast<std::uint32_t>(program_.at(w.value).value));
      for (const ir::Label& label : iso_.labels) {
        const std::uint32_t line = iso_.statements[label.statement].line;
        if (label.number != program_.at(w.value).value || line < own_.first_line || line > own_.last_line) continue;
        const bool is_here = label.span.begin >= here.begin && label.span.begin < here.end;
        (is_here ? found : elsewhere) = true;
      }
      if (elsewhere || !found)
        return cannot(found ? "a cycle whose block number stands in another part of the program, too,"
                            : "a cycle whose blocks do not all stand in its part of ISO mode",
                      s.span);
    }
  }

  std::uint32_t call(const ir::Statement& s) {
    ir::Call made = copy_.call(iso_.calls[s.payload]);
    const auto first = static_cast<std::uint32_t>(program_.arguments.size());
    for (ir::Argument argument : iso_.arguments_of(iso_.calls[s.payload])) {
      argument.value = copy_.expression(argument.value);
      program_.arguments.push_back(words_.translate(argument));
    }
    made.first_argument = first;
    return add(program_.calls, made);
  }

  std::uint32_t native(const ir::Statement& s) {
    ir::Native made = iso_.natives[s.payload];
    made.name = copy_.string(made.name);
    return add(program_.natives, made);
  }

  // Within the parts they are those of ISO mode, and what a semicolon makes a comment.
  void join_tokens() {
    std::vector<ir::Token> all;
    std::vector<std::uint32_t> token_at;
    std::size_t next = 0;
    const auto take_iso = [&](std::uint32_t end) {
      for (; next < iso_.tokens.size() && iso_.tokens[next].span.begin < end; ++next) {
        iso_token_at_.push_back(static_cast<std::uint32_t>(all.size()));
        if (in_text_of_part(iso_.tokens[next].span.begin)) all.push_back(iso_.tokens[next]);
      }
    };
    for (const ir::Token& t : program_.tokens) {
      take_iso(t.span.begin);
      token_at.push_back(static_cast<std::uint32_t>(all.size()));
      if (!in_text_of_part(t.span.begin)) {
        all.push_back(t);
      } else if (t.kind == ir::TokenKind::comment && iso_.source.text()[t.span.begin] == ' ') {
        take_iso(t.span.begin + 1);
        all.back().span.end = t.span.begin;  // the blank that stands for it there
        all.push_back(t);
      }
    }
    take_iso(ir::kNoIndex);
    token_at.push_back(static_cast<std::uint32_t>(all.size()));
    iso_token_at_.push_back(static_cast<std::uint32_t>(all.size()));
    program_.tokens = std::move(all);
    for (ir::Statement& s : program_.statements) s.tokens = {token_at[s.tokens.first], token_at[s.tokens.last]};
  }
  [[nodiscard]] bool in_text_of_part(std::uint32_t place) const {
    const auto begin_of = [](const ir::ForeignPart& part) { return part.text.begin; };
    const auto next = std::ranges::upper_bound(program_.foreign_parts, place, {}, begin_of);
    return next != program_.foreign_parts.begin() && place < std::prev(next)->text.end;
  }

  void cannot(passes::Refusal what, text::Span span) {
    diagnostics_.push_back(passes::diagnose(std::move(what), span, to_.title));
  }

  ir::Program& program_;
  const ir::Control& from_;
  const ir::Control& to_;
  ir::Control iso_control_;
  ir::Program iso_;
  Copier copy_;
  IsoWords words_;
  passes::Rewrite out_;
  std::vector<text::Diagnostic> diagnostics_;
  struct Own {
    std::uint32_t first_line = 0;
    std::uint32_t last_line = 0;
    std::set<std::uint32_t> numbers;  // of blocks
    bool frames = false;
    bool poles = false;
  };
  Own own_;                                  // of Siemens mode, in the program that is at hand
  std::vector<std::uint32_t> iso_token_at_;  // the token of `program_` that one of `iso_` is
  std::size_t part_ = 0;
  std::uint32_t next_ = 0;  // statement of iso_
  bool calls_each_move_ = false;
  bool iso_calls_each_move_ = false;
  bool reported_ = false;
};

}  // namespace

bool uses_iso_mode(const ir::Program& program) {
  return !program.foreign_parts.empty() || std::ranges::any_of(program.calls, &ir::Call::in_other_language);
}

std::vector<text::Diagnostic> splice_iso_parts(ir::Program& program, const ir::Control& from, const ir::Control& to) {
  return Splicing(program, from, to).run();
}

}  // namespace dripfeed::compile
