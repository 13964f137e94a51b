// The list of checks, and what they share.
#include "dialects/sinumerik/validate.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "dialects/sinumerik/certainty.h"
#include "dialects/sinumerik/name_index.h"
#include "dialects/sinumerik/sinumerik.h"

namespace dripfeed::sinumerik {

text::Diagnostic& Check::report(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments) const {
  out.push_back(ir::diagnose(control, id, span, std::move(arguments)));
  return out.back();
}

void Check::report_if_machine(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments) const {
  report(id, span, std::move(arguments)).severity =
      control.from_profile ? text::Severity::error : text::Severity::warning;
}

namespace {

bool ends_with(std::string_view name, std::string_view ending) {
  return name.size() > ending.size() && same_name(name.substr(name.size() - ending.size()), ending);
}

// SPF is the ending of subprograms, whatever code ends them.
bool is_subprogram_file(std::string_view name) { return ends_with(name, ".SPF") || ends_with(name, ".CYC"); }

// The endings of data: definitions, initialization, machine and setting data, tools, magazines, offsets, R parameters.
constexpr std::string_view kDataEndings[] = {"DEF", "INI", "TEA", "SEA", "TOA", "TMA", "TOP", "TMP",
                                             "UFR", "RPA", "GUD", "PRO", "CEC", "EEC", "QEC"};

}  // namespace

bool is_other_ending(std::string_view ending) {
  constexpr std::string_view kOthers[] = {"COM", "TXT", "XML", "BMP", "PNG", "ICO", "CSV", "LOG", "JOB",
                                          "WPD", "DIR", "ARC", "TCM", "HLP", "HTM", "DAT", "BIN", "BOT"};
  return std::ranges::any_of(kOthers, [ending](std::string_view known) { return same_name(known, ending); });
}

std::size_t section_of(const ir::Program& program, std::uint32_t begin) {
  const auto starts_before = [&](const ir::Section& section) {
    return section.first < program.statements.size() && program.statements[section.first].span.begin <= begin;
  };
  const auto sections = std::ranges::count_if(program.sections, starts_before);
  return sections == 0 ? 0 : static_cast<std::size_t>(sections) - 1;
}

bool is_data_file(const ir::Program& program) {
  // "%_N_INITIAL_INI", or the name of the file.
  const auto head = std::ranges::find(program.tokens, ir::TokenKind::tape_mark, &ir::Token::kind);
  std::string_view name =
      head == program.tokens.end() ? std::string_view(program.source.name()) : head->span.in(program.source.text());
  while (!name.empty() && name.back() <= ' ') name.remove_suffix(1);
  return std::ranges::any_of(kDataEndings, [name](std::string_view ending) {
    return ends_with(name, ending) && (name[name.size() - 4] == '.' || name[name.size() - 4] == '_');
  });
}

bool is_subprogram(const ir::Program& program) {
  if (is_data_file(program)) return true;
  for (const ir::Statement& s : program.statements) {
    if (s.kind == ir::StatementKind::procedure) return true;
    if (s.kind == ir::StatementKind::program_end) return is_subprogram_file(program.source.name());
  }
  return true;
}

std::vector<text::Diagnostic> validate(const ir::Program& program, const ir::Control& control, ir::Delivery delivery) {
  std::vector<text::Diagnostic> found;
  const Check check{program, control, delivery, found};
  check_structures(check);
  check_labels(check);
  check_reachability(check);
  check_delivery(check);
  check_names(check);
  check_values(check);
  check_blocks(check);
  check_modal_state(check);
  check_limits(check);
  check_calls(check);
  check_tools(check);
  check_ranges(check);
  check_definitions(check);
  check_order(check);
  check_symbols(check);
  check_words(check);
  check_cycles(check);
  check_interpreted(check);
  check_leftovers(check);
  keep_one_per_name(program, found);
  std::ranges::sort(found, {}, [](const text::Diagnostic& d) { return std::tuple(d.span.begin, d.id, d.span.end); });
  return found;
}

}  // namespace dripfeed::sinumerik
