// A control: what it can do, what it calls things, how it calculates and what a block costs it. Tables are static spans
// owned by the dialect; a machine's profile copies the struct and overrides single fields.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/ir/cost_model.h"
#include "dialects/ir/expression.h"
#include "dialects/ir/function.h"
#include "dialects/ir/semantics.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::ir {

enum class MachineKind : std::uint8_t { mill, lathe, mill_turn };
enum class GSystem : std::uint8_t { a, b, c };  // of lathes

// A consecutive range of variables that the control has.
enum class VariableUse : std::uint8_t { local, common, permanent, system };
struct VariableRange {
  Bank bank = Bank::hash;
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  VariableUse use = VariableUse::common;
  bool writable = true;
};

// A system variable by name (bank `system`) or number range; `kind` says what the interpreter answers.
enum class SystemValue : std::uint8_t {
  not_modelled,
  end_position,
  machine_position,
  work_offset_value,
  feed,
  spindle_speed,
  tool_number,
  active_code,
  clock_ms,
  selected_tool,
  tool_edge,
  spindle_direction,
  constant,  // SystemVariableRow::first
};
struct SystemVariableRow {
  std::string_view name;    // "$P_EP"; empty for numbered ones
  std::uint32_t first = 0;  // #5001
  std::uint32_t last = 0;
  SystemValue kind = SystemValue::not_modelled;
  bool writable = false;
  std::string_view reference;
  bool inert = false;  // writing it neither moves nor changes what is modelled
};

struct AlarmRow {
  text::DiagnosticId id;
  std::string_view alarm;  // "PS0124", "14080"
};

// 0 means: no limit.
struct ControlLimits {
  std::uint32_t block_length_bytes = 0;
  std::uint32_t digits = 8;  // of one number
  std::uint32_t expression_nesting = 5;
  std::uint32_t loop_nesting = 3;
  std::uint32_t call_nesting = 4;
  std::uint32_t macro_nesting = 4;
  std::uint32_t name_length = 31;
  int linear_decimals = 3;  // digits after the point that an axis word resolves
};

struct Control {
  std::string dialect;  // "fanuc", "sinumerik-840d"
  std::string title;    // as people say it: "Fanuc 0i-TF"
  MachineKind kind = MachineKind::mill;
  GSystem g_system = GSystem::a;
  std::string axes = "XYZ";  // letters in the order of the trace: X Y Z A B C U V W
  Semantics semantics;
  ControlLimits limits;
  CostModel cost;
  std::span<const CodeRow> g_codes;  // sorted by number10
  std::span<const CodeRow> m_codes;
  std::span<const SystemVariableRow> system_variables;
  std::span<const AlarmRow> alarms;
  std::vector<VariableRange> variables;
  std::vector<std::string> definition_files;  // programs that declare global data, by name; read before a run
  bool from_profile = false;                  // a named machine: what it leaves unconfirmed is an error, not a warning
  // Why the control was taken for this one, when no machine was named: the line that decided, 0 for the default.
  std::uint32_t because_line = 0;
};

// nullptr when the table has no such number. `number10` is ten times the written number.
const CodeRow* find_code(std::span<const CodeRow> table, std::int32_t number10);
// The control's own alarm for a diagnostic, "" when it has none.
std::string_view alarm_of(const Control& control, text::DiagnosticId id);
// The range that holds the variable; nullptr when the control has no such variable.
const VariableRange* find_variable(const Control& control, Bank bank, std::uint32_t number);

// A diagnostic with the control's alarm beside it.
text::Diagnostic diagnose(const Control& control, text::DiagnosticId id, text::Span span,
                          std::vector<std::string> arguments = {});

}  // namespace dripfeed::ir
