// parse: tokens to statements. Macro statements (assignments, IF, WHILE, GOTO) become IR here; the words of NC blocks
// are handed to lower. Faults are of the syntax only.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/macro_b/reader/cursor.h"
#include "dialects/macro_b/reader/lower.h"
#include "dialects/macro_b/reader/parse_expression.h"
#include "dialects/macro_b/tables/grammar.h"

namespace dripfeed::macro_b {

class Parser {
 public:
  // `program` has its source and tokens; the last token is an eob, which may be empty.
  Parser(ir::Program& program, const ir::Control& control, const Grammar& grammar,
         std::vector<text::Diagnostic>& diagnostics);
  // Adds statements and labels, sets the name and matches the structures.
  void run();

 private:
  struct OpenLoop {
    std::uint8_t number;
    bool conditional;
  };
  void block();
  void finish_block(std::uint32_t first_statement, std::uint32_t first_token);
  void head();
  void program_number();
  void block_number();
  void zero_number(std::string_view written, text::Span span);
  void zero_program(text::Span span);
  void body();
  void name_main();
  void skip_leader();
  void skip_label();
  void skip_after_end();
  void trailer();
  void macro_statement(const Keyword& keyword);
  void one_macro_statement(std::string_view after);
  void assignment();
  void warn_of_second_statement();
  void warn_of_no_then();
  void message(const ir::Variable& target, ir::ExpressionId value);
  void if_statement();
  void go_to(ir::ExpressionId condition);
  void while_statement();
  void loop_begin(ir::ExpressionId condition, bool conditional);
  void loop_end();
  void text_statement(const Keyword& keyword);
  void output_statement(const Keyword& keyword);
  bool output_parts(std::string_view text, std::uint32_t begin);
  void set_names();
  void check_variable_name(std::string_view name);
  void open_section(std::uint32_t first_statement);
  void words();
  void word();
  void other_word();
  void rest_of_block();
  void comma_word();
  void word_without_value(text::Span address);
  void bare_expression(text::Span address, std::uint32_t value_index);
  void unexpected();
  void character_fault();
  [[nodiscard]] bool has_nested_comment() const;
  [[nodiscard]] bool only_brackets_follow() const;
  void warn_of_brackets();
  void comment_faults();
  std::uint8_t loop_number(std::string_view word);
  void structure(ir::StatementKind kind, ir::ExpressionId condition, std::uint8_t number);
  [[nodiscard]] BlockPlace place() const;

  ir::Program& program_;
  const Grammar& grammar_;
  KeywordIndex keywords_;
  Cursor cursor_;
  Faults faults_;
  ExpressionReader expressions_;
  BlockLowering lowering_;
  std::vector<RawWord> raw_;
  std::uint32_t line_ = 1;
  std::uint32_t begin_ = 0;  // offset of the block's first token that counts
  std::uint32_t next_token_ = 0;
  std::uint32_t label_ = ir::kNoIndex;
  text::Span label_span_;
  std::uint8_t skip_level_ = 0;
  std::uint8_t rest_level_ = 0;  // of "/" inside the block
  std::uint32_t rest_begin_ = 0;
  std::string section_name_;       // of the program that the block begins
  bool bracketed_target_ = false;  // [#NAME] = …
  std::vector<OpenLoop> open_loops_;
  bool keeps_structure_ = false;  // a fault in WHILE or END leaves the loop in place
  std::uint32_t tape_marks_ = 0;
  bool ended_ = false;  // after the closing tape mark
  bool reported_after_end_ = false;
  bool reported_label_ = false;
  bool reported_second_statement_ = false;
  bool reported_lower_case_ = false;
  bool leader_ = false;  // the text begins with a tape mark
  bool of_machine_;      // the control is that of a named machine
};

}  // namespace dripfeed::macro_b
