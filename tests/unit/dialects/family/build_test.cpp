// The built program: what it starts with, that its structures match, that lines are the family's, that no node is
// shared. What it does when it runs is tested where an interpreter is at hand.
#include "dialects/family/build.h"

#include <algorithm>
#include <memory>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "dialects/family/read.h"

namespace dripfeed::family {
namespace {

ir::Program built(const std::string& machine, const std::string& body) {
  ReadFamilyResult read =
      read_family(text::Source("t", "family my-part\nmachine " + machine +
                                        "\nparam len length 30 mm in 1..100\nprogram main-cut\n" + body + "end\n"));
  EXPECT_TRUE(read.diagnostics.empty()) << text::message_of(read.diagnostics.front());
  const BindResult bound = bind_family(std::make_shared<const Family>(std::move(read.family)), {});
  EXPECT_TRUE(bound.diagnostics.empty());
  return build(bound.bound);
}

std::vector<ir::Function> functions_of(const ir::Program& program, const ir::Statement& statement) {
  std::vector<ir::Function> out;
  for (const ir::Code& code : program.codes_of(program.blocks[statement.payload])) out.push_back(code.function);
  return out;
}

TEST(FamilyBuild, StartsWithTheSafeState) {
  using ir::Function;
  const ir::Program lathe = built("lathe, x is diameter", "  feed 0.1 mm/rev\n");
  EXPECT_EQ(lathe.name, "MAIN_CUT");
  EXPECT_EQ(functions_of(lathe, lathe.statements[0]),
            (std::vector<Function>{Function::unit_mm, Function::plane_zx, Function::absolute, Function::feed_per_rev,
                                   Function::surface_speed_off, Function::comp_off, Function::diameter_on}));
  const ir::Program radius = built("lathe, x is radius", "");
  EXPECT_EQ(functions_of(radius, radius.statements[0]).back(), Function::diameter_off);
  const ir::Program mill = built("mill", "  feed 100 mm/min\n");
  EXPECT_EQ(functions_of(mill, mill.statements[0]),
            (std::vector<Function>{Function::unit_mm, Function::plane_xy, Function::absolute, Function::feed_per_min,
                                   Function::comp_off}));
}

TEST(FamilyBuild, ParametersAreAssignedBeforeTheBody) {
  const ir::Program program = built("mill", "  rapid x len\n");
  ASSERT_EQ(program.statements.size(), 4U);
  ASSERT_EQ(program.statements[1].kind, ir::StatementKind::assign);
  EXPECT_EQ(program.statements[1].line, 3U);
  const ir::Assign& assign = program.assigns[program.statements[1].payload];
  EXPECT_DOUBLE_EQ(program.at(assign.value).value, 30.0);
  EXPECT_EQ(program.statements[2].line, 5U);
  EXPECT_EQ(program.statements[3].kind, ir::StatementKind::program_end);
  const ir::Word& word = program.words_of(program.blocks[program.statements[2].payload])[0];
  EXPECT_EQ(program.at(word.value).op, ir::Operator::variable);
}

TEST(FamilyBuild, StructuresMatchAndNodesAreNotShared) {
  const ir::Program program = built("mill",
                                    "  feed 100 mm/min\n  for r from min(len, 3 mm) to len^2/1 mm step 1 mm\n"
                                    "    if r > 5 mm and not r = 7 mm\n      cut x r^3/(len*len)\n    else\n"
                                    "      let d = 2*r\n      cut x max(d, len)\n    end\n  end\n");
  for (const ir::Structure& structure : program.structures) EXPECT_NE(structure.partner, ir::kNoIndex);
  std::multiset<std::uint32_t> used;
  for (const ir::Expression& e : program.expressions) {
    for (const ir::ExpressionId id : {e.a, e.b}) {
      if (id != ir::ExpressionId::none) used.insert(static_cast<std::uint32_t>(id));
    }
  }
  for (const std::uint32_t id : used) EXPECT_EQ(used.count(id), 1U);
  const auto is_minimum = [](const ir::Expression& e) {
    return e.op == ir::Operator::minimum || e.op == ir::Operator::maximum;
  };
  EXPECT_TRUE(std::ranges::none_of(program.expressions, is_minimum));
}

}  // namespace
}  // namespace dripfeed::family
