// Standard cycles that are no programs here: their parameters by number and type, as far as a call shows them. Newer
// software adds parameters after those of the table (surface, modes of the operator's screen), so more than ten
// further ones are a fault, not one.
#include <algorithm>
#include <optional>
#include <string>

#include "dialects/sinumerik/tables/called_cycles.h"
#include "dialects/sinumerik/validator/validate.h"

namespace dripfeed::sinumerik {

namespace {

using ir::TokenKind;
using text::DiagnosticId;

// PGZ, the parameters of each cycle in order: N a number, S a text (a name), C a character.
struct CycleRow {
  std::string_view name;
  std::string_view types;
};
constexpr CycleRow kCycles[] = {
    {"CYCLE72", "SNNNNNNNNNNNNNNNN"},
    {"CYCLE90", "NNNNNNNNNNNNNN"},
    {"CYCLE93", "NNNNNNNNNNNNNNNNN"},
    {"CYCLE94", "NNCN"},
    {"CYCLE96", "NNCN"},
    {"CYCLE98", "NNNNNNNNNNNNNNNNNNNNNN"},
    {"POCKET1", "NNNNNNNNNNNNNNNNNNNN"},
    {"POCKET2", "NNNNNNNNNNNNNNNNN"},
};
constexpr std::size_t kFurtherParameters = 10;
constexpr std::string_view kNumbers = "NNNNNNNNNNNNNNNNNNNNNNNNNNNNNNNNNNNNNNNN";  // of a milling cycle

std::optional<CycleRow> row_of(std::string_view name) {
  const auto* const row = std::ranges::find(kCycles, name, &CycleRow::name);
  if (row != std::end(kCycles)) return *row;
  const ir::CalledCycle* const cycle = find_called_cycle(name);
  if (cycle == nullptr || cycle->sort != ir::CalledSort::milling) return std::nullopt;
  return CycleRow{cycle->name, kNumbers.substr(0, cycle->values.size())};
}

class Call {
 public:
  Call(const Check& check, const ir::Statement& s, const CycleRow& cycle)
      : check_(check), cycle_(cycle), span_(s.span) {
    const auto& tokens = check.program.tokens;
    at_ = std::ranges::lower_bound(tokens, s.span.begin, {}, [](const ir::Token& t) { return t.span.begin; });
    end_ = tokens.end();
  }

  void run() {
    while (at_ != end_ && !ends() && text() != "(") ++at_;
    if (at_ == end_ || ends()) return;  // without parameters: MCALL's end is reported elsewhere
    ++at_;
    std::size_t place = 0;
    for (int open = 1; at_ != end_ && !ends(); ++at_) {
      if (text() == "(" || text() == "[") ++open;
      if ((text() == ")" || text() == "]") && --open == 0) break;
      if (open != 1) continue;
      if (text() == ",") {
        ++place;
        first_ = true;
      } else if (at_->kind != TokenKind::white && first_) {
        first_ = false;
        argument(place);
      }
    }
    const std::size_t most = cycle_.types.size() + kFurtherParameters;
    if (place >= most)
      check_
          .report(DiagnosticId::wrong_argument_count, span_,
                  {std::string(cycle_.name), std::to_string(most), std::to_string(place + 1)})
          .alarm = "12340";
  }

 private:
  // A constant as the whole argument; what is computed has the type of its variables.
  void argument(std::size_t place) {
    if (place >= cycle_.types.size()) return;
    const char wanted = cycle_.types[place];
    const bool is_text = at_->kind == TokenKind::string;
    const bool is_number = at_->kind == TokenKind::number;
    if ((wanted == 'N' && is_text) || (wanted == 'S' && is_number))
      check_
          .report(DiagnosticId::wrong_type, at_->span,
                  {std::string(text()), is_text ? "STRING" : "REAL", is_text ? "a number" : "STRING"})
          .alarm = "12330";
  }

  [[nodiscard]] bool ends() const { return at_->kind == TokenKind::eob || at_->kind == TokenKind::comment; }
  [[nodiscard]] std::string_view text() const { return check_.text_of(at_->span); }

  const Check& check_;
  const CycleRow& cycle_;
  text::Span span_;
  std::vector<ir::Token>::const_iterator at_;
  std::vector<ir::Token>::const_iterator end_;
  bool first_ = true;  // of an argument
};

}  // namespace

void check_cycles(const Check& check) {
  const ir::Program& program = check.program;
  for (const ir::Statement& s : program.statements) {
    const bool is_call = s.kind == ir::StatementKind::call && program.calls[s.payload].cycle != nullptr;
    if (s.kind != ir::StatementKind::native && !is_call) continue;
    const auto row = row_of(is_call ? program.calls[s.payload].cycle->name : check.native_name(s));
    if (row) Call(check, s, *row).run();
  }
}

}  // namespace dripfeed::sinumerik
