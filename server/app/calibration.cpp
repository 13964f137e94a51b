// Each part lies between two short dwells: on the control they make it finish what it reads ahead, here they end a
// motion each, with the counts of the work before it.
#include "server/app/calibration.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "dialects/compile/execute.h"
#include "dialects/text/number.h"

namespace dripfeed::app {

namespace {

constexpr int kPasses = 40;
constexpr int kStatements = 10;  // a pass
constexpr std::uint32_t kFirstHash = 500;
constexpr std::uint32_t kFirstR = 20;

// The statement of each part in both spellings. A control without named variables leaves that part out.
struct Part {
  std::string_view what;
  std::string_view hash;
  std::string_view sinumerik;
};
constexpr std::array<Part, 7> kParts = {{
    {"a constant", "#101=1.5", "R11=1.5"},
    {"a variable", "#101=#102", "R11=R12"},
    {"a variable and an operator", "#101=#102+1.5", "R11=R12+1.5"},
    {"four variables, three operators", "#101=#102+#103-#102*#103", "R11=R12+R13-R12*R13"},
    {"a function", "#101=SIN[#102]", "R11=SIN(R12)"},
    {"a named variable", "", "_V1=_V2"},
    {"two named variables, an operator", "", "_V1=_V2+_V3"},
}};

bool is_sinumerik(const ir::Control& control) { return control.dialect.starts_with("sinumerik"); }
std::string_view statement_of(const Part& part, bool sinumerik) { return sinumerik ? part.sinumerik : part.hash; }

std::vector<Part> parts_of(const ir::Control& control) {
  std::vector<Part> parts;
  for (const Part& part : kParts) {
    if (!statement_of(part, is_sinumerik(control)).empty()) parts.push_back(part);
  }
  return parts;
}

bool has_variable(const ir::Control& control, ir::Bank bank, std::uint32_t number) {
  return std::ranges::any_of(control.variables, [&](const ir::VariableRange& range) {
    return range.bank == bank && range.writable && range.first <= number && number <= range.last;
  });
}

std::string body_of(std::string_view statement) {
  std::string body;
  for (int i = 0; i < kStatements; ++i) body += fmt::format("{}\n", statement);
  return body;
}

std::string hash_program(const std::vector<Part>& parts, bool prints) {
  std::string text =
      "%\nO7110(DRIPFEED TIMING)\n(MOVES NOTHING; RESULTS IN MS FROM #500 ON)\n#102=1.5\n#103=2.5\nG04 P100\n";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text += fmt::format("#100=0\n#3001=0\nWHILE[#100 LT {}]DO1\n{}#100=#100+1\nEND1\n#{}=#3001\nG04 P100\n", kPasses,
                        body_of(parts[i].hash), kFirstHash + i);
  }
  if (prints) {
    text += "POPEN\n";
    for (std::size_t i = 0; i < parts.size(); ++i)
      text += fmt::format("DPRNT[V{}*#{}[63]]\n", kFirstHash + i, kFirstHash + i);
    text += "PCLOS\n";
  }
  return text + "M30\n%\n";
}

std::string sinumerik_program(const std::vector<Part>& parts) {
  std::string text =
      "; DRIPFEED TIMING: MOVES NOTHING, RESULTS IN S FROM R20 ON\nDEF REAL _V1,_V2,_V3\n_V2=1.5\n_V3=2.5\nR12=1.5\n"
      "R13=2.5\nG4 F0.1\n";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text += fmt::format(
        "R10=0\nSTOPRE\n$AC_TIMER[1]=0\nWHILE R10<{}\n{}R10=R10+1\nENDWHILE\nSTOPRE\nR{}=$AC_TIMER[1]\n"
        "G4 F0.1\n",
        kPasses, body_of(parts[i].sinumerik), kFirstR + i);
  }
  return text + "M30\n";
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

Result<std::string> calibration_program(const ir::Control& control, bool prints) {
  const std::vector<Part> parts = parts_of(control);
  const bool sinumerik = is_sinumerik(control);
  if (sinumerik && prints) return fail(ErrorCode::refused, "the control has no DPRNT: read its R parameters out");
  const std::uint32_t first = sinumerik ? kFirstR : kFirstHash;
  const ir::Bank bank = sinumerik ? ir::Bank::r : ir::Bank::hash;
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    if (!has_variable(control, bank, first + i))
      return fail(ErrorCode::refused,
                  fmt::format("the control has no {}{} to leave a time in", sinumerik ? "R" : "#", first + i));
  }
  return sinumerik ? sinumerik_program(parts) : hash_program(parts, prints);
}

Result<std::vector<CalibrationRow>> calibration_rows(const compile::Dialect& dialect, const ir::Control& control,
                                                     const std::map<std::uint32_t, double>& values) {
  const auto text = calibration_program(control);
  if (!text) return std::unexpected(text.error());
  const bool sinumerik = is_sinumerik(control);
  DwellCounts dwells;
  const ir::ReadResult read = dialect.read(text::Source("timing program", *text), control);
  compile::execute(read.program, control, nullptr, dwells, {});
  const std::vector<Part> parts = parts_of(control);
  if (dwells.counts.size() != parts.size() + 1)
    return fail(ErrorCode::internal, "the timing program does not run on this control's model");
  std::vector<CalibrationRow> rows;
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    const std::uint32_t number = (sinumerik ? kFirstR : kFirstHash) + i;
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
