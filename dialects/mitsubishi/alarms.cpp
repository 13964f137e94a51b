// Program errors (P...) of the M800/M80 alarm list.
#include <array>

#include "dialects/mitsubishi/tables.h"

namespace dripfeed::mitsubishi {

namespace {

using ir::AlarmRow;
using enum text::DiagnosticId;
using enum ir::AlarmDetail;

constexpr auto kAlarms = std::to_array<AlarmRow>({
    {invalid_character, "P32"},
    {homoglyph, "P32"},
    {unterminated_comment, "P33"},
    {nested_comment, "P33"},
    {block_too_long, "P33"},
    {too_many_digits, "P35"},
    {malformed_number, "P33"},
    {address_without_value, "P33"},
    {value_without_address, "P33"},
    {unknown_address, "P32"},
    {unknown_code, "P34"},
    {missing_equals, "P242"},
    {decimal_point_not_allowed, "P33"},
    {no_feed, "P62"},
    {syntax_error, "P33"},
    {expression_without_brackets, "P33"},
    {missing_operand, "P282"},
    {missing_target, "P282"},
    {missing_bracket, "P281"},
    {unbalanced_bracket, "P281"},
    {bracket_nesting_too_deep, "P280"},
    {variable_out_of_range, "P241"},
    {variable_write_protected, "P241"},
    {name_too_long, "P300"},
    {name_defined_twice, "P301"},
    {wrong_type, "P275"},
    {wrong_argument_count, "P275"},
    {missing_end, "P294"},
    {end_without_begin, "P294"},
    {wrong_nesting, "P294"},
    {nesting_too_deep, "P293"},
    {loop_number_invalid, "P291"},
    {jump_target_missing, "P231"},
    {statement_not_alone, "P272"},
    {not_in_drip_mode, "P295"},
    {call_target_missing, "P232"},
    {call_nesting_too_deep, "P230"},
    {number_zero, "P37"},
    {modal_call_not_open, "P276"},
    {missing_program_end, "P36"},
    {tape_mark_in_comment, "P36"},
    {division_by_zero, "P283"},
    {argument_out_of_domain, "P282"},
    {result_overflow, "P285"},
    {arc_radius_mismatch, "P70"},
    {arc_without_center, "P71"},
    {plane_changed_in_comp, "P112"},
    {comp_started_by_arc, "P151"},
    {user_alarm, "P277"},
    {plane_changed_in_rotation, "P111"},
    {skip_in_comp, "P608"},
    {cycle_in_comp, "P155"},
    {comp_without_number, "P170"},
    {shift_in_extended_offset, "P438"},
    {corner_without_move, "P382"},
    {value_out_of_range, "P170"},
    {code_beside_function, "P435", reference_check},
    {tap_without_speed, "P181"},
    {data_setting_invalid, "P173"},
    {code_beside_function, "P436"},
    {statement_not_alone, "P33", second_call},
    {cycle_shape_missing, "P201"},
    {cycle_shape_invalid, "P203"},
    {cycle_shape_not_monotonic, "P203"},
    {syntax_error, "P290", if_statement},
    {syntax_error, "P291", while_statement},
    {syntax_error, "P231", jump_number},
    {call_nesting_too_deep, "P273", macro_call},
    {nesting_too_deep, "P288", if_nesting},
    {curve_invalid, "P551"},
    {curve_invalid, "P552", first_point},
    {unknown_address, "P11", axis_letter},
    {syntax_error, "P292", name_statement},
    {no_feed, "P183", tap},
    {no_feed, "P93", thread},
    {result_overflow, "P284", whole_numbers},
    {cycle_shape_too_long, "P202"},
    {corner_without_move, "P385", thread},
    {code_not_in_mode, "P481"},
});

}  // namespace

std::span<const AlarmRow> alarms() { return kAlarms; }

}  // namespace dripfeed::mitsubishi
