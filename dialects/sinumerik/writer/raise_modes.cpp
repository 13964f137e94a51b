// G94 to G97 are one group here and two elsewhere: a feed mode ends constant surface speed and the reverse.
// Both are followed through the text, and each block says the one code that means the pair. At the head of a main
// program stands what it relies on without saying it, because no two controls start in the same state.
#include <algorithm>
#include <array>
#include <iterator>
#include <set>

#include "dialects/facts/resolved.h"
#include "dialects/passes/safe_start.h"
#include "dialects/sinumerik/tables/codes.h"
#include "dialects/sinumerik/writer/raise.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Address;
using ir::Function;
using ir::StatementKind;

class FeedAndSpeed {
 public:
  explicit FeedAndSpeed(const Raising& raising)
      : raising_(raising),
        program_(raising.program),
        per_rev_(raising.from.semantics.power_on_feed == Function::feed_per_rev) {}

  void run() {
    const auto& codes = program_.codes;
    const auto uses = [&codes](Function f) { return std::ranges::find(codes, f, &ir::Code::function) != codes.end(); };
    if (!uses(Function::surface_speed_on) && !uses(Function::surface_speed_off)) return;
    branches_ = uses(Function::surface_speed_on) && uses(Function::surface_speed_off);
    // Before anything is rewritten: the feed mode where paths join.
    if (uses(Function::feed_per_min) || uses(Function::feed_per_rev)) find_feed_modes();
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      const ir::Statement& s = program_.statements[i];
      if (branches_ && joins_paths(s)) surface_known_ = false;
      if (s.kind != StatementKind::block) continue;
      feed_is_certain_ = !uncertain_.contains(i);
      block(program_.blocks[s.payload]);
    }
  }

 private:
  // Blocks of a speed before which the paths differ in the feed mode.
  void find_feed_modes() {
    const facts::Resolved known(program_, raising_.from);
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      const ir::Statement& s = program_.statements[i];
      if (s.kind != StatementKind::block) continue;
      const auto codes = program_.codes_of(program_.blocks[s.payload]);
      const auto sets = [](const ir::Code& c) {
        return c.function == Function::feed_per_min || c.function == Function::feed_per_rev;
      };
      if (std::ranges::none_of(codes, [](const ir::Code& c) { return is_speed(c.function); })) continue;
      if (std::ranges::any_of(codes, sets)) continue;
      const facts::Facts* before = known.before(i);
      const bool differs = before != nullptr && (*before)[facts::Mode::feed].other_origin != facts::kNoStatement;
      if (differs) uncertain_.insert(i);
    }
  }

  // Two paths that differ may join here.
  static bool joins_paths(const ir::Statement& s) {
    return s.is_label || (s.kind >= StatementKind::if_begin && s.kind <= StatementKind::loop_end);
  }

  void block(ir::Block& block) {
    const auto first = program_.codes.begin() + block.first_code;
    const auto last = first + block.code_count;
    bool stated = false;
    bool speed_stated = false;
    text::Span span;
    for (auto code = first; code != last; ++code) {
      const bool mode = code->function == Function::feed_per_min || code->function == Function::feed_per_rev;
      if (mode) per_rev_ = code->function == Function::feed_per_rev;
      if (code->function == Function::surface_speed_on || code->function == Function::surface_speed_off) {
        surface_ = code->function == Function::surface_speed_on;
        speed_stated = surface_known_ = true;
      }
      stated = stated || mode || code->group == ir::ModalGroup::surface_speed || is_speed(code->function);
      if (mode || is_speed(code->function)) span = code->span;
    }
    if (!stated) return;
    if (!surface_known_) {
      raising_.report(text::DiagnosticId::unknown_modal_state, span,
                      {"constant surface speed", "two control-flow paths lead to this block and differ"});
      surface_known_ = true;
    }
    if (!feed_is_certain_)
      raising_.report(text::DiagnosticId::unknown_modal_state, span,
                      {"the feed mode, which G96 and G97 state as well", "the paths to this block differ in it"});
    say(block, speed_stated, span);
  }

  static bool is_speed(Function f) { return f == Function::surface_speed_on || f == Function::surface_speed_off; }

  // One code in the place of the first: the pair's own.
  void say(ir::Block& block, bool speed_stated, text::Span span) {
    ir::Code code;
    code.span = span;
    std::string_view name;
    if (surface_) {
      name = per_rev_ ? "G96" : "G961";
      code.function = Function::surface_speed_on;
    } else if (speed_stated) {
      name = per_rev_ ? "G97" : "G971";
      code.function = Function::surface_speed_off;
    } else {
      name = per_rev_ ? "G95" : "G94";
      code.function = per_rev_ ? Function::feed_per_rev : Function::feed_per_min;
    }
    code.group = surface_ || speed_stated ? ir::ModalGroup::surface_speed : ir::ModalGroup::feed;
    code.name = program_.strings.add(name);
    const auto begin = program_.codes.begin() + block.first_code;
    const auto end = begin + block.code_count;
    const auto kept = std::remove_if(begin, end, [](const ir::Code& c) {
      return is_speed(c.function) || c.function == Function::feed_per_min || c.function == Function::feed_per_rev;
    });
    *kept = code;
    block.code_count = static_cast<std::uint32_t>(kept - begin) + 1;
  }

  const Raising& raising_;
  ir::Program& program_;
  bool per_rev_;
  bool surface_ = false;
  bool surface_known_ = true;
  bool branches_ = false;
  bool feed_is_certain_ = true;
  std::set<std::uint32_t> uncertain_;  // statements
};

struct ModeName {
  Function function;
  std::string_view name;
};
// Length units are those of feeds, too, on the controls that this is translated from.
constexpr std::array kModeNames = {
    ModeName{Function::rapid, "G0"},           ModeName{Function::linear, "G1"},
    ModeName{Function::plane_xy, "G17"},       ModeName{Function::plane_zx, "G18"},
    ModeName{Function::plane_yz, "G19"},       ModeName{Function::unit_inch, "G700"},
    ModeName{Function::unit_mm, "G710"},       ModeName{Function::absolute, "G90"},
    ModeName{Function::incremental, "G91"},    ModeName{Function::feed_per_min, "G94"},
    ModeName{Function::feed_per_rev, "G95"},   ModeName{Function::diameter_off, "DIAMOF"},
    ModeName{Function::diameter_on, "DIAMON"}, ModeName{Function::diameter_absolute_only, "DIAM90"},
};

// What the program leaves to its control's power-on state is stated in front of it.
void state_power_on_modes(const Raising& raising) {
  passes::UnstatedModes unstated =
      passes::unstated_modes(raising.program, raising.from, raising.to.kind != ir::MachineKind::mill);
  std::vector<ir::Code> codes;
  for (const passes::UnstatedMode& mode : unstated.modes) {
    const auto* const row = std::ranges::find(kModeNames, mode.function, &ModeName::function);
    if (row == kModeNames.end()) continue;  // a mode that needs no word here
    ir::Code code;
    code.function = mode.function;
    code.group = mode.group;
    code.name = raising.program.strings.add(row->name);
    codes.push_back(code);
  }
  passes::insert_first(raising.program, codes);
  std::ranges::move(unstated.diagnostics, std::back_inserter(raising.diagnostics));
}

}  // namespace

void raise_modes(const Raising& raising) {
  FeedAndSpeed(raising).run();
  state_power_on_modes(raising);
}

}  // namespace dripfeed::sinumerik
