// One answer a kind of statement.
#include "dialects/facts/calls.h"

namespace dripfeed::facts {

using ir::StatementKind;

bool is_call(StatementKind kind) { return kind == StatementKind::call || kind == StatementKind::modal_call; }

bool keeps_modes(StatementKind kind) {
  using enum StatementKind;
  switch (kind) {
    case empty:
    case assign:
    case go_to:
    case if_begin:
    case else_begin:
    case if_end:
    case while_begin:
    case while_end:
    case repeat_begin:
    case repeat_end:
    case for_begin:
    case for_end:
    case loop_begin:
    case loop_end:
    case define:
    case declaration:
    case procedure:
    case message:
    case alarm:
    case output: return true;
    case block:
    case call:
    case subprogram_return:
    case return_to:
    case modal_call:
    case modal_call_end:
    case program_end:
    case native:
    case repeat_section:
    case execute_text: return false;
  }
  return false;
}

bool is_standard_cycle(const ir::Program& program, const ir::Statement& call) {
  return program.calls[call.payload].cycle != nullptr;
}

}  // namespace dripfeed::facts
