// What a program says, for those who look for programs: its names, comments, words and calls, as the dialect's reader
// finds them. Nothing is run.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/ir/program.h"
#include "dialects/ir/stage.h"

namespace dripfeed::compile {

// The name by which calls find a program, in one form: O0012 and O12 are O12, "/_N_WKS_DIR/_N_X_WPD/_N_GROOVE_SPF" and
// "groove.spf" are GROOVE.
std::string call_key(std::string_view name);

struct DigestCall {
  std::string name;  // as call_key() has it
  ir::CallKind kind = ir::CallKind::subprogram;
  std::uint32_t line = 0;
};

struct ProgramDigest {
  std::vector<std::string> names{};  // that the text gives its programs, as they are written
  std::string comments{};            // a line each, UTF-8
  std::string words{};               // a line a block, blanks between the words, no comments, UTF-8
  bool is_cut = false;               // long texts: only blocks that do more than move are in `words` as a whole
  std::vector<DigestCall> calls{};   // each program once, where it is called first
  std::uint64_t computed_calls = 0;  // that name their program by a value
  std::string not_read{};            // why the calls are not all of them; empty: they are
};

ProgramDigest digest_of(const ir::ReadResult& read);

// Any bytes as UTF-8: what is none is read as Latin-1.
std::string as_utf8(std::string_view bytes);

}  // namespace dripfeed::compile
