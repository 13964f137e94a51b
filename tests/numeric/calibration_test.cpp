// The timing program of every control: it is read without an error, runs here, and what it would leave on a control
// with a known cost model gives that model back.
#include "server/app/calibration.h"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dialects/compile/execute.h"
#include "dialects/text/number.h"

namespace dripfeed::app {
namespace {

std::vector<std::pair<const compile::Dialect*, ir::Control>> controls() {
  std::vector<std::pair<const compile::Dialect*, ir::Control>> all;
  for (const compile::Dialect& dialect : compile::dialects()) {
    for (const ir::MachineKind kind : {ir::MachineKind::mill, ir::MachineKind::lathe})
      all.emplace_back(&dialect, dialect.control(kind, ir::GSystem::a));
  }
  return all;
}

TEST(Calibration, TheProgramIsLegalAndEnds) {
  for (const auto& [dialect, control] : controls()) {
    const auto text = calibration_program(control);
    ASSERT_TRUE(text) << dialect->name << text.error().text;
    const auto read = dialect->read(text::Source("timing", *text), control);
    EXPECT_FALSE(text::has_error(read.diagnostics)) << dialect->name;
    for (const auto& one : dialect->validate(read.program, control, ir::Delivery::memory))
      EXPECT_NE(one.severity, text::Severity::error) << dialect->name << ": " << text::message_of(one);
    compile::NoMotions nobody;
    EXPECT_EQ(compile::execute(read.program, control, nullptr, nobody, {}).ended, interpreter::Ended::end);
  }
}

TEST(Calibration, GivesAKnownModelBack) {
  const ir::CostModel truth{1.3, 0.21, 0.47, 0.06, 0.55, true, {}};
  for (const auto& [dialect, control] : controls()) {
    const bool sinumerik = dialect->name.starts_with("sinumerik");
    // The counts first, with times that say nothing; then the times that such a control would leave.
    std::map<std::uint32_t, double> ones;
    for (std::uint32_t i = 0; i < 7; ++i) ones[(sinumerik ? 20 : 500) + i] = 1.0;
    auto rows = calibration_rows(*dialect, control, ones);
    ASSERT_TRUE(rows) << dialect->name << rows.error().text;
    std::string dump = "VARIABLES\n";
    for (const CalibrationRow& row : *rows) {
      const double ms = ir::compute_ms(truth, row.row.counts);
      dump += fmt::format("{}={}\n", row.variable, text::format_fixed(sinumerik ? ms / 1000 : ms, 6));
    }
    const auto values = read_variables(dump);
    ASSERT_TRUE(values) << dump;
    rows = calibration_rows(*dialect, control, *values);
    ASSERT_TRUE(rows);
    std::vector<timing::CostRow> measured;
    for (const CalibrationRow& row : *rows) measured.push_back(row.row);
    const auto fit = timing::fit_cost(measured);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->model.block_ms, truth.block_ms, 1e-4) << dialect->name;
    EXPECT_NEAR(fit->model.number_read_ms, truth.number_read_ms, 1e-4) << dialect->name;
    EXPECT_NEAR(fit->model.operator_ms, truth.operator_ms, 1e-4) << dialect->name;
    EXPECT_NEAR(fit->model.function_ms, truth.function_ms, 1e-4) << dialect->name;
    EXPECT_NEAR(fit->model.named_read_ms, sinumerik ? truth.named_read_ms : 0.0, 1e-4) << dialect->name;
  }
}

TEST(Calibration, TheInterpretersOwnClockIsMeasuredLikeAControls) {
  // Its #3001 counts the block time alone: the model that comes out has that, and next to nothing else.
  const compile::Dialect& dialect = *compile::find_dialect("fanuc");
  const ir::Control control = dialect.control(ir::MachineKind::mill, ir::GSystem::a);
  const auto text = calibration_program(control);
  const auto read = dialect.read(text::Source("timing", *text), control);
  compile::NoMotions nobody;
  interpreter::RunOptions options;
  options.want_variables = true;
  const auto run = compile::execute(read.program, control, nullptr, nobody, options);
  std::string dump;
  for (const auto& variable : run.variables) {
    if (variable.value) dump += fmt::format("{} = {}\n", variable.name, text::format_fixed(*variable.value, 3));
  }
  const auto values = read_variables(dump);
  ASSERT_TRUE(values) << dump;
  const auto rows = calibration_rows(dialect, control, *values);
  ASSERT_TRUE(rows) << rows.error().text;
  std::vector<timing::CostRow> measured;
  for (const CalibrationRow& row : *rows) measured.push_back(row.row);
  const auto fit = timing::fit_cost(measured);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->model.block_ms, control.cost.block_ms, 0.02 * control.cost.block_ms);
  EXPECT_LT(fit->model.number_read_ms + fit->model.operator_ms + fit->model.function_ms, 0.02 * control.cost.block_ms);
  EXPECT_LT(fit->worst_share, 0.02);
}

TEST(Calibration, ReadsWhatPeopleWriteDown) {
  const auto values = read_variables("#500 = 412.\r\nR20=0.412\n  501 -3\nnothing\n%\n");
  ASSERT_TRUE(values);
  EXPECT_EQ(*values, (std::map<std::uint32_t, double>{{20, 0.412}, {500, 412}, {501, -3}}));
  EXPECT_FALSE(read_variables("no number\n"));
  EXPECT_FALSE(read_variables("#500=1\n#500=2\n"));
  const compile::Dialect& fanuc = *compile::find_dialect("fanuc");
  const ir::Control control = fanuc.control(ir::MachineKind::mill, ir::GSystem::a);
  EXPECT_FALSE(calibration_rows(fanuc, control, {{500, 1.0}}));
  EXPECT_FALSE(calibration_rows(fanuc, control, {{500, -1.0}, {501, 1}, {502, 1}, {503, 1}, {504, 1}}));
}

}  // namespace
}  // namespace dripfeed::app
