// The timing program of every control: it is read without an error, runs here, and what it would leave on a control
// with a known cost model gives that model back.
#include "server/app/checks/calibration.h"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dialects/compile/dialect/execute.h"
#include "dialects/text/number.h"
#include "server/app/lines/variable_dump.h"

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
    for (const bool calls : {false, true}) {
      const auto text = calibration_program(control, {.calls = calls});
      ASSERT_TRUE(text) << dialect->name << text.error().text;
      const auto read = dialect->read(text::Source("timing", *text), control);
      EXPECT_FALSE(text::has_error(read.diagnostics)) << dialect->name;
      for (const auto& one : dialect->validate(read.program, control, ir::Delivery::memory))
        EXPECT_NE(one.severity, text::Severity::error) << dialect->name << ": " << text::message_of(one);
      compile::NoMotions no_sink;
      EXPECT_EQ(compile::execute(read.program, control, nullptr, no_sink, {}).ended, interpreter::Ended::end);
    }
  }
}

TEST(Calibration, GivesAKnownModelBack) {
  const ir::CostModel truth{.block_ms = 1.3,
                            .number_read_ms = 0.21,
                            .number_write_ms = 0.11,
                            .named_read_ms = 0.47,
                            .named_write_ms = 0.4,
                            .operator_ms = 0.06,
                            .function_ms = 0.55,
                            .jump_ms = 2.2,
                            .round_ms = 1.7,
                            .call_ms = 20.0,
                            .indexed_ms = 0.3,
                            .origin = {}};
  for (const auto& [dialect, control] : controls()) {
    const bool sinumerik = dialect->name.starts_with("sinumerik");
    // The counts first, with times that say nothing; then the times that such a control would leave.
    std::map<std::uint32_t, double> ones;
    for (std::uint32_t i = 0; i < (sinumerik ? 14 : 11); ++i) ones[(sinumerik ? 20 : 500) + i] = 1.0;
    auto rows = calibration_rows(*dialect, control, ones);
    ASSERT_TRUE(rows) << dialect->name << rows.error().text;
    std::string dump = "VARIABLES\n";
    for (const CalibrationRow& row : *rows) {
      const double ms = ir::compute_ms(truth, row.row.counts);
      dump += fmt::format("{}={}\n", row.variable, text::format_fixed(sinumerik ? ms / 1000 : ms, 6));
    }
    const auto values = read_variables(dump, *dialect, control);
    ASSERT_TRUE(values) << dump;
    rows = calibration_rows(*dialect, control, *values);
    ASSERT_TRUE(rows);
    std::vector<timing::CostRow> measured;
    for (const CalibrationRow& row : *rows) measured.push_back(row.row);
    const auto fit = timing::fit_cost(measured);
    ASSERT_TRUE(fit);
    for (const ir::CostTerm& term : ir::kCostTerms) {
      const bool is_named = term.ms == &ir::CostModel::named_read_ms || term.ms == &ir::CostModel::named_write_ms;
      EXPECT_NEAR(fit->model.*term.ms, sinumerik || !is_named ? truth.*term.ms : 0.0, 1e-4)
          << dialect->name << ' ' << term.name;
    }
  }
}

TEST(Calibration, TheInterpretersOwnClockIsMeasuredLikeAControls) {
  // Its #3001 counts the block time alone: the model that comes out has that, and next to nothing else.
  const compile::Dialect& dialect = *compile::find_dialect("fanuc");
  const ir::Control control = dialect.control(ir::MachineKind::mill, ir::GSystem::a);
  const auto text = calibration_program(control);
  const auto read = dialect.read(text::Source("timing", *text), control);
  compile::NoMotions no_sink;
  interpreter::RunOptions options;
  options.want_variables = true;
  const auto run = compile::execute(read.program, control, nullptr, no_sink, options);
  std::string dump;
  for (const auto& variable : run.variables) {
    if (variable.value) dump += fmt::format("{} = {}\n", variable.name, text::format_fixed(*variable.value, 3));
  }
  const auto values = read_variables(dump, dialect, control);
  ASSERT_TRUE(values) << dump;
  const auto rows = calibration_rows(dialect, control, *values);
  ASSERT_TRUE(rows) << rows.error().text;
  std::vector<timing::CostRow> measured;
  for (const CalibrationRow& row : *rows) measured.push_back(row.row);
  const auto fit = timing::fit_cost(measured);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->model.block_ms, control.cost.block_ms, 0.02 * control.cost.block_ms);
  EXPECT_NEAR(fit->model.round_ms, control.cost.block_ms, 0.05 * control.cost.block_ms);  // it counts END as a block
  for (const ir::CostTerm& term : ir::kCostTerms) {
    if (term.ms == &ir::CostModel::block_ms || term.ms == &ir::CostModel::round_ms) continue;
    EXPECT_LT(fit->model.*term.ms, 0.02 * control.cost.block_ms) << term.name;
  }
  EXPECT_LT(fit->worst_share, 0.02);
}

// What a program sends by DPRNT: the texts of its messages, in order.
class Printed final : public ir::MotionSink {
 public:
  void consume(std::span<const ir::Motion> motions) override {
    for (const ir::Motion& motion : motions) {
      if (motion.kind == ir::MotionKind::message) texts.push_back(motion.text);
    }
  }
  std::vector<std::uint32_t> texts;
};

TEST(Calibration, WhatTheProgramPrintsIsReadBack) {
  for (const auto& [dialect, control] : controls()) {
    const auto text = calibration_program(control, {.prints = true});
    if (dialect->name.starts_with("sinumerik")) {
      EXPECT_FALSE(text);
      continue;
    }
    ASSERT_TRUE(text) << text.error().text;
    const auto read = dialect->read(text::Source("timing", *text), control);
    EXPECT_FALSE(text::has_error(read.diagnostics)) << dialect->name;
    Printed printed;
    const auto run = compile::execute(read.program, control, nullptr, printed, {});
    ASSERT_EQ(run.ended, interpreter::Ended::end) << dialect->name;
    std::string received = "%\r\n";
    for (const std::uint32_t i : printed.texts) received += run.strings[i] + "\r\n";
    const auto values = read_variables(received + "%\r\n", *dialect, control);
    ASSERT_TRUE(values) << received << values.error().text;
    EXPECT_TRUE(calibration_rows(*dialect, control, *values)) << received;
  }
}

struct Fanuc {
  const compile::Dialect& dialect = *compile::find_dialect("fanuc");
  ir::Control control = dialect.control(ir::MachineKind::mill, ir::GSystem::a);
  Result<std::map<std::uint32_t, double>> read(std::string_view text) const {
    return read_variables(text, dialect, control);
  }
};

TEST(Calibration, ReadsWhatPeopleWriteDown) {
  const Fanuc fanuc;
  const auto values = fanuc.read("O1(12 34)\r\n#500 = 412.\r\nV502 -0.5\n  501 -3\nnothing\nN7#503=1\n%\n");
  ASSERT_TRUE(values) << values.error().text;
  EXPECT_EQ(*values, (std::map<std::uint32_t, double>{{500, 412}, {501, -3}, {502, -0.5}, {503, 1}}));
  EXPECT_FALSE(fanuc.read("no number\n"));
  EXPECT_FALSE(fanuc.read("#500=1\n#500=2\n"));
  EXPECT_FALSE(calibration_rows(fanuc.dialect, fanuc.control, {{500, 1.0}}));
  EXPECT_FALSE(calibration_rows(fanuc.dialect, fanuc.control, {{500, -1.0}, {501, 1}, {502, 1}, {503, 1}, {504, 1}}));
}

TEST(Calibration, ReadsWhatControlsPunch) {
  const Fanuc fanuc;
  const auto punched = fanuc.read("%\n#500=[25283*65536+65536]/134217728\n#501=12.5\nM02\n%\n");
  ASSERT_TRUE(punched) << punched.error().text;
  EXPECT_NEAR(punched->at(500), 12.3458, 1e-4);
  EXPECT_EQ(punched->at(501), 12.5);
  // A vacant variable is no value, and an assignment that is none is an error with its line.
  for (const char* wrong : {"#500=1\n#501=#0\n", "#500=1\n#501=[1\n", "#500=1\n#501=\n"}) {
    const auto values = fanuc.read(wrong);
    ASSERT_FALSE(values) << wrong;
    EXPECT_TRUE(values.error().text.starts_with("line 2: \"#501=")) << values.error().text;
  }
  const compile::Dialect& siemens = *compile::find_dialect("sinumerik-840d");
  const ir::Control control = siemens.control(ir::MachineKind::mill, ir::GSystem::a);
  const auto archive =
      read_variables("%_N_RPA_INI\n;$PATH=/_N_INITIAL\nR[20]=0.412\nN10 R21 = 2\n$R[22]=-1\nM17\n", siemens, control);
  ASSERT_TRUE(archive) << archive.error().text;
  EXPECT_EQ(*archive, (std::map<std::uint32_t, double>{{20, 0.412}, {21, 2}, {22, -1}}));
}

}  // namespace
}  // namespace dripfeed::app
