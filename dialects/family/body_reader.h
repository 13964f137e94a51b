// The body of a family, from after `program NAME` to its `end`: verbs become steps, blocks are matched.
#pragma once

#include <vector>

#include "dialects/family/cursor.h"
#include "dialects/family/expression_reader.h"
#include "dialects/family/model.h"
#include "dialects/family/scope.h"

namespace dripfeed::family {

class BodyReader {
 public:
  BodyReader(Cursor& cursor, Scope& scope, ExpressionReader& expressions, Family& family)
      : cursor_(cursor), scope_(scope), expressions_(expressions), family_(family) {}

  // Reads up to and with the `end` of the program, or reports that it is missing.
  void read();

 private:
  using Verb = void (BodyReader::*)();
  struct VerbRow {
    std::string_view word;
    Verb read;
  };
  static const VerbRow* find_verb(std::string_view word);

  void work_offset();
  void tool();
  void spindle();
  void coolant();
  void compensate();
  void feed();
  void rapid();
  void cut();
  void arc();
  void retract();
  void profile();
  void for_loop();
  void if_block();
  void else_block();
  void end();
  void let();
  void message();
  void dwell();
  void stop();
  void optional_stop();

  Step step(StepKind kind) const;
  void add(Step step);
  void move(Step step);
  void axis_words(Step& step);
  void word(Step& step, ir::Address address, Typed value);
  [[nodiscard]] bool at_axis() const;

  // A block that is open: what began it, and where that stands.
  struct Open {
    StepKind kind;
    text::Span span;
    std::uint32_t line;
    bool has_else = false;
  };

  Cursor& cursor_;
  Scope& scope_;
  ExpressionReader& expressions_;
  Family& family_;
  std::vector<Open> open_;
  std::size_t open_profiles_ = 0;  // of those
  text::Span verb_;                // first word of the line
  std::uint32_t line_ = 0;
  bool ended_ = false;
  bool has_feed_ = false;
};

}  // namespace dripfeed::family
