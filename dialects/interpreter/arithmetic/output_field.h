// DPRNT: a value in a field of digits.
#pragma once

#include <cstdint>
#include <string>

namespace dripfeed::interpreter {

// Sign (a blank for plus), `whole_digits` places before the point filled up with blanks, the point and `decimals`
// places. What does not fit in front is cut off there, as the control does. Without decimals there is no point. (0i-F
// B-64604EN, DPRNT with parameter PRT = 0.)
void append_field(std::string& text, double value, unsigned whole_digits, unsigned decimals);

}  // namespace dripfeed::interpreter
