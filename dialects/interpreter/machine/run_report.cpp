// Collecting what a run has to say.
#include "dialects/interpreter/machine/run_report.h"

#include <algorithm>

#include "dialects/interpreter/arithmetic/unknown.h"

namespace dripfeed::interpreter {

using text::DiagnosticId;

void RunReport::add(const Instruction& at, DiagnosticId id, std::vector<std::string> arguments,
                    ir::AlarmDetail detail) {
  const auto index = static_cast<std::size_t>(&at - program_->code.data());
  text::Diagnostic made = ir::diagnose(control_, id, program_->spans[index], std::move(arguments), detail);
  // The control's memory may have the program; otherwise the search stood at a name that is written here.
  const bool may_exist = control_.semantics.unset_is_unknown && control_.semantics.has_vacant;
  if (id == DiagnosticId::call_target_missing && may_exist) {
    made.severity = text::Severity::warning;
    made.notes.push_back(
        {made.span, "it was not among the programs that were given: it may be in the control's memory"});
  }
  // How many R parameters there are is a machine datum (MD28050): without the machine it is a guess.
  const bool is_beyond = id == DiagnosticId::variable_out_of_range && made.arguments.front().starts_with('R') &&
                         !made.arguments.front().starts_with("R-");
  if (is_beyond && !control_.from_profile && made.severity == text::Severity::error) {
    made.severity = text::Severity::warning;
    made.notes.push_back({made.span, "a machine profile that states the R parameters decides this"});
  }
  const bool certain = !uncertain_ || id == DiagnosticId::call_target_missing;
  if (!certain && made.severity == text::Severity::error) {
    // A program that guards itself is no fault of its own: whether the guard strikes, those values decide.
    made.severity = id == DiagnosticId::user_alarm ? text::Severity::note : text::Severity::warning;
    made.notes.push_back({made.span, "after a condition on a value that is not known"});
  }
  result_.diagnostics.push_back({program_->index, out_.place.line, std::move(made)});
}

bool RunReport::fail(const Instruction& at, DiagnosticId id, std::vector<std::string> arguments,
                     ir::AlarmDetail detail) {
  add(at, id, std::move(arguments), detail);
  return end(id == DiagnosticId::limit_reached ? Ended::limit : Ended::alarm);
}

bool RunReport::fail_limit(const Instruction& at, std::string_view limit) {
  constexpr std::string_view kGuesses = "guesses at conditions on values that are not known, which a state can give";
  return fail(at, DiagnosticId::limit_reached, {std::string(guesses_end_ ? kGuesses : limit)});
}

bool RunReport::fail_user(const Instruction& at, std::uint32_t number, std::string_view message) {
  std::string shown = number == 0 ? std::string() : std::to_string(number);
  if (!shown.empty() && !message.empty()) shown += ' ';
  shown += message;
  add(at, DiagnosticId::user_alarm, {shown});
  std::string& alarm = result_.diagnostics.back().diagnostic.alarm;
  if (alarm.empty() && number != 0) alarm = std::to_string(number);
  return end(Ended::alarm);
}

bool RunReport::end(Ended ended) {
  result_.ended = ended;
  return false;
}

// A loop may say the same of a block as often as it goes round.
void RunReport::say(const Instruction& at, DiagnosticId id, std::vector<std::string> arguments) {
  constexpr std::uint32_t kMostOfABlock = 20;
  if (++reported_[{program_->index, out_.place.line, id}] <= kMostOfABlock) add(at, id, std::move(arguments));
}

void RunReport::warn(const Instruction& at, DiagnosticId id, std::vector<std::string> arguments,
                     std::string_view note) {
  const std::size_t before = result_.diagnostics.size();
  say(at, id, std::move(arguments));
  if (result_.diagnostics.size() == before) return;
  text::Diagnostic& warning = result_.diagnostics.back().diagnostic;
  warning.severity = text::Severity::warning;
  warning.notes.push_back({warning.span, std::string(note)});
}

// What was reported last is not certain after all.
void RunReport::soften(std::string_view note) {
  text::Diagnostic& last = result_.diagnostics.back().diagnostic;
  last.severity = std::min(last.severity, text::Severity::warning);
  last.notes.push_back({last.span, std::string(note)});
}

void RunReport::keep_no_feed(const Instruction& at, ir::AlarmDetail detail) {
  add(at, DiagnosticId::no_feed, {}, detail);
  no_feed_ = std::move(result_.diagnostics.back());
  result_.diagnostics.pop_back();
  no_feed_place_ = result_.diagnostics.size();
}

void RunReport::report_no_feed() {
  if (!no_feed_.has_value()) return;
  const auto place = result_.diagnostics.begin() + static_cast<std::ptrdiff_t>(no_feed_place_);
  result_.diagnostics.insert(place, *std::move(no_feed_));
  no_feed_.reset();
}

void RunReport::count(const Report& report) {
  const auto [entry, added] = counted_.try_emplace(report.name, result_.not_interpreted.size());
  if (added)
    result_.not_interpreted.push_back({report.name, program_->index, out_.place.line, 0, report.function,
                                       report.effects_known, report.is_input, report.is_model});
  ++result_.not_interpreted[entry->second].count;
}

void RunReport::note_computed(const std::string& name, ir::Function function) {
  const auto same = [function](const ComputedCodeUse& use) { return use.function == function; };
  if (std::ranges::any_of(result_.computed_codes, same)) return;
  result_.computed_codes.push_back({name, function, program_->index, out_.place.line});
}

std::uint32_t RunReport::text_index(const std::string& written) {
  if (is_unknown(written)) {
    std::string shown = written;
    std::ranges::replace(shown, kUnknownMark, '?');
    return text_index(shown);
  }
  const std::string& text = written;
  const auto next = static_cast<std::uint32_t>(names_.strings.size());
  if (const auto found = texts_.find(text); found != texts_.end()) return found->second;
  if (next >= limits_.strings) return kNoText;
  texts_.emplace(text, next);
  names_.strings.push_back(text);
  return next;
}

}  // namespace dripfeed::interpreter
