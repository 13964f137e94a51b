// The lines that are kept of a stretch show how the other control writes a line of their look: the same number, code,
// axes and values, to the last digit. Only such lines are written here, and both programs are run to the end: what the
// lines of each stretch add up to must be the same, and so must be where every other line leads. Lines with arcs and
// feeds have more forms on other controls, so where they cannot be written, straight lines alone are.
#include "dialects/compile/translate/convert_thin.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/execute.h"
#include "dialects/compile/translate/move_sums.h"
#include "dialects/compile/translate/thin_program.h"

namespace dripfeed::compile {

namespace {

// "-.50" is "-0.5", "3.000" is "3.", as every control here writes it.
void append_value(std::string_view value, std::string& out, bool has_point_if_whole = true) {
  const bool is_negative = value.starts_with('-');
  if (is_negative) value.remove_prefix(1);
  const std::size_t point = value.find('.');
  std::string_view whole = value.substr(0, point);
  std::string_view part = point == std::string_view::npos ? std::string_view() : value.substr(point + 1);
  whole.remove_prefix(std::min(whole.find_first_not_of('0'), whole.size()));
  part = part.substr(0, part.find_last_not_of('0') + 1);
  if (is_negative && !(whole.empty() && part.empty())) out += '-';
  out += whole.empty() ? "0" : whole;
  if (!part.empty() || has_point_if_whole) out += '.';
  out += part;
}

bool is_whole(std::string_view value) {
  const std::size_t point = std::min(value.find('.'), value.size());
  return value.find_first_not_of(".0", point) == std::string_view::npos;
}

// "X1.Y-.5" is "X1. Y-0.5". A whole feed is F300 on some controls and F300. on others.
void append_words(std::string_view words, bool feed_has_point, std::string& out) {
  for (std::size_t at = 0; at < words.size();) {
    if (words[at] == ' ') {
      ++at;
      continue;
    }
    const std::size_t end = std::min(words.find_first_not_of("-.0123456789", at + 1), words.size());
    if (!out.empty() && out.back() != '\n') out += ' ';
    out += words[at];
    append_value(words.substr(at + 1, end - at - 1), out, feed_has_point || words[at] != 'F');
    at = end;
  }
}

// What the other control writes for the code of a line, by how the line looks.
class Writer {
 public:
  // The first line of a look counts.
  void learn(std::string_view line, std::string_view written) {
    const MoveForm form = move_form_of(line);
    const MoveForm made = move_form_of(written);
    if (!form.is_move() || form.code.empty() != made.code.empty()) return;
    Form& known = forms_.try_emplace(look_of(form), Form{.code = std::string(made.code)}).first->second;
    if (!known.feed_has_point && !made.feed.empty() && is_whole(made.feed))
      known.feed_has_point = made.feed.ends_with('.');
  }

  // False: no line of this look was learnt.
  bool append(std::string_view line, std::string& out) const {
    const MoveForm form = move_form_of(line);
    const auto known = forms_.find(look_of(form));
    if (known == forms_.end()) return false;
    const auto& [code, feed_has_point] = known->second;
    if (!form.feed.empty() && is_whole(form.feed) && !feed_has_point) return false;
    if (!form.number.empty()) out.append("N").append(form.number);
    if (!code.empty()) out.append(form.number.empty() ? "" : " ").append(code);
    append_words(form.words, feed_has_point.value_or(true), out);
    out += '\n';
    return true;
  }

 private:
  struct Form {
    std::string code;
    std::optional<bool> feed_has_point = {};  // of a whole number; nothing: no line showed it
  };
  std::map<std::string, Form, std::less<>> forms_;
};

// The next line of a text, without its EOB.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) lines.push_back(take_line(text));
  return lines;
}

class ThinConverter {
 public:
  ThinConverter(const ConvertRequest& request, const Dialect& to, const ThinProgram& thin)
      : request_(request), to_(to), thin_(thin), source_lines_(lines_of(thin.read_result.program.source.text())) {}

  std::optional<ConvertResult> run() {
    ConvertRequest small = request_;
    small.source = thin_.read_result.program.source;
    ConvertResult made = convert_whole(small);
    if (text::has_error(made.diagnostics) || made.text.empty()) return std::nullopt;
    thin_text_ = std::move(made.text);
    if (!write(made.origin_lines) || !moves_alike()) return std::nullopt;
    ConvertResult out{.text = std::move(text_),
                      .origin_lines = {},
                      .diagnostics = std::move(made.diagnostics),
                      .not_verified = std::move(made.not_verified)};
    out.origin_lines = std::move(origins_);
    thin_.place(out.diagnostics);
    return out;
  }

 private:
  // The whole translation. False: some line has another form.
  bool write(const std::vector<std::uint32_t>& origins) {
    const std::vector<std::string_view> printed = lines_of(thin_text_);
    if (printed.size() > origins.size()) return false;
    learn(printed, origins);
    std::size_t copied = 0;
    text_.reserve(request_.source.text().size());
    std::size_t lines = origins.size();
    for (const ir::PlainStretch& one : thin_.stretches.all) lines += one.line_count;
    origins_.reserve(lines);
    for (std::size_t i = 0; i < thin_.stretches.all.size(); ++i) {
      const std::uint32_t line_after = thin_.line_after(i);
      const auto at = std::find(origins.begin() + static_cast<std::ptrdiff_t>(copied), origins.end(), line_after);
      const auto index = static_cast<std::size_t>(at - origins.begin());
      if (index < copied + ThinProgram::kKeptBefore || !has_form(printed, origins, index, line_after)) return false;
      copy(printed, origins, copied, index);
      if (!write_stretch(thin_.stretches.all[i])) return false;
      copied = index;
    }
    copy(printed, origins, copied, printed.size());
    return true;
  }

  // Each line that is kept around a stretch must be one line of the translation, in the form that its look has.
  [[nodiscard]] bool has_form(const std::vector<std::string_view>& printed, const std::vector<std::uint32_t>& origins,
                              std::size_t index, std::uint32_t line_after) const {
    for (std::size_t k = 0; k < ThinProgram::kKeptBefore + ThinProgram::kKeptAfter; ++k) {
      const std::size_t at = index - ThinProgram::kKeptBefore + k;
      const auto line = static_cast<std::uint32_t>(line_after - ThinProgram::kKeptBefore + k);
      std::string again;
      if (at >= printed.size() || origins[at] != line || counts_[line] != 1) return false;
      if (!writer_.append(source_lines_[line - 1], again) || again != std::string(printed[at]) + "\n") return false;
    }
    return true;
  }

  // From every line of moves that became one line: each look that a stretch has is among them.
  void learn(const std::vector<std::string_view>& printed, const std::vector<std::uint32_t>& origins) {
    counts_.resize(source_lines_.size() + 1);
    for (const std::uint32_t line : origins) ++counts_[line];
    for (std::size_t i = 0; i < printed.size(); ++i)
      if (origins[i] != 0 && counts_[origins[i]] == 1) writer_.learn(source_lines_[origins[i] - 1], printed[i]);
  }

  void copy(const std::vector<std::string_view>& printed, const std::vector<std::uint32_t>& origins, std::size_t from,
            std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      text_.append(printed[i]).append("\n");
      origins_.push_back(origins[i] == 0 ? 0 : thin_.line_in_full_text(origins[i]));
    }
  }

  bool write_stretch(const ir::PlainStretch& stretch) {
    ir::PlainStretch made{.line = static_cast<std::uint32_t>(origins_.size() + 1),
                          .line_count = stretch.line_count,
                          .begin = text_.size()};
    std::string_view rest = thin_.stretches.text.substr(stretch.begin, stretch.end - stretch.begin);
    for (std::uint32_t i = 0; i < stretch.line_count; ++i) {
      if (!writer_.append(take_line(rest), text_)) return false;
      origins_.push_back(stretch.line + i);
    }
    made.end = text_.size();
    made_.push_back(made);
    return true;
  }

  // Both are run to their ends, the stretches from their texts.
  bool moves_alike() {
    const auto translated = ThinProgram::join(text::Source("translation", thin_text_), text_, made_, to_, request_.to);
    if (translated == nullptr) return false;
    MoveSums first(thin_.stretches.all, nullptr);
    MoveSums second(made_, &origins_);
    return ends(thin_, request_.from, first) && ends(*translated, request_.to, second) && first.same(second);
  }

  bool ends(const ThinProgram& program, const ir::Control& on, ir::MotionSink& sink) {
    ir::Control control = on;
    control.semantics.unset_is_unknown = true;
    ProgramLibrary standard(control, [](std::string_view) { return std::nullopt; });
    interpreter::RunOptions options;
    options.stretches = &program.stretches;
    const bool is_source = &program == &thin_;
    const auto run = execute(program.read_result.program, control,
                             is_source && request_.library != nullptr ? request_.library : &standard, sink, options);
    return run.ended == interpreter::Ended::end || run.ended == interpreter::Ended::text_end;
  }

  const ConvertRequest& request_;
  const Dialect& to_;
  const ThinProgram& thin_;
  std::vector<std::string_view> source_lines_;
  std::string thin_text_;
  std::vector<std::uint32_t> counts_;  // lines of the translation by line of the thin source
  Writer writer_;
  std::string text_;
  std::vector<std::uint32_t> origins_;
  std::vector<ir::PlainStretch> made_;  // of the translation
};

}  // namespace

std::optional<ConvertResult> convert_thin(const ConvertRequest& request, const ThinOptions& options) {
  const Dialect* from = find_dialect(request.from.dialect);
  const Dialect* to = find_dialect(request.to.dialect);
  if (from == nullptr || to == nullptr || from == to || request.mode != ConvertMode::macro) return std::nullopt;
  for (const bool straight_alone : {false, true}) {
    ThinOptions lines = options;
    lines.straight_alone = straight_alone;
    const auto thin = ThinProgram::read(request.source, *from, request.from, lines);
    if (thin == nullptr || text::has_error(thin->read_result.diagnostics)) return std::nullopt;
    if (auto made = ThinConverter(request, *to, *thin).run()) return made;
  }
  return std::nullopt;
}

}  // namespace dripfeed::compile
