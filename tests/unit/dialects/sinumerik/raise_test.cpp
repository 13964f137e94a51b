// Programs of other controls and built ones: what they become, and what cannot.
#include <functional>
#include <string>

#include "tests/unit/dialects/sinumerik/reading.h"

namespace dripfeed::sinumerik {
namespace {

using ir::Address;
using ir::Bank;
using ir::ExpressionId;
using ir::Function;
using ir::Operator;
using ir::StatementKind;

// A control with '#' variables, as far as raising looks at it.
ir::Control other_control(ir::MachineKind kind) {
  ir::Control c = control(kind);
  c.dialect = "other";
  c.system_variables = {};
  c.variables = {{Bank::hash, 1, 33, ir::VariableUse::local, true},
                 {Bank::hash, 100, 199, ir::VariableUse::common, true}};
  c.semantics = ir::Semantics();
  c.semantics.power_on_plane = kind == ir::MachineKind::lathe ? Function::plane_zx : Function::plane_xy;
  return c;
}

class Builder {
 public:
  ExpressionId number(double value, bool point = true) { return program.add_constant(value, {}, point); }
  ExpressionId hash(std::uint32_t n) { return program.add_variable(variable(n)); }
  ExpressionId op(Operator o, ExpressionId a, ExpressionId b = ExpressionId::none) {
    return program.add_operator(o, a, b);
  }

  void assign(std::uint32_t n, ExpressionId value) {
    program.assigns.push_back({program.add(variable(n)), value});
    statement(StatementKind::assign, program.assigns.size() - 1);
  }
  struct W {
    Address address;
    ExpressionId value;
  };
  void block(std::initializer_list<std::pair<Function, ir::ModalGroup>> codes, std::initializer_list<W> words,
             std::int16_t argument = 0) {
    ir::Block b;
    b.first_code = static_cast<std::uint32_t>(program.codes.size());
    b.first_word = static_cast<std::uint32_t>(program.words.size());
    for (const auto& [function, group] : codes) {
      ir::Code c;
      c.function = function;
      c.group = group;
      c.argument = argument;
      program.codes.push_back(c);
    }
    for (const W& w : words) {
      ir::Word word;
      word.address = w.address;
      word.value = w.value;
      program.words.push_back(word);
    }
    b.code_count = static_cast<std::uint32_t>(codes.size());
    b.word_count = static_cast<std::uint32_t>(words.size());
    program.blocks.push_back(b);
    statement(StatementKind::block, program.blocks.size() - 1);
  }
  void statement(StatementKind kind, std::size_t payload) {
    ir::Statement s;
    s.kind = kind;
    s.payload = static_cast<std::uint32_t>(payload);
    s.line = static_cast<std::uint32_t>(program.statements.size() + 1);
    program.statements.push_back(s);
  }
  void end() {
    statement(StatementKind::program_end, 0);
    program.statements.back().payload = ir::kNoIndex;
  }

  ir::Program program;

 private:
  static ir::Variable variable(std::uint32_t n) {
    ir::Variable v;
    v.number = n;
    return v;
  }
};

std::string raised(const Builder& b, const ir::Control& from) {
  const ir::Control to = control(from.kind);
  const ir::RaiseResult result = raise(b.program, from, to);
  for (const text::Diagnostic& d : result.diagnostics) {
    if (d.severity == text::Severity::error) ADD_FAILURE() << text::message_of(d);
  }
  return print(result.program, to).text;
}

std::string refusal(const Builder& b, const ir::Control& from) {
  const ir::RaiseResult result = raise(b.program, from, control(from.kind));
  for (const text::Diagnostic& d : result.diagnostics) {
    if (d.severity == text::Severity::error) return text::message_of(d);
  }
  return "nothing was refused";
}

// The value that `value` becomes, with #101 in R101.
std::string expression(const std::function<ExpressionId(Builder&)>& value) {
  Builder b;
  b.assign(101, b.number(1));
  b.assign(102, value(b));
  b.end();
  const std::string text = raised(b, other_control(ir::MachineKind::mill));
  const std::size_t begin = text.find("R102=") + 5;
  return text.substr(begin, text.find('\n', begin) - begin);
}

TEST(Raise, OperatorsThatAreLacking) {
  EXPECT_EQ(expression([](Builder& b) { return b.op(Operator::power, b.hash(101), b.number(2)); }), "POT(R101)");
  EXPECT_EQ(expression([](Builder& b) { return b.op(Operator::power, b.hash(101), b.number(3)); }), "R101*R101*R101");
  EXPECT_EQ(expression([](Builder& b) { return b.op(Operator::power, b.hash(101), b.number(0.5)); }),
            "EXP(0.5*LN(R101))");
  EXPECT_EQ(expression([](Builder& b) { return b.op(Operator::atan, b.hash(101)); }), "ATAN2(R101,1)");
}

TEST(Raise, AnglesAndRoundingKeepTheirRange) {
  EXPECT_EQ(expression([](Builder& b) { return b.op(Operator::atan2, b.hash(101), b.number(1)); }),
            "ATAN2(R101,1)+360*ROUNDUP(MAXVAL(-ATAN2(R101,1),0)/180)");
  EXPECT_EQ(expression([](Builder& b) { return b.op(Operator::round, b.hash(101)); }),
            "ROUND(MAXVAL(R101,0))-ROUND(MAXVAL(-R101,0))");
  EXPECT_EQ(expression([](Builder& b) { return b.op(Operator::round, b.op(Operator::abs, b.hash(101))); }),
            "ROUND(ABS(R101))");
  EXPECT_EQ(expression([](Builder& b) { return b.op(Operator::round_up, b.hash(101)); }),
            "ROUNDUP(MAXVAL(R101,0))-ROUNDUP(MAXVAL(-R101,0))");
  EXPECT_EQ(expression([](Builder& b) { return b.op(Operator::truncate, b.hash(101)); }), "TRUNC(R101)");
}

TEST(Raise, TheHeadSaysWhatTheProgramLeftToTheMachine) {
  Builder b;
  b.block({{Function::linear, ir::ModalGroup::motion}}, {{Address::x, b.number(5)}, {Address::f, b.number(100)}});
  b.end();
  ir::Control mill = other_control(ir::MachineKind::mill);
  // Whether it began in inches is not known.
  EXPECT_EQ(refusal(b, mill), "the program moves before it states inch or millimetre");
  mill.semantics.power_on_known = true;
  EXPECT_EQ(raised(b, mill), "G17 G710 G90 G94\nG1 X5. F100\nM30\n");
  mill.caller_modes = {{.name = "G20",
                        .number10 = 200,
                        .function = Function::unit_inch,
                        .argument = 0,
                        .group = ir::ModalGroup::unit,
                        .reference = {}}};
  EXPECT_EQ(raised(b, mill), "G17 G700 G90 G94\nG1 X5. F100\nM30\n");
  ir::Control lathe = other_control(ir::MachineKind::lathe);
  lathe.semantics.power_on_known = true;
  lathe.semantics.power_on_feed = Function::feed_per_rev;
  lathe.semantics.power_on_diameter = ir::DiameterMode::diameter;
  EXPECT_EQ(raised(b, lathe), "G18 G710 G90 G95 DIAMON\nG1 X5. F100\nM30\n");
}

TEST(Raise, FeedAndSurfaceSpeedAreOneGroup) {
  Builder b;
  using G = ir::ModalGroup;
  b.block({{Function::plane_zx, G::plane},
           {Function::unit_mm, G::unit},
           {Function::absolute, G::distance},
           {Function::feed_per_rev, G::feed},
           {Function::diameter_on, G::diameter},
           {Function::rapid, G::motion}},
          {});
  b.block({{Function::surface_speed_on, G::surface_speed}, {Function::spindle_cw, G::spindle}},
          {{Address::s, b.number(200)}, {Address::spindle_limit, b.number(3000)}});
  b.block({{Function::feed_per_rev, G::feed}}, {{Address::f, b.number(0.15)}});
  b.block({{Function::feed_per_min, G::feed}}, {{Address::f, b.number(100)}});
  b.block({{Function::surface_speed_off, G::surface_speed}}, {{Address::s, b.number(500)}});
  b.end();
  EXPECT_EQ(raised(b, other_control(ir::MachineKind::lathe)),
            "G18 G710 G90 DIAMON G0 G95\nG96 S200 LIMS=3000 M3\nG96 F0.15\nG961 F100\nG971 S500\nM30\n");
}

TEST(Raise, LatheWordsOfTheOtherControl) {
  using G = ir::ModalGroup;
  ir::Control from = other_control(ir::MachineKind::lathe);
  from.semantics.incremental_letters_uvw = true;
  from.semantics.tool_word = ir::ToolWord::number_and_offset;
  from.semantics.decimal_mode = ir::DecimalMode::least_increment;
  Builder b;
  b.block({{Function::plane_zx, G::plane},
           {Function::unit_mm, G::unit},
           {Function::absolute, G::distance},
           {Function::feed_per_rev, G::feed},
           {Function::diameter_on, G::diameter},
           {Function::rapid, G::motion}},
          {});
  b.block({}, {{Address::t, b.number(606, false)}});
  b.block({{Function::rapid, G::motion}}, {{Address::u, b.number(-1500, false)}, {Address::w, b.number(2)}});
  b.block({{Function::arc_cw, G::motion}},
          {{Address::x, b.number(10)}, {Address::z, b.number(-5)}, {Address::r, b.number(5)}});
  b.block({{Function::dwell, G::non_modal}}, {{Address::p, b.number(1500, false)}});
  b.block({{Function::work_offset, G::work_offset}}, {}, 6);
  b.end();
  EXPECT_EQ(raised(b, from),
            "G18 G710 G90 G95 DIAMON G0\nT6 D1\nG0 X=IC(-1.5) Z=IC(2.)\nG2 X10. Z-5. CR=5.\nG4 F1.5\nG506\nM30\n");
}

TEST(Raise, JumpsGetTheirDirection) {
  Builder b;
  b.assign(101, b.number(0));
  b.assign(101, b.op(Operator::add, b.hash(101), b.number(1)));
  ir::Jump back;
  back.condition = b.op(Operator::less, b.hash(101), b.number(5));
  back.number = 20;
  b.program.jumps.push_back(back);
  b.statement(StatementKind::go_to, 0);
  b.end();
  b.program.labels.push_back({ir::StringId::none, 10, 0, {}});
  b.program.labels.push_back({ir::StringId::none, 20, 1, {}});
  EXPECT_EQ(raised(b, other_control(ir::MachineKind::mill)), "N10 R101=0\nN20 R101=R101+1\nIF R101<5 GOTOB N20\nM30\n");
}

TEST(Raise, NamesOfAFamilyBecomeRParametersWithTheirNamesNextTo) {
  ir::Control from = control(ir::MachineKind::mill);
  from.dialect = "family";
  from.semantics.power_on_known = true;
  Builder b;
  ir::Symbol symbol;
  symbol.name = b.program.strings.add("half_axis");
  ir::Variable v;
  v.bank = Bank::named;
  v.symbol = b.program.add(symbol);
  b.program.assigns.push_back({b.program.add(v), b.number(100)});
  b.statement(StatementKind::assign, 0);
  b.block({{Function::rapid, ir::ModalGroup::motion}}, {{Address::x, b.program.add_variable(v)}});
  b.end();
  const std::string text = raised(b, from);
  EXPECT_TRUE(text.contains("=100 ; half_axis\n")) << text;
  EXPECT_TRUE(text.contains("G0 X=R")) << text;
}

TEST(Raise, WhatHasNoCounterpartIsRefused) {
  const ir::Control mill = other_control(ir::MachineKind::mill);
  {
    Builder b;
    ir::Expression vacant;
    vacant.op = Operator::vacant;
    b.assign(101, b.program.add(vacant));
    EXPECT_EQ(refusal(b, mill), "an empty value (#0) has no counterpart on SINUMERIK 840D sl");
  }
  {
    Builder b;
    b.assign(101, b.op(Operator::bcd, b.number(5)));
    EXPECT_EQ(refusal(b, mill), "BCD has no counterpart on SINUMERIK 840D sl");
  }
  {
    Builder b;
    b.block({{Function::reference_return, ir::ModalGroup::non_modal}}, {{Address::z, b.number(0)}});
    EXPECT_EQ(refusal(b, mill), "reference return has no counterpart on SINUMERIK 840D sl");
  }
  {
    Builder b;
    b.program.calls.push_back({});
    b.program.calls[0].kind = ir::CallKind::macro;
    b.program.arguments.push_back({'G', b.number(1)});
    b.program.calls[0].argument_count = 1;
    b.statement(StatementKind::call, 0);
    EXPECT_EQ(refusal(b, mill), "the argument G has no counterpart on SINUMERIK 840D sl");
  }
}

// A local variable is empty until it is set; on one of two paths it is not.
TEST(Raise, AVariableThatMayBeEmptyIsRefused) {
  const auto program = [](bool both_branches) {
    Builder b;
    ir::Structure open;
    open.condition = b.op(Operator::greater, b.hash(101), b.number(0));
    b.program.structures.push_back(open);
    b.statement(StatementKind::if_begin, 0);
    b.assign(1, b.number(5));
    if (both_branches) {
      b.program.structures.push_back({});
      b.statement(StatementKind::else_begin, 1);
      b.assign(1, b.number(6));
    }
    b.program.structures.push_back({});
    b.statement(StatementKind::if_end, b.program.structures.size() - 1);
    b.assign(102, b.hash(1));
    b.end();
    (void)ir::match_structures(b.program);
    return b;
  };
  const ir::Control mill = other_control(ir::MachineKind::mill);
  EXPECT_EQ(refusal(program(false), mill),
            "the variable #1, which may be empty here, has no counterpart on SINUMERIK 840D sl");
  EXPECT_EQ(refusal(program(true), mill), "nothing was refused");
}

}  // namespace
}  // namespace dripfeed::sinumerik
