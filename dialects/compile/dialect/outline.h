// What a text consists of, for people who look for a place in it: its programs, labels, calls, tools and stops, as the
// dialect's reader finds them. Nothing is run.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/ir/stage.h"

namespace dripfeed::compile {

enum class OutlineSort : std::uint8_t { program, label, call, tool, stop };
// By OutlineSort.
inline constexpr std::array<std::string_view, 5> kOutlineSortNames = {"program", "label", "call", "tool", "stop"};
constexpr std::string_view name_of(OutlineSort sort) { return kOutlineSortNames[static_cast<std::size_t>(sort)]; }

struct OutlineRow {
  OutlineSort sort = OutlineSort::program;
  std::uint32_t line = 0;
  std::string text;  // a name, or the words of the block; UTF-8
};

struct Outline {
  static constexpr std::size_t kMost = 500;
  std::vector<OutlineRow> rows;  // in the order of the text, kMost at most
  bool is_cut = false;
};

Outline outline_of(const ir::ReadResult& read);

}  // namespace dripfeed::compile
