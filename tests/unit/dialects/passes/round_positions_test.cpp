// Positions as a control counts them.
#include "dialects/passes/round_positions.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "building.h"

namespace dripfeed::passes {
namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;

// Blocks of one code, if any, and one X.
class Moves {
 public:
  void x(double value, Function code = Function::none, Address address = Address::x) {
    ir::Program& p = b_.program;
    ir::Block block;
    block.first_code = static_cast<std::uint32_t>(p.codes.size());
    block.first_word = static_cast<std::uint32_t>(p.words.size());
    if (code != Function::none) {
      ir::Code made;
      made.function = code;
      made.group = code == Function::unit_inch ? ModalGroup::unit : ModalGroup::distance;
      p.codes.push_back(made);
      block.code_count = 1;
    }
    p.words.push_back(ir::word(address, p.add_constant(value)));
    block.word_count = 1;
    p.blocks.push_back(block);
    ir::Statement s;
    s.kind = ir::StatementKind::block;
    s.payload = static_cast<std::uint32_t>(p.blocks.size() - 1);
    p.statements.push_back(s);
  }
  std::vector<double> rounded() {
    round_positions(b_.program, control_with(10));
    std::vector<double> out;
    for (const ir::Word& w : b_.program.words) out.push_back(b_.program.at(w.value).value);
    return out;
  }

 private:
  Building b_;
};

TEST(RoundPositions, ByTheIncrementOfTheUnit) {
  Moves metric;
  metric.x(1.23456);
  metric.x(2.0004, Function::unit_inch);
  EXPECT_EQ(metric.rounded(), (std::vector<double>{1.235, 2.0004}));
  Moves inch;
  inch.x(1.23456, Function::unit_inch);
  EXPECT_EQ(inch.rounded(), (std::vector<double>{1.2346}));
}

TEST(RoundPositions, TheEndsOfAChainAndNotItsIncrements) {
  Moves chain;
  chain.x(0.0, Function::absolute);
  chain.x(0.0004, Function::incremental);
  for (int i = 1; i < 1000; ++i) chain.x(0.0004);
  double end = 0.0;
  for (const double step : chain.rounded()) {
    EXPECT_NEAR(step * 1000.0, std::nearbyint(step * 1000.0), 1e-9);
    end += step;
  }
  EXPECT_NEAR(end, 0.4, 1e-9);
}

TEST(RoundPositions, AFeedIsNoPosition) {
  Moves feed;
  feed.x(0.01234, Function::none, Address::f);
  EXPECT_EQ(feed.rounded(), (std::vector<double>{0.01234}));
}

}  // namespace
}  // namespace dripfeed::passes
