// Each part lies between two short dwells: on the control they make it finish what it reads ahead, here they end a
// motion each, with the counts of the work before it.
#include "server/app/checks/calibration.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "dialects/compile/dialect/execute.h"
#include "dialects/text/number.h"

namespace dripfeed::app {

namespace {

constexpr int kPasses = 40;
constexpr int kStatements = 10;  // a pass
constexpr std::uint32_t kFirstHash = 500;
constexpr std::uint32_t kFirstR = 20;

// What stands in the loop of each part, in both spellings: one block, which is written kStatements times, or several
// as they are. A control without named variables leaves such a part out. Single statements separate the figures; the
// rounds and the last one, a piece of a program, show whether they add up.
struct Part {
  std::string_view what;
  std::string_view hash;
  std::string_view sinumerik;
};
constexpr std::array kParts = std::to_array<Part>({
    {"a block", "G40", "G40"},
    {"a constant", "#101=1.5", "R11=1.5"},
    {"a variable", "#101=#102", "R11=R12"},
    {"a variable and an operator", "#101=#102+1.5", "R11=R12+1.5"},
    {"four variables, three operators", "#101=#102+#103-#102*#103", "R11=R12+R13-R12*R13"},
    {"a function", "#101=SIN[#102]", "R11=SIN(R12)"},
    {"a variable by its number", "#101=#[#105]", "R11=R[R15]"},
    {"a named variable set", "", "_V1=1.5"},
    {"a named variable", "", "_V1=_V2"},
    {"two named variables, an operator", "", "_V1=_V2+_V3"},
    {"rounds of a loop", "#106=0\nWHILE[#106 LT 10]DO2\n#106=#106+1\nEND2\n",
     "R16=0\nWHILE R16<10\nR16=R16+1\nENDWHILE\n"},
    {"rounds by IF and GOTO", "#106=0\nN10#106=#106+1\nIF[#106 LT 10]GOTO10\n",
     "R16=0\nN10 R16=R16+1\nIF R16<10 GOTOB N10\n"},
    {"a piece of a program",
     "#101=SIN[#102]*#103\n#104=COS[#102]*#103-[#101*#101]\n#106=SQRT[#101*#101+#104*#104]\n#101=#[#105]/#106\n",
     "R11=SIN(R12)*R13\nR14=COS(R12)*R13-(R11*R11)\nR16=SQRT(R11*R11+R14*R14)\nR11=R[R15]/R16\n"},
});
// The last part where there are calls.
constexpr Part kCall = {"a call of a program", "M98 P7111", "DRIPPART"};

bool is_sinumerik(const ir::Control& control) { return control.dialect.starts_with("sinumerik"); }
std::string_view statement_of(const Part& part, bool sinumerik) { return sinumerik ? part.sinumerik : part.hash; }

std::vector<Part> parts_of(const ir::Control& control, bool calls) {
  std::vector<Part> parts;
  for (const Part& part : kParts) {
    if (!statement_of(part, is_sinumerik(control)).empty()) parts.push_back(part);
  }
  if (calls) parts.push_back(kCall);
  return parts;
}

bool has_variable(const ir::Control& control, ir::Bank bank, std::uint32_t number) {
  return std::ranges::any_of(control.variables, [&](const ir::VariableRange& range) {
    return range.bank == bank && range.writable && range.first <= number && number <= range.last;
  });
}

std::string body_of(std::string_view statement) {
  if (statement.ends_with('\n')) return std::string(statement);
  std::string body;
  for (int i = 0; i < kStatements; ++i) body += fmt::format("{}\n", statement);
  return body;
}

std::string hash_program(const std::vector<Part>& parts, const CalibrationOptions& options) {
  std::string text =
      fmt::format("%\nO7110({})\n(MOVES NOTHING, RESULTS IN MS FROM #500 ON)\n#102=1.5\n#103=2.5\n#105=103\nG04 P100\n",
                  kTimingProgramName);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text += fmt::format("#100=0\n#3001=0\nWHILE[#100 LT {}]DO1\n{}#100=#100+1\nEND1\n#{}=#3001\nG04 P100\n", kPasses,
                        body_of(parts[i].hash), kFirstHash + i);
  }
  if (options.prints) {
    text += "POPEN\n";
    for (std::size_t i = 0; i < parts.size(); ++i)
      text += fmt::format("DPRNT[V{}*#{}[63]]\n", kFirstHash + i, kFirstHash + i);
    text += "PCLOS\n";
  }
  return text + "M30\n" + (options.calls ? "O7111(DRIPFEED PART)\n#101=1.5\nM99\n%\n" : "%\n");
}

std::string sinumerik_program(const std::vector<Part>& parts, const CalibrationOptions& options) {
  std::string text = fmt::format(
      "{}; {}: MOVES NOTHING, RESULTS IN S FROM R20 ON\nDEF REAL _V1,_V2,_V3\n_V2=1.5\n_V3=2.5\nR12=1.5\nR13=2.5\n"
      "R15=13\nG4 F0.1\n",
      options.calls ? "%_N_DRIPTIME_MPF\n;$PATH=/_N_MPF_DIR\n" : "", kTimingProgramName);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text += fmt::format(
        "R10=0\nSTOPRE\n$AC_TIMER[1]=0\nWHILE R10<{}\n{}R10=R10+1\nENDWHILE\nSTOPRE\nR{}=$AC_TIMER[1]\n"
        "G4 F0.1\n",
        kPasses, body_of(parts[i].sinumerik), kFirstR + i);
  }
  return text + "M30\n" + (options.calls ? "%_N_DRIPPART_SPF\n;$PATH=/_N_SPF_DIR\nR11=1.5\nM17\n" : "");
}

// Counts of the work between two dwells.
class DwellCounts final : public ir::MotionSink {
 public:
  void consume(std::span<const ir::Motion> motions) override {
    for (const ir::Motion& motion : motions) {
      if (motion.kind == ir::MotionKind::dwell) counts.push_back(motion.compute);
    }
  }
  std::vector<ir::ComputeCounts> counts;
};

}  // namespace

Result<std::string> calibration_program(const ir::Control& control, const CalibrationOptions& options) {
  const std::vector<Part> parts = parts_of(control, options.calls);
  const bool sinumerik = is_sinumerik(control);
  if (sinumerik && options.prints)
    return fail(ErrorCode::refused, "the control has no DPRNT: read its R parameters out");
  const std::uint32_t first = sinumerik ? kFirstR : kFirstHash;
  const ir::Bank bank = sinumerik ? ir::Bank::r : ir::Bank::hash;
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    if (!has_variable(control, bank, first + i))
      return fail(ErrorCode::refused,
                  fmt::format("the control has no {}{} to leave a time in", sinumerik ? "R" : "#", first + i));
  }
  return sinumerik ? sinumerik_program(parts, options) : hash_program(parts, options);
}

Result<std::vector<CalibrationRow>> calibration_rows(const compile::Dialect& dialect, const ir::Control& control,
                                                     const std::map<std::uint32_t, double>& values) {
  const bool sinumerik = is_sinumerik(control);
  const std::uint32_t first = sinumerik ? kFirstR : kFirstHash;
  const bool calls = values.contains(first + static_cast<std::uint32_t>(parts_of(control, false).size()));
  const auto text = calibration_program(control, {.calls = calls});
  if (!text) return std::unexpected(text.error());
  DwellCounts dwells;
  const text::Source source("timing program", *text);
  const ir::ReadResult read = dialect.read(source, control);
  compile::execute(read.program, control, nullptr, dwells, {});
  const std::vector<Part> parts = parts_of(control, calls);
  if (dwells.counts.size() != parts.size() + 1)
    return fail(ErrorCode::internal, "the timing program does not run on this control's model");
  std::vector<CalibrationRow> rows;
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    const std::uint32_t number = first + i;
    const std::string name = fmt::format("{}{}", sinumerik ? "R" : "#", number);
    const auto value = values.find(number);
    if (value == values.end()) return fail(ErrorCode::invalid, fmt::format("the value of {} is missing", name));
    if (!(value->second > 0.0)) return fail(ErrorCode::invalid, fmt::format("{} is no time", name));
    rows.push_back(
        {std::string(parts[i].what), name, {dwells.counts[i + 1], value->second * (sinumerik ? 1000.0 : 1.0)}});
  }
  return rows;
}

}  // namespace dripfeed::app
