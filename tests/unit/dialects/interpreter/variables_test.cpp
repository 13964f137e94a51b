// Variables of every bank: types, arrays, indirect numbers, system values, start values, strings, and the listing.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/dialects/interpreter/run_trace.h"

namespace dripfeed::test {
namespace {

using interpreter::Ended;
using ir::Address;
using ir::Bank;
using ir::Function;
using ir::Operator;
using ir::ValueType;
using text::DiagnosticId;
using Builder = ProgramBuilder;

TEST(Variables, TypesConvertWhenAssigned) {
  Builder b;
  const ir::Variable n = Builder::named(b.declare("N", ValueType::integer));
  const ir::Variable flag = Builder::named(b.declare("FLAG", ValueType::boolean));
  const ir::Variable letter = Builder::named(b.declare("LETTER", ValueType::character));
  b.assign(Builder::r(1), b.number(2.5));
  b.assign(n, b.read(Builder::r(1)));
  b.assign(flag, b.read(Builder::r(1)));
  b.assign(letter, b.number(65));
  b.assign(Builder::r(2), b.apply(Operator::divide, b.read(n), b.number(2, false)));
  b.end();
  const Ran ran = run_program(b.build(), sinumerik_control());
  EXPECT_EQ(ran.value("N"), 3.0);
  EXPECT_EQ(ran.value("FLAG"), 1.0);
  EXPECT_EQ(ran.value("LETTER"), 65.0);
  EXPECT_EQ(ran.value("R2"), 1.5);  // INT by INT is REAL
  Builder over;
  const ir::Variable c = Builder::named(over.declare("C", ValueType::character));
  over.assign(c, over.apply(Operator::add, over.read(Builder::r(1)), over.number(256)));
  EXPECT_EQ(run_program(over.build(), sinumerik_control()).last_diagnostic()->diagnostic.id,
            DiagnosticId::result_overflow);
}

TEST(Variables, WholeDivisionWhereTheControlHasIt) {
  ir::Control control = sinumerik_control();
  control.semantics.integer_division_is_real = false;
  Builder b;
  const ir::Variable n = Builder::named(b.declare("N", ValueType::integer));
  b.assign(n, b.number(7, false));
  b.assign(Builder::r(1), b.apply(Operator::divide, b.read(n), b.number(4, false)));
  b.assign(Builder::r(2), b.apply(Operator::divide, b.read(n), b.number(4.0, true)));
  b.end();
  const Ran ran = run_program(b.build(), control);
  EXPECT_EQ(ran.value("R1"), 1.0);
  EXPECT_EQ(ran.value("R2"), 1.75);
}

TEST(Variables, DefinitionsInitialise) {
  Builder b;
  const ir::SymbolId a = b.declare("A");
  const ir::SymbolId list = b.declare("LIST", ValueType::integer, 3);
  b.symbol(a).initial = b.number(1.25);
  b.symbol(list).initial = b.number(4.6);
  b.define(a, 2);
  b.end();
  const Ran ran = run_program(b.build(), sinumerik_control());
  EXPECT_EQ(ran.value("A"), 1.25);
  for (const char* name : {"LIST[0]", "LIST[1]", "LIST[2]"}) EXPECT_EQ(ran.value(name), 5.0);
}

TEST(Variables, ArraysHaveBounds) {
  Builder b;
  const ir::SymbolId table = b.declare("T", ValueType::real, 3, 2);
  b.assign(Builder::r(1), b.number(1));
  b.assign(Builder::named(table, b.number(2), b.read(Builder::r(1))), b.number(42));
  b.assign(Builder::r(2), b.read(Builder::named(table, b.number(2.2), b.number(1))));
  b.assign(Builder::named(table, b.read(Builder::r(1)), b.number(2)), b.number(1));
  b.end();
  const Ran ran = run_program(b.build(), sinumerik_control());
  EXPECT_EQ(ran.value("T[2,1]"), 42.0);
  EXPECT_EQ(ran.value("T[1,1]"), 0.0);
  EXPECT_EQ(ran.value("R2"), 42.0);
  EXPECT_EQ(ran.result.ended, Ended::alarm);
  EXPECT_EQ(ran.last_diagnostic()->diagnostic.id, DiagnosticId::variable_out_of_range);
  EXPECT_EQ(ran.last_diagnostic()->diagnostic.arguments, std::vector<std::string>{"T[1,2]"});
}

TEST(Variables, TooManySlotsAreALimit) {
  Builder b;
  b.declare("HUGE", ValueType::real, 60000, 60000);
  b.end();
  EXPECT_EQ(run_program(b.build(), sinumerik_control()).result.ended, Ended::limit);
}

TEST(Variables, IndirectNumbers) {
  Builder b;
  b.assign(Builder::hash(1), b.number(100.4));
  b.assign(Builder::indirect(Bank::hash, b.read(Builder::hash(1))), b.number(7));
  b.assign(Builder::hash(102),
           b.read(Builder::indirect(Bank::hash, b.apply(Operator::add, b.read(Builder::hash(1)), b.number(-99.4)))));
  b.assign(Builder::hash(103), b.read(Builder::indirect(Bank::hash, b.number(0))));
  b.assign(Builder::hash(104), b.read(Builder::indirect(Bank::hash, b.read(Builder::hash(33)))));
  const Ran ran = run_program(b.build(), mill_control());
  EXPECT_EQ(ran.value("#100"), 7.0);
  EXPECT_EQ(ran.value("#102"), 100.4);
  EXPECT_EQ(ran.value("#103"), -999.0);
  EXPECT_EQ(ran.result.ended, Ended::alarm);  // the number is vacant
  EXPECT_EQ(ran.last_diagnostic()->line, 5U);
}

TEST(Variables, StartValues) {
  Builder b;
  const ir::Variable x = Builder::named(b.declare("X1"));
  b.assign(Builder::hash(101), b.apply(Operator::add, b.read(Builder::hash(100)), b.read(x)));
  b.end();
  interpreter::RunOptions options;
  options.initial_values = {{Bank::hash, 100, "", 5.0}, {Bank::named, 0, "X1", 2.0}, {Bank::hash, 4000000, "", 1.0}};
  EXPECT_EQ(run_program(b.build(), mill_control(), options).value("#101"), 7.0);
}

TEST(Variables, SystemValues) {
  constexpr ir::SystemVariableRow kRows[] = {
      {"", 4001, 4030, ir::SystemValue::active_code, false, ""},
      {"", 5001, 5020, ir::SystemValue::end_position, false, ""},
      {"", 3001, 3001, ir::SystemValue::clock_ms, true, ""},
      {"$P_EP", 0, 0, ir::SystemValue::end_position, false, ""},
  };
  constexpr ir::CodeRow kCodes[] = {{"G00", 0, Function::rapid, 0, ir::ModalGroup::motion, ""},
                                    {"G01", 10, Function::linear, 0, ir::ModalGroup::motion, ""}};
  ir::Control control = lathe_control();
  control.system_variables = kRows;
  control.g_codes = kCodes;
  Builder b;
  b.block({{Function::linear}}, {{Address::x, 40.0}, {Address::f, 0.1}});
  b.assign(Builder::hash(100), b.read(Builder::hash(5001)));
  b.assign(Builder::hash(101), b.read(Builder::hash(4001)));
  b.assign(Builder::hash(102), b.read(Builder::hash(5002)));  // Z was never commanded
  b.assign(Builder::hash(103), b.read(Builder::system(3, b.number(0))));
  b.assign(Builder::hash(104), b.read(Builder::hash(3001)));
  b.assign(Builder::hash(3001), b.number(12));
  b.assign(Builder::hash(105), b.read(Builder::hash(3001)));
  b.assign(Builder::hash(5001), b.number(1));
  const Ran ran = run_program(b.build(), control);
  EXPECT_EQ(ran.value("#100"), 40.0);
  EXPECT_EQ(ran.value("#101"), 1.0);
  EXPECT_EQ(ran.value("#102"), -999.0);
  EXPECT_EQ(ran.value("#103"), 40.0);
  EXPECT_EQ(ran.value("#104"), 0.0);  // blocks cost nothing on this control
  EXPECT_EQ(ran.value("#105"), 12.0);
  ASSERT_EQ(ran.result.not_interpreted.size(), 1U);
  EXPECT_EQ(ran.result.not_interpreted[0].name, "#5002");
  EXPECT_EQ(ran.last_diagnostic()->diagnostic.id, DiagnosticId::variable_write_protected);
}

TEST(Variables, Strings) {
  Builder b;
  const ir::SymbolId s = b.declare("S", ValueType::string);
  b.symbol(s).string_length = 8;
  const ir::Variable text = Builder::named(s);
  const ir::Variable n = Builder::named(b.declare("N", ValueType::integer));
  b.assign(n, b.number(3));
  b.assign(text, b.apply(Operator::concatenate, b.text("ab"), b.apply(Operator::add, b.read(n), b.number(1, false))));
  b.message(
      b.apply(Operator::concatenate, b.read(text), b.apply(Operator::concatenate, b.text(" of "), b.number(0.1))));
  b.message(ir::ExpressionId::none);
  b.assign(Builder::r(1), b.apply(Operator::string_length, b.read(text)));
  b.assign(Builder::r(2), b.apply(Operator::equal, b.apply(Operator::to_upper, b.read(text)), b.text("AB4")));
  b.assign(Builder::r(3), b.apply(Operator::not_equal, b.read(text), b.text("AB4")));
  b.assign(Builder::r(4), b.apply(Operator::to_number, b.text("-1.5")));
  b.assign(Builder::r(5), b.apply(Operator::is_variable, b.text("N")));
  b.assign(Builder::r(6), b.apply(Operator::is_variable, b.text("M")));
  b.assign(text, b.text("123456789"));
  const Ran ran = run_program(b.build(), sinumerik_control());
  EXPECT_EQ(ran.trace, "3 message \"ab4 of 0.1\"\n4 message \"\"\n");
  EXPECT_EQ(ran.value("R1"), 3.0);
  EXPECT_EQ(ran.value("R2"), 1.0);
  EXPECT_EQ(ran.value("R3"), 1.0);
  EXPECT_EQ(ran.value("R4"), -1.5);
  EXPECT_EQ(ran.value("R5"), 1.0);
  EXPECT_EQ(ran.value("R6"), 0.0);
  EXPECT_EQ(ran.result.ended, Ended::alarm);  // nine characters do not fit
  EXPECT_EQ(ran.last_diagnostic()->line, 11U);
  ASSERT_FALSE(ran.result.variables.empty());
  bool listed = false;
  for (const auto& variable : ran.result.variables)
    if (variable.name == "S") listed = variable.text == "ab4";
  EXPECT_TRUE(listed);
}

TEST(Variables, StringsAreNoNumbers) {
  Builder sum;
  sum.assign(Builder::r(1), sum.apply(Operator::add, sum.text("1"), sum.number(1)));
  EXPECT_EQ(run_program(sum.build(), sinumerik_control()).last_diagnostic()->diagnostic.id, DiagnosticId::wrong_type);
  Builder order;
  order.assign(Builder::r(1), order.apply(Operator::less, order.text("1"), order.text("2")));
  EXPECT_EQ(run_program(order.build(), sinumerik_control()).last_diagnostic()->diagnostic.id, DiagnosticId::wrong_type);
  Builder word;
  word.block({{Function::rapid}}, {{Address::x, word.text("1")}});
  EXPECT_EQ(run_program(word.build(), sinumerik_control()).last_diagnostic()->diagnostic.id, DiagnosticId::wrong_type);
}

TEST(Variables, BoundAndNestedExpressions) {
  Builder b;
  b.assign(Builder::r(1), b.apply(Operator::bound, b.number(0), b.number(10), b.number(12)));
  b.assign(Builder::r(2), b.number(3));
  // (R2 * (R2 + 1)) - ((R2 - 1) / (R2 + 1)) = 12 - 0.5
  const auto r2 = [&] { return b.read(Builder::r(2)); };
  b.assign(Builder::r(2),
           b.apply(Operator::subtract, b.apply(Operator::multiply, r2(), b.apply(Operator::add, r2(), b.number(1))),
                   b.apply(Operator::divide, b.apply(Operator::subtract, r2(), b.number(1)),
                           b.apply(Operator::add, r2(), b.number(1)))));
  b.assign(Builder::r(3), b.apply(Operator::bound, b.number(0), b.read(Builder::r(1)), b.read(Builder::r(2))));
  b.end();
  const Ran ran = run_program(b.build(), sinumerik_control());
  EXPECT_EQ(ran.value("R1"), 10.0);
  EXPECT_EQ(ran.value("R2"), 11.5);
  EXPECT_EQ(ran.value("R3"), 10.0);
}

// Counts of computing, as the cost model needs them: of the blocks since the motion before.
TEST(Variables, WorkIsCountedForEachMotion) {
  Builder b;
  const ir::Variable n = Builder::named(b.declare("N"));
  b.assign(Builder::r(1), b.number(1));                                                           // no reads
  b.assign(n, b.apply(Operator::add, b.apply(Operator::sin, b.read(Builder::r(1))), b.read(n)));  // 1 R, 1 name, + sin
  b.block({{Function::rapid}}, {{Address::x, b.read(Builder::r(1))}});
  b.block({}, {{Address::x, 1.0}});
  b.end();
  const Ran ran = run_program(b.build(), sinumerik_control());
  ASSERT_EQ(ran.motions.size(), 3U);
  const ir::ComputeCounts& first = ran.motions[0].compute;
  EXPECT_EQ(first.blocks, 3U);
  EXPECT_EQ(first.number_reads, 2U);
  EXPECT_EQ(first.number_writes, 1U);
  EXPECT_EQ(first.named_reads, 1U);
  EXPECT_EQ(first.named_writes, 1U);
  EXPECT_EQ(first.operators, 1U);
  EXPECT_EQ(first.functions, 1U);
  EXPECT_EQ(ran.motions[1].compute.blocks, 1U);
  EXPECT_EQ(ran.motions[1].compute.number_reads, 0U);
}

class Changes : public interpreter::BlockObserver {
 public:
  explicit Changes(const interpreter::RunNames& names) : names_(names) {}
  void block(const ir::Place& place, std::span<const interpreter::VariableChange> changes) override {
    text += std::to_string(place.ordinal) + "/" + std::to_string(place.line);
    for (const auto& change : changes)
      text += " " + names_.variables[change.variable] + "=" + std::to_string(static_cast<int>(change.value));
    text += "\n";
  }
  std::string text;

 private:
  const interpreter::RunNames& names_;
};

TEST(Variables, AnObserverHearsOfEveryBlock) {
  Builder b;
  const ir::SymbolId list = b.declare("LIST", ValueType::real, 3);
  b.assign(Builder::r(1), b.number(5));
  b.block({{Function::rapid}}, {{Address::x, 1.0}});
  b.assign(Builder::indirect(Bank::r, b.number(2)), b.number(6));
  b.assign(Builder::named(list, b.number(1)), b.number(7));
  b.end();
  interpreter::RunNames names;
  Changes changes(names);
  interpreter::RunOptions options;
  options.names = &names;
  options.observer = &changes;
  run_program(b.build(), sinumerik_control(), options);
  EXPECT_EQ(changes.text, "0/1 R1=5\n1/2\n2/3 R2=6\n3/4 LIST[1]=7\n4/5\n");
}

TEST(Variables, AnObserverHearsOfScalarsAlone) {
  Builder b;
  const ir::SymbolId list = b.declare("LIST", ValueType::real, 3);
  b.assign(Builder::named(list, b.number(1)), b.number(7));
  b.assign(Builder::r(1), b.read(Builder::named(list, b.number(1))));
  b.assign(Builder::named(list, b.apply(Operator::subtract, b.read(Builder::r(1)), b.number(5))), b.number(8));
  b.end();
  const auto heard = [&](interpreter::Changes of) {
    interpreter::RunNames names;
    Changes changes(names);
    interpreter::RunOptions options;
    options.names = &names;
    options.observer = &changes;
    options.changes = of;
    run_program(b.build(), sinumerik_control(), options);
    return changes.text;
  };
  EXPECT_EQ(heard(interpreter::Changes::all), "0/1 LIST[1]=7\n1/2 R1=7\n2/3 LIST[2]=8\n3/4\n");
  EXPECT_EQ(heard(interpreter::Changes::scalars), "0/1\n1/2 R1=7\n2/3\n3/4\n");
  EXPECT_EQ(heard(interpreter::Changes::none), "0/1\n1/2\n2/3\n3/4\n");
}

// An index that is a number of the text and one that is computed are the same place, rounded alike, with the same end.
TEST(Variables, ElementsByNumberAndByComputedIndex) {
  for (const double index : {0.0, 2.0, 0.8, 2.4, 2.6, 3.0, -1.0}) {
    const auto run = [&](bool computed) {
      Builder b;
      const ir::SymbolId list = b.declare("LIST", ValueType::integer, 3);
      b.assign(Builder::r(1), b.number(index));
      const auto place = [&] { return computed ? b.read(Builder::r(1)) : b.number(index); };
      b.assign(Builder::named(list, place()), b.number(4.0));
      b.assign(Builder::named(list, place()),
               b.apply(Operator::add, b.read(Builder::named(list, place())), b.read(Builder::named(list, place()))));
      b.assign(Builder::r(2), b.read(Builder::named(list, b.number(0))));
      b.assign(Builder::r(3), b.read(Builder::named(list, b.number(1))));
      b.assign(Builder::r(4), b.read(Builder::named(list, b.number(2))));
      b.end();
      return run_program(b.build(), sinumerik_control());
    };
    const Ran fixed = run(false);
    const Ran computed = run(true);
    ASSERT_EQ(fixed.result.ended, computed.result.ended) << index;
    if (index < 0.0 || index > 2.5) {
      EXPECT_EQ(fixed.last_diagnostic()->diagnostic.id, DiagnosticId::variable_out_of_range);
      EXPECT_EQ(fixed.last_diagnostic()->diagnostic.arguments, computed.last_diagnostic()->diagnostic.arguments);
      continue;
    }
    for (const char* name : {"R2", "R3", "R4"}) {
      const bool is_place = name[1] - '2' == static_cast<int>(std::lround(index));
      EXPECT_EQ(fixed.value(name), is_place ? 8.0 : 0.0) << index << " " << name;
      EXPECT_EQ(computed.value(name), is_place ? 8.0 : 0.0) << index << " " << name;
    }
  }
}

// A block belongs to the program and line where it stands, also when it calls.
TEST(Variables, AnObserverHearsTheRightPlaceAroundCalls) {
  Builder sub("S");
  sub.add(ir::StatementKind::empty);
  sub.assign(Builder::r(1), sub.number(1));
  sub.back();
  Programs programs;
  programs.add("S", sub.build());
  Builder b;
  b.call(ir::CallKind::subprogram, "S");
  b.end();
  class Places : public interpreter::BlockObserver {
   public:
    void block(const ir::Place& place, std::span<const interpreter::VariableChange>) override {
      text += std::to_string(place.program) + ":" + std::to_string(place.line) + " ";
    }
    std::string text;
  };
  Places places;
  interpreter::RunOptions options;
  options.observer = &places;
  run_program(b.build(), sinumerik_control(), options, programs);
  EXPECT_EQ(places.text, "0:1 1:2 1:3 0:2 ");
}

// What a reader could not read is an alarm where it is reached, never more.
TEST(Variables, HolesInTheProgramAreAlarms) {
  const auto id_of = [](auto make) {
    Builder b;
    make(b);
    b.end();
    const Ran ran = run_program(b.build(), mill_control());
    EXPECT_EQ(ran.result.ended, Ended::alarm);
    return ran.last_diagnostic()->diagnostic.id;
  };
  constexpr auto kNone = ir::ExpressionId::none;
  EXPECT_EQ(id_of([](Builder& b) { b.assign(Builder::hash(1), kNone); }), DiagnosticId::missing_operand);
  EXPECT_EQ(id_of([](Builder& b) { b.assign(Builder::hash(1), b.apply(Operator::negate, kNone)); }),
            DiagnosticId::missing_operand);
  EXPECT_EQ(id_of([](Builder& b) { b.assign(Builder::hash(1), b.apply(Operator::add, b.number(1), kNone)); }),
            DiagnosticId::missing_operand);
  EXPECT_EQ(id_of([](Builder& b) { b.block({{Function::rapid}}, {{Address::x, b.apply(Operator::negate, kNone)}}); }),
            DiagnosticId::missing_operand);
  EXPECT_EQ(id_of([](Builder& b) { b.assign(Builder::hash(1), b.apply(Operator::bound, kNone, kNone, kNone)); }),
            DiagnosticId::missing_operand);
  EXPECT_EQ(id_of([](Builder& b) { b.assign(Builder::named(ir::SymbolId::none), b.number(1)); }),
            DiagnosticId::unknown_name);
  EXPECT_EQ(id_of([](Builder& b) { b.assign(Builder::hash(1), b.read(Builder::named(ir::SymbolId::none))); }),
            DiagnosticId::unknown_name);
  EXPECT_EQ(id_of([](Builder& b) {
              b.structure(ir::StatementKind::for_begin);
              b.structure(ir::StatementKind::for_end);
            }),
            DiagnosticId::missing_operand);
}

TEST(Variables, EndlessExpressionsAreALimit) {
  Builder b;
  ir::ExpressionId sum = b.read(Builder::hash(100));
  for (int i = 0; i < 200'000; ++i) sum = b.apply(Operator::add, sum, b.number(1));
  b.assign(Builder::hash(100), sum);
  b.end();
  EXPECT_EQ(run_program(b.build(), mill_control()).result.ended, Ended::limit);
}

}  // namespace
}  // namespace dripfeed::test
