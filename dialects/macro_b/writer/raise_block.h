// raise: codes and words of NC blocks. Modes that change what a word means (incremental, diameter, inch, the tool) are
// followed in the order of the text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dialects/facts/resolved.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/rewrite.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::macro_b {

class BlockRaiser {
 public:
  BlockRaiser(ir::Program& program, const ir::Control& from, const ir::Control& to, passes::Rewrite& out,
              std::vector<text::Diagnostic>& diagnostics);

  // The block statement that `out` is at, by its index: emits what says the same on the target, one block or several.
  void block(const ir::Statement& statement, std::uint32_t index);
  // Something of the statement that the target cannot say.
  void cannot(const ir::Statement& statement, passes::Refusal what);
  // … which changes neither a move nor a value: a warning.
  void leave_out(const ir::Statement& statement, passes::Refusal what);

 private:
  // A block in the making.
  struct Draft {
    std::vector<ir::Code> codes;
    std::vector<ir::Word> words;
    std::uint8_t rest_level = 0;  // as in ir::Block
    std::uint32_t rest_begin = 0;
    [[nodiscard]] bool empty() const { return codes.empty() && words.empty(); }
  };
  // What the words of the block are about.
  struct Traits {
    bool dwell = false;
    bool tool_change = false;
    bool comp = false;
    bool drills = false;
    bool repeats = false;        // G70 to G76
    bool counts_passes = false;  // G73 of these
    bool threads = false;
    bool changes_lead = false;  // G34 of a lathe
    std::int16_t pattern = -1;  // as ir/hole_pattern.h
    const ir::Word* tool = nullptr;
    const ir::Word* edge = nullptr;
    bool any_incremental = false;  // words that say so themselves, or by their letter
    bool any_absolute = false;
  };

  Traits traits_of(const std::vector<ir::Code>& codes, const std::vector<ir::Word>& words) const;
  void code(const ir::Code& code);
  void code_by_name(const ir::Code& code);
  void follow_direction(const ir::Code& code);
  [[nodiscard]] bool is_plain_number(const ir::Word& word, const Traits& traits) const;
  [[nodiscard]] bool begins_transformation() const;
  void word(const ir::Word& word, const Traits& traits);
  void axis_word(ir::Word word);
  void dwell_word(const ir::Word& word);
  void tool_words(const Traits& traits);
  void prepare(const Traits& traits);
  void lathe_tool(ir::ExpressionId tool, ir::ExpressionId edge);
  void length_offset(const Traits& traits, ir::ExpressionId edge);
  [[nodiscard]] Draft length_of(ir::ExpressionId tool) const;
  void change_first(const Traits& traits, Draft length);
  void compensation_number();
  [[nodiscard]] facts::Facts facts_here() const;
  [[nodiscard]] ir::ExpressionId edge_of(const Traits& traits) const;
  // The tool that D means, or that is in: nothing, and reported, where it is not known; none where no tool was named.
  std::optional<ir::ExpressionId> tool_of(const Traits& traits);
  std::optional<ir::ExpressionId> tool_in(const facts::Facts& facts);
  [[nodiscard]] bool lacks_edge();
  [[nodiscard]] bool plane_is_always_xy() const;
  [[nodiscard]] bool calls_next() const;
  [[nodiscard]] std::optional<bool> moves_without_edge(const ir::Statement& s) const;
  void warn(std::string what, std::string why);
  void speed_limit(const ir::Word& word);
  void pattern_word(ir::Word word, std::int16_t pattern);
  void distance_frame(const Traits& traits);
  [[nodiscard]] bool keeps_rest(const ir::Block& old) const;
  void emit_all();
  void emit(const Draft& draft);
  void split_m_codes();
  void write_speed(Draft& turn);
  static void move_words(ir::Address address, Draft& from, Draft& to);
  void whole_shift();

  ir::Code code_of(ir::Function function, std::int16_t argument = 0) const;
  ir::Word word_of(ir::Address address, ir::ExpressionId value) const;
  ir::ExpressionId scaled(ir::ExpressionId value, double factor);
  ir::ExpressionId with_point(ir::ExpressionId value, bool rotary);
  [[nodiscard]] bool is_constant(ir::ExpressionId id, double value) const;
  [[nodiscard]] bool is_incremental(const ir::Word& word) const;

  ir::Program& program_;
  const ir::Control& from_;
  const ir::Control& to_;
  passes::Rewrite& out_;
  std::vector<text::Diagnostic>& diagnostics_;
  bool same_;                  // the same codes on both sides
  bool edges_;                 // D is an edge of the tool
  bool calls_others_ = false;  // programs that are not the control's own
  bool foreign_ = false;  // the block is of another language of its control, whose T, D and H are those of the target
  std::optional<facts::Resolved> tools_;  // where D is an edge
  std::vector<bool> lacks_edge_;          // by statement, once it is asked for
  bool stands_on_xy_ = false;             // all tools do
  std::uint32_t index_ = 0;
  enum class MovesBy : std::uint8_t { other, holes, curve };
  MovesBy moves_by_ = MovesBy::other;
  bool shifts_ = false;  // the cycle goes aside at the bottom, by I, J or K
  bool plane_is_xy_;     // K is no letter of it
  bool incremental_ = false;
  bool inch_ = false;
  bool feed_in_mm_ = false;      // inch for lengths only
  bool counts_factors_ = false;  // the block has a factor without a point
  bool leaves_words_ = false;    // of a code that is not said here
  bool shifts_whole_ = false;    // the block's shift takes away those of axes that it does not name
  ir::DiameterMode diameter_;
  const ir::Statement* statement_ = nullptr;
  std::vector<Draft> before_;
  Draft draft_;
  std::vector<Draft> after_;
};

}  // namespace dripfeed::macro_b
