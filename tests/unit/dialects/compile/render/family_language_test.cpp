// The family language: every example of its documentation, and every construct against its closed form, in all
// dialects and both forms.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/compile/render/render.h"
#include "tests/unit/dialects/compile/render/family_run.h"

namespace dripfeed::compile::test {
namespace {

// X of each move.
std::vector<double> x_of(const std::vector<ir::Motion>& moves) {
  std::vector<double> out;
  for (const ir::Motion& one : moves) out.push_back(one.end[0]);
  return out;
}

void expect_x(const text::Source& family, const std::vector<double>& wanted, const Values& values = {}) {
  const std::vector<double> found = x_of(one_trace(family, values));
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(found[i], wanted[i], 1e-6) << "move " << i;
}

std::string first_fault(const text::Source& family, const Values& values = {}) {
  const RenderResult result = rendered(family, "fanuc", RenderMode::macro, values);
  EXPECT_TRUE(text::has_error(result.diagnostics));
  EXPECT_TRUE(result.text.empty());
  return result.diagnostics.empty() ? "" : messages_of({result.diagnostics.front()}, family);
}

TEST(FamilyLanguage, EveryExampleOfTheDocumentationIsOneTrace) {
  const std::string document = file_text("docs/families.md");
  constexpr std::string_view kFence = "```family\n";
  std::size_t examples = 0;
  for (std::size_t at = document.find(kFence); at != std::string::npos; at = document.find(kFence, at)) {
    at += kFence.size();
    const std::string text = document.substr(at, document.find("```", at) - at);
    SCOPED_TRACE(text.substr(0, text.find('\n')));
    ++examples;
    if (text.contains("\n  polar\n")) continue;  // family_polar_test.cpp
    EXPECT_GT(one_trace({"example.family", text}).size(), 5U);
  }
  EXPECT_EQ(examples, 18U);
}

TEST(FamilyLanguage, ExamplesAreTheirClosedForm) {
  // layers-by-depth: 4, then 0.7 of the layer before, never less than 0.5, at last 9.
  std::vector<double> depths;
  for (double depth = 4.0, layer = 4.0; depth < 8.999;) {
    depths.push_back(depth);
    layer = std::max(layer * 0.7, 0.5);
    depth += layer;
  }
  depths.push_back(9.0);
  const std::string document = file_text("docs/families.md");
  const std::size_t at = document.find("family layers-by-depth");
  ASSERT_NE(at, std::string::npos);
  const auto moves = one_trace({"layers.family", document.substr(at, document.find("```", at) - at)});
  std::vector<double> plunges;
  for (const ir::Motion& one : moves)
    if (one.kind == ir::MotionKind::linear && one.end[2] != one.start[2]) plunges.push_back(-one.end[2]);
  ASSERT_EQ(plunges.size(), depths.size());
  for (std::size_t i = 0; i < depths.size(); ++i) EXPECT_NEAR(plunges[i], depths[i], 1e-6);
}

TEST(FamilyLanguage, SetChangesALetOfTheProgram) {
  expect_x(with("", "  let size = 1 mm\n  for n from 1 to 4 step 1\n    set size = size*2\n    cut x size\n  end\n"),
           {2, 4, 8, 16});
}

TEST(FamilyLanguage, ALoopKeepsItsBoundsThoughTheirNamesAreSet) {
  expect_x(with("",
                "  let first = 1 mm\n  let last = 3 mm\n  for n from first to last step 1 mm\n    set first = 5 mm\n"
                "    set last = 9 mm\n    cut x n\n  end\n  cut x first\n"),
           {1, 2, 3, 5});
}

TEST(FamilyLanguage, ListsAreReadAndWrittenByComputedIndex) {
  expect_x(with("list row = 3 mm, 1 mm, 2 mm\n",
                "  for n from 0 to 2 step 1\n    cut x row[n]\n    set row[n] = 10*row[2 - n]\n  end\n"
                "  for one in row\n    cut x one\n  end\n  cut x count(row)*1 mm\n"),
           {3, 1, 2, 20, 10, 200, 3});
}

TEST(FamilyLanguage, AListParameterTakesItsNumbersAndTheirCount) {
  const text::Source family = with("param row list of length 1 mm, 2 mm in 0..100 count 1..5\n",
                                   "  for one in row\n    cut x one\n  end\n  cut x count(row)*1 mm\n");
  expect_x(family, {1, 2, 2});
  expect_x(family, {4, 25.4, 7, 3}, {{"row", "4 mm, 1 in, 7 mm"}});
  EXPECT_NE(first_fault(family, {{"row", "4 mm, 5 mm, 6 mm, 7 mm, 8 mm, 9 mm"}}).find("6 numbers"), std::string::npos);
  EXPECT_NE(first_fault(family, {{"row", "4 mm, 5"}}).find("needs a unit"), std::string::npos);
  EXPECT_NE(first_fault(family, {{"row", "4 mm, 101 mm"}}).find("outside"), std::string::npos);
}

TEST(FamilyLanguage, WhileWithAConditionThatTakesStatements) {
  expect_x(with("param most length 7 mm in 1..50\n",
                "  let n = 1 mm\n  while max(n, 2 mm) < min(most, 9 mm)\n    cut x n\n    set n = n + 3 mm\n  end\n  "
                "cut x n\n"),
           {1, 4, 7});
}

TEST(FamilyLanguage, FunctionsStandWithTheirArguments) {
  expect_x(with("function square(p length) = p*p\nfunction side(p length, q length) = sqrt(square(p) + square(q))\n",
                "  let t = 3 mm\n  cut x side(t, t + 1 mm)\n  cut x side(5 mm, 12 mm)\n"),
           {5, 13});
}

TEST(FamilyLanguage, NamesOfASubprogramAreItsOwn) {
  expect_x(with("sub twice(n length)\n  let size = n*2\n  cut x size\nend\nsub both(n length)\n  call twice(n)\n  call "
                "twice(n + 1 mm)\n  cut x n\nend\n",
                "  let size = 50 mm\n  let n = 7 mm\n  call both(3 mm)\n  cut x size\n  cut x n\n"),
           {6, 8, 3, 50, 7});
}

TEST(FamilyLanguage, ChoicesAreDecidedWhenRendered) {
  const text::Source family = with("param entry choice ramp of ramp, plunge\nparam deep yes_no no\n",
                                   "  if entry is ramp and not deep\n    cut x 1 mm\n  else\n    cut x 2 mm\n  end\n  "
                                   "if deep\n    cut x 3 mm\n  end\n");
  expect_x(family, {1});
  expect_x(family, {2}, {{"entry", "plunge"}});
  expect_x(family, {2, 3}, {{"deep", "yes"}});
  const RenderResult macro = rendered(family, "fanuc", RenderMode::macro, {});
  EXPECT_EQ(macro.text.find("IF"), std::string::npos) << macro.text;
  EXPECT_EQ(macro.variables, 0U);
  EXPECT_NE(first_fault(family, {{"entry", "drop"}}).find("none of ramp, plunge"), std::string::npos);
}

// What no step names is not in the program.
TEST(FamilyLanguage, OnlyWhatIsNeededIsAssigned) {
  const RenderResult macro =
      rendered(with("param p length 1 mm in 0..9\nparam q length 2 mm in 0..9\nlet sum = p + q\nlet twice = 2*p\n"
                    "const more = 4 mm\nlist both = p, q\n",
                    "  cut x twice + more\n"),
               "fanuc", RenderMode::macro, {});
  EXPECT_EQ(macro.variables, 2U) << macro.text;
}

// What waits for a move does not wait on one path only, and has the value of its time.
TEST(FamilyLanguage, CompensationAndFeedKeepTheirPlaces) {
  const std::string start = "  tool 1 diameter 10 mm\n  rapid x 0 mm y 0 mm z 0 mm\n";
  const text::Source branches =
      with("param n count 3 in 1..9\n",
           start +
               "  if n > 2\n    compensate left\n  else\n    compensate right\n  end\n  cut x 5 mm y 1 mm\n"
               "  cut x 30 mm\n  compensate off\n  if n > 5\n    cut y 30 mm\n  end\n  cut x 0 mm y 50 mm\n");
  std::vector<ir::CompSide> sides;
  for (const ir::Motion& one : one_trace(branches)) sides.push_back(one.comp);
  using enum ir::CompSide;
  EXPECT_EQ(sides, (std::vector<ir::CompSide>{off, left, left, off}));

  const text::Source feeds = with(
      "",
      "  let f_now = 100 mm/min\n  feed f_now\n  set f_now = 800 mm/min\n  cut x 10 mm\n  feed f_now\n  cut x 0 mm\n");
  std::vector<double> found;
  for (const ir::Motion& one : one_trace(feeds)) found.push_back(one.feed);
  EXPECT_EQ(found, (std::vector<double>{100.0, 800.0}));
}

// A last "compensate off" stands before the end of the program, in blocks too.
TEST(FamilyLanguage, NothingFollowsTheEndOfTheProgram) {
  const text::Source family =
      with("", "  tool 1 diameter 10 mm\n  rapid x 0 mm y 0 mm\n  compensate left\n  cut x 20 mm\n  compensate off\n");
  for (const RenderMode mode : {RenderMode::macro, RenderMode::explicit_blocks}) {
    const std::string text = rendered(family, "fanuc", mode, {}).text;
    EXPECT_LT(text.find("G40", text.find("G41")), text.find("M30")) << text;
  }
}

// Two loops of one name, one of which ends at a fraction.
TEST(FamilyLanguage, ANameThatIsNoWholeNumberElsewhereCountsNoLoop) {
  expect_x(with("param n count 3 in 1..9\n",
                "  if n > 1\n    let t = 0.5\n    for q from 0 to t step 1\n      cut x q*10 mm\n    end\n  end\n"
                "  for t from 0 to 2 step 1\n    cut x t*1 mm\n  end\n"),
           {0, 5, 0, 1, 2});
}

TEST(FamilyLanguage, AnIndexThatIsNoneOfItsListsIsRefused) {
  const std::string list = "param n count 3 in 1..9\nparam row list of length 1 mm, 2 mm, 3 mm in 0..9 count 1..12\n";
  for (const char* steps : {"  cut x row[3]\n", "  cut x row[-1]\n", "  set row[n] = 9 mm\n  cut x row[0]\n",
                            "  cut x row[n/2]\n", "  for m_now from 0 to n step 1\n    cut x row[m_now]\n  end\n"}) {
    const std::string found = first_fault(with(list, steps));
    EXPECT_NE(found.find("row["), std::string::npos) << steps << found;
    EXPECT_EQ(found.find(":1:1:"), std::string::npos) << steps << found;
  }
}

// A message and a title hold no more than the control shows.
TEST(FamilyLanguage, MessagesAreShortAndPlain) {
  const text::Source family =
      with("", "  message \"50 % DONE; \x13\x11 \xC3\xA9" + std::string(200, 'x') + "\"\n  cut x 1 mm\n");
  for (const std::string& dialect : dialect_names()) {
    const std::string text = rendered(family, dialect, RenderMode::macro, {}).text;
    EXPECT_TRUE(std::ranges::all_of(text, [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); })) << dialect;
    EXPECT_EQ(text.find(std::string(80, 'X')), std::string::npos) << dialect;
    EXPECT_EQ(text.find("% DONE"), std::string::npos) << dialect;
  }
}

// As they are when it is rendered; a value that only the message names is no variable.
TEST(FamilyLanguage, MessagesHaveTheValuesOfParameters) {
  const text::Source family = with(
      "param depth length 5 mm in 0..20\nparam alone length 0.5 in in 0..2\nparam n count 3 in 1..9\nlet third = "
      "depth/n\n",
      "  message \"layers \" n \" of \" third \", \" alone \"wide\"\n  cut x depth\n");
  for (const std::string& dialect : dialect_names()) {
    for (const RenderMode mode : {RenderMode::macro, RenderMode::explicit_blocks}) {
      const std::string text = rendered(family, dialect, mode, {{"depth", "10 mm"}}).text;
      const bool as_written = dialect.starts_with("sinumerik");
      EXPECT_TRUE(
          text.contains(as_written ? "layers 3 of 3.3333 mm, 12.7 mmwide" : "LAYERS 3 OF 3.3333 MM, 12.7 MMWIDE"))
          << dialect << "\n"
          << text;
      EXPECT_FALSE(mode == RenderMode::macro && text.contains("=12.7")) << dialect << "\n" << text;
    }
  }
  EXPECT_EQ(one_trace(family).size(), 1U);
}

// The spindle's block does not change the feed mode of a lathe, on no path.
TEST(FamilyLanguage, ASpindleKeepsTheFeedModeOfALathe) {
  const text::Source family(
      "test.family",
      "family test\nmachine lathe, x is diameter\nparam n count 2 in 1..9\nprogram test\n  feed 100 mm/min\n"
      "  for q from 1 to n step 1\n    spindle 500 rpm cw\n    cut x q*5 mm\n    feed 0.2 mm/rev\n"
      "    cut z q*5 mm\n  end\nend\n");
  for (const std::string& dialect : dialect_names()) {
    RenderRequest request;
    request.family = family;
    request.target = control(dialect, ir::MachineKind::lathe);
    request.mode = RenderMode::macro;
    const RenderResult result = render(request);
    ASSERT_FALSE(text::has_error(result.diagnostics)) << dialect << messages_of(result.diagnostics, family);
    for (const ir::Motion& one : moves_of(run_text(result.text, request.target).motions))
      EXPECT_GT(one.feed, 0.0) << dialect << "\n" << result.text;
  }
}

// The moves of a call inside `profile` make the nominal, those of another call of the same subprogram do not.
TEST(FamilyLanguage, ACallInAProfileIsOfTheProfile) {
  const text::Source family =
      with("sub line_to(p length)\n  cut x p\nend\n",
           "  call line_to(5 mm)\n  profile\n    call line_to(9 mm)\n  end\n  call line_to(1 mm)\n");
  for (const RenderMode mode : {RenderMode::macro, RenderMode::explicit_blocks}) {
    const RenderResult result = rendered(family, "fanuc", mode, {});
    std::vector<double> marked;
    for (const ir::Motion& one : run_text(result.text, control("fanuc", ir::MachineKind::mill)).motions) {
      const auto holds = [&](const family::LineRange& r) {
        return r.first <= one.place.line && one.place.line <= r.last;
      };
      if (ir::is_move(one.kind) && std::ranges::any_of(result.profile_lines, holds)) marked.push_back(one.end[0]);
    }
    EXPECT_EQ(marked, (std::vector<double>{9.0})) << result.text;
  }
}

// A formula that the control cannot read in one block makes no macro.
TEST(FamilyLanguage, ABlockIsNoLongerThanTheControlReads) {
  std::string sum = "n";
  for (int i = 0; i < 60; ++i) sum += " + " + std::to_string(i) + ".125 mm*sqrt(n/1 mm)";
  const text::Source family = with("param n length 3 mm in 1..9\n", "  cut x " + sum + "\n");
  const RenderResult macro = rendered(family, "mitsubishi-m80", RenderMode::macro, {});
  EXPECT_NE(messages_of(macro.diagnostics, family).find("block-too-long"), std::string::npos);
  const RenderResult automatic = rendered(family, "mitsubishi-m80", RenderMode::automatic, {});
  EXPECT_EQ(automatic.mode, RenderMode::explicit_blocks);
  EXPECT_NE(automatic.because.find("bytes"), std::string::npos) << automatic.because;
}

// The shape of a tool is a value like any other, and for the checks alone.
TEST(FamilyLanguage, AToolsShapeIsOfValuesAndInNoProgram) {
  const text::Source family(
      "test.family",
      "family test\nmachine lathe, x is diameter\nparam insert length 0.8 mm in 0.1..2\nprogram test\n"
      "  tool 1 nose insert/2 tip 3\n  feed 0.1 mm/rev\n  cut x 1 mm\nend\n");
  const FamilyGeometry made = family_geometry(family, {{"insert", "1 mm"}});
  ASSERT_EQ(made.geometry.tools.size(), 1U);
  EXPECT_DOUBLE_EQ(made.geometry.tools.front().nose_radius_mm, 0.5);
  EXPECT_EQ(rendered(family, "fanuc", RenderMode::macro, {}).variables, 0U);
}

struct Fault {
  const char* declarations;
  const char* steps;
  const char* sentence;
};

TEST(FamilyLanguage, FaultsNameWhatIsWrong) {
  const Fault faults[] = {
      {"", "  wihle 1 mm < 2 mm\n", "did you mean while?"},
      {"", "  set n = 1 mm\n", "not defined"},
      {"param n length 1 mm in 0..2\n", "  set n = 1 mm\n", "n cannot be set"},
      {"list row = 1 mm, 2 mm\n", "  cut x row\n", "name one of its numbers"},
      {"list row = 1 mm, 2 mm\n", "  cut x row[2]\n", "[0] to [1]"},
      {"list row = 1 mm, 2\n", "", "needs a unit"},
      {"list row = 1 mm, 2 mm\n", "  for one in other\n    cut x 1 mm\n  end\n", "the name of a list"},
      {"param n length 1 mm in 0..2\nconst twice = 2*n\n", "", "made of numbers"},
      {"function f(p length) = p\n", "  cut x f(1)\n", "needs a unit"},
      {"function f(p length) = p\n", "  cut x f(1 mm, 2 mm)\n", "expected ')'"},
      {"function f(p length) = p\nfunction f(q length) = q\n", "", "already taken"},
      {"function f(rate feed) = rate\n", "", "needs its unit"},
      {"sub slot(p length)\n  cut x p\nend\n", "  call slit(1 mm)\n", "did you mean slot?"},
      {"sub slot(p length)\n  cut x p\nend\n", "  call slot(1 deg)\n", "a length is needed"},
      {"sub slot(p length)\n  call slot(p)\nend\n", "", "stands above"},
      {"sub slot\n  cut x 1 mm\n", "", "no 'end'"},
      {"param entry choice no of yes, nay\n", "", "not among the choices"},
      {"param entry choice a_ of a_, b_\n", "  if entry is c_\n  end\n", "a_ or b_"},
      {"", "  compensate left\n  arc cw x 1 mm y 0 mm radius 5 mm\n", "straight move"},
      {"param n length 1 mm in 0..2 step 0.3\n", "", "between the steps"},
      {"param cutter tool 3 in 1..2\n", "", "outside"},
  };
  for (const Fault& one : faults) {
    const std::string found = first_fault(with(one.declarations, one.steps));
    EXPECT_NE(found.find(one.sentence), std::string::npos) << one.declarations << one.steps << "\n" << found;
  }
}

// Many calls in one another are an error, not a text without end.
TEST(FamilyLanguage, CallsThatMultiplyAreRefused) {
  std::string subs = "sub s0\n  cut x 1 mm\nend\n";
  for (int i = 1; i < 20; ++i) {
    const std::string before = "  call s" + std::to_string(i - 1) + "\n";
    subs += "sub s" + std::to_string(i) + "\n" + before + before + before + "end\n";
  }
  EXPECT_NE(first_fault(with(subs, "  call s19\n")).find("steps"), std::string::npos);
  std::string functions = "function f0(p length) = p + p\n";
  for (int i = 1; i < 20; ++i)
    functions += "function f" + std::to_string(i) + "(p length) = f" + std::to_string(i - 1) + "(p) + f" +
                 std::to_string(i - 1) + "(p)\n";
  EXPECT_NE(first_fault(with(functions, "  cut x f19(1 mm)\n")).find("too long"), std::string::npos);
}

}  // namespace
}  // namespace dripfeed::compile::test
