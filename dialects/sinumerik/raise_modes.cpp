// G94 to G97 are one group here and two elsewhere: a feed mode ends constant surface speed and the other way round.
// Both are followed through the text, and each block says the one code that means the pair. At the head of a main
// program stands what it relies on without saying it, because no two controls start in the same state.
#include <algorithm>

#include "dialects/sinumerik/codes.h"
#include "dialects/sinumerik/raise.h"

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
    for (const ir::Statement& s : program_.statements) {
      if (branches_ && joins_ways(s)) surface_known_ = false;
      if (s.kind == StatementKind::block) block(program_.blocks[s.payload]);
    }
  }

 private:
  // Two ways that differ may meet here.
  static bool joins_ways(const ir::Statement& s) {
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
      raising_.report(text::DiagnosticId::unknown_modal_state, span, {"constant surface speed"});
      surface_known_ = true;
    }
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
};

bool moves(const ir::Program& program, const ir::Block& block) {
  return std::ranges::any_of(program.words_of(block), [](const ir::Word& w) {
    return w.address <= Address::c || (w.address >= Address::u && w.address <= Address::z);
  });
}

// What the program says before it moves for the first time, in the order of the text.
class SafeStart {
 public:
  explicit SafeStart(const Raising& raising) : raising_(raising), program_(raising.program) {}

  void run() {
    bool any_move = false;
    for (const ir::Statement& s : program_.statements) {
      if (s.kind == StatementKind::procedure || s.kind == StatementKind::subprogram_return) return;
      if (s.kind == StatementKind::call) break;  // the called program may say it
      if (s.kind != StatementKind::block || any_move) continue;
      const ir::Block& block = program_.blocks[s.payload];
      for (const ir::Code& c : program_.codes_of(block)) groups_.push_back(c.group);
      any_move = moves(program_, block);
    }
    if (any_move) insert();
  }

 private:
  [[nodiscard]] bool says(ir::ModalGroup group) const { return std::ranges::find(groups_, group) != groups_.end(); }

  void add(ir::ModalGroup group, Function function, std::string_view name) {
    if (says(group)) return;
    ir::Code code;
    code.function = function;
    code.group = group;
    code.name = program_.strings.add(name);
    program_.codes.push_back(code);
  }

  void insert() {
    const ir::Semantics& s = raising_.from.semantics;
    ir::Block block;
    block.first_code = static_cast<std::uint32_t>(program_.codes.size());
    block.first_word = static_cast<std::uint32_t>(program_.words.size());
    add(ir::ModalGroup::motion, s.power_on_motion, s.power_on_motion == Function::linear ? "G1" : "G0");
    add(ir::ModalGroup::plane, s.power_on_plane,
        s.power_on_plane == Function::plane_zx   ? "G18"
        : s.power_on_plane == Function::plane_yz ? "G19"
                                                 : "G17");
    add(ir::ModalGroup::unit, s.power_on_unit, s.power_on_unit == Function::unit_inch ? "G700" : "G710");
    add(ir::ModalGroup::distance, s.power_on_distance, s.power_on_distance == Function::incremental ? "G91" : "G90");
    if (!says(ir::ModalGroup::surface_speed))
      add(ir::ModalGroup::feed, s.power_on_feed, s.power_on_feed == Function::feed_per_rev ? "G95" : "G94");
    if (raising_.to.kind != ir::MachineKind::mill) {
      const bool radius = s.power_on_diameter == ir::DiameterMode::radius;
      const bool always = s.power_on_diameter == ir::DiameterMode::diameter;
      add(ir::ModalGroup::diameter,
          radius   ? Function::diameter_off
          : always ? Function::diameter_on
                   : Function::diameter_absolute_only,
          radius   ? "DIAMOF"
          : always ? "DIAMON"
                   : "DIAM90");
    }
    block.code_count = static_cast<std::uint32_t>(program_.codes.size()) - block.first_code;
    if (block.code_count == 0) return;
    program_.blocks.push_back(block);
    ir::Statement statement;
    statement.kind = StatementKind::block;
    statement.payload = static_cast<std::uint32_t>(program_.blocks.size() - 1);
    program_.statements.insert(program_.statements.begin(), statement);
    for (ir::Label& label : program_.labels) ++label.statement;
    for (ir::Structure& structure : program_.structures)
      if (structure.partner != ir::kNoIndex) ++structure.partner;
  }

  const Raising& raising_;
  ir::Program& program_;
  std::vector<ir::ModalGroup> groups_;
};

}  // namespace

void raise_modes(const Raising& raising) {
  FeedAndSpeed(raising).run();
  SafeStart(raising).run();
}

}  // namespace dripfeed::sinumerik
