// The alarms are those of the Diagnostics Manual, NC alarms 10000 to 17190. A fault without a row is none to the
// control: it runs, and only a reader sees what is wrong.
#include "dialects/sinumerik/tables/alarms.h"

#include "dialects/ir/alarm_details.h"

namespace dripfeed::sinumerik {

namespace {

using enum text::DiagnosticId;

// clang-format off
constexpr ir::AlarmRow kAlarms[] = {
  {invalid_character, "12080"},
  {homoglyph, "12080"},
  {unterminated_string, "12080"},
  {block_too_long, "12540"},
  {too_many_digits, "12160"},
  {malformed_number, "12080"},
  {skip_level_invalid, "14060"},
  {address_without_value, "12080"},
  {value_without_address, "12080"},
  {unknown_address, "12050"},
  {unknown_code, "12470"},
  {duplicate_address, "12000"},
  {address_too_often, "12010"},
  {codes_of_one_group, "12060"},
  {missing_equals, "12080"},
  {no_feed, "10860"},
  {surface_speed_missing, "10900"},
  {comp_without_tool, "10750"},
  {syntax_error, "12080"},
  {missing_operand, "12080"},
  {missing_target, "12080"},
  {missing_bracket, "12080"},
  {unbalanced_bracket, "12080"},
  {bracket_nesting_too_deep, "14050"},
  {variable_out_of_range, "12290"},
  {unknown_name, "12550"},
  {name_too_long, "12420"},
  {name_defined_twice, "12170"},
  {parameter_defined_twice, "12170"},
  {definition_not_at_start, "12110"},
  {wrong_type, "12150"},
  {missing_end, "12640"},
  {end_without_begin, "12640"},
  {wrong_nesting, "12640"},
  {nesting_too_deep, "12641"},
  {jump_target_missing, "14080"},
  {label_defined_twice, "12450"},
  {not_in_drip_mode, "14080"},
  {statement_not_alone, "12080"},
  {call_target_missing, "14011"},
  {wrong_argument_count, "14020"},
  {call_nesting_too_deep, "14012"},
  {missing_program_end, "14000"},
  {division_by_zero, "14051"},
  {argument_out_of_domain, "14051"},
  {result_overflow, "14051"},
  {arc_radius_mismatch, "14040"},
  {arc_without_center, "14040"},
  {arc_radius_mismatch, "14095", ir::AlarmDetail::small_radius},
  {comp_started_by_arc, "10753"},
  {comp_started_by_arc, "10754", ir::AlarmDetail::ends},
  {plane_changed_in_comp, "10757"},
  {travel_exceeded, "10720"},
  {wrong_type, "12030", ir::kValueOfWord},
  {wrong_type, "12330", ir::kPassedValue},
  {wrong_type, "12320", ir::kPassedReference},
  {wrong_type, "14096", ir::kToCharacter},
  {wrong_type, "14097", ir::kToAxis},
  {argument_out_of_domain, "14098", ir::kToNumber},
  {argument_out_of_domain, "14013", ir::kPasses},
  {wrong_argument_count, "12340", ir::kTooManyPassed},
  {wrong_argument_count, "14010", ir::kLeftOut},
  {variable_out_of_range, "17020", ir::kFirstIndex},
  {variable_out_of_range, "17030", ir::kSecondIndex},
  {result_overflow, "12160", ir::AlarmDetail::whole_numbers},
  {string_too_long, "12210"},
  {string_too_long, "14099", ir::kJoined},
  {no_feed, "14800", ir::kNegative},
};
// clang-format on

}  // namespace

std::span<const ir::AlarmRow> alarms() { return kAlarms; }

}  // namespace dripfeed::sinumerik
