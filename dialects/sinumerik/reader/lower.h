// lower: what the parser recognised becomes statements of the program model, in the order in which the control acts:
// the assignments of a block, then its codes and words, then its jump or its end. Which words make a block and which
// fault they have is the parser's.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "dialects/ir/program.h"
#include "dialects/sinumerik/tables/codes.h"
#include "dialects/text/span.h"

namespace dripfeed::sinumerik {

// A block that Lowering::add_aside made: nothing of the text is its own.
bool is_aside(const ir::Program& program, const ir::Block& block);

class Lowering {
 public:
  explicit Lowering(ir::Program& program);

  // One line of the text: begin, then anything of what is below, then end.
  // Of the line that is being read.
  [[nodiscard]] std::uint32_t first_statement() const { return first_statement_; }
  [[nodiscard]] bool is_first_in_line() const {
    return program_.statements.size() == first_statement_ && !has_pending_block();
  }
  void begin_line(std::uint32_t line, std::uint32_t first_token);
  void set_skip_level(std::uint8_t level) { skip_level_ = level; }
  void add_label(std::string_view name, text::Span span);
  void add_block_number(std::uint32_t number, text::Span span);
  void end_line(std::uint32_t token_after, text::Span span);

  // Codes and words of the line's block.
  void add_code(const GCode& code, text::Span span);
  void add_code(const ir::Code& code);
  void add_m_code(std::uint32_t number, std::uint32_t extension, text::Span span);
  void add_computed_m_code(ir::ExpressionId number, text::Span span);
  void add_word(const ir::Word& word);
  // A move of an axis by itself, whatever the block's motion code: a block of its own after the line's. The word that
  // was written stays in the line's block, with extension 1: what it does is carried out elsewhere.
  void add_aside(const ir::Code& code, const std::optional<ir::Word>& word);
  // The last word of the line is carried out by a block that is added after it.
  void last_word_is(std::uint8_t extension);  // ir::kCarriedOut …

  // Statements. The span is the statement's own.
  void add_assign(ir::VariableId target, ir::ExpressionId value, text::Span span);
  void add_jump(const ir::Jump& jump, text::Span span);
  void add_return(const ir::Jump& jump, text::Span span);
  void add_structure(ir::StatementKind kind, const ir::Structure& structure, text::Span span);
  void add_call(ir::StatementKind kind, ir::Call call, text::Span span);
  void add_message(ir::StatementKind kind, const ir::Message& message, text::Span span);
  void add_repeat(const ir::Repeat& repeat, text::Span span);
  void add_plain(ir::StatementKind kind, text::Span span);  // declaration, subprogram_return
  [[nodiscard]] bool has_pending_block() const;
  // What was recognised of the line so far, structures and jumps excepted, becomes one Native; so does what follows.
  // `moves`: axes may be anywhere after it.
  void keep_as_native(std::string_view name, bool effects_known, text::Span span, bool moves = false);
  [[nodiscard]] bool is_native() const { return native_; }

  // Another program of the same text begins, with names of its own.
  void begin_program() { symbols_.clear(); }

  // Names, upper case whatever their case in the text.
  ir::StringId name(std::string_view text);
  ir::SymbolId find_symbol(std::string_view name) const;  // none: neither declared nor used before
  // Of a name that is used: declared before, or now taken for global user data, with an empty span.
  ir::SymbolId symbol_used(std::string_view name);
  ir::SymbolId declare(const ir::Symbol& symbol);
  [[nodiscard]] bool is_declared(ir::SymbolId id) const;

 private:
  void flush_block();
  void flush_block_of(text::Span span);
  void flush_asides();
  void push(ir::StatementKind kind, std::uint32_t payload, text::Span span);
  template <class T>
  void push(ir::StatementKind kind, std::vector<T>& arena, const T& item, text::Span span);
  [[nodiscard]] bool pending_words_are_constant() const;

  ir::Program& program_;
  std::unordered_map<ir::StringId, ir::SymbolId> symbols_;
  // of the line
  std::uint32_t line_ = 0;
  std::uint32_t first_token_ = 0;
  std::uint32_t first_statement_ = 0;
  std::uint32_t first_label_ = 0;
  std::uint8_t skip_level_ = 0;
  std::uint32_t first_code_ = 0;
  std::uint32_t first_word_ = 0;
  struct Aside {
    ir::Code code;
    std::optional<ir::Word> word;
  };
  std::vector<Aside> asides_;
  text::Span block_span_;
  bool block_flushed_early_ = false;
  bool native_ = false;
  ir::StatementKind ending_ = ir::StatementKind::empty;  // program_end or subprogram_return by M code
  text::Span ending_span_;
};

}  // namespace dripfeed::sinumerik
