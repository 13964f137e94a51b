// Which alarm of a 30i or 0i-F names which fault; PS numbers below 1000 are the P/S alarms of older controls too.
#include <array>

#include "dialects/fanuc/tables.h"

namespace dripfeed::fanuc {

namespace {

using ir::AlarmRow;
using enum text::DiagnosticId;
using enum ir::AlarmDetail;

constexpr auto kAlarms = std::to_array<AlarmRow>({
    {invalid_character, "PS0009"},
    {homoglyph, "PS0009"},
    {unterminated_comment, "PS1090"},
    {nested_comment, "PS1090"},
    {too_many_digits, "PS0003"},
    {malformed_number, "PS0007"},
    {address_without_value, "PS0005"},
    {value_without_address, "PS0004"},
    {unknown_address, "PS0009"},
    {unknown_code, "PS0010"},
    {missing_equals, "PS1133"},
    {decimal_point_not_allowed, "PS0007"},
    {no_feed, "PS0011"},
    {syntax_error, "PS0114"},
    {missing_operand, "PS0114"},
    {missing_target, "PS0114"},
    {missing_bracket, "PS1131"},
    {unbalanced_bracket, "PS1120"},
    {bracket_nesting_too_deep, "PS0118"},
    {expression_without_brackets, "PS0114"},
    {variable_out_of_range, "PS0115"},
    {variable_write_protected, "PS0116"},
    {name_too_long, "PS1097"},
    {wrong_type, "PS0129"},
    {wrong_argument_count, "PS0114"},
    {missing_end, "PS0124"},
    {end_without_begin, "PS0125"},
    {wrong_nesting, "PS0124"},
    {nesting_too_deep, "PS0124"},
    {loop_number_invalid, "PS0126"},
    {jump_target_missing, "PS0128"},
    {statement_not_alone, "PS0127"},
    {not_in_drip_mode, "PS0123"},
    {call_target_missing, "PS0076"},
    {call_nesting_too_deep, "PS0077"},
    {missing_program_end, "PS0008"},
    {tape_mark_in_comment, "PS0008"},
    {division_by_zero, "PS0112"},
    {argument_out_of_domain, "PS0119"},
    {result_overflow, "PS0111"},
    {arc_radius_mismatch, "PS0020"},
    {arc_without_center, "PS0022"},
    {peck_without_depth, "PS0045"},
    {modal_call_not_open, "PS1100"},
    {reference_in_cycle, "PS0044"},
    {comp_started_by_arc, "PS0034"},
    {plane_changed_in_comp, "PS0037"},
    {skip_in_comp, "PS0035"},
    {corner_without_move, "PS0051"},
    {rigid_tap_invalid, "PS0203"},
    {rigid_tap_invalid, "PS0204", axis_moves},
    {rigid_tap_invalid, "PS0206", plane_changes},
    {value_out_of_range, "PS0030"},
    {tap_without_speed, "PS0200"},
    {data_setting_invalid, "PS0031"},
    {no_feed, "PS1202", inverse_time},
    {statement_not_alone, "PS1091", second_call},
    {cycle_shape_missing, "PS0063"},
    {cycle_shape_invalid, "PS0065"},
    {cycle_shape_not_monotonic, "PS0064"},
    {address_without_value, "PS1090", macro_program},
    {user_alarm, "MC3000"},
    {syntax_error, "PS1137", if_statement},
    {syntax_error, "PS1138", while_statement},
    {syntax_error, "PS1128", jump_number},
    {syntax_error, "PS0006", two_signs},
    {missing_bracket, "PS1131", opening_bracket},
    {missing_bracket, "PS1121", closing_bracket},
    {wrong_type, "PS0129", code_as_argument},
    {not_in_drip_mode, "PS0210", subprogram_in_drip},
    {call_nesting_too_deep, "PS0122", macro_call},
});

}  // namespace

std::span<const AlarmRow> alarms() { return kAlarms; }

}  // namespace dripfeed::fanuc
