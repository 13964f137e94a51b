// What an operator changed at the control, as values of the part: a program that was rendered from a family comes back
// with other numbers, and the values are looked for that make the family say just that. Nothing is taken for an
// explanation that was not rendered and compared, number by number.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "server/app/checks/workers.h"

namespace dripfeed::app {

struct ValueOrder {
  RenderWork work;       // that gave `stored`
  std::string stored;    // text
  std::string received;  // text
};

struct ChangedValue {
  std::string name;    // of the parameter
  std::string before;  // "100 mm"
  std::string after;   // "102 mm"
};

// A block that the values do not explain.
struct LeftOver {
  std::uint32_t line = 0;  // of the received text, from 1
  std::string stored;      // the stored program's block
  std::string received;
};

struct ValueChanges {
  std::vector<ChangedValue> values;  // in the family's order
  std::vector<LeftOver> rest;        // kMostLeftOver at most; none: the values explain all
  bool explains_all = false;
  std::string why_not;  // a sentence; "" where they explain all

  static constexpr std::size_t kMostLeftOver = 20;
};

// Comments, blanks and the program's own name and number do not count: the rendered text names the part's values.
// Errors: invalid: the family or the machine cannot be read.
Result<ValueChanges> explain_values(const ValueOrder& order, const Documents& documents);

}  // namespace dripfeed::app
