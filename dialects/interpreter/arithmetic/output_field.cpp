// The digits are those of the value rounded to the field's decimals.
#include "dialects/interpreter/arithmetic/output_field.h"

#include <cmath>

#include "dialects/text/number.h"

namespace dripfeed::interpreter {

void append_field(std::string& text, double value, unsigned whole_digits, unsigned decimals) {
  std::string digits = text::format_fixed(std::abs(value), static_cast<int>(decimals));
  const std::size_t point = digits.find('.');
  std::string whole = digits.substr(0, point);
  if (whole.size() > whole_digits) whole.erase(0, whole.size() - whole_digits);
  const bool is_zero = digits.find_first_not_of("0.") == std::string::npos;
  text += value < 0.0 && !is_zero ? '-' : ' ';
  text.append(whole_digits - whole.size(), ' ');
  text += whole;
  if (point != std::string::npos) text += digits.substr(point);
}

}  // namespace dripfeed::interpreter
