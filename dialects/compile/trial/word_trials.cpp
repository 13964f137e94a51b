// In a shape '@' is the word. A shape belongs to a sort of words, never to one word: which of them fits a word, the
// control's own reader and validator decide.
#include "dialects/compile/trial/word_trials.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>

#include "dialects/compile/render/render.h"
#include "dialects/compile/translate/convert.h"
#include "dialects/text/source.h"

namespace dripfeed::compile {

namespace {

constexpr std::string_view kMillFamily = R"(family trial "A trial"
machine mill
program trial
  work offset 1
  tool 1 diameter 10 mm
  spindle 500 rpm cw
  feed 100 mm/min
  rapid x 0 mm y 0 mm
  rapid z 50 mm
  cut x 10 mm y 0 mm
end
)";
constexpr std::string_view kLatheFamily = R"(family trial "A trial"
machine lathe, x is diameter
program trial
  work offset 1
  tool 1 nose 0.8 mm tip 3
  spindle 500 rpm cw
  feed 0.1 mm/rev
  rapid x 50 mm z 5 mm
  cut x 50 mm z 2 mm
end
)";

// The end of every program; what stands before it is the head.
constexpr std::string_view kEnd = "M30";

constexpr auto kNumberedCodes = std::to_array<std::string_view>({
    "@",
    "@ X20.",
    "@ X20. Y10.",
    "@ X20. Z-5.",
    "@ X20. Y10. R30.",
    "@ X40. Z-5. R30.",
    "@ Z40. H1",
    "@ X20. D1\nG40 X30.",
    "@ X20.\nX30.\nG40 X60.",
    "@ P500",
    "@ S100",
    "@ F0.2",
    "@ P1 X20. Y10.",
    "@ P2 X0. Y0. Z0.",
    "@ L2 P1 X0. Y0. Z0.",
    "@ X0. Y0. R30.",
    "@ X0. Y0. I2. J2.",
    "@ X20. Y10. Z-5. R2. F100.\nG80",
    "@ X20. Y10. Z-5. R2. Q1. F100.\nG80",
    "@ X20. Y10. Z-5. R2. P500 F100.\nG80",
    "@ X30. Z-5. F1.5",
    "@ X30. Z-5. R-1. F1.5",
    "@ C90. Z-5. R-3. F0.1\nG80",
});
constexpr auto kNumberedKeywords = std::to_array<std::string_view>({
    "@",
    "#1=1.\n@[#1EQ0]GOTO10\nN10 G01 X20.",
    "#1=1.\n@[#1LT3]DO1\n#1=#1+1.\nEND1",
    "#1=1.\nIF[#1EQ0]@ 10\nN10 G01 X20.",
    "#1=1.\nIF[#1EQ0]@ #1=2.",
    "#1=1.\nIF[#1EQ0]THEN\n#1=2.\n@\n#1=3.\nENDIF",
    "#1=1.\nIF[#1EQ0]THEN\n#1=2.\n@",
    "#1=1.\nWHILE[#1LT3]@ 1\n#1=#1+1.\nEND1",
    "#1=1.\nWHILE[#1LT3]DO1\n#1=#1+1.\n@ 1",
    "@ 10\nN10 G01 X20.",
    "#1=1.\nIF[#1 @ 0]GOTO10\nN10 G01 X20.",
    "#1=1.\nIF[[#1EQ1] @ [#1EQ2]]GOTO10\nN10 G01 X20.",
    "#1=7. @ 2.\nG01 X#1",
});
constexpr auto kNumberedFunctions = std::to_array<std::string_view>({
    "#1=@[0.5]\nG01 X#1",
    "#1=@[2.,3.]\nG01 X#1",
    "#1=@[2.]/[3.]\nG01 X#1",
    "#1=3. @ 2.\nG01 X#1",
    "#1=1.\nIF[#1 @ 0]GOTO10\nN10 G01 X20.",
    "#1=1.\nIF[[#1EQ1] @ [#1EQ2]]GOTO10\nN10 G01 X20.",
});
constexpr auto kNumberedVariables = std::to_array<std::string_view>({"#1=@\nG01 X#1", "@=1."});

constexpr auto kNamedCodes = std::to_array<std::string_view>({
    "@",
    "@ X20",
    "@ X20 Y10",
    "@ X20 Z-5",
    "@ X20 Y10 CR=30",
    "@ X40 Z-5 CR=30",
    "@ X20 Y10 I1=15 J1=8",
    "@ X20\nX30\nG40 X60",
    "@ F2",
    "@ S100",
    "@ X30 Z-5 K1.5",
    "@ X30 Z-5 K1.5 F0.1",
    "SPOS=0\n@ Z-5 K1.5\nM5",
});
constexpr auto kNamedKeywords = std::to_array<std::string_view>({
    "@",
    "@ X20",
    "@ X20 Y10",
    "@ X20 Y10 Z5",
    "@ Z30",
    "@=1",
    "@=100",
    "@ LABEL\nLABEL: G1 X20",
    "LABEL: R1=R1+1\nIF R1<3 @ LABEL",
    "R1=1\n@ R1==0\nR1=2\nENDIF",
    "R1=1\n@ R1<3\nR1=R1+1\nENDWHILE",
    "@ R1=1 TO 3\nR2=R1\nENDFOR",
    "R1=1\nIF R1==0\nR1=2\n@\nENDIF",
    "R1=1\nIF R1==0\nR1=2\n@",
    "R1=1\nWHILE R1<3\nR1=R1+1\n@",
    "FOR R1=1 TO 3\nR2=R1\n@",
    "FOR R1=1 @ 3\nR2=R1\nENDFOR",
    "R1=1\n@\nR1=R1+1\nUNTIL R1>3",
    "R1=1\nREPEAT\nR1=R1+1\n@ R1>3",
    "R1=1\nIF (R1==1) @ (R1==2) GOTOF LABEL\nLABEL: G1 X20",
    "R1=7 @ 2\nG1 X=R1",
    "@ AP=30 RP=20",
    "@(\"A\")",
    "@(10)",
});
constexpr auto kNamedFunctions = std::to_array<std::string_view>({
    "R1=@(0.5)\nG1 X=R1",
    "R1=@(2,3)\nG1 X=R1",
    "R1=@(1,2,3)\nG1 X=R1",
    "R1=7 @ 2\nG1 X=R1",
    "G1 X=@(20)",
    "DEF FRAME MYFRAME\nMYFRAME=@(X,1)\nG54",
});
constexpr auto kNamedCycles = std::to_array<std::string_view>({
    "@",
    "@(10,0,2,-5)",
    "@(10,0,2,-5,,0.5)",
    "@(10,0,2,-20,,-5,,0,0,0,1,1)",
    "@(10,0,2,-5,,0,100,200)",
    "@(10,0,2,-5,,0,3,1,0,1,0)",
    "@(10,0,2,-5,,0,4,3,1,,1.5)",
    "@(10,0,2,-5,,0.5,3,,1.5)",
    "@(10,0,2,-5,,0,3,,1.5,0,100,100)",
    "@(1)",
    "MCALL CYCLE81(10,0,2,-5)\n@(0,0,0,10,10,3)\nMCALL",
    "MCALL CYCLE81(10,0,2,-5)\n@(0,0,10,0,90,4)\nMCALL",
});
constexpr auto kNamedVariables = std::to_array<std::string_view>({
    "R1=@\nG1 X=R1",
    "R1=@[1]\nG1 X=R1",
    "R1=@[X]\nG1 X=R1",
    "R1=@[1,X]\nG1 X=R1",
    "@=1",
    "@[1]=1",
    "@[X]=1",
});

// By ir::WordSort: codes, keywords, functions, cycles, variables.
using Shapes = std::array<std::span<const std::string_view>, 5>;
const Shapes kNumbered = {kNumberedCodes, kNumberedKeywords, kNumberedFunctions, kNumberedCodes, kNumberedVariables};
const Shapes kNamed = {kNamedCodes, kNamedKeywords, kNamedFunctions, kNamedCycles, kNamedVariables};

std::string with_word(std::string_view shape, std::string_view word) {
  std::string out;
  for (const char c : shape) c == '@' ? out.append(word) : out.append(1, c);
  return out + '\n';
}

// A word that a message calls unknown was not understood, so that the program is no trial of it.
bool is_unknown(const text::Diagnostic& one) {
  return one.id == text::DiagnosticId::unknown_code || one.id == text::DiagnosticId::unknown_address ||
         one.id == text::DiagnosticId::unknown_name;
}
bool speaks_against(const std::vector<text::Diagnostic>& found) {
  return text::has_error(found) || std::ranges::any_of(found, is_unknown);
}

}  // namespace

WordTrials::WordTrials(const Dialect& from, ir::Control control) : from_(from), control_(std::move(control)) {
  const bool mills = control_.kind == ir::MachineKind::mill;
  const RenderResult made =
      render({.family = text::Source("trial.family", std::string(mills ? kMillFamily : kLatheFamily)),
              .values = {},
              .target = control_,
              .mode = RenderMode::macro,
              .program_name = {},
              .heading = {}});
  const std::size_t end = made.text.rfind(kEnd);
  if (end == std::string::npos) return;
  head_ = made.text.substr(0, end);
  tail_ = made.text.substr(end);
}

bool WordTrials::is_accepted(const std::string& text) const {
  const text::Source source("trial", text);
  const ir::ReadResult read = from_.read(source, control_);
  return !speaks_against(read.diagnostics) &&
         !speaks_against(from_.validate(read.program, control_, ir::Delivery::memory));
}

std::vector<std::string> WordTrials::programs(const DialectWord& word) const {
  std::vector<std::string> accepted;
  if (head_.empty()) return accepted;
  const Shapes& shapes = ir::has_numbered_variables(control_) ? kNumbered : kNamed;
  for (const std::string_view shape : shapes[static_cast<std::size_t>(word.sort)]) {
    std::string text = head_ + with_word(shape, word.spelling) + tail_;
    if (!is_accepted(text)) continue;
    accepted.push_back(std::move(text));
    if (accepted.size() == kPrograms) break;
  }
  return accepted;
}

TrialResult WordTrials::of(const DialectWord& word, const ir::Control& to) const {
  const std::vector<std::string> tried = programs(word);
  const auto is_translated = [&](const std::string& text) {
    return !text::has_error(convert({.source = text::Source("trial", text), .from = control_, .to = to}).diagnostics);
  };
  if (tried.empty()) return TrialResult::not_tried;
  return std::ranges::any_of(tried, is_translated) ? TrialResult::translated : TrialResult::refused;
}

}  // namespace dripfeed::compile
