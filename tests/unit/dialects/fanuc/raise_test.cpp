// Programs of other origins in Fanuc's words. That both do the same when they run is tested where the interpreter is.
#include <string>

#include <gtest/gtest.h>

#include "dialects/fanuc/fanuc.h"

namespace dripfeed::fanuc {
namespace {

using ir::Address;
using ir::Function;
using ir::MachineKind;
using ir::Operator;
using ir::StatementKind;

// A control as the family language has it: D is an edge, F of a dwell are seconds.
ir::Control neutral(MachineKind kind) {
  ir::Control c;
  c.dialect = "neutral";
  c.kind = kind;
  c.axes = kind == MachineKind::mill ? "XYZ" : "XZ";
  c.semantics.has_vacant = false;
  c.semantics.power_on_known = true;
  c.semantics.d_selects_edge = true;
  c.semantics.dwell_p_is_ms = false;
  c.semantics.atan_full_circle = false;
  c.semantics.asin_from_90_to_270 = false;
  return c;
}

class Built {
 public:
  ir::Program program;
  ir::ExpressionId value(double v) { return program.add_constant(v); }
  ir::Variable variable(const std::string& name) {
    ir::Symbol s;
    s.name = program.strings.add(name);
    ir::Variable v;
    v.bank = ir::Bank::named;
    v.symbol = program.add(s);
    return v;
  }
  ir::ExpressionId value(const ir::Variable& v) { return program.add_variable(v); }
  void statement(StatementKind kind, std::size_t payload) {
    ir::Statement s;
    s.kind = kind;
    s.payload = static_cast<std::uint32_t>(payload);
    s.line = static_cast<std::uint32_t>(program.statements.size() + 1);
    program.statements.push_back(s);
  }
  void assign(const ir::Variable& v, ir::ExpressionId e) {
    program.assigns.push_back({program.add(v), e});
    statement(StatementKind::assign, program.assigns.size() - 1);
  }
  void structure(StatementKind kind, ir::ExpressionId condition = ir::ExpressionId::none) {
    ir::Structure s;
    s.condition = condition;
    program.structures.push_back(s);
    statement(kind, program.structures.size() - 1);
  }
  void block(std::vector<std::pair<Function, std::int16_t>> codes, std::vector<std::pair<Address, double>> words = {},
             ir::WordMode mode = ir::WordMode::as_modal) {
    ir::Block b;
    b.first_code = static_cast<std::uint32_t>(program.codes.size());
    b.code_count = static_cast<std::uint32_t>(codes.size());
    b.first_word = static_cast<std::uint32_t>(program.words.size());
    b.word_count = static_cast<std::uint32_t>(words.size());
    for (const auto& [function, argument] : codes) {
      ir::Code code;
      code.function = function;
      code.argument = argument;
      program.codes.push_back(code);
    }
    for (const auto& [address, v] : words) {
      ir::Word word;
      word.address = address;
      word.mode = mode;
      word.value = value(v);
      program.words.push_back(word);
    }
    program.blocks.push_back(b);
    statement(StatementKind::block, program.blocks.size() - 1);
  }
};

// What a program that says no mode at all is given in front; all of those here are such.
constexpr std::string_view kSafeStart = "G00 G17 G21 G90 G94\n";
constexpr std::string_view kSafeStartOnLathes = "G00 G17 G21 G98\n";

std::string printed(Built& built, MachineKind kind, ir::GSystem system = ir::GSystem::a) {
  ir::match_structures(built.program);
  const ir::Control to = control(kind, system);
  const ir::RaiseResult raised = Stages::raise(built.program, neutral(kind), to);
  if (!raised.diagnostics.empty()) return "fault: " + text::message_of(raised.diagnostics.front());
  const std::string text = Stages::print(raised.program, to).text;
  const std::string head = "%\nO0001\n";
  EXPECT_TRUE(text.starts_with(head) && text.ends_with("%\n")) << text;
  std::string body = text.substr(head.size(), text.size() - head.size() - 2);
  // What is printed is understood without a fault.
  const text::Source source("x.nc", text);
  EXPECT_TRUE(Stages::read(source, to).diagnostics.empty()) << text;
  const std::string_view safe = kind == MachineKind::mill ? kSafeStart : kSafeStartOnLathes;
  if (body.starts_with(safe)) body.erase(0, safe.size());
  return body;
}

TEST(Raise, SaysWhatTheProgramLeftToItsControl) {
  Built mill;
  mill.block({{Function::linear, 0}}, {{Address::x, 1}});
  const ir::RaiseResult raised =
      Stages::raise(mill.program, neutral(MachineKind::mill), control(MachineKind::mill, ir::GSystem::a));
  EXPECT_EQ(Stages::print(raised.program, control(MachineKind::mill, ir::GSystem::a)).text,
            "%\nO0001\n" + std::string(kSafeStart) + "G01 X1.\n%\n");
}

TEST(Raise, SaysToolsAsTheControlDoes) {
  Built lathe;
  lathe.block({}, {{Address::t, 6}, {Address::d, 1}});
  lathe.block({}, {{Address::d, 0}});
  EXPECT_EQ(printed(lathe, MachineKind::lathe), "T0606\nT0600\n");
  Built mill;
  mill.block({{Function::tool_change, 0}}, {{Address::t, 6}, {Address::d, 1}});
  mill.block({{Function::comp_left, 0}, {Function::linear, 0}}, {{Address::x, 1}});
  EXPECT_EQ(printed(mill, MachineKind::mill), "T6 M06\nG43 H6\nG41 G01 X1. D6\n");
}

// A point less is a thousandth of the angle; a place less is another angle.
TEST(FanucPrint, HIsTheIncrementOfCWhereIncrementsHaveLetters) {
  const auto printed_again = [](std::string text, ir::Control target) {
    target.axes = "XZC";
    return Stages::print(Stages::read(text::Source("h.nc", std::move(text)), target).program, target).text;
  };
  EXPECT_EQ(printed_again("G00 H-51.429\nG00 H5.\n", control(MachineKind::lathe, ir::GSystem::a)),
            "%\nO0001\nG00 H-51.429\nG00 H5.\n%\n");
  EXPECT_EQ(printed_again("G00 H5\n", control(MachineKind::lathe, ir::GSystem::a)), "%\nO0001\nG00 H5\n%\n");
  EXPECT_EQ(printed_again("G43 H5\n", control(MachineKind::mill, ir::GSystem::a)), "%\nO0001\nG43 H5\n%\n");
}

TEST(Raise, SaysModesByTheTargetsCodes) {
  const auto safe = [] {
    Built b;
    b.block({{Function::unit_mm, 0}, {Function::absolute, 0}, {Function::feed_per_rev, 0}, {Function::diameter_on, 0}});
    b.block({{Function::work_offset, 2}});
    b.block({{Function::work_offset, 8}});
    return b;
  };
  Built a = safe();
  EXPECT_EQ(printed(a, MachineKind::lathe, ir::GSystem::a), "G21 G99\nG55\nG54.1 P2\n");
  Built b = safe();
  EXPECT_EQ(printed(b, MachineKind::lathe, ir::GSystem::b), "G21 G90 G95\nG55\nG54.1 P2\n");
  Built c = safe();
  EXPECT_EQ(printed(c, MachineKind::lathe, ir::GSystem::c), "G71 G90 G95\nG55\nG54.1 P2\n");
}

TEST(Raise, DoublesRadiiOfLathes) {
  Built b;
  b.block({{Function::diameter_off, 0}});
  b.block({{Function::rapid, 0}}, {{Address::x, 10}, {Address::z, 5}});
  b.block({{Function::diameter_on, 0}});
  b.block({{Function::rapid, 0}}, {{Address::x, 10}, {Address::z, 5}});
  EXPECT_EQ(printed(b, MachineKind::lathe), "G00 X20. Z5.\nG00 X10. Z5.\n");
}

TEST(Raise, SaysIncrements) {
  Built lathe;
  lathe.block({{Function::diameter_on, 0}});
  lathe.block({{Function::linear, 0}}, {{Address::x, 2}, {Address::z, -1}}, ir::WordMode::incremental);
  EXPECT_EQ(printed(lathe, MachineKind::lathe), "G01 U2. W-1.\n");
  Built mill;
  mill.block({{Function::linear, 0}}, {{Address::x, 2}}, ir::WordMode::incremental);
  EXPECT_EQ(printed(mill, MachineKind::mill), "G91\nG01 X2.\nG90\n");
  Built modal;
  modal.block({{Function::incremental, 0}, {Function::linear, 0}}, {{Address::x, 2}});
  EXPECT_EQ(printed(modal, MachineKind::mill), "G91 G01 X2.\n");
}

TEST(Raise, SaysDwellsLimitsAndSeveralMCodes) {
  Built b;
  b.block({{Function::dwell, 0}}, {{Address::f, 1.5}});
  b.block({{Function::surface_speed_on, 0}, {Function::spindle_cw, 0}},
          {{Address::s, 200}, {Address::spindle_limit, 3000}});
  b.block({{Function::spindle_cw, 0}, {Function::coolant_flood, 0}}, {{Address::s, 500}});
  EXPECT_EQ(printed(b, MachineKind::lathe), "G04 P1500\nG50 S3000\nG96 S200 M03\nS500 M03\nM08\n");
}

TEST(Raise, GivesNamesNumbersAndLowersStructures) {
  Built b;
  const ir::Variable x = b.variable("x");
  b.assign(x, b.value(3));
  b.structure(StatementKind::if_begin, b.program.add_operator(Operator::less, b.value(x), b.value(5)));
  b.assign(x, b.value(1));
  b.structure(StatementKind::else_begin);
  b.assign(x, b.value(2));
  b.structure(StatementKind::if_end);
  b.structure(StatementKind::loop_begin);
  b.assign(x, b.program.add_operator(Operator::square, b.value(x)));
  b.structure(StatementKind::loop_end);
  EXPECT_EQ(printed(b, MachineKind::mill),
            "#100=3.\nIF[#100 GE 5.]GOTO 10\n#100=1.\nGOTO 20\nN10 #100=2.\nN20 DO1\n#100=#100*#100\nEND1\n");
}

TEST(Raise, TurnsAnglesIntoTheRangeOfTheSource) {
  Built b;
  const ir::Variable x = b.variable("x");
  b.assign(x, b.program.add_operator(Operator::atan2, b.value(-1), b.value(1)));
  EXPECT_EQ(printed(b, MachineKind::mill), "#101=ATAN[-1.]/[1.]\nIF[#101 GT 180.]THEN #101=#101-360.\n#100=#101\n");
}

TEST(Raise, SplitsExpressionsThatNestTooDeep) {
  Built b;
  const ir::Variable x = b.variable("x");
  b.assign(x, b.value(1));
  ir::ExpressionId e = b.value(x);
  for (int i = 0; i < 12; ++i) e = b.program.add_operator(Operator::sqrt, e);
  b.assign(x, e);
  ir::match_structures(b.program);
  const std::string text = printed(b, MachineKind::mill);
  EXPECT_FALSE(text.starts_with("fault"));
  const text::Source source("x.nc", text);
  EXPECT_TRUE(Stages::read(source, control(MachineKind::mill, ir::GSystem::a)).diagnostics.empty()) << text;
}

TEST(Raise, ReportsWhatHasNoCounterpart) {
  Built opening;
  opening.block({{Function::arc_cw, 0}}, {{Address::x, 1}, {Address::opening_angle, 90}});
  EXPECT_TRUE(printed(opening, MachineKind::mill).starts_with("fault")) << "opening angle";
  Built shift;
  shift.block({{Function::axial_shift, 0}}, {{Address::x, 1}});
  EXPECT_TRUE(printed(shift, MachineKind::mill).starts_with("fault")) << "axial shift";
  Built base;
  base.block({{Function::work_offset, 0}});
  EXPECT_TRUE(printed(base, MachineKind::mill).starts_with("fault")) << "no work offset";
}

TEST(Raise, WritesThePointThatTheControlCounted) {
  const ir::Control c = control(MachineKind::mill, ir::GSystem::a);
  const text::Source source("x.nc", "%\nO7\nG21 G90 G00 X1500 Y-2. Z#1\nG04 X500\nT5\nM30\n%\n");
  const ir::RaiseResult raised = Stages::raise(Stages::read(source, c).program, c, c);
  EXPECT_TRUE(raised.diagnostics.empty());
  EXPECT_EQ(Stages::print(raised.program, c).text, "%\nO0007\nG21 G90 G00 X1.5 Y-2. Z#1\nG04 X0.5\nT5\nM30\n%\n");
}

TEST(Print, IsIdempotentAndGivesOrigins) {
  const ir::Control c = control(MachineKind::mill, ir::GSystem::a);
  const text::Source source("x.nc",
                            "%\nO7\n(C)\nG21 G90\n/2N10 G00 X[ROUND[#1*2]] (D)\nIF[#1 EQ #0]THEN #3000=1(STOP IT)\n"
                            "WHILE[#1 LT 3.]DO2\n#1=#1+1\nIF[#1 GT 9]GOTO10\nEND2\nM98 P51234\nG65 P9010 A1. I2. I3.\n"
                            "#3006=2(LOOK)\nG54.1 P3\nDPRNT[X#1[53]]\nG81 X1. Y2. Z-3. R1. F100.\nM8\nM30\n%\n");
  const ir::RaiseResult first = Stages::raise(Stages::read(source, c).program, c, c);
  ASSERT_TRUE(first.diagnostics.empty()) << text::message_of(first.diagnostics.front());
  const ir::PrintResult printed = Stages::print(first.program, c);
  EXPECT_EQ(printed.text,
            "%\nO0007\nG21 G90\n/2 N10 G00 X[ROUND[#1*2]]\nIF[#1 EQ #0]THEN #3000=1(STOP IT)\nWHILE[#1 LT 3.]DO1\n"
            "#1=#1+1\nIF[#1 GT 9]GOTO 10\nEND1\nM98 P1234 L5\nG65 P9010 A1. I2. I3.\n#3006=2(LOOK)\nG54.1 P3\n"
            "DPRNT[X#1[53]]\nG81 X1. Y2. Z-3. R1. F100.\nM08\nM30\n%\n");
  EXPECT_EQ(printed.origin_lines.size(), 18U);
  EXPECT_EQ(printed.origin_lines[2], 4U);
  EXPECT_EQ(printed.variables, 1U);
  const text::Source again("y.nc", printed.text);
  const ir::RaiseResult second = Stages::raise(Stages::read(again, c).program, c, c);
  EXPECT_EQ(Stages::print(second.program, c).text, printed.text);
}

// Codes of one function that differ by its argument keep their numbers on a control that has them too.
TEST(Raise, KeepsFramesAndSetCoordinatesApart) {
  const ir::Control mill = control(MachineKind::mill, ir::GSystem::a);
  ir::Control other = mill;
  other.dialect = "other";
  const text::Source source("a.nc", "G21 G17 G90\nG68 X0. Y0. R30.\nG69\nG51.1 X1.\nG50.1\nG92 X0.\nG92.1 X0.\nM30\n");
  const ir::RaiseResult raised = Stages::raise(Stages::read(source, other).program, other, mill);
  EXPECT_TRUE(raised.diagnostics.empty());
  const std::string text = Stages::print(raised.program, mill).text;
  for (const char* code : {"G68 ", "G69", "G51.1 ", "G50.1", "G92 ", "G92.1 "})
    EXPECT_NE(text.find(code), std::string::npos) << code << " in\n" << text;
}

}  // namespace
}  // namespace dripfeed::fanuc
