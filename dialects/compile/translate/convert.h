// From the text of one control to the text of another. Same dialect in macro mode: the bytes themselves.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/compile/dialect/library.h"
#include "dialects/compile/plain/explicit_program.h"
#include "dialects/interpreter/interpreter.h"
#include "dialects/ir/control.h"
#include "dialects/text/diagnostic.h"
#include "dialects/text/source.h"

namespace dripfeed::compile {

enum class ConvertMode : std::uint8_t { macro, explicit_blocks };
inline constexpr std::array<std::string_view, 2> kConvertModeNames = {"macro", "explicit"};
constexpr std::string_view name_of(ConvertMode mode) { return kConvertModeNames[static_cast<std::size_t>(mode)]; }

struct ConvertRequest {
  text::Source source;
  ir::Control from;
  ir::Control to;
  ConvertMode mode = ConvertMode::macro;
  ProgramLibrary* library = nullptr;  // of called programs (explicit) and definition files; nullptr: none are found
  interpreter::Limits limits = kWrittenLimits;  // of the run, for explicit
};

struct ConvertResult {
  std::string text;                           // empty with an error, except where it is the source's own bytes
  std::vector<std::uint32_t> origin_lines;    // per printed line the source's line; empty for the source's own bytes
  std::vector<text::Diagnostic> diagnostics;  // spans in `source`
  // Source and translation were run and made the same moves; otherwise why that is not known. Empty for the source's
  // own bytes, too.
  std::string not_verified;
};

// macro: read, raise, print; explicit: read, interpret, print plain blocks. A long program is translated without its
// stretches of plain moves where it may be (see convert_thin.h), with the same result.
ConvertResult convert(const ConvertRequest& request);
// Every line as a statement.
ConvertResult convert_whole(const ConvertRequest& request);

}  // namespace dripfeed::compile
