// Programs that a generator makes of the whole of what the optimizer looks at: loops in loops of every form, IF with
// and without ELSE, jumps forward and back, assignments of all kinds, moves. The interpreter is the oracle:
// optimize_text runs each program before and after, with several values for what it takes from outside, and leaves one
// as it was whose moves would be others. Here that is a fault.
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/render/optimized.h"
#include "dialects/text/number.h"

namespace dripfeed::compile {
namespace {

// Of a control with words (SINUMERIK) or with numbered variables (Fanuc).
class Generator {
 public:
  Generator(std::uint32_t seed, bool has_words) : random_(seed), has_words_(has_words) {}

  std::string program() {
    if (has_words_)
      out_ += "DEF REAL AL,BE,GA\nDEF INT NN,MM\n";
    else
      out_ += "O1\n";
    line("G0 X0 Y0 Z0");
    line(has_words_ ? "G1 F100" : "G1 F100.");
    for (std::uint32_t i = below(4); i > 0; --i) line(fmt::format("{}={}", variable(), number()));
    statements(3 + below(8), 0);
    line("M30");
    return std::move(out_);
  }

 private:
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }
  void line(const std::string& text) { out_ += text + '\n'; }
  std::string number() {
    constexpr std::array kNumbers = {"0", "1", "2", "-1.5", "0.25", "3", "7", "30"};
    std::string text = kNumbers[below(kNumbers.size())];
    if (text[0] == '-') text = has_words_ ? "(" + text + ")" : "[" + text + "]";
    return text;
  }
  std::string variable() {
    if (!has_words_) return "#" + std::to_string(below(2) == 0 ? 1 + below(8) : 101 + below(4));
    constexpr std::array kNames = {"AL", "BE", "GA", "R1", "R2", "R3", "R4", "R5", "R50", "R51"};
    return kNames[below(kNames.size())];
  }
  std::string bracket(const std::string& inner) { return has_words_ ? "(" + inner + ")" : "[" + inner + "]"; }

  std::string expression(std::uint32_t depth) {
    if (depth == 0 || below(4) == 0) return below(3) == 0 ? number() : variable();
    if (below(4) == 0) {
      constexpr std::array kFunctions = {"SIN", "COS", "ABS"};
      return kFunctions[below(kFunctions.size())] + bracket(expression(depth - 1));
    }
    constexpr std::array kOperators = {"+", "-", "*"};
    return bracket(expression(depth - 1) + kOperators[below(kOperators.size())] + expression(depth - 1));
  }
  std::string condition() {
    constexpr std::array kWords = {"<", ">=", "==", "<>"};
    constexpr std::array kLetters = {"LT", "GE", "EQ", "NE"};
    const std::uint32_t op = below(4);
    return variable() + (has_words_ ? kWords[op] : kLetters[op]) + (below(2) == 0 ? number() : variable());
  }

  void statements(std::uint32_t count, std::uint32_t depth) {
    for (; count > 0; --count) statement(depth);
  }
  void statement(std::uint32_t depth) {
    switch (below(depth < 3 ? 10 : 6)) {
      case 0:
      case 1:
      case 2: return line(fmt::format("{}={}", variable(), expression(3)));
      case 3: return several();
      case 4:
      case 5: return move();
      case 6: return loop(depth);
      case 7: return branch(depth);
      case 8: return jump_over(depth);
      default: return jump_back(depth);
    }
  }
  void several() {
    if (!has_words_) return line(fmt::format("{}={}", variable(), variable()));
    line(fmt::format("R1={} R2={} R50={}", expression(1), number(), expression(2)));
  }
  void move() {
    const auto word = [&](char axis) {
      return has_words_ ? fmt::format("{}={}", axis, expression(2)) : fmt::format("{}[{}]", axis, expression(2));
    };
    line(fmt::format("G1 {} {}", word('X'), word('Y')));
  }
  // A counter of its own, so that each loop ends.
  std::string counter() { return (has_words_ ? "R" : "#") + std::to_string((has_words_ ? 60 : 11) + counters_++ % 20); }

  void loop(std::uint32_t depth) {
    const std::string n = counter();
    const std::uint32_t rounds = below(4);
    const std::uint32_t form = has_words_ ? below(3) : 0;
    if (form == 0) {
      line(fmt::format("{}=0", n));
      line(has_words_ ? fmt::format("WHILE {}<{}", n, rounds) : fmt::format("WHILE[{}LT{}]DO{}", n, rounds, depth + 1));
    } else if (form == 1) {
      line(fmt::format("{}=0", n));
      line("REPEAT");
    } else {
      line(fmt::format("FOR {}=1 TO {}", below(2) == 0 ? "NN" : "MM", rounds));
    }
    statements(1 + below(4), depth + 1);
    if (form < 2) line(fmt::format("{}={}+1", n, n));
    if (form == 0) line(has_words_ ? "ENDWHILE" : fmt::format("END{}", depth + 1));
    if (form == 1) line(fmt::format("UNTIL {}>={}", n, rounds));
    if (form == 2) line("ENDFOR");
  }
  void branch(std::uint32_t depth) {
    if (!has_words_) return jump_over(depth);
    line("IF " + condition());
    statements(1 + below(3), depth + 1);
    if (below(2) == 0) {
      line("ELSE");
      statements(1 + below(3), depth + 1);
    }
    line("ENDIF");
  }
  std::string label() { return std::to_string(labels_ += 10); }
  void jump_over(std::uint32_t depth) {
    const std::string first = label(), second = label();
    line(has_words_ ? fmt::format("IF {} GOTOF N{}", condition(), first)
                    : fmt::format("IF[{}]GOTO{}", condition(), first));
    statements(1 + below(2), depth + 1);
    const bool has_else = below(2) == 0;
    if (has_else) line((has_words_ ? "GOTOF N" : "GOTO") + second);
    line(fmt::format("N{} {}={}", first, variable(), expression(1)));
    if (!has_else) return;
    statements(below(2), depth + 1);
    line(fmt::format("N{} G1 X1", second));
  }
  void jump_back(std::uint32_t depth) {
    const std::string n = counter(), top = label();
    line(fmt::format("{}=0", n));
    line(fmt::format("N{} {}={}+1", top, n, n));
    statements(1 + below(3), depth + 1);
    line(has_words_ ? fmt::format("IF {}<{} GOTOB N{}", n, 1 + below(3), top)
                    : fmt::format("IF[{}LT{}]GOTO{}", n, 1 + below(3), top));
  }

  std::mt19937 random_;
  bool has_words_;
  std::uint32_t counters_ = 0;
  std::uint32_t labels_ = 0;
  std::string out_;
};

struct Sums {
  int programs = 0;
  int changed = 0;
  double before_ms = 0.0;
  double after_ms = 0.0;
};

Sums run(const char* dialect_name, bool has_words, int programs) {
  const Dialect& dialect = *find_dialect(dialect_name);
  const ir::Control control = dialect.control(ir::MachineKind::mill, ir::GSystem::a);
  Sums sums;
  for (int seed = 0; seed < programs; ++seed) {
    const std::string text = Generator(static_cast<std::uint32_t>(seed), has_words).program();
    OptimizeRequest request{.source = text::Source("random", text), .control = control, .cost = control.cost};
    if (seed % 2 == 0) request.settings.own = {{ir::Bank::r, 0, 99}, {ir::Bank::hash, 100, 149}};
    if (seed % 3 == 0) request.settings.free = {{ir::Bank::r, 200, 240}, {ir::Bank::hash, 150, 190}};
    request.settings.rules.set(optimize::Rule::comments, true);
    request.settings.rules.set(optimize::Rule::numbers, seed % 5 == 0);
    const OptimizeResult result = optimize_text(request);
    EXPECT_FALSE(text::has_error(result.diagnostics)) << text;
    if (!result.obstacle.empty()) {
      ADD_FAILURE() << "seed " << seed << ": " << result.obstacle << "\n" << text;
      return sums;
    }
    ++sums.programs;
    if (!result.before || result.changes.empty()) continue;
    ++sums.changed;
    double saved_ms = 0.0;
    for (const RuleSaving& one : result.savings) saved_ms += one.saved.ms;
    EXPECT_NEAR(saved_ms, result.before->total_ms - result.after->total_ms, 1e-6) << "seed " << seed << "\n" << text;
    sums.before_ms += result.before->total_ms;
    sums.after_ms += result.after->total_ms;
  }
  fmt::print("{}: {} programs, {} changed, {} s of computing before and {} s after\n", dialect_name, sums.programs,
             sums.changed, text::format_fixed(sums.before_ms / 1000, 1), text::format_fixed(sums.after_ms / 1000, 1));
  return sums;
}

TEST(Optimize, RandomProgramsOfASinumerikMakeTheSameMoves) {
  const Sums sums = run("sinumerik-840d", true, 1000);
  EXPECT_GT(sums.changed, 700);
  EXPECT_LT(sums.after_ms, sums.before_ms);
}

TEST(Optimize, RandomProgramsOfAFanucMakeTheSameMoves) {
  const Sums sums = run("fanuc", false, 1000);
  EXPECT_GT(sums.changed, 700);
  EXPECT_LE(sums.after_ms, sums.before_ms);
}

}  // namespace
}  // namespace dripfeed::compile
