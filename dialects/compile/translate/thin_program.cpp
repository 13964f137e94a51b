// Lines are kept at both ends of a stretch, because passes look at neighbours, and wherever a line looks like none
// before it. A stretch is scanned once here, so that a run later finds nothing in it that is not plain.
#include "dialects/compile/translate/thin_program.h"

#include <algorithm>
#include <array>
#include <deque>
#include <iterator>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/source_lines.h"

namespace dripfeed::compile {

namespace {

constexpr std::uint32_t kKeptBefore = ThinProgram::kKeptBefore;
constexpr std::uint32_t kKeptAfter = ThinProgram::kKeptAfter;

constexpr std::array<std::string_view, 8> kCodes = {"G00", "G01", "G02", "G03", "G0", "G1", "G2", "G3"};

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view take_digits(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_not_of("0123456789"), text.size());
  const std::string_view digits = text.substr(0, end);
  text.remove_prefix(end);
  return digits;
}

void skip_blanks(std::string_view& text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
}

// "-12.5", "3.", ".25"
bool take_value(std::string_view& text) {
  if (!text.empty() && text.front() == '-') text.remove_prefix(1);
  const std::size_t whole = take_digits(text).size();
  if (text.empty() || text.front() != '.') return false;
  text.remove_prefix(1);
  const std::size_t part = take_digits(text).size();
  constexpr std::size_t kMostDigits = 9;
  return whole + part > 0 && whole + part <= kMostDigits;
}

// "300", "0.25"; a feed of zero is none.
bool take_feed(std::string_view& text, std::string_view& feed) {
  const std::size_t end = std::min(text.find_first_not_of("0123456789."), text.size());
  feed = text.substr(0, end);
  text.remove_prefix(end);
  constexpr std::size_t kMostDigits = 9;
  return feed.size() <= kMostDigits && std::ranges::count(feed, '.') <= 1 &&
         feed.find_first_not_of("0.") != std::string_view::npos;
}

// Its letter; 0: it is none of a plain move.
char take_word(std::string_view& text, MoveForm& form) {
  const char letter = text.front();
  text.remove_prefix(1);
  if (letter == 'F') {
    if (!take_feed(text, form.feed)) return 0;
    return form.feed.find('.') == std::string_view::npos ? 'f' : 'F';
  }
  const std::string_view allowed = form.is_arc() ? "XYZIJK" : "XYZABC";
  return allowed.find(letter) != std::string_view::npos && take_value(text) ? letter : '\0';
}

// Lines of the whole text, one after the other.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}
  struct Line {
    std::string_view text;
    std::size_t begin = 0;
    std::size_t end = 0;  // after its EOB
    bool has_eob = true;  // LF or CR LF
  };
  bool next(Line& line) {
    if (at_ >= text_.size()) return false;
    const std::size_t found = text_.find('\n', at_);
    line.has_eob = found != std::string_view::npos;
    const std::size_t end = std::min(found, text_.size());
    line.begin = at_;
    line.end = line.has_eob ? end + 1 : end;
    line.text = text_.substr(at_, end - at_);
    if (line.text.ends_with('\r')) line.text.remove_suffix(1);
    // LF CR CR is one EOB: what begins with CR belongs to the one before.
    at_ = line.end;
    return true;
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

// What the lines of a stretch leave in effect.
struct Modes {
  std::string_view code;  // as written; empty: that of before the run of lines
  std::string_view feed;

  void take(const MoveForm& form) {
    if (!form.code.empty()) code = form.code;
    if (!form.feed.empty()) feed = form.feed;
  }
};

class StretchFinder {
 public:
  StretchFinder(const text::Source& whole, const ThinOptions& options) : whole_(whole), options_(options) {}

  // The thin text; the stretches without their statements.
  std::string run(std::vector<ir::PlainStretch>& out) {
    std::string thin;
    Lines lines(whole_.text());
    Lines::Line line;
    std::size_t copied = 0;
    while (lines.next(line)) {
      const MoveForm form = line.has_eob ? move_form_of(line.text) : MoveForm();
      if (belongs(form)) {
        remember(form, line.begin);
        continue;
      }
      finish(thin, copied, out);
    }
    finish(thin, copied, out);
    thin += whole_.text().substr(copied);
    return thin;
  }

 private:
  // Whether the line continues the run of lines that look alike.
  bool belongs(const MoveForm& form) {
    if (!form.is_move() || (options_.straight_alone && !is_straight(form))) return false;
    if (count_ > 0 && form.number.empty() != is_unnumbered_) return false;
    // A line without a code does what the code in effect makes of it; an arc needs its centre.
    if (form.code.empty() && !now_.code.empty() && (now_.code.back() == '2' || now_.code.back() == '3')) return false;
    const std::string look = form.code.empty() ? fmt::format("{}:{}", now_.code, look_of(form)) : look_of(form);
    if (count_ == 0) is_unnumbered_ = form.number.empty();
    if (looks_.contains(look)) return true;
    // It is kept: the first of its look shows what becomes of it.
    const bool is_kept = count_ < kKeptBefore;
    looks_.insert(look);
    return is_kept;
  }

  bool is_straight(const MoveForm& form) const {
    return !form.is_arc() && form.feed.empty() && (count_ == 0 || form.code == now_.code);
  }

  // A stretch may end where the line after it states what the stretch has changed, or where that is unchanged. After
  // arcs it is a straight line to a place in their plane: an arc that is kept must begin where it should.
  void remember(const MoveForm& form, std::size_t begin) {
    if (count_ == kKeptBefore) {
      inner_begin_ = begin;
      at_begin_ = now_;
    }
    const bool has_code = now_.code == at_begin_.code || !form.code.empty();
    const bool has_feed = now_.feed == at_begin_.feed || !form.feed.empty();
    const bool has_place = arc_axes_.empty() || (!form.is_arc() && names_all(form, arc_axes_));
    if (count_ > kKeptBefore && has_code && has_feed && has_place) ends_.push_back({count_, begin});
    for (const char center : std::string_view("IJK"))
      if (form.letters.find(center) != std::string::npos) arc_axes_.insert(static_cast<char>(center - 'I' + 'X'));
    now_.take(form);
    ++count_;
    while (ends_.size() > 1 && ends_[1].lines + kKeptAfter <= count_) ends_.pop_front();
  }

  void finish(std::string& thin, std::size_t& copied, std::vector<ir::PlainStretch>& out) {
    const std::uint32_t count = std::exchange(count_, 0);
    const std::deque<End> ends = std::exchange(ends_, {});
    now_ = {};
    arc_axes_.clear();
    if (ends.empty() || ends.front().lines + kKeptAfter > count) return;
    const std::uint32_t lines = ends.front().lines - kKeptBefore;
    if (lines < options_.least_lines) return;
    ir::PlainStretch stretch{.line = whole_.position(static_cast<std::uint32_t>(inner_begin_)).line,
                             .line_count = lines,
                             .begin = inner_begin_,
                             .end = ends.front().begin};
    thin += whole_.text().substr(copied, inner_begin_ - copied);
    copied = ends.front().begin;
    out.push_back(stretch);
  }

  static bool names_all(const MoveForm& form, const std::set<char>& axes) {
    return std::ranges::all_of(axes, [&](char axis) { return form.letters.find(axis) != std::string::npos; });
  }

  struct End {
    std::uint32_t lines = 0;  // of the run before it
    std::size_t begin = 0;    // of the line after it
  };

  const text::Source& whole_;
  const ThinOptions& options_;
  std::set<std::string> looks_;
  std::uint32_t count_ = 0;  // lines of the run at hand
  std::size_t inner_begin_ = 0;
  Modes at_begin_;           // of the stretch
  Modes now_;                // after the last line of the run
  std::set<char> arc_axes_;  // in which the run has arcs
  std::deque<End> ends_;     // the newest with enough lines after it, and those that have too few as yet
  bool is_unnumbered_ = false;
};

// Whether scanning the stretch gives a row of moves for each of its lines.
bool is_plain(const ir::PlainStretches& stretches, const ir::PlainStretch& stretch) {
  const auto scanner = stretches.make_scanner();
  const std::string_view text = stretches.text;
  ir::PlainBatch batch;
  std::uint64_t rows = 0;
  for (std::uint64_t at = stretch.begin; at < stretch.end;) {
    batch.clear();
    const ir::PlainScan scan = scanner->scan(text.substr(at, stretch.end - at), batch);
    const auto moves = [](const ir::PlainCode& code) {
      constexpr std::array kMoves = {ir::Function::rapid, ir::Function::linear, ir::Function::arc_cw,
                                     ir::Function::arc_ccw};
      return std::ranges::find(kMoves, code.function) != kMoves.end();
    };
    if (scan.taken == 0 || !batch.reports.empty() || !std::ranges::all_of(batch.codes, moves)) return false;
    at += scan.taken;
    rows += batch.blocks.size();
  }
  return rows == stretch.line_count;
}

bool has_text_argument(const ir::Program& program, const ir::Call& call) {
  return std::ranges::any_of(program.arguments_of(call), [&](const ir::Argument& one) {
    return one.value != ir::ExpressionId::none && program.at(one.value).op == ir::Operator::string;
  });
}

// Blocks of the stretches are none that anything leads to, nothing is done after each of them, and none of them needs
// a feed of its own.
bool looks_at_each_block(const ir::Program& program) {
  using enum ir::StatementKind;
  constexpr std::array kLeading = {go_to, return_to, modal_call, repeat_section, execute_text, procedure};
  const auto leads = [&](const ir::Statement& s) { return std::ranges::find(kLeading, s.kind) != kLeading.end(); };
  const auto names = [&](const ir::Call& call) {
    return call.start != ir::ExpressionId::none || call.name == ir::StringId::none || has_text_argument(program, call);
  };
  return program.sections.size() > 1 || !program.foreign_parts.empty() ||
         std::ranges::any_of(program.statements, leads) || std::ranges::any_of(program.calls, names) ||
         std::ranges::any_of(program.codes, [](const ir::Code& code) {
           return code.function == ir::Function::repetitive_cycle || code.function == ir::Function::feed_inverse_time;
         });
}

}  // namespace

MoveForm move_form_of(std::string_view line) {
  MoveForm form;
  skip_blanks(line);
  if (line.starts_with('N')) {
    line.remove_prefix(1);
    form.number = take_digits(line);
    if (form.number.empty()) return {};
    skip_blanks(line);
  }
  for (const std::string_view code : kCodes) {
    if (!line.starts_with(code) || (line.size() > code.size() && is_digit(line[code.size()]))) continue;
    form.code = code;
    line.remove_prefix(code.size());
    skip_blanks(line);
    break;
  }
  form.words = line;
  while (!line.empty()) {
    const char letter = take_word(line, form);
    if (letter == 0 || form.letters.find(letter) != std::string::npos) return {};
    form.letters += letter;
    skip_blanks(line);
  }
  if (form.letters.find_first_of("XYZABC") == std::string::npos) return {};
  if (form.is_arc() && form.letters.find_first_of("IJK") == std::string::npos) return {};
  return form;
}

std::string look_of(const MoveForm& form) {
  std::string look(form.number.empty() ? "" : "N");
  return look.append(form.code).append(form.letters);
}

ThinProgram::ThinProgram(std::string_view whole, const Dialect& dialect, const ir::Control& control)
    : stretches{.text = whole, .make_scanner = [&dialect, &control] { return dialect.plain_scanner(control); }} {}

std::unique_ptr<ThinProgram> ThinProgram::read(const text::Source& whole, const Dialect& dialect,
                                               const ir::Control& control, const ThinOptions& options) {
  if (whole.text().size() < options.least_bytes) return nullptr;
  if (auto out = read_without(whole, dialect, control, options)) return out;
  ThinOptions straight = options;
  straight.straight_alone = true;
  return options.straight_alone ? nullptr : read_without(whole, dialect, control, straight);
}

std::unique_ptr<ThinProgram> ThinProgram::read_without(const text::Source& whole, const Dialect& dialect,
                                                       const ir::Control& control, const ThinOptions& options) {
  std::vector<ir::PlainStretch> found;
  std::string text = StretchFinder(whole, options).run(found);
  if (found.empty()) return nullptr;
  auto out = join(text::Source(whole.name(), std::move(text)), whole.text(), found, dialect, control);
  if (out != nullptr) out->whole_ = whole;
  return out;
}

std::unique_ptr<ThinProgram> ThinProgram::join(const text::Source& thin, std::string_view whole,
                                               const std::vector<ir::PlainStretch>& stretches, const Dialect& dialect,
                                               const ir::Control& control) {
  std::unique_ptr<ThinProgram> out(new ThinProgram(whole, dialect, control));
  const auto plain = [&](const ir::PlainStretch& one) { return is_plain(out->stretches, one); };
  if (!std::ranges::all_of(stretches, plain) || !out->take(thin, stretches, dialect, control)) return nullptr;
  return out;
}

bool ThinProgram::take(const text::Source& thin, const std::vector<ir::PlainStretch>& found, const Dialect& dialect,
                       const ir::Control& control) {
  read_result = dialect.read(thin, control);
  ir::Program& program = read_result.program;
  if (looks_at_each_block(program)) return false;
  std::uint32_t removed_bytes = 0;
  std::uint32_t removed_lines = 0;
  auto statement = program.statements.begin();
  for (ir::PlainStretch stretch : found) {
    const auto at = static_cast<std::uint32_t>(stretch.begin - removed_bytes);
    const std::uint32_t line = thin.position(at).line;  // the first that is kept after it
    for (; statement != program.statements.end() && statement->line < line; ++statement)
      statement->line += removed_lines;
    if (statement == program.statements.end() || statement->line != line) return false;
    stretch.statement = static_cast<std::uint32_t>(statement - program.statements.begin());
    if (statement != program.statements.begin()) std::prev(statement)->moves_follow = true;
    stretches.all.push_back(stretch);
    removed_bytes += static_cast<std::uint32_t>(stretch.end - stretch.begin);
    removed_lines += stretch.line_count;
    cuts_.push_back({.at = at, .line = line, .removed_bytes = removed_bytes, .removed_lines = removed_lines});
  }
  for (; statement != program.statements.end(); ++statement) statement->line += removed_lines;
  return true;
}

std::uint32_t ThinProgram::line_in_full_text(std::uint32_t thin_line) const {
  const auto after = std::ranges::upper_bound(cuts_, thin_line, {}, &Cut::line);
  return after == cuts_.begin() ? thin_line : thin_line + std::prev(after)->removed_lines;
}

text::Span ThinProgram::in_whole(text::Span span) const {
  const auto moved = [&](std::uint32_t offset) {
    const auto after = std::ranges::upper_bound(cuts_, offset, {}, &Cut::at);
    return after == cuts_.begin() ? offset : offset + std::prev(after)->removed_bytes;
  };
  return {moved(span.begin), moved(span.begin) + (span.end - span.begin)};
}

void ThinProgram::place(text::Diagnostic& diagnostic) const {
  if (diagnostic.elsewhere != nullptr) return;
  diagnostic.span = in_whole(diagnostic.span);
  for (text::DiagnosticNote& note : diagnostic.notes) note.span = in_whole(note.span);
  if (diagnostic.fix) diagnostic.fix->replaced = in_whole(diagnostic.fix->replaced);
}

void ThinProgram::place(std::vector<text::Diagnostic>& diagnostics) const {
  for (text::Diagnostic& one : diagnostics) place(one);
}

// A fault in a stretch has the place of the line after it, and its own line.
void ThinProgram::place(interpreter::RunResult& run) const {
  for (interpreter::RunDiagnostic& one : run.diagnostics) {
    if (one.program != 0) continue;
    place(one.diagnostic);
    const auto in = std::ranges::find_if(stretches.all, [&](const ir::PlainStretch& stretch) {
      return stretch.line <= one.line && one.line - stretch.line < stretch.line_count;
    });
    if (in != stretches.all.end()) one.diagnostic.span = span_of_line(whole_, one.line);
  }
}

}  // namespace dripfeed::compile
