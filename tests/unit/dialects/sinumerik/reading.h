// What the tests of this folder share: reading a text, printing it again, and seeing what was reported of it.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/sinumerik/sinumerik.h"

namespace dripfeed::sinumerik {

inline ir::ReadResult read_text(std::string_view text, ir::MachineKind kind = ir::MachineKind::mill) {
  return read(text::Source("TEST.MPF", std::string(text)), control(kind));
}

// Read without a fault.
inline ir::Program good(std::string_view text, ir::MachineKind kind = ir::MachineKind::mill) {
  ir::ReadResult result = read_text(text, kind);
  for (const text::Diagnostic& d : result.diagnostics) ADD_FAILURE() << text << ": " << text::message_of(d);
  return std::move(result.program);
}

inline std::string printed(const ir::Program& program, ir::MachineKind kind = ir::MachineKind::mill) {
  const ir::Control c = control(kind);
  const ir::RaiseResult raised = raise(program, c, c);
  EXPECT_TRUE(raised.diagnostics.empty());
  return print(raised.program, c).text;
}

// What reading and validating report of a file of that name.
inline std::vector<text::Diagnostic> findings_of(std::string_view name, std::string_view text, const ir::Control& c) {
  ir::ReadResult read = sinumerik::read(text::Source(std::string(name), std::string(text)), c);
  std::vector<text::Diagnostic> found = std::move(read.diagnostics);
  for (text::Diagnostic& d : validate(read.program, c, ir::Delivery::memory)) found.push_back(std::move(d));
  soften_unreached(read.program, found);
  return found;
}

// Names of the diagnostics of reading, in order.
inline std::string faults_of(std::string_view text) {
  std::string out;
  for (const text::Diagnostic& d : read_text(text).diagnostics) {
    if (!out.empty()) out += ' ';
    out += text::row_of(d.id).name;
  }
  return out;
}

}  // namespace dripfeed::sinumerik
