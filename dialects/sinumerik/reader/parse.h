// parse: tokens to statements, block by block. parse.cpp reads lines, parse_words.cpp words, parse_polynomial.cpp
// those of POLY, parse_expression.cpp, parse_texts.cpp and parse_variable.cpp values, parse_flow.cpp jumps and
// structures, parse_declarations.cpp PROC, DEF and EXTERN, parse_calls.cpp calls, parse_macros.cpp DEFINE,
// parse_statements.cpp messages and what is kept as written. Names are resolved and statements ordered by Lowering;
// rules that need the whole program are validate's.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/sinumerik/reader/lower.h"
#include "dialects/sinumerik/reader/token_cursor.h"
#include "dialects/sinumerik/tables/keywords.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::sinumerik {

// Of the native statements that keep a foreign part.
inline constexpr std::string_view kInIsoMode = "ISO mode";

class Parser {
 public:
  // `program` has its source and its tokens.
  Parser(ir::Program& program, const ir::Control& control, std::vector<text::Diagnostic>& diagnostics);
  void run();

 private:
  // lines: parse.cpp
  void line();
  void block_head();
  bool label_here();
  [[nodiscard]] text::Span short_label() const;
  void statement();
  void variable_statement();
  void name_statement();
  [[nodiscard]] bool is_axis_word() const;
  void no_parameters(text::Span head, bool may_be_empty);
  void stray_symbol();
  void tape_head();
  void open_section(const std::string& name);
  void finish_line(text::Span start);
  void unreadable_tokens();
  [[nodiscard]] text::Span to_here(text::Span from) const { return {from.begin, cursor_.previous_end()}; }

  // words: parse_words.cpp
  void address_word();
  void extended_address();
  void axis_of_another_name(char letter, std::string_view name, text::Span head);
  void g_code(text::Span head);
  void m_function(std::uint32_t extension, text::Span head);
  void numbered_m_function(double number, std::uint32_t extension, text::Span span);
  void word(ir::Address address, std::uint8_t extension, ir::StringId name, text::Span head,
            ir::ExpressionId axis = ir::ExpressionId::none);
  void named_word(const Keyword& keyword);
  void named_axis_word(text::Span head);
  void positioning(const Keyword& keyword, ir::StringId name, ir::ExpressionId axis, text::Span head);
  [[nodiscard]] bool is_list_here() const;
  bool group_by_number(text::Span head);
  bool signed_constant(ir::ExpressionId& value);
  ir::ExpressionId word_value(ir::Word& word);
  ir::ExpressionId moded_value(ir::Word& word);
  void repeats_word(text::Span head);

  // parse_polynomial.cpp: PO[X]=(…) after PO, and (…) of either spelling.
  void polynomial_of_axis(text::Span head);
  void polynomial(ir::Address axis, text::Span head);

  // parse_spindles.cpp
  void orientation(ir::StringId name, text::Span head, ir::ExpressionId spindle);
  [[nodiscard]] std::optional<std::uint32_t> spindle_number(ir::ExpressionId id) const;
  void main_spindle(text::Span head);

  // parse_fixed_point.cpp: after G75; false, and nothing read, where it is not the approach of the reference point.
  bool reference_approach(text::Span head);

  // ISO mode: parse_iso.cpp. True when the line was kept as written.
  bool iso_line(text::Span start);
  void switch_line(text::Span start);
  [[nodiscard]] bool switches_mode(std::uint32_t code) const;
  [[nodiscard]] std::uint32_t named_switch() const;
  static TokenCursor after_comments(TokenCursor at);
  void begin_iso_mode(std::uint32_t statement, std::uint32_t text_begin);
  void end_iso_mode(std::uint32_t text_end, bool by_switch);
  [[nodiscard]] bool calls_from_iso_mode() const;
  [[nodiscard]] TokenCursor after_block_number() const;
  static bool is_code(const TokenCursor& at, char letter);

  // values: parse_expression.cpp
  ir::ExpressionId expression();
  ir::ExpressionId binary(std::uint8_t weakest);
  ir::ExpressionId unary();
  ir::ExpressionId primary();
  ir::ExpressionId parenthesized();
  ir::ExpressionId number();
  ir::ExpressionId string_literal();
  ir::ExpressionId name_value();
  ir::ExpressionId function_call(const Keyword& keyword, text::Span name);
  ir::ExpressionId foreign_call(text::Span name);
  ir::ExpressionId axis_name();
  [[nodiscard]] bool is_axis_at_end() const;
  ir::ExpressionId system_index();
  ir::ExpressionId missing_operand();
  ir::Operator infix_here(std::uint8_t& rank) const;
  void warn_of_rank(ir::ExpressionId operand, bool in_parentheses, text::Span span);

  // texts: parse_texts.cpp
  ir::ExpressionId text_of_value(text::Span head);
  [[nodiscard]] bool is_character(ir::ExpressionId id) const;
  ir::ExpressionId character_code(ir::ExpressionId id);
  [[nodiscard]] ir::ExpressionId* character_index(ir::Variable& v) const;
  std::optional<ir::ExpressionId> character_of(ir::VariableId id);

  // frames: parse_frame.cpp
  ir::ExpressionId frame_chain(ir::ExpressionId first);
  ir::ExpressionId frame_of_axes(const Keyword& keyword, text::Span name);
  ir::ExpressionId frame_in_plane(const Keyword& keyword, text::Span name);
  static bool is_frame_of_axes(ir::Operator op);
  void frame_elsewhere(ir::VariableId target, text::Span span);

  // variables: parse_variable.cpp
  ir::VariableId variable();
  ir::VariableId r_variable();
  void index_list(ir::Variable& variable, bool of_system);
  ir::ExpressionId constant(double value, text::Span span);

  // jumps and structures: parse_flow.cpp
  void flow(Verb verb, text::Span head);
  void if_statement(text::Span head);
  void jump(Verb verb, ir::ExpressionId condition, text::Span head);
  bool jump_target(ir::Jump& jump);
  void for_statement(text::Span head);
  void case_statement(text::Span head);
  bool case_branch(ir::ExpressionId selector, text::Span head);
  void repeat_statement(text::Span head, bool one_block);
  bool section_label(ir::StringId& label, std::uint32_t& number);
  void opener(ir::StatementKind kind, text::Span head, bool with_condition);
  ir::ExpressionId condition(text::Span head);
  static std::optional<Verb> go_to_verb(std::string_view name);

  // definitions: parse_declarations.cpp
  void procedure(text::Span head);
  bool parameter(ir::Symbol& symbol);
  void definition(text::Span head);
  bool defined_name(ir::ValueType type, std::uint16_t string_length, ir::Symbol& symbol);
  bool is_code_or_address();
  void dimensions(ir::Symbol& symbol);
  [[nodiscard]] std::uint16_t size_of(ir::ExpressionId id) const;
  void join_short_name();
  bool value_list(const ir::Variable& first, text::Span head);
  void repeated_value(const ir::Variable& first, text::Span head);
  [[nodiscard]] std::optional<std::uint32_t> elements_of(const ir::Variable& first) const;
  [[nodiscard]] std::optional<std::uint32_t> constant_count(ir::ExpressionId id) const;
  bool element(const ir::Variable& first, std::uint32_t offset, ir::ExpressionId value, text::Span head);
  bool is_beyond(const ir::Symbol& symbol, std::uint64_t flat, text::Span head);
  bool skip_value_attributes();

  // calls and returns: parse_calls.cpp
  void call_by_name(ir::StringId name, text::Span head, ir::StatementKind kind = ir::StatementKind::call);
  void call_statement(text::Span head);
  void modal_call(text::Span head);
  void path_call(text::Span head);
  void external_call(text::Span head);
  void iso_call(text::Span head);
  void computed_call(ir::ExpressionId name, ir::Call call, text::Span head);
  bool part_labels(ir::Call& call, text::Span head);
  void own_part_call(text::Span head);
  void numbered_call(text::Span head, ir::StatementKind kind = ir::StatementKind::call);
  void arguments(ir::Call& call);
  void return_statement(text::Span head);
  [[nodiscard]] bool returns_usually(std::uint8_t& levels, bool& has_target) const;

  // macros: parse_macros.cpp
  struct Macro {
    std::string name;  // upper case
    ir::TokenRange body;
  };
  void macro_definition(text::Span head);
  bool expand_macro();
  void assign_macro(const Macro& macro, text::Span name, const TokenCursor& after);
  bool expand_shared_macro(std::string_view name, text::Span span, const TokenCursor& after);
  std::optional<ir::ExpressionId> macro_value();
  ir::ExpressionId shared_macro_value(std::string_view body, text::Span span);
  ir::ExpressionId unknown_value(text::Span span);
  std::optional<ir::ExpressionId> macro_operator();
  [[nodiscard]] bool is_variable(std::string_view name) const;

  // the rest: parse_statements.cpp
  void assignment(ir::VariableId target, text::Span head);
  void statement_of(const Keyword& keyword, text::Span head);
  void execute_statement(text::Span head);
  void message(text::Span head);
  void alarm(text::Span head);
  void transformation(std::string_view name, text::Span head);
  void native(std::string_view name, bool effects_known, text::Span head);
  [[nodiscard]] bool acts_on_axes() const;
  [[nodiscard]] bool sets_smoothing_alone() const;
  [[nodiscard]] bool is_axis_address() const;
  [[nodiscard]] bool positions_are_absolute() const;
  [[nodiscard]] bool names_the_usual_axes() const;
  void missing_target();

  // faults
  void report(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments = {});
  // A fault after which the rest of the block cannot be read.
  void give_up(text::DiagnosticId id, text::Span span, std::vector<std::string> arguments = {});
  void expect(char symbol);
  void skip_block();
  [[nodiscard]] std::string here() const;  // the token as written, "the end of the block"

  // The manuals publish no depth of expressions; the control ends with 14050 when its stack is full. Beyond this the
  // reader stops, so that its own stack is not.
  static constexpr std::uint32_t kDeepestNesting = 200;
  // Of one block. A chain of operators is a tree as deep as it is long, and whoever walks it must not run out of stack.
  static constexpr std::uint32_t kMostOperators = 1000;
  static constexpr std::uint32_t kMostDimensions = 3;

  ir::Program& program_;
  const ir::Control& control_;
  std::vector<text::Diagnostic>& diagnostics_;
  Lowering lower_;
  TokenCursor cursor_;
  std::uint32_t line_ = 1;
  bool in_other_data_ = false;  // a part of an archive that is not in the control's language
  bool has_head_ = false;       // the text has named a program
  // of the block
  bool faulty_ = false;         // a fault was reported: what follows from it is not
  bool in_condition_ = false;   // a name before '=' is a comparison gone wrong, not the next word
  bool foreign_chain_ = false;  // an array of more than three indices was read
  std::uint32_t brackets_ = 0;  // open around the value being read
  std::uint32_t nesting_ = 0;
  std::uint32_t operators_ = 0;
  text::Span operator_;                                // the last operator or function read: what lacks its operand
  bool in_parentheses_ = false;                        // the last operand read was
  ir::ExpressionId repeats_ = ir::ExpressionId::none;  // P= before a call
  text::Span repeats_span_;
  bool has_call_ = false;
  bool has_invalid_ = false;   // anywhere in the text
  std::vector<Macro> macros_;  // DEFINE … AS
  bool in_macro_ = false;
  std::set<ir::StringId> externs_;  // names that EXTERN declares: programs, whatever else they may be
  std::uint64_t elements_ = 0;      // of lists of values, so far
  bool resumes_iso_ = false;        // the line calls as Siemens mode does, in ISO mode
  bool in_iso_ = false;             // after G291: the last of the foreign parts is open
};

}  // namespace dripfeed::sinumerik
