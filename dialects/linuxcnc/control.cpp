// The control, and the stages from text to statements.
#include "dialects/macro_b/tables/control.h"

#include <numbers>

#include "dialects/linuxcnc/linuxcnc.h"
#include "dialects/linuxcnc/parse.h"
#include "dialects/linuxcnc/tables.h"
#include "dialects/macro_b/validator/validate.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::linuxcnc {

namespace {

// Every block may be a line of the language.
class NothingPlain final : public ir::PlainScanner {
 public:
  ir::PlainScan scan(std::string_view, ir::PlainBatch&) override { return {0, ir::PlainStop::not_plain}; }
  [[nodiscard]] std::string_view name() const override { return {}; }
};

}  // namespace

const macro_b::Grammar& grammar() {
  static const macro_b::Grammar kGrammar = {
      .keywords = {}, .packed_calls = false, .reference_alone_is_all_axes = true, .rounds_words_whole = true};
  return kGrammar;
}

ir::Control control(ir::MachineKind, ir::GSystem) {
  ir::Control c = macro_b::usual_control(
      ir::MachineKind::mill, ir::GSystem::a,
      {.dialect = "linuxcnc",
       .title = "LinuxCNC",
       .limits = {.digits = 255, .expression_nesting = 64, .loop_nesting = 0, .call_nesting = 10, .macro_nesting = 10},
       .cost = {.block_ms = 1.0, .origin = "not measured"},
       .g_codes = g_codes(),
       .m_codes = m_codes(),
       .system_variables = system_variables(),
       .alarms = {},
       .variables = variable_ranges()});
  constexpr double kPeck_mm = 0.254;  // 0.01 inch, which the control has built in
  // An arc's radii may differ by this, or by a thousandth of the larger one.
  constexpr double kArcGap_mm = 0.02 * std::numbers::sqrt2;
  constexpr double kArcGapPart = 0.001 / 0.999;  // of the smaller one
  c.axes = "XYZABCUVW";
  c.semantics.has_vacant = false;
  c.semantics.atan_full_circle = false;
  c.semantics.asin_from_90_to_270 = false;
  c.semantics.round_up = ir::RoundUpMode::next_larger;
  c.semantics.decimal_mode = ir::DecimalMode::calculator;
  c.semantics.decimal_mode_confirmed = true;
  c.semantics.machine_move = ir::MachineMove::programmed;
  c.semantics.arc_tolerance_mm = kArcGap_mm;
  c.semantics.arc_tolerance_factor = kArcGapPart;
  c.semantics.chip_break_retract_mm = kPeck_mm;
  c.semantics.peck_clearance_mm = kPeck_mm;
  c.semantics.pecks_need_depth = true;
  c.semantics.length_needs_code = true;
  return c;
}

// In inches the control takes arcs that are further out.
ir::Control infer_control(const text::Source& source) {
  constexpr double kArcGapInInches_mm = 0.002 * std::numbers::sqrt2 * 25.4;
  ir::Control c = control(ir::MachineKind::mill, ir::GSystem::a);
  if (text::upper_case(source.text()).contains("G20")) c.semantics.arc_tolerance_mm = kArcGapInInches_mm;
  return c;
}

ir::ReadResult read(const text::Source& source, const ir::Control& control) {
  ir::ReadResult result;
  result.program.source = source;
  Parser(result.program, control, result.diagnostics).run();
  return result;
}

std::unique_ptr<ir::PlainScanner> plain_scanner(const ir::Control&) { return std::make_unique<NothingPlain>(); }

std::vector<text::Diagnostic> validate(const ir::Program& program, const ir::Control& control, ir::Delivery) {
  macro_b::Findings findings(control);
  macro_b::check_not_interpreted(program, control, findings);
  return findings.take();
}

}  // namespace dripfeed::linuxcnc
