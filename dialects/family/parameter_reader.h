// A `param` line: kind, default, range and what forms show of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "dialects/family/cursor.h"
#include "dialects/family/expression_reader.h"
#include "dialects/family/model.h"
#include "dialects/family/naming.h"
#include "dialects/family/scope.h"

namespace dripfeed::family {

inline constexpr std::int32_t kMostNumbers = 1000;  // of a list
inline constexpr std::int32_t kLongestText = 60;    // characters, as many as a comment takes

// Defines the list's name, with that many numbers at most, and the name of their count.
void add_list(Family& family, Scope& scope, const NewName& name, List list, std::int32_t most);

// What a quantity may be: by its kind the dimensions that it may have.
struct QuantityKind {
  std::string_view name;
  Dimension first;
  Dimension second;
  bool whole = false;
};
// nullptr when no kind of quantity is so called.
const QuantityKind* find_quantity(std::string_view name);
inline constexpr std::string_view kQuantityNames = "length, angle, feed, speed, time, count or ratio";

// Lists of points are read in point_reader.cpp.
class ParameterReader {
 public:
  ParameterReader(Cursor& cursor, Scope& scope, ExpressionReader& expressions, Family& family)
      : cursor_(cursor), scope_(scope), expressions_(expressions), family_(family) {}

  // The rest of the line after `param`.
  void read();

 private:
  void number(Parameter& out, const QuantityKind& kind);
  void list(Parameter& out);
  void points(const NewName& name, std::uint32_t line);
  std::vector<Parameter> axes_of(const NewName& name);
  bool point(std::vector<Parameter>& axes);
  void ranges(std::vector<Parameter>& axes);
  void choice(Parameter& out);
  void yes_no(Parameter& out);
  void tool(Parameter& out);
  void name_text(Parameter& out);
  // step, text and group.
  void trailer(Parameter& out);
  void range(Parameter& out);
  // count FEWEST .. MOST of what is `called` numbers, points or characters; the default has `given`.
  void count_range(Parameter& out, std::size_t given, std::string_view called, std::int32_t largest);
  std::optional<double> standard(Parameter& out, const QuantityKind& kind);
  bool has_kind(const Literal& literal, const QuantityKind& kind);
  std::optional<double> bound(const Parameter& parameter);
  void check(const Parameter& parameter, double value, text::Span span);
  // A list under its name, so that expressions know it.
  void define_list(Parameter& out, const NewName& name, std::uint32_t line);

  Cursor& cursor_;
  Scope& scope_;
  ExpressionReader& expressions_;
  Family& family_;
};

}  // namespace dripfeed::family
