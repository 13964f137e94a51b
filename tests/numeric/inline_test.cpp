// Random programs that call random subprograms, in every control's language, from the same text and from other files.
// The generator writes each program a second time without calls: what the optimizer makes has to move as that one does,
// next to the optimizer's own proof. It also knows which calls have to stay.
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/render/optimized.h"
#include "dialects/compile/translate/inline_moves.h"

namespace dripfeed::compile {
namespace {

constexpr std::size_t kBodies = 4;  // O0011 …, each may call those after it

// "DO@" and "END@" stand for a loop's number, which is its depth.
constexpr std::size_t kNone = SIZE_MAX;
struct Line {
  std::string text;
  std::size_t calls = kNone;  // the body
};
using Lines = std::vector<Line>;

class Programs {
 public:
  Programs(std::uint32_t seed, bool has_words) : random_(seed), has_words_(has_words) {
    for (std::size_t i = kBodies; i-- > 0;) {
      bodies_[i] = block(1 + below(5), i + 1);
      if (below(5) == 0) stays_[i] = true, add_jump(bodies_[i]);
    }
    main_.push_back({has_words_ ? "G0 X0 Y0 Z5" : "G0 X0. Y0. Z5."});
    main_.push_back({has_words_ ? "G1 F100" : "G1 F100."});
    for (std::size_t i = 1; i < 5; ++i) main_.push_back({fmt::format("{}={}", variable(i), i)});
    add(main_, block(3 + below(4), 0));
    add_loop(main_, 0);
  }

  [[nodiscard]] static std::string name(std::size_t body, bool has_words) {
    return has_words ? fmt::format("PART{}", body) : fmt::format("O{:04}", 11 + body);
  }
  [[nodiscard]] std::string main_text() const { return (has_words_ ? "" : "O0001\n") + written(main_) + "M30\n"; }
  [[nodiscard]] std::string body_text(std::size_t body) {
    const std::string head = has_words_ ? fmt::format("PROC {}\n", name(body, true)) : name(body, false) + "\n";
    return head + written(bodies_[body], true) + (has_words_ ? "RET\n" : "M99\n");
  }
  // Without calls.
  [[nodiscard]] std::string flat() const {
    std::string out = has_words_ ? "" : "O0001\n";
    flatten(main_, 0, out);
    return out + "M30\n";
  }
  // Whether a call of it has to stay, or one in it.
  [[nodiscard]] bool stays(std::size_t body) const { return stays_[body]; }
  [[nodiscard]] bool calls_one_that_stays() const {
    for (const Line& line : main_)
      if (line.calls != kNone && reaches_one(line.calls)) return true;
    return false;
  }

 private:
  std::size_t below(std::size_t n) { return random_() % n; }
  static void add(Lines& to, const Lines& lines) { to.insert(to.end(), lines.begin(), lines.end()); }
  [[nodiscard]] std::string variable(std::size_t n) const { return (has_words_ ? "R" : "#10") + std::to_string(n); }
  [[nodiscard]] std::string axis(char letter, const std::string& value) const {
    return has_words_ ? fmt::format("{}={}", letter, value) : fmt::format("{}[{}]", letter, value);
  }
  std::string value() {
    constexpr std::array kNumbers = {"1.5", "2.", "0.25", "7."};
    return fmt::format("{}{}{}", variable(1 + below(4)), below(2) == 0 ? "+" : "*0.5+", kNumbers[below(4)]);
  }

  Lines block(std::size_t count, std::size_t first_body) {
    Lines out;
    for (; count > 0; --count) {
      const std::size_t kind = below(6);
      if (kind < 2) out.push_back({fmt::format("{}={}", variable(1 + below(4)), value())});
      if (kind == 2 || kind == 3) out.push_back({fmt::format("G1 {} {}", axis('X', value()), axis('Y', value()))});
      if (kind == 4 && first_body < kBodies) out.push_back({"", first_body + below(kBodies - first_body)});
      if (kind == 5 && first_body > 0) add_loop(out, first_body);
    }
    out.push_back({fmt::format("G1 {}", axis('Z', value()))});
    return out;
  }

  // Two rounds, with a counter of its own.
  void add_loop(Lines& out, std::size_t first_body) {
    const std::string counter = has_words_ ? fmt::format("R{}", 20 + counters_) : fmt::format("#{}", 120 + counters_);
    ++counters_;
    out.push_back({counter + "=0"});
    out.push_back({has_words_ ? fmt::format("WHILE {}<2", counter) : fmt::format("WHILE[{}LT2]DO@", counter)});
    for (std::size_t i = 1 + below(2); i > 0; --i) {
      if (first_body < kBodies && below(2) == 0)
        out.push_back({"", first_body + below(kBodies - first_body)});
      else
        out.push_back({fmt::format("G1 {}", axis('X', value()))});
    }
    out.push_back({fmt::format("{}={}+1", counter, counter)});
    out.push_back({has_words_ ? "ENDWHILE" : "END@"});
  }

  void add_jump(Lines& out) {
    const std::size_t n = 900 + below(50);
    out.push_back({has_words_ ? fmt::format("IF {}<0 GOTOF N{}", variable(1), n)
                              : fmt::format("IF[{}LT0]GOTO{}", variable(1), n)});
    out.push_back({fmt::format("G1 {}", axis('Y', value()))});
    out.push_back({fmt::format("N{} {}={}+1", n, variable(2), variable(2))});
  }

  static std::string numbered(std::string text, int depth) {
    if (const std::size_t at = text.find('@'); at != std::string::npos) text.replace(at, 1, std::to_string(depth));
    return text;
  }
  [[nodiscard]] std::string call(std::size_t body) const {
    return has_words_ ? name(body, true) : fmt::format("M98 P{}", 11 + body);
  }

  // Numbers and comments here and there.
  [[nodiscard]] std::string written(const Lines& lines, bool is_body = false) const {
    std::string out;
    int depth = 0, count = 0;
    for (const Line& line : lines) {
      ++count;
      if (is_body && count % 3 == 0 && !line.text.starts_with("N") && !line.text.contains('@'))
        out += fmt::format("N{} ", 10 * count);
      if (line.calls != kNone) {
        out += call(line.calls);
      } else {
        if (line.text.contains("DO@")) ++depth;
        out += numbered(line.text, depth);
        if (line.text.starts_with("END@")) --depth;
      }
      out += count % 4 == 0 ? (has_words_ ? " ; line\n" : " (LINE)\n") : "\n";
    }
    return out;
  }

  void flatten(const Lines& lines, int depth, std::string& out) const {
    static int labels = 0;
    std::string label;
    for (const Line& line : lines) {
      if (line.calls != kNone) {
        flatten(bodies_[line.calls], depth, out);
        continue;
      }
      if (line.text.contains("DO@")) ++depth;
      std::string text = numbered(line.text, depth);
      // Jumps get labels that occur once.
      if (const std::size_t at = text.find(has_words_ ? "GOTOF N" : "GOTO"); at != std::string::npos) {
        label = std::to_string(1000 + ++labels % 8000);
        text = text.substr(0, at) + (has_words_ ? "GOTOF N" : "GOTO") + label;
      } else if (text.starts_with("N")) {
        text = "N" + label + text.substr(text.find(' '));
      }
      out += text + "\n";
      if (line.text.starts_with("END@")) --depth;
    }
  }

  [[nodiscard]] bool reaches_one(std::size_t body) const {
    if (stays_[body]) return true;
    for (const Line& line : bodies_[body])
      if (line.calls != kNone && reaches_one(line.calls)) return true;
    return false;
  }

  std::mt19937 random_;
  bool has_words_;
  int counters_ = 0;
  Lines main_;
  std::array<Lines, kBodies> bodies_;
  std::array<bool, kBodies> stays_ = {};
};

std::vector<ir::Motion> moves_of(const std::string& text, const Dialect& dialect, const ir::Control& control,
                                 ProgramLibrary& library) {
  const ir::ReadResult read = dialect.read(text::Source("moves", text), control);
  interpreter::RunOptions options;
  options.limits = run_limits({});
  RecordedRun run = record(read.program, control, library, options, {}, {});
  EXPECT_EQ(run.result.ended, interpreter::Ended::end) << text;
  return std::move(run.motions);
}

void run_programs(std::string_view dialect_name, int programs) {
  const Dialect& dialect = *find_dialect(dialect_name);
  const ir::Control control = dialect.control(ir::MachineKind::mill, ir::GSystem::a);
  const bool has_words = dialect_name.starts_with("sinumerik");
  int inlined = 0, kept = 0, whole = 0;
  for (int seed = 0; seed < programs; ++seed) {
    Programs made(static_cast<std::uint32_t>(seed), has_words);
    std::map<std::string, std::string, std::less<>> files;
    std::string text = made.main_text();
    for (std::size_t i = 0; i < kBodies; ++i) {
      if (seed % 2 == 0)
        files[Programs::name(i, has_words)] = made.body_text(i);
      else
        text += (has_words ? fmt::format("%_N_{}_SPF\n", Programs::name(i, true)) : "") + made.body_text(i);
    }
    if (has_words && seed % 2 == 1) text = "%_N_MAIN_MPF\n" + text;
    ProgramLibrary library(control, [&](std::string_view name) -> std::optional<text::Source> {
      const auto file = files.find(name);
      return file == files.end() ? std::nullopt : std::optional(text::Source(file->first, file->second));
    });
    OptimizeRequest request{.source = text::Source("random", text), .control = control, .cost = {}};
    request.cost = find_dialect("sinumerik-840d")->control(ir::MachineKind::mill, ir::GSystem::a).cost;
    request.library = &library;
    if (seed % 3 != 0) request.settings.rules = optimize::Rules::none();
    request.settings.rules.set(optimize::Rule::inlined, true);
    const OptimizeResult result = optimize_text(request);
    ASSERT_FALSE(text::has_error(result.diagnostics)) << text;
    ASSERT_EQ(result.obstacle, "") << "seed " << seed << "\n" << text;
    ASSERT_EQ(result.not_verified, "") << "seed " << seed << "\n" << text;
    for (const KeptCall& one : result.not_inlined) {
      const bool by_size = one.why.contains("too deep") || one.why.contains("for which it pays");
      ASSERT_TRUE(one.why == "it jumps" || by_size) << one.why << " seed " << seed << "\n" << text;
    }
    ASSERT_TRUE(!made.calls_one_that_stays() || !result.not_inlined.empty()) << "seed " << seed << "\n" << text;
    if (result.not_inlined.empty()) {
      ++whole;
      const std::string main = result.text.substr(0, result.text.find("M30\n"));
      ASSERT_EQ(main.find(has_words ? "\nPART" : "\nM98"), std::string::npos) << result.text;
    }
    for (const optimize::Change& change : result.changes) inlined += change.rule == optimize::Rule::inlined ? 1 : 0;
    kept += static_cast<int>(result.not_inlined.size());

    const std::vector<ir::Motion> is = moves_of(result.text, dialect, control, library);
    const std::vector<ir::Motion> wanted = moves_of(made.flat(), dialect, control, library);
    ASSERT_EQ(is.size(), wanted.size()) << "seed " << seed << "\n" << text << "\n" << result.text;
    for (std::size_t i = 0; i < is.size(); ++i) {
      ASSERT_EQ(is[i].kind, wanted[i].kind);
      ASSERT_EQ(is[i].end[0], wanted[i].end[0]) << "seed " << seed << "\n" << text << "\n" << result.text;
      ASSERT_EQ(is[i].end[1], wanted[i].end[1]) << "seed " << seed << "\n" << text << "\n" << result.text;
      ASSERT_EQ(is[i].end[2], wanted[i].end[2]) << "seed " << seed << "\n" << text << "\n" << result.text;
    }
  }
  fmt::print("{}: {} programs, {} calls became blocks, {} stayed; {} programs have none left\n", dialect_name, programs,
             inlined, kept, whole);
  EXPECT_GT(inlined, programs / 2);
  EXPECT_GT(kept, programs / 10);
  EXPECT_GT(whole, programs / 4);
}

TEST(Inline, RandomCallsOfAFanuc) { run_programs("fanuc", 400); }
TEST(Inline, RandomCallsOfAMazak) { run_programs("mazak", 200); }
TEST(Inline, RandomCallsOfAMitsubishi) { run_programs("mitsubishi-m80", 200); }
TEST(Inline, RandomCallsOfAHaas) { run_programs("haas", 200); }
TEST(Inline, RandomCallsOfASinumerik) { run_programs("sinumerik-840d", 400); }

}  // namespace
}  // namespace dripfeed::compile
