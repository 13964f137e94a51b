// Tools and offsets by number (T6 M6, G43 H6, D6, T0606) as edges of the tool in the spindle (T6 M6, D1): a number that
// is not the tool's own has no counterpart here.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "dialects/facts/tool_in.h"
#include "dialects/sinumerik/writer/raise.h"

namespace dripfeed::sinumerik {

// Argument of Function::length_offset_plus: the length that was in effect before D0, of the tool that is in.
inline constexpr std::int16_t kLengthAgain = -1;

// Follows the blocks in the order of the text, and the tool in the spindle on all paths where T is a number alone.
class ToolOffsets {
 public:
  explicit ToolOffsets(const Raising& raising);

  // The block that comes next; the words that are written for it begin at `first_word` of the program's.
  void begin_block(std::uint32_t statement, std::uint32_t first_word, std::span<const ir::Code> codes,
                   std::span<const ir::Word> words);
  // Each writes the words that stand for what it is given, or reports why none do.
  void length_on(const ir::Code& code);   // G43
  void length_off(const ir::Code& code);  // G49
  void tool(const ir::Word& word);
  void compensation_number(const ir::Word& word);  // D
  void length_number(const ir::Word& word);        // H of a block without G43
  // G41 of a block without D takes the last one.
  void end_block(text::Span span);

  // Whether H without G43 is looked at: T is a number alone, and the tool in the spindle is known.
  [[nodiscard]] bool follows_spindle() const { return !tools_.empty(); }

 private:
  bool is_tool(double number, std::string_view otherwise, text::Span span);
  void warn_taken_as_tool(text::Span span);
  void warn_of_caller(std::uint32_t caller, text::Span span);
  void add(ir::Address address, double number, text::Span span);
  void add_edge(text::Span span);
  [[nodiscard]] bool has(ir::Function function) const;
  [[nodiscard]] bool starts_compensation() const;

  const Raising& raising_;
  ir::Program& program_;
  std::vector<facts::ToolIn> tools_;  // after each statement
  std::span<const ir::Code> codes_;
  std::span<const ir::Word> words_;
  std::uint32_t index_ = 0;
  std::uint32_t first_word_ = 0;
  // In the order of the text.
  enum class Length : std::uint8_t { unstated, on, off };
  Length length_ = Length::unstated;
  bool compensates_ = false;
  std::optional<double> number_;  // of D
  double last_tool_ = -1.0;       // of T0606
  bool names_offsets_only_;       // no T of the program names a tool: T6
  bool warned_of_tool_ = false;
};

}  // namespace dripfeed::sinumerik
