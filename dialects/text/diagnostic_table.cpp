// The one table of diagnostics: a row an id, in the order of diagnostic_id.h, which the compiler checks. A new id takes
// one line there and one row here. `{}` stands for the arguments in order; a sentence is lower case, without full stop.
#include <algorithm>
#include <array>
#include <cstddef>

#include "dialects/text/diagnostic.h"

namespace dripfeed::text {

namespace {

using enum DiagnosticId;
using enum Severity;

// clang-format off
constexpr auto kRows = std::to_array<DiagnosticRow>({
  // text
  {invalid_character, "invalid-character", error, "the character {} is not one that the control reads",
   "Controls read ASCII only. Remove the character, or put it inside a comment if the control allows it there."},
  {homoglyph, "homoglyph", error, "{} only looks like the letter {}",
   "The character is from another alphabet and the control does not know it. Type the Latin letter instead."},
  {unterminated_comment, "unterminated-comment", error, "the comment has no closing bracket",
   "The control reads on for the closing bracket and swallows what follows. Close the comment on its own line."},
  {unterminated_string, "unterminated-string", error, "the string has no closing quote",
   "A string ends on the line where it begins. Add the closing quote."},
  {nested_comment, "nested-comment", error, "a comment inside a comment",
   "The first closing bracket ends the comment, and the rest is read as program. Use no brackets inside comments."},
  {block_too_long, "block-too-long", error, "the block has {} bytes, the control takes {}",
   "Split the block in two, or leave out blanks, comments and leading zeros."},
  {too_many_digits, "too-many-digits", error, "the number {} has {} digits, the control takes {}",
   "Write the number with fewer digits; what lies beyond the control's resolution has no effect."},
  {malformed_number, "malformed-number", error, "{} is not a number",
   "A number has digits and at most one decimal point; in words of a program it has no exponent."},
  {skip_level_invalid, "skip-level-invalid", error, "{} is no skip level",
   "A block that can be skipped begins with / or with / and one digit."},
  // words and codes
  {address_without_value, "address-without-value", error, "the address {} has no value",
   "Every address needs a number, a variable or an expression after it."},
  {value_without_address, "value-without-address", error, "the value {} has no address before it",
   "A number alone means nothing to the control. Put the address before it, or remove the number."},
  {unknown_address, "unknown-address", error, "the control has no address {}",
   "Check the spelling and whether the machine has that axis."},
  {unknown_code, "unknown-code", error, "the control has no code {}",
   "Check the number; the same code may be an option, or mean something else on another control."},
  {duplicate_address, "duplicate-address", warning, "the address {} stands twice in the block",
   "Some controls take the last one and others stop with an alarm. Keep one."},
  {address_too_often, "address-too-often", error, "the block has {} words {}, the control takes {}",
   "Put some of them into a block before or after this one."},
  {codes_of_one_group, "codes-of-one-group", error, "{} and {} are of the same group and stand in one block",
   "Codes of one group exclude each other. Put them in two blocks, or remove one."},
  {missing_equals, "missing-equals", error, "the address {} needs = before its value",
   "Addresses of several letters, and values that are expressions, are written with an equals sign: X1=10, X=R1+2."},
  {motion_without_code, "motion-without-code", warning, "the block moves {} without a motion code of its own or before it",
   "How the axis moves depends on what was active when the program started. Write G00 or G01 in the block."},
  {missing_decimal_point, "missing-decimal-point", warning, "{} has no decimal point: it may be read as {} or as {}",
   "What a number without a point means is a machine setting. Write the point, also for whole numbers: X10."},
  {decimal_point_not_allowed, "decimal-point-not-allowed", error, "the address {} takes no decimal point",
   "Numbers of programs, tools, offsets, repeats and blocks are whole numbers without a point."},
  {unit_not_stated, "unit-not-stated", warning, "the program moves before it says inch or millimetre",
   "Write the unit's code at the start of the program; otherwise the machine's last setting decides."},
  {feed_mode_not_stated, "feed-mode-not-stated", warning, "the feed {} is used before the program says per minute or per revolution",
   "Write the feed mode's code at the start; read in the wrong mode a feed is a thousand times too high or too low."},
  {distance_mode_not_stated, "distance-mode-not-stated", warning, "the program moves before it says absolute or incremental",
   "Write the distance mode's code at the start of the program; otherwise the machine's last setting decides."},
  {plane_not_stated, "plane-not-stated", warning, "an arc or a compensation is used before the program names its plane",
   "Write G17, G18 or G19 at the start of the program; otherwise the machine's last setting decides."},
  {no_feed, "no-feed", error, "the block cuts and no feed was given",
   "Write an F word in this block or before it."},
  {not_interpreted, "not-interpreted", warning, "{} is known to the control but not interpreted here",
   "What the code does is not checked. Every verdict on this program says so."},
  // expressions and variables
  {syntax_error, "syntax-error", error, "{}",
   "The control does not understand the block. Compare it with the control's programming manual."},
  {missing_operand, "missing-operand", error, "{} has no operand",
   "An operator needs a value on each side, and a function a value in its brackets."},
  {missing_target, "missing-target", error, "the assignment has no variable on its left side",
   "Write the variable that is to take the value before the equals sign."},
  {missing_bracket, "missing-bracket", error, "{} is missing",
   "Functions and groups need an opening and a closing bracket."},
  {unbalanced_bracket, "unbalanced-bracket", error, "the bracket {} has no partner",
   "Count the opening and the closing brackets of the block; each needs the other."},
  {bracket_nesting_too_deep, "bracket-nesting-too-deep", error, "brackets are nested {} deep, the control takes {}",
   "Keep a part of the expression in a variable, in a block before this one."},
  {expression_without_brackets, "expression-without-brackets", error, "the expression after {} has no brackets",
   "This control calculates inside brackets only: write X[#106+50.] for X#106+50."},
  {comparison_beside_logic, "comparison-beside-logic", warning, "a comparison stands beside {} without brackets",
   "Controls differ in which of the two comes first. Put the comparison in brackets."},
  {variable_out_of_range, "variable-out-of-range", error, "the control has no variable {}",
   "Use a variable from the ranges that the control has; some ranges are options."},
  {variable_write_protected, "variable-write-protected", error, "the variable {} can only be read",
   "The control itself sets this variable. Assign to one of the common variables."},
  {unknown_name, "unknown-name", error, "the name {} is not defined",
   "Define the name before it is used, or check its spelling."},
  {name_too_long, "name-too-long", error, "the name {} has {} characters, the control takes {}",
   "Shorten the name; some controls cut it off without a word, and two names become one."},
  {name_defined_twice, "name-defined-twice", error, "the name {} is defined twice",
   "Every name is defined once in a program. Remove or rename the second."},
  {parameter_defined_twice, "parameter-defined-twice", error, "the parameter {} stands twice in the list",
   "Each parameter of a subprogram has a name of its own. Remove or rename the second."},
  {definition_not_at_start, "definition-not-at-start", error, "the definition stands after the first block that does something",
   "Definitions come first in a program, each in a block of its own, before any move, assignment or call."},
  {parameter_never_used, "parameter-never-used", warning, "the parameter {} is never used",
   "The value that callers give has no effect. Either the parameter can go, or its use was forgotten."},
  {variable_never_set, "variable-never-set", warning, "the variable {} is read but never set",
   "It has the value that the control gives by default. Either the assignment was forgotten or the name is misspelled."},
  {read_before_set, "read-before-set", warning, "the variable {} is read before it is set",
   "It holds what an earlier program left there, or nothing. Set it first."},
  {diameter_doubles_increment, "diameter-doubles-increment", warning, "the increment of {} is taken as a diameter",
   "With diameter programming on for increments too, the axis moves half of it. Use the mode for absolute values only."},
  {wrong_type, "wrong-type", error, "{} is of type {}, {} is needed",
   "The control converts between numbers only. Use a value of the needed type."},
  // control flow
  {missing_end, "missing-end", error, "{} has no {}",
   "Close every loop and condition in the program in which it begins."},
  {end_without_begin, "end-without-begin", error, "{} has no {} before it",
   "Remove the end, or write the line that opens the structure."},
  {wrong_nesting, "wrong-nesting", error, "{} closes before {}, which began inside it",
   "Structures lie inside each other: what begins last ends first."},
  {nesting_too_deep, "nesting-too-deep", error, "structures are nested {} deep, the control takes {}",
   "Move the inner part into a subprogram."},
  {loop_number_invalid, "loop-number-invalid", error, "{} is no number of a loop",
   "DO and END take the numbers 1, 2 and 3, and each loop inside another needs its own."},
  {jump_target_missing, "jump-target-missing", error, "the jump target {} is not in the program",
   "Write the label or block number at the target, or check the direction in which the jump looks."},
  {jump_into_loop, "jump-into-loop", error, "the jump to {} enters a loop from outside",
   "Jump to the line that opens the loop, or out of it, never into it."},
  {label_defined_twice, "label-defined-twice", warning, "the label {} stands twice in the program",
   "A jump takes the one that it meets first, and that differs between controls. Keep one."},
  {unreachable, "unreachable", warning, "the block is never reached",
   "The jump or program end before it leaves no way here."},
  {endless_loop, "endless-loop", warning, "the loop has no way out",
   "Its condition does not change inside it. The program runs until it is reset."},
  {not_in_drip_mode, "not-in-drip-mode", error, "{} cannot run while the program is fed block by block",
   "A control that is fed has no program to jump in. Render the program explicitly, or load it into the memory."},
  {statement_not_alone, "statement-not-alone", error, "{} must stand alone in its block",
   "Move the other words to a block before or after it."},
  // calls
  {call_target_missing, "call-target-missing", error, "the program {} is called and was not found",
   "What it does is not checked. Give the folder in which called programs lie, or store the program."},
  {wrong_argument_count, "wrong-argument-count", error, "{} takes {} arguments, {} are given",
   "Give one value for each parameter, in the order of the definition."},
  {call_nesting_too_deep, "call-nesting-too-deep", error, "calls are nested {} deep, the control takes {}",
   "Put the body of the innermost program in the place of its call."},
  // framing
  {missing_program_number, "missing-program-number", warning, "the program has no number or name",
   "Without it the control stores the text under a number of its own choice, or refuses it. Write O1234 first."},
  {missing_tape_mark, "missing-tape-mark", warning, "the {} % is missing",
   "Controls read a program from the first % to the next one. Write one before and one after the program."},
  {missing_program_end, "missing-program-end", error, "the program has no end code",
   "Write M30, or M02, as the last block; M99 or M17 in a subprogram."},
  {tape_mark_in_comment, "tape-mark-in-comment", error, "a % stands inside a comment",
   "The control takes it for the end of the tape, and the rest is not read. Remove it."},
  // run
  {division_by_zero, "division-by-zero", error, "the division is by zero",
   "The control stops with an alarm here. Test the divisor before dividing."},
  {argument_out_of_domain, "argument-out-of-domain", error, "{} is not defined for {}",
   "The square root of a negative number, the arc sine beyond 1 and the like stop the control with an alarm."},
  {result_overflow, "result-overflow", error, "the result is too large for the control",
   "Check the values that go into the expression."},
  {arc_radius_mismatch, "arc-radius-mismatch", error, "the arc begins {} mm and ends {} mm from its centre",
   "Both must agree within the control's tolerance. Give I, J and K from the start point, with enough digits."},
  {arc_without_center, "arc-without-center", error, "the arc has neither a centre nor a radius",
   "Write I, J, K or the radius in the block; they are not modal."},
  {vacant_value, "vacant-value", warning, "the variable {} has no value here",
   "A word with a vacant variable is ignored by the control, and the axis does not move."},
  {limit_reached, "limit-reached", error, "the run was ended at the limit of {}",
   "Either the program does not end, or the limit is too low for it."},
  {user_alarm, "user-alarm", error, "the program stops by its own alarm {}",
   "The program itself found something wrong: look at the condition before the alarm."},
  // translation and rendering
  {cannot_translate, "cannot-translate", error, "{} has no counterpart on {}",
   "Replace it in the source, or render explicitly, where only moves remain."},
  {unknown_modal_state, "unknown-modal-state", error, "{} is not known here: two ways lead to this block and differ",
   "State it in the block, so that it is the same whichever way the program comes."},
  {not_enough_variables, "not-enough-variables", error, "the program needs {} variables, the control has {}",
   "Render explicitly, or allow more of the control's ranges in the machine's profile."},
  // family language
  {family_syntax, "family-syntax", error, "{}",
   "Each line of a family is one sentence that begins with its keyword. The reference lists them with examples."},
  {family_unknown_parameter, "family-unknown-parameter", error, "the family has no parameter {}",
   "Check the spelling against the param lines of the family."},
  {family_value_out_of_range, "family-value-out-of-range", error, "{} = {} lies outside {} .. {}",
   "The family's param line gives the range. Choose a value inside it."},
  {family_missing_unit, "family-missing-unit", error, "{} needs a unit: {}",
   "Lengths, angles and feeds are written with their unit, so that nobody has to guess."},
  {family_wrong_unit, "family-wrong-unit", error, "{} is {}, {} is needed",
   "Quantities of different kinds cannot be added, compared or put in each other's place."},
  {family_constraint_failed, "family-constraint-failed", error, "the values break the condition {}",
   "The family states which values go together. Change one of those that the condition names."},
  {family_unknown_name, "family-unknown-name", error, "the name {} is not defined",
   "Names are param, let or for names that stand before the line."},
  {family_duplicate_name, "family-duplicate-name", error, "the name {} is already taken",
   "Every param, let and for name is used once, and keywords are no names."},
  {family_bad_loop, "family-bad-loop", error, "the loop {}",
   "A loop needs a step that is not zero and that leads from its start to its end."},
  // checks
  {travel_exceeded, "travel-exceeded", error, "{} goes to {} in machine coordinates, the travel is {}",
   "The control stops at its limit, or the slide does. Check the work offset, the clamping and the program's zero."},
  {feed_too_high, "feed-too-high", error, "the feed is {} mm/min, the machine's highest is {}",
   "Check whether the feed is meant per minute or per revolution, and in which unit."},
  {spindle_too_fast, "spindle-too-fast", error, "the spindle is to turn at {} rpm, the machine's highest is {}",
   "The control alarms, or turns slower and the feed per tooth changes. Lower the speed or its limit."},
  {surface_speed_unlimited, "surface-speed-unlimited", warning, "the surface speed asks for {} rpm at diameter {}, and no limit is set; the machine's highest is {}",
   "Set a spindle limit before constant surface speed: towards the centre the speed rises without end."},
  {tool_missing, "tool-missing", warning, "the tool {} is not in the machine's list",
   "Load the tool, or add it to the machine's profile with its nose radius or diameter."},
  {unit_suspicion, "unit-suspicion", warning, "the program's {} looks as if inch and millimetre were confused: {}",
   "A factor of 25.4 stands between what the program reaches and what it should. Check the unit's code."},
  {rapid_into_stock, "rapid-into-stock", error, "a rapid move enters the stock by {} mm at z {}",
   "The tool runs into material at full speed. Retract farther, or approach from another side."},
  {rapid_into_nominal, "rapid-into-nominal", error, "a rapid move enters the finished part by {} mm at z {}",
   "The tool runs through the part that is to remain. Retract farther, or approach from another side."},
  {rapid_may_enter_stock, "rapid-may-enter-stock", warning, "a rapid move may enter the stock by {} mm at z {} if the axes do not move in a line",
   "Many controls let each axis run at its own rapid speed, and the tool bends off the line. Move one axis at a time."},
  {cut_below_nominal, "cut-below-nominal", error, "the cut is {} mm below the nominal at z {}, the tolerance is {}",
   "Too much is taken off. Check the tool's nose radius, its compensation and the points of the path."},
  {deviation_beyond_tolerance, "deviation-beyond-tolerance", error, "the surface is {} mm off the nominal at z {}, the tolerance is {}",
   "Take shorter steps where chords are the cause, or compensate the nose radius where that is."},
  {nominal_not_covered, "nominal-not-covered", error, "the cuts leave the nominal from z {} to {} uncovered",
   "The path ends too early or leaves a part out. What was not cut was not measured either."},
  {line_starves, "line-starves", warning, "the control waits {} s for its next block",
   "The line or the control's computing is slower than the moves. Raise the baud rate, shorten the blocks, or slow down."},
});
// clang-format on

constexpr bool in_order() {
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    if (kRows[i].id != static_cast<DiagnosticId>(i)) return false;
  }
  return true;
}
static_assert(kRows.size() == static_cast<std::size_t>(count_), "one row for each id");
static_assert(in_order(), "rows in the order of diagnostic_id.h");

}  // namespace

const DiagnosticRow& row_of(DiagnosticId id) { return kRows[static_cast<std::size_t>(id)]; }

const DiagnosticRow* find_diagnostic(std::string_view name) {
  const auto row = std::ranges::find(kRows, name, &DiagnosticRow::name);
  return row == kRows.end() ? nullptr : &*row;
}

}  // namespace dripfeed::text
