// Every diagnostic that dripfeed can give, in the order of the way of a program: text, words, values, variables, flow,
// calls, framing, run, translation, family. One row each in diagnostic_table.cpp.
#pragma once

#include <cstdint>

namespace dripfeed::text {

enum class DiagnosticId : std::uint16_t {
  // text
  invalid_character,
  homoglyph,
  unterminated_comment,
  unterminated_string,
  nested_comment,
  block_too_long,
  too_many_digits,
  malformed_number,
  // words and codes
  address_without_value,
  value_without_address,
  unknown_address,
  unknown_code,
  duplicate_address,
  codes_of_one_group,
  missing_equals,
  motion_without_code,
  missing_decimal_point,
  decimal_point_not_allowed,
  unit_not_stated,
  feed_mode_not_stated,
  distance_mode_not_stated,
  plane_not_stated,
  no_feed,
  not_interpreted,
  // expressions and variables
  syntax_error,
  missing_operand,
  missing_target,
  missing_bracket,
  unbalanced_bracket,
  bracket_nesting_too_deep,
  expression_without_brackets,
  comparison_beside_logic,
  variable_out_of_range,
  variable_write_protected,
  unknown_name,
  name_too_long,
  name_defined_twice,
  parameter_defined_twice,
  parameter_never_used,
  variable_never_set,
  read_before_set,
  diameter_doubles_increment,
  wrong_type,
  // control flow
  missing_end,
  end_without_begin,
  wrong_nesting,
  nesting_too_deep,
  loop_number_invalid,
  jump_target_missing,
  jump_into_loop,
  label_defined_twice,
  unreachable,
  endless_loop,
  not_in_drip_mode,
  statement_not_alone,
  // calls
  call_target_missing,
  wrong_argument_count,
  call_nesting_too_deep,
  // framing
  missing_program_number,
  missing_tape_mark,
  missing_program_end,
  tape_mark_in_comment,
  // run
  division_by_zero,
  argument_out_of_domain,
  result_overflow,
  arc_radius_mismatch,
  arc_without_center,
  vacant_value,
  limit_reached,
  user_alarm,
  // translation and rendering
  cannot_translate,
  unknown_modal_state,
  not_enough_variables,
  // family language
  family_syntax,
  family_unknown_parameter,
  family_value_out_of_range,
  family_missing_unit,
  family_wrong_unit,
  family_constraint_failed,
  family_unknown_name,
  family_duplicate_name,
  family_bad_loop,
  count_,  // number of rows, not a diagnostic
};

}  // namespace dripfeed::text
