// Where a jump leads: block numbers and labels of a compiled program, looked for as the control does.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dialects/interpreter/bytecode/bytecode.h"

namespace dripfeed::interpreter {

inline constexpr std::uint32_t kNoTarget = 0xFFFFFFFFU;

// The first of `targets` (in order) that a jump from the instruction `from` finds; kNoTarget without one.
std::uint32_t find_target(const std::vector<std::uint32_t>* targets, std::uint32_t from, ir::JumpSearch search);
std::uint32_t find_number(const CompiledProgram& program, std::optional<std::uint32_t> number, std::uint32_t from,
                          ir::JumpSearch search);
// A label, or a block number with its N.
std::uint32_t find_text(const CompiledProgram& program, const std::string& text, std::uint32_t from,
                        ir::JumpSearch search);

}  // namespace dripfeed::interpreter
