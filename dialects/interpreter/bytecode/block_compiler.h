// Blocks of codes and words to templates: what is constant is kept ready, what is computed gets its instructions before
// the template is applied, and what is not interpreted is put down for the report.
#pragma once

#include "dialects/interpreter/bytecode/expression_compiler.h"

namespace dripfeed::interpreter {

class BlockCompiler {
 public:
  BlockCompiler(CodeBuilder& builder, ExpressionCompiler& expressions);

  void compile(const ir::Block& block, text::Span span);

 private:
  void compile_codes(const ir::Block& block);
  void compile_word(const ir::Word& word);
  void put_word(const ir::Word& word, const Value& value, std::uint8_t flags);
  void put_value(const ir::Word& word);
  void put_other_speed(const ir::Word& word);
  [[nodiscard]] bool is_other_speed(const ir::Word& word) const;
  [[nodiscard]] PlainCode plain(const ir::Code& code) const;
  void put_named_axis(const ir::Word& word);
  void report(std::string_view name, ir::Function function, bool effects_known);
  [[nodiscard]] bool is_interpreted(const ir::Word& word) const;
  [[nodiscard]] std::string name_of(const ir::Word& word) const;
  [[nodiscard]] std::uint8_t flags_of(const ir::Word& word) const;
  // Without a point it counts least increments on this control.
  [[nodiscard]] bool counts_increments(const ir::Word& word) const;

  CodeBuilder& builder_;
  ExpressionCompiler& expressions_;
  bool drills_ = false;                // the block at hand has the code of a drilling cycle
  bool has_other_speed_ = false;       // … S of a spindle by its number
  bool names_main_ = false;            // the program states which spindle is the main one
  bool words_belong_to_code_ = false;  // a code takes the axis words for something that is not a move
};

}  // namespace dripfeed::interpreter
