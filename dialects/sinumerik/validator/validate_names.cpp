// Names: defined once and before use, short enough, used at all. What is kept as native is searched by its tokens, so
// that a name that only stands there counts as used and as set.
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "dialects/sinumerik/reader/one_per_name.h"
#include "dialects/sinumerik/tables/name_index.h"
#include "dialects/sinumerik/validator/validate.h"

namespace dripfeed::sinumerik {

namespace {

using ir::StatementKind;
using text::DiagnosticId;

class Names {
 public:
  explicit Names(const Check& check) : check_(check), program_(check.program), uses_(program_.symbols.size()) {}

  void run() {
    collect_uses();
    collect_native_names();
    definitions();
    unknown_names();
    unused();
    lengths();
    places_of_definitions();
  }

 private:
  struct Use {
    bool read = false;
    bool set = false;
    text::Span first;  // of the first use, read or set
  };

  [[nodiscard]] std::string name(const ir::Symbol& symbol) const {
    return std::string(program_.strings.at(symbol.name));
  }
  static bool is_declared(const ir::Symbol& symbol) { return !symbol.span.empty(); }

  // Every variable that an expression holds is read, every target is set. A parameter by reference may be set by a call
  // that has it as an argument.
  void collect_uses() {
    for (const ir::Variable& v : program_.variables) {
      if (v.bank != ir::Bank::named) continue;
      Use& use = uses_[static_cast<std::size_t>(v.symbol)];
      if (use.first.empty() || v.span.begin < use.first.begin) use.first = v.span;
    }
    for (const ir::Expression& e : program_.expressions) {
      if (e.op == ir::Operator::variable && program_.at(e.variable).bank == ir::Bank::named)
        uses_[static_cast<std::size_t>(program_.at(e.variable).symbol)].read = true;
    }
    for (const ir::Assign& a : program_.assigns) set(a.target);
    for (const ir::Structure& s : program_.structures) set(s.counter);
    for (const ir::Argument& a : program_.arguments) {
      if (a.value != ir::ExpressionId::none && program_.at(a.value).op == ir::Operator::variable)
        set(program_.at(a.value).variable);
    }
  }

  void set(ir::VariableId id) {
    if (id != ir::VariableId::none && program_.at(id).bank == ir::Bank::named)
      uses_[static_cast<std::size_t>(program_.at(id).symbol)].set = true;
  }

  void collect_native_names() {
    for (const ir::Statement& s : program_.statements) {
      if (s.kind != StatementKind::native) continue;
      const auto first =
          std::ranges::lower_bound(program_.tokens, s.span.begin, {}, [](const ir::Token& t) { return t.span.begin; });
      for (auto t = first; t != program_.tokens.end() && t->kind != ir::TokenKind::eob; ++t)
        if (t->kind == ir::TokenKind::name) natives_.insert(std::string(UpperName(check_.text_of(t->span)).view()));
    }
  }

  [[nodiscard]] bool in_native(const ir::Symbol& symbol) const { return natives_.contains(name(symbol)); }

  void definitions() const {
    std::map<std::pair<std::size_t, ir::StringId>, const ir::Symbol*> first;
    for (const ir::Symbol& symbol : program_.symbols) {
      if (!is_declared(symbol)) continue;
      const std::size_t section = section_of(program_, symbol.span.begin);
      const auto [entry, is_new] = first.emplace(std::pair(section, symbol.name), &symbol);
      if (is_new) continue;
      const bool parameters = symbol.is_parameter && entry->second->is_parameter;
      text::Diagnostic& d =
          check_.report(parameters ? DiagnosticId::parameter_defined_twice : DiagnosticId::name_defined_twice,
                        symbol.span, {name(symbol)});
      d.notes.push_back({entry->second->span, "the first one is here"});
      if (parameters) d.notes.push_back({symbol.span, "the value that callers give in this place has no name"});
    }
  }

  // A name that is nowhere defined may be global user data or a macro, which the machine's own definition files hold,
  // an axis, or in a subprogram the caller's. Where there is a defined name of nearly the same spelling it is most
  // likely a slip.
  void unknown_names() const {
    for (std::size_t i = 0; i < program_.symbols.size(); ++i) {
      const ir::Symbol& symbol = program_.symbols[i];
      if (is_declared(symbol) || uses_[i].first.empty() || ir::is_shared(check_.control.shared.get(), name(symbol)))
        continue;
      text::Diagnostic& d = check_.report(DiagnosticId::unknown_name, uses_[i].first, {name(symbol)});
      if (const ir::Symbol* meant = nearly_the_same(symbol))
        d.notes.push_back({meant->span, "this one has nearly the same name"});
    }
  }

  // A defined name that lacks one letter or has one too many, or where two changed places. Names that are told apart by
  // one letter or a digit (POS_L and POS_R, X1 and X2) are meant to differ.
  [[nodiscard]] const ir::Symbol* nearly_the_same(const ir::Symbol& unknown) const {
    const std::string wrong = name(unknown);
    for (const ir::Symbol& symbol : program_.symbols)
      if (is_declared(symbol) && is_slip(wrong, name(symbol))) return &symbol;
    return nullptr;
  }

  // Length of the part between underscores that the place lies in.
  static std::size_t part_at(std::string_view name, std::size_t place) {
    const std::size_t before = place == 0 ? std::string_view::npos : name.rfind('_', place - 1);
    const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
    return std::min(name.find('_', place), name.size()) - begin;
  }

  static bool is_slip(std::string_view a, std::string_view b) {
    constexpr std::size_t kShortest = 5;
    constexpr std::size_t kShortestPart = 4;
    if (std::min(a.size(), b.size()) < kShortest) return false;
    // Parts between underscores are told apart by less (RND_R, RND_TR).
    const auto differ = static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
    if (part_at(a, differ) < kShortestPart || part_at(b, differ) < kShortestPart) return false;
    while (!a.empty() && !b.empty() && a.front() == b.front()) a.remove_prefix(1), b.remove_prefix(1);
    while (!a.empty() && !b.empty() && a.back() == b.back()) a.remove_suffix(1), b.remove_suffix(1);
    const auto letters = [](std::string_view text) { return std::ranges::all_of(text, is_letter); };
    if (!letters(a) || !letters(b)) return false;
    if (a.size() == 2 && b.size() == 2) return a[0] == b[1] && a[1] == b[0];
    return a.size() + b.size() == 1;
  }

  void unused() const {
    std::set<ir::StringId> seen;
    for (std::size_t i = 0; i < program_.symbols.size(); ++i) {
      const ir::Symbol& symbol = program_.symbols[i];
      if (!is_declared(symbol) || !seen.insert(symbol.name).second || in_native(symbol)) continue;
      const Use& use = uses_[i];
      if (symbol.is_parameter && !use.read && !use.set)
        check_.report(DiagnosticId::parameter_never_used, symbol.span, {name(symbol)});
      // EXECSTRING sets variables by texts that are made while running.
      if (std::ranges::any_of(program_.statements,
                              [](const ir::Statement& s) { return s.kind == StatementKind::execute_text; }))
        continue;
      // Arrays are often filled by the operator or by cycles; a scalar that nothing sets is a slip.
      if (!symbol.is_parameter && use.read && !use.set && symbol.initial == ir::ExpressionId::none &&
          symbol.dimension1 == 0)
        check_.report(DiagnosticId::variable_never_set, use.first, {name(symbol)});
    }
  }

  void too_long(std::string_view long_name, text::Span span) const {
    const std::uint32_t limit = check_.control.limits.name_length;
    if (limit != 0 && long_name.size() > limit)
      check_.report(DiagnosticId::name_too_long, span,
                    {std::string(long_name), std::to_string(long_name.size()), std::to_string(limit)});
  }

  void lengths() const {
    for (const ir::Symbol& symbol : program_.symbols)
      if (is_declared(symbol)) too_long(name(symbol), symbol.span);
    for (const ir::Label& label : program_.labels)
      if (label.name != ir::StringId::none) too_long(program_.strings.at(label.name), label.span);
    for (const ir::Statement& s : program_.statements)
      if (s.kind == StatementKind::call || s.kind == StatementKind::modal_call)
        too_long(program_.strings.at(program_.calls[s.payload].name), s.span);
  }

  // PROC first, then DEF and EXTERN, then the program.
  void places_of_definitions() const {
    std::uint32_t acts_from_line = 0;  // the first line that does something
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      const ir::Statement& s = program_.statements[i];
      // Each program of the text has a start of its own.
      if (std::ranges::find(program_.sections, i, &ir::Section::first) != program_.sections.end()) acts_from_line = 0;
      if (s.kind == StatementKind::define && acts_from_line != 0 && s.line > acts_from_line)
        check_.report(DiagnosticId::definition_not_at_start, s.span);
      const bool inert = s.kind == StatementKind::empty || s.kind == StatementKind::procedure ||
                         s.kind == StatementKind::declaration || s.kind == StatementKind::define;
      // The elements of an array's list are assignments of their DEF's own line.
      const bool of_definition =
          s.kind == StatementKind::assign && s.tokens.first == s.tokens.last && last_define_ == s.line;
      // DEFINE … AS, groups of the editor; what could not be read has its own fault.
      const bool quiet = s.kind == StatementKind::native &&
                         (program_.natives[s.payload].effects_known || check_.native_name(s).contains(' '));
      if (s.kind == StatementKind::define) last_define_ = s.line;
      if (!inert && !of_definition && !quiet && acts_from_line == 0) acts_from_line = s.line;
    }
  }

  const Check& check_;
  const ir::Program& program_;
  std::vector<Use> uses_;
  std::set<std::string> natives_;
  mutable std::uint32_t last_define_ = 0;
};

}  // namespace

void check_names(const Check& check) { Names(check).run(); }

}  // namespace dripfeed::sinumerik
