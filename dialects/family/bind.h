// A family with a value for each parameter. Values come as people write them ("120 mm", "4.7244 in"), because a number
// without its unit is how a part is scrapped.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dialects/family/model.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::family {

struct Override {
  std::string name;
  // "120 mm"; a plain number for count and ratio; "10 mm, 12 mm" for a list; "(0 mm, 5 mm), (2 mm, 7 mm)" for points;
  // a word for a choice; a text as it is
  std::string value;
};

struct BoundFamily {
  std::shared_ptr<const Family> family;
  // One a symbol of Family::arena, stored units: parameters, then lets as computed from them; 0 for the body's own.
  // After them the numbers of the lists, as list_in (evaluate.h) finds them.
  std::vector<double> values;
  std::map<ir::SymbolId, std::string> texts;  // of text parameters
};

struct BindResult {
  BoundFamily bound;  // to be built only when no diagnostic is an error
  std::vector<text::Diagnostic> diagnostics;
};

// A number that a person wrote for a parameter, or for one number of a list.
struct WrittenValue {
  double stored = 0.0;
  std::optional<ValueFault> fault;
};
WrittenValue read_value(const Parameter& parameter, const std::string& written);

// "(0 mm, 5 mm), (2 mm, 7 mm)" as one list an axis: "0 mm, 2 mm" and "5 mm, 7 mm"; nothing where it is no such text.
std::optional<std::vector<std::string>> axes_of_points(std::string_view written, std::size_t axes);

// Defaults where nothing is given. Faults: unknown parameter, one given twice, no or wrong unit, out
// of range, not whole, a failed `require` (with its text), a loop that cannot run, a value that cannot be computed.
// Spans are in the family's source: at the parameter, the constraint or the loop.
BindResult bind_family(std::shared_ptr<const Family> family, std::span<const Override> overrides);

// Of a step that names a tool.
std::int32_t tool_number(const BoundFamily& bound, const Step& step);

}  // namespace dripfeed::family
