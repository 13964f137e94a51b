// What the tests of SINUMERIK programs share: a text is read and run, and its trace, motions and variables are kept.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/compile/dialect/execute.h"
#include "dialects/interpreter/machine/trace.h"
#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {

struct Result {
  interpreter::RunResult result;
  std::string trace;
  std::vector<ir::Motion> motions;

  [[nodiscard]] bool names(std::string_view what) const {
    return std::ranges::any_of(result.not_interpreted,
                               [&](const interpreter::NotInterpreted& one) { return one.name == what; });
  }
  [[nodiscard]] double value(std::string_view name) const {
    for (const interpreter::VariableValue& variable : result.variables)
      if (variable.name == name) return variable.value.value_or(-999.0);
    return -999.0;
  }
  [[nodiscard]] std::string text(std::string_view name) const {
    for (const interpreter::VariableValue& variable : result.variables)
      if (variable.name == name) return variable.text.value_or("no text");
    return "no variable";
  }
};

using Texts = std::map<std::string, std::string, std::less<>>;

inline Result run_on(const ir::Control& control, const std::string& text, const Texts& called = {},
                     std::vector<interpreter::InitialValue> state = {}, std::uint64_t loop_passes = 100'000,
                     std::uint32_t skip_switches = 0) {
  const text::Source source("TEST.MPF", text);
  const ir::ReadResult read = find_dialect(control.dialect)->read(source, control);
  EXPECT_FALSE(text::has_error(read.diagnostics)) << messages_of(read.diagnostics, source) << text;
  ProgramLibrary library(control, [&](std::string_view name) -> std::optional<text::Source> {
    const auto found = called.find(name);
    if (found == called.end()) return std::nullopt;
    return text::Source(found->first, found->second);
  });
  interpreter::RunNames names;
  interpreter::RunOptions options;
  options.initial_values = std::move(state);
  options.want_variables = true;
  options.names = &names;
  options.limits.loop_passes = loop_passes;
  options.skip_switches = skip_switches;
  interpreter::TraceWriter writer(control, names);
  Motions motions;
  FanOut both({&writer, &motions});
  Result out;
  out.result = execute(read.program, control, &library, both, options);
  out.trace = writer.text();
  out.motions = motions.all;
  return out;
}

inline Result run(const std::string& text, const Texts& called = {}, ir::MachineKind kind = ir::MachineKind::mill,
                  std::vector<interpreter::InitialValue> state = {}, std::uint64_t loop_passes = 100'000) {
  ir::Control control = test::control("sinumerik-840d", kind);
  control.semantics.power_on_known = true;
  return run_on(control, text, called, std::move(state), loop_passes);
}

inline std::string moves(const Result& run) {
  std::string out;
  std::size_t begin = 0;
  while (begin < run.trace.size()) {
    const std::size_t end = run.trace.find('\n', begin);
    const std::string line = run.trace.substr(begin, end - begin);
    if (line.contains("rapid") || line.contains("linear") || line.contains("arc-") || line.contains("thread") ||
        line.contains("dwell") || line.contains("spline"))
      out += line + "\n";
    begin = end + 1;
  }
  return out;
}

inline std::string alarm_of(const Result& run) {
  return run.result.diagnostics.empty() ? "" : run.result.diagnostics.back().diagnostic.alarm;
}

}  // namespace dripfeed::compile::test
