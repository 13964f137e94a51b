// Looking up jump targets.
#include "dialects/interpreter/bytecode/jump_target.h"

#include <algorithm>
#include <string_view>

#include "dialects/text/number.h"

namespace dripfeed::interpreter {

std::uint32_t find_target(const std::vector<std::uint32_t>* targets, std::uint32_t from, ir::JumpSearch search) {
  if (targets == nullptr || targets->empty()) return kNoTarget;
  const auto after = std::ranges::upper_bound(*targets, from);
  if (search == ir::JumpSearch::backward) return after == targets->begin() ? kNoTarget : *(after - 1);
  if (after != targets->end()) return *after;
  return search == ir::JumpSearch::both ? targets->front() : kNoTarget;
}

std::uint32_t find_number(const CompiledProgram& program, std::optional<std::uint32_t> number, std::uint32_t from,
                          ir::JumpSearch search) {
  const auto found = number.has_value() ? program.numbers.find(*number) : program.numbers.end();
  return find_target(found == program.numbers.end() ? nullptr : &found->second, from, search);
}

std::uint32_t find_text(const CompiledProgram& program, const std::string& text, std::uint32_t from,
                        ir::JumpSearch search) {
  if (const auto found = program.labels.find(text); found != program.labels.end())
    return find_target(&found->second, from, search);
  if (text.size() < 2 || text[0] != 'N') return kNoTarget;
  const auto number = text::parse_integer(std::string_view(text).substr(1));
  if (!number.has_value() || *number < 0 || *number > 99999999) return kNoTarget;
  return find_number(program, static_cast<std::uint32_t>(*number), from, search);
}

}  // namespace dripfeed::interpreter
