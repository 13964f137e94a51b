// Each constant of the header is tried as a target; what is refused becomes a note with the reason.
#include "dialects/compile/propose/propose_family.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/native/header_constants.h"
#include "dialects/compile/native/native_targets.h"
#include "dialects/compile/native/native_unit.h"
#include "dialects/compile/native/variable_quantities.h"
#include "dialects/compile/propose/proposed_names.h"
#include "dialects/compile/render/render.h"
#include "dialects/text/number.h"

namespace dripfeed::compile {

namespace {

using family::Dimension;

// A row a kind: its word in the family language, its units in millimetres and in inches, and half of a range around
// zero.
struct KindRow {
  Dimension dimension;
  bool is_count;
  std::string_view kind;
  std::string_view unit;
  std::string_view inch_unit;
  double around_zero;
  bool is_ms = false;
};
constexpr KindRow kKinds[] = {
    {family::kLength, false, "length", "mm", "in", 10.0},
    {family::kAngle, false, "angle", "deg", "deg", 90.0},
    {family::kFeedPerMin, false, "feed", "mm/min", "in/min", 100.0},
    {family::kFeedPerRev, false, "feed", "mm/rev", "in/rev", 1.0},
    {family::kSpeed, false, "speed", "rpm", "rpm", 100.0},
    {family::kSurfaceSpeed, false, "speed", "m/min", "ft/min", 100.0},
    {family::kRatio, true, "count", "", "", 10.0},
    {family::kRatio, false, "ratio", "", "", 1.0},
    {family::kTime, false, "time", "s", "s", 1.0},
    {family::kTime, false, "time", "ms", "ms", 1000.0, true},
};
constexpr const KindRow& kPlain = kKinds[7];

constexpr std::size_t kMostParameters = 200;

// As a family writes it: digits before and after the point, no noise.
std::string in_family(double value) {
  constexpr int kDecimals = 9;
  std::string out;
  text::append_word_number(out, value, kDecimals, true);
  return out;
}

class Proposer {
 public:
  Proposer(const text::Source& source, const Dialect& dialect, const ir::Control& control, const std::string& name)
      : source_(source), dialect_(dialect), control_(control), name_(proposed_family_name(name)) {}

  FamilyProposal propose() {
    const ir::ReadResult read = dialect_.read(source_, control_);
    const ir::Program& program = read.program;
    const facts::Resolved resolved(program, control_);
    const VariableQuantities quantities(program, control_, resolved);
    const NativeUnits units(program, control_, resolved);
    std::string parameters;
    for (const HeaderConstant& one : header_constants(program, control_)) {
      if (out_.parameters == kMostParameters) {
        note(one.line, fmt::format("this and what follows is not proposed: {} parameters are enough", kMostParameters));
        break;
      }
      const NativeTarget target = find_target(program, control_, one.target);
      if (!target.constant) {
        note(one.line, fmt::format("{} is not proposed: {}", one.name, target.why));
        continue;
      }
      const Taken taken{.quantity = quantities.of(one.variable),
                        .uses = quantities.uses_of(target.variables, target.scope)};
      if (!target.warning.empty()) note(one.line, fmt::format("{} may lose its value: {}", one.name, target.warning));
      parameters += parameter(program, one, *target.constant, taken, units);
      ++out_.parameters;
    }
    out_.text = head(program) + parameters + fmt::format("\nnative {}\n", dialect_.name);
    out_.text += source_.text();
    try_it();
    return std::move(out_);
  }

 private:
  // What takes a number.
  struct Taken {
    std::optional<VariableQuantity> quantity;
    std::vector<WordUse> uses;
  };

  void note(std::uint32_t line, std::string text) { out_.notes.push_back({.line = line, .text = std::move(text)}); }

  [[nodiscard]] std::string head(const ir::Program& program) const {
    std::string out =
        "# Proposed from a program. Look at each kind, unit and range: a range marked as proposed is the program's "
        "value\n"
        "# halved and doubled, and whether the machine can make it was not checked.\n";
    const std::string title = title_of(program);
    out += fmt::format("family {}{}{}\nmachine {}", name_, title.empty() ? "" : " ", title, machine_word());
    if (control_.kind != ir::MachineKind::mill)
      out += fmt::format(", x is {}", x_is_diameter(program) ? "diameter" : "radius");
    return out + "\n\n";
  }

  // The comment next to the program's number, or at its very top.
  [[nodiscard]] std::string title_of(const ir::Program& program) const {
    constexpr std::uint32_t kLines = 3;
    for (const ir::Token& token : program.tokens) {
      if (source_.position(token.span.begin).line > kLines) break;
      if (token.kind != ir::TokenKind::comment) continue;
      const std::string_view text = comment_at(program, token.span.begin);
      if (!text.empty() && !text.starts_with("$PATH")) return quoted_text(text);
    }
    return {};
  }

  [[nodiscard]] std::string_view machine_word() const {
    switch (control_.kind) {
      case ir::MachineKind::mill: return "mill";
      case ir::MachineKind::lathe: return "lathe";
      case ir::MachineKind::mill_turn: return "mill-turn";
    }
    return "mill";
  }

  [[nodiscard]] bool x_is_diameter(const ir::Program& program) const {
    const bool stated = std::ranges::any_of(program.codes, [](const ir::Code& code) {
      return code.function == ir::Function::diameter_on || code.function == ir::Function::diameter_absolute_only;
    });
    return stated || control_.semantics.power_on_diameter != ir::DiameterMode::radius;
  }

  std::string parameter(const ir::Program& program, const HeaderConstant& one, const NativeConstant& constant,
                        const Taken& taken, const NativeUnits& units) {
    const std::string_view comment = comment_on_line(program, constant.span.begin);
    const auto [row, inches] = kind_of(one, constant, taken, units);
    const std::string_view unit = inches ? row.inch_unit : row.unit;
    const auto [low, high] = range_around(constant.value, row);
    std::string out =
        fmt::format("param {} {} {}{}{} in {}..{}", name_of(one, comment), row.kind, in_family(constant.value),
                    unit.empty() ? "" : " ", unit, in_family(low), in_family(high));
    if (!comment.empty()) out += fmt::format(" {}", quoted_text(comment));
    return out + fmt::format(" is {}  # proposed range\n", one.target);
  }

  std::string name_of(const HeaderConstant& one, std::string_view comment) {
    if (one.has_own_name) return names_.name_for(one.name, one.target);
    const std::string plain = one.name.starts_with('#') ? fmt::format("v{}", one.name.substr(1)) : one.name;
    return names_.name_for(comment, plain);
  }

  // A plain number where the uses do not show it, where its unit is not known, and where the value is no such one.
  std::pair<const KindRow&, bool> kind_of(const HeaderConstant& one, const NativeConstant& constant, const Taken& taken,
                                          const NativeUnits& units) {
    std::optional<VariableQuantity> quantity = taken.quantity;
    if (constant.takes_integer) quantity = VariableQuantity{family::kRatio, true};
    if (!quantity) return {kPlain, false};
    const auto row = std::ranges::find_if(kKinds, [&](const KindRow& kind) {
      return kind.dimension == quantity->dimension && kind.is_count == quantity->is_count &&
             kind.is_ms == quantity->is_ms;
    });
    if (row == std::end(kKinds) || (row->is_count && std::trunc(constant.value) != constant.value))
      return {kPlain, false};
    const NativeUnit unit = units.of(row->dimension, nullptr, constant.statement, taken.uses);
    if (unit.factor) return {*row, *unit.factor != 1.0};
    note(one.line, fmt::format("{} is proposed as a plain number: {}", one.name, unit.why));
    return {kPlain, false};
  }

  [[nodiscard]] static std::pair<double, double> range_around(double value, const KindRow& row) {
    if (value == 0.0) return {row.is_count ? 0.0 : -row.around_zero, row.around_zero};
    double half = value / 2.0;
    if (row.is_count) half = value > 0.0 ? std::max(1.0, std::floor(half)) : std::min(-1.0, std::ceil(half));
    const double twice = value * 2.0;
    return {std::min(half, twice), std::max(half, twice)};
  }

  // What would not come back as it is here is no proposal.
  void try_it() {
    RenderRequest request;
    request.family = text::Source("proposal", out_.text);
    request.target = control_;
    request.mode = RenderMode::macro;
    const RenderResult rendered = render(request);
    for (const text::Diagnostic& one : rendered.diagnostics)
      if (one.severity == text::Severity::error) note(0, text::message_of(one));
    if (!text::has_error(rendered.diagnostics) && rendered.text == source_.text()) return;
    note(0, "nothing is proposed: the family would not render to the program's own bytes");
    out_.text.clear();
  }

  const text::Source& source_;
  const Dialect& dialect_;
  const ir::Control& control_;
  std::string name_;
  ProposedNames names_;
  FamilyProposal out_;
};

}  // namespace

FamilyProposal propose_family(const text::Source& program, const Dialect& dialect, const ir::Control& control,
                              const std::string& name) {
  return Proposer(program, dialect, control, name).propose();
}

}  // namespace dripfeed::compile
