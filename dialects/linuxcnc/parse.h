// parse: lines to statements. O-words become the structures, jumps and calls of the IR; the words of other lines are
// macro_b's to lower, with this control's tables.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/linuxcnc/line.h"
#include "dialects/linuxcnc/parse_expression.h"
#include "dialects/macro_b/reader/lower.h"

namespace dripfeed::linuxcnc {

class Parser {
 public:
  Parser(ir::Program& program, const ir::Control& control, std::vector<text::Diagnostic>& diagnostics);
  // Adds tokens and statements of the whole text.
  void run();

 private:
  enum class Form : std::uint8_t { condition, while_loop, do_loop, repeat };
  struct Open {
    std::string name;
    Form form = Form::condition;
    std::uint32_t number = 0;      // of the structure, for its labels
    std::uint32_t conditions = 1;  // IF and its ELSEIF
    ir::Variable count;            // of repeat
  };
  // How an o-word is written.
  struct OWord {
    std::string name;  // as the program is called: "O0100", "drill"; empty where it is computed
    ir::ExpressionId computed = ir::ExpressionId::none;
  };
  struct Keyword {
    std::string_view spelling;
    void (Parser::*read)(const OWord&);
  };
  static const Keyword kKeywords[];

  void line();
  void block_number();
  [[nodiscard]] macro_b::BlockPlace place() const;
  void finish_line(std::uint32_t first_statement, std::uint32_t first_token);

  // words: parse_words.cpp
  void words();
  void assignment();
  void emit_assignments();
  void emit_words();
  void emit_around_dwell();
  bool emit_data_setting();
  void interpret_words(std::size_t first_code, std::uint32_t first_word);
  ir::ExpressionId scaled(ir::ExpressionId id, double factor, double added);
  void comments();
  void message(std::string_view text, bool has_values, bool stops);
  ir::ExpressionId text_constant(std::string_view text);
  ir::ExpressionId text_with_values(std::string_view text);
  ir::ExpressionId value_in_text(std::string_view written);
  [[nodiscard]] bool has_code(char letter, double number) const;
  [[nodiscard]] double number_of(ir::ExpressionId id) const;

  // o-words: o_words.cpp
  void o_word();
  bool read_name(OWord& word);
  void program_number(const OWord& word);
  void begin_sub(const OWord& word);
  void end_sub(const OWord& word);
  void return_word(const OWord& word);
  void call(const OWord& word);
  void begin_if(const OWord& word);
  void else_if(const OWord& word);
  void else_word(const OWord& word);
  void end_if(const OWord& word);
  void begin_while(const OWord& word);
  void end_while(const OWord& word);
  void begin_do(const OWord& word);
  void begin_repeat(const OWord& word);
  void end_repeat(const OWord& word);
  void break_loop(const OWord& word);
  void continue_loop(const OWord& word);
  void give_back();
  void structure(ir::StatementKind kind, ir::ExpressionId condition = ir::ExpressionId::none);
  void assign(const ir::Variable& target, ir::ExpressionId value) { lowering_.emit_assign(target, value, place()); }
  void label(const Open& open, std::string_view where);
  void jump(const Open& open, std::string_view where);
  // The innermost structure if it has that name and form; a fault otherwise.
  Open* innermost(const OWord& word, Form form, std::string_view closer);
  Open* loop_named(const OWord& word);
  ir::ExpressionId condition();
  void put_sections_in_order();
  void check_styles();

  ir::Program& program_;
  macro_b::Faults faults_;
  ExpressionReader expressions_;
  macro_b::BlockLowering lowering_;

  Line line_;
  std::uint32_t number_ = 0;  // of the line
  std::uint8_t skip_level_ = 0;
  std::vector<macro_b::RawWord> raw_;
  std::vector<ir::Assign> assigns_;
  std::vector<std::string> assigned_names_;
  bool asks_existence_ = false;  // EXISTS stands somewhere in the text
  bool centers_absolute_ = false;
  // In the order of the text, for words that mean something else in each.
  ir::Function motion_ = ir::Function::none;
  bool probes_ = false;  // G38 is in effect
  bool began_ = false;   // something stood before: a tape mark is the last one
  bool ended_ = false;   // after it

  std::vector<Open> open_;
  std::uint32_t structures_ = 0;
  std::vector<std::string> sections_ = {""};  // names; the first is the main program
  std::uint32_t section_ = 0;
  std::vector<std::string> numbered_;      // those that an O number begins
  bool by_number_ = false;                 // the section began with an O number, and M99 ends it
  std::vector<std::uint32_t> section_of_;  // by statement
};

}  // namespace dripfeed::linuxcnc
