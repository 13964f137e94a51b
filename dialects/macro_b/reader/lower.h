// lower: the words of one NC block to codes, words, calls and statements by the control's code tables. What a code
// means is in the table; which words belong to a call and which blocks stay text is decided here.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/macro_b/reader/call_words.h"
#include "dialects/macro_b/reader/cursor.h"
#include "dialects/macro_b/tables/grammar.h"

namespace dripfeed::macro_b {

// Names of Native statements that others ask for.
inline constexpr std::string_view kNotUnderstood = "a block that was not understood";
inline constexpr std::string_view kRestNotModelled = "block skip inside a block that calls or ends";
inline constexpr std::string_view kFolderLine = "&";  // &F=/USER/ of a memory dump: where the next programs belong

// Arguments of Function::work_offset above this are G54.1 P1, P2 ….
inline constexpr std::int16_t kExtendedOffset = 100;

// A word as parsed. `letter` is the address; ',' before it (,R ,C) sets `comma`; '<' is a program name.
struct RawWord {
  char letter = 0;
  bool comma = false;
  ir::ExpressionId value = ir::ExpressionId::none;
  text::Span span;
};

// Statements of one block get its line and skip level; tokens are set by the parser.
struct BlockPlace {
  std::uint32_t line = 0;
  std::uint8_t skip_level = 0;
  text::Span span;
  std::uint8_t rest_level = 0;  // as in ir::Block
  std::uint32_t rest_begin = 0;
};

class BlockLowering {
 public:
  BlockLowering(ir::Program& program, const ir::Control& control, const Grammar& grammar, Faults& faults);

  // Adds the statements that the words say.
  void lower(std::span<const RawWord> words, const BlockPlace& place);
  // Between G10 L50 or L52 and G11 the blocks hold parameters, not moves.
  [[nodiscard]] bool in_data_input() const { return in_data_input_; }

  ir::Statement& emit(ir::StatementKind kind, std::uint32_t payload, const BlockPlace& place);
  // `moves`: the axes may be anywhere after it.
  void emit_native(std::string_view name, bool effects_known, const BlockPlace& place, bool moves = false);
  // A block of one code without words.
  void emit_code(ir::Function function, ir::ModalGroup group, const BlockPlace& place);
  void emit_assign(const ir::Variable& target, ir::ExpressionId value, const BlockPlace& place);

 private:
  [[nodiscard]] const ir::CodeRow* row_of(char letter, std::int32_t number10) const;
  void add_code(const RawWord& word, std::int32_t number10);
  void add_word(const RawWord& raw);
  ir::ExpressionId with_short_offset(const ir::Word& word);
  void lower_call_block(CallWord kind, std::size_t at, std::span<const RawWord> words, const BlockPlace& place);
  // Whether the block begins a list of parameters; it is then lowered.
  bool begins_data(CallWord kind, std::span<const RawWord> words, const BlockPlace& place);
  [[nodiscard]] bool is_macro_call(const RawWord& word) const;
  void emit_call(CallWord kind, const RawWord& code, std::span<const RawWord> words, const BlockPlace& place);
  void emit_code_call(const RawWord& code, std::span<const RawWord> words, const BlockPlace& place);
  // G66.1 and the blocks under it: lower_each_block.cpp
  void begin_each_block(const RawWord& code, std::span<const RawWord> words, const BlockPlace& place);
  [[nodiscard]] bool is_under_each_block(std::span<const RawWord> words) const;
  void emit_each_block(std::span<const RawWord> words, const BlockPlace& place);
  void emit_return_jump(ir::ExpressionId target, const BlockPlace& place);
  void set_called_program(ir::Call& call, const RawWord& word);
  void emit_block(std::uint32_t first_code, std::uint32_t first_word, const BlockPlace& place);
  void emit_ending_block(std::uint32_t first_code, std::uint32_t first_word, const BlockPlace& place);
  [[nodiscard]] bool changes_tool(std::uint32_t first_code) const;
  void emit_tool_change(std::uint32_t first_code, std::uint32_t first_word, const BlockPlace& place);
  void name_contour_control(std::uint32_t first_code, std::uint32_t first_word);
  void take_other_forms(std::uint32_t first_code, std::uint32_t first_word);
  void number_extended_offset(std::uint32_t first_code, std::uint32_t first_word);
  void name_direct_angle(std::uint32_t first_code, std::uint32_t first_word);
  ir::ExpressionId in_increments(ir::ExpressionId value, double increment);
  [[nodiscard]] std::int32_t number10_of(ir::ExpressionId value) const;
  [[nodiscard]] std::int32_t whole_m_number10(const RawWord& word, std::int32_t number10) const;

  ir::Program& program_;
  const ir::Control& control_;
  const Grammar& grammar_;
  Faults& faults_;
  std::array<std::vector<std::int16_t>, 2> rows_;  // G, M: ten times the number -> row, -1
  bool in_data_input_ = false;
  struct EachBlock {
    RawWord program;  // P or a name
    ir::ExpressionId repeats = ir::ExpressionId::none;
  };
  std::optional<EachBlock> each_block_;  // G66.1 in effect, in the order of the text
};

// "O0012": as programs are called.
std::string program_name(double number);

}  // namespace dripfeed::macro_b
