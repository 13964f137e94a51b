// A few words on each operator and function, in the order of their enumerators.
#include "dialects/ir/language_word.h"

#include <fmt/format.h>

#include "dialects/ir/cycle.h"

namespace dripfeed::ir {

namespace {

constexpr std::array kOperators = std::to_array<std::string_view>({
    "",
    "no value",
    "",
    "",
    "negative of a value",
    "true where the operand is false",
    "each bit reversed",
    "sine of an angle in degrees",
    "cosine of an angle in degrees",
    "tangent of an angle in degrees",
    "angle in degrees of a sine",
    "angle in degrees of a cosine",
    "angle in degrees of a tangent",
    "square root",
    "square",
    "absolute value",
    "natural logarithm",
    "power of e",
    "rounded to a whole number",
    "whole number toward zero",
    "whole number, rounded up",
    "binary number to BCD",
    "BCD to a binary number",
    "whether a variable exists",
    "frame: mirrored axis",
    "length of a text",
    "value as a text",
    "text as a number",
    "whether a text is a number",
    "axis of a name",
    "text in capitals",
    "text in small letters",
    "sum",
    "difference",
    "product",
    "quotient",
    "whole part of a quotient",
    "remainder of a division",
    "and, bit by bit",
    "or, bit by bit",
    "exclusive or, bit by bit",
    "true where both are",
    "true where at least one of the two is",
    "true where exactly one of the two is",
    "equal",
    "not equal",
    "less",
    "less or equal",
    "greater",
    "greater or equal",
    "texts joined",
    "angle in degrees of two lengths",
    "power of a value",
    "the smaller of two values",
    "the larger of two values",
    "place of a character in a text",
    "last place of a character in a text",
    "place of any of several characters in a text",
    "frame: shift of an axis",
    "frame: rotation about an axis",
    "frame: scale of an axis",
    "frames one after the other",
    "value within two limits",
    "part of a text",
});
static_assert(kOperators.size() == static_cast<std::size_t>(Operator::count_));

constexpr std::array kDrilling = std::to_array<std::string_view>({
    "drilling: in by feed, out by rapid",
    "drilling: in by feed, dwell, out by rapid",
    "deep hole drilling: each peck comes out to the R level",
    "drilling with chip breaking: each peck retracts a little",
    "tapping: out by feed with the spindle reversed",
    "tapping left-handed: out by feed with the spindle reversed",
    "boring: in and out by feed",
    "boring: dwell, out by feed",
    "boring: spindle stopped, out by rapid",
    "boring: dwell, spindle stopped, program held",
    "fine boring: oriented and shifted from the wall, out by rapid",
    "back boring: shifted in, bored upward from below",
});
static_assert(kDrilling.size() == static_cast<std::size_t>(DrillCycle::count_));

constexpr std::array kTurning =
    std::to_array<std::string_view>({"turning cycle along Z", "thread cycle", "turning cycle along X"});
static_assert(kTurning.size() == static_cast<std::size_t>(TurningCycle::count_));

constexpr std::array kRepetitive = std::to_array<std::string_view>({
    "finishing of a shape",
    "roughing of a shape along Z",
    "roughing of a shape along X",
    "repeating a shape",
    "grooving or peck drilling along Z",
    "grooving along X",
    "thread in several passes",
});
static_assert(kRepetitive.size() == static_cast<std::size_t>(RepetitiveCycle::count_));

constexpr std::int16_t kEachAlong = kDrillAlongZ;

template <std::size_t N>
std::string row_of(const std::array<std::string_view, N>& rows, std::int16_t argument, Function otherwise) {
  const auto index = static_cast<std::size_t>(argument);
  return std::string(argument >= 0 && index < N ? rows[index] : name_of(otherwise));
}

}  // namespace

std::string_view about_operator(Operator op) { return kOperators[static_cast<std::size_t>(op)]; }

std::string about_code(const CodeRow& row) {
  const Function function = row.function;
  if (function == Function::work_offset)
    return row.argument == 0 ? "no work offset" : fmt::format("work offset {}", row.argument);
  if (function == Function::drill)
    return row_of(kDrilling, static_cast<std::int16_t>(row.argument % kEachAlong), function);
  if (function == Function::turning_cycle) return row_of(kTurning, row.argument, function);
  if (function == Function::repetitive_cycle) return row_of(kRepetitive, row.argument, function);
  if (function == Function::not_modelled) return "known to the control; a check does not know what it does";
  if (function == Function::no_effect) return "no effect on what is checked";
  return std::string(name_of(function));
}

WordState state_of(const CodeRow& row) {
  // What an M function of its builder does, the machine's profile states.
  if (row.function == Function::not_modelled || row.function == Function::machine_function) return WordState::reported;
  return row.function == Function::no_effect ? WordState::without_effect : WordState::interpreted;
}

}  // namespace dripfeed::ir
