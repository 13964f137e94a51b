// print: a raised program as text, one block a line. The frame around it (tape marks, program number) is the dialect's.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/ir/stage.h"
#include "dialects/macro_b/tables/grammar.h"
#include "dialects/macro_b/writer/print_expression.h"

namespace dripfeed::macro_b {

class ProgramPrinter {
 public:
  ProgramPrinter(const ir::Program& program, const ir::Control& control, const Grammar& grammar)
      : program_(program),
        control_(control),
        expressions_(program, grammar),
        start_letter_(grammar.start_letter),
        has_local_calls_(std::ranges::find(control.m_codes, ir::Function::local_call, &ir::CodeRow::function) !=
                         control.m_codes.end()) {}

  // A line of the frame.
  void frame_line(std::string_view line);
  // All statements.
  void statements();
  // The text so far, with the number of distinct user variables that it touches.
  ir::PrintResult take();

 private:
  void statement(std::uint32_t index);
  void line(const ir::Statement& statement, const std::string& text);
  std::string labels_at(std::uint32_t index);
  std::string block(const ir::Block& block) const;
  std::string code(const ir::Code& code) const;
  // `p_is_angle`: P keeps its point.
  std::string word(const ir::Word& word, bool p_is_angle) const;
  std::string assignment(const ir::Assign& assign) const;
  std::string jump(const ir::Jump& jump) const;
  std::string call(const ir::Call& call, std::string_view word) const;
  [[nodiscard]] std::string_view call_word(const ir::Call& call) const;
  std::string output(const ir::Output& output) const;
  std::string alarm(const ir::Message& message, std::uint32_t variable) const;
  std::string message(const ir::Message& message) const;
  std::string native(const ir::Statement& statement) const;
  [[nodiscard]] bool is_stop_of_message(std::uint32_t index) const;
  std::uint32_t count_variables() const;

  const ir::Program& program_;
  const ir::Control& control_;
  ExpressionPrinter expressions_;
  char start_letter_;
  bool has_local_calls_;
  static constexpr std::string_view kLocalCall = "M97";
  ir::PrintResult result_;
  std::size_t next_label_ = 0;
};

// X12.5: the word of an axis with a computed position.
void append_position(std::string& out, ir::Address axis, double value, const ir::Control& control);
// Upper case without brackets and tape marks: what may stand in a comment.
std::string comment_text(std::string_view text);
// "O0012" for a name of that form, otherwise "O0001(NAME)".
// O1234; <NAME> of a subprogram, which calls name so; O0001(NAME).
std::string program_head(const ir::Program& program);
// The row that does this on the control: G codes first. nullptr when it has none.
const ir::CodeRow* find_function(const ir::Control& control, ir::Function function, std::int16_t argument);

}  // namespace dripfeed::macro_b
