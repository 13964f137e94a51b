// Which machine a text was written for, when no one says. Rules, the first line that meets one decides:
//   lathe: T with four digits and no M06; U or W together with X or Z words; G50 S; G32; G70-G76 with P and Q or with U
//   and R;
//          H with a point, the increment of C, in a block that says no tool length
//   lathe: G70 to G72 with P and Q, which mills do not have, outweigh an M06 before them.
//   mill:  a Y word; G43 or G44; M06, unless its tool has its own offset (T0707 M06 may be either's); G81, G82 or
//          G73 with R
//   then:  G17 or G49, which stand in the first line of lathes' programs, too: mill; X and Z in one block and no Y
//          anywhere: lathe; otherwise mill, with no line.
// G-code system of a lathe: A by G50 S, G32, U or W; B by G91, G95, G92 S, G33; C by G70 or G71 without words, G24.
// Where none of these stand, A by G98 or G99 without drilling, B by G90 or G94 without words: programs of system A have
// a G90 among the codes of their first line, where it turns nothing. Where lines contradict each other the system is
// not certain (Control::contradiction). Axes beyond the usual are those that the program moves.
#include "dialects/macro_b/reader/infer.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dialects/ir/axis_letters.h"
#include "dialects/macro_b/reader/lex.h"
#include "dialects/text/number.h"

namespace dripfeed::macro_b {

namespace {

// One block as far as the rules ask.
struct Block {
  std::uint32_t line = 1;
  std::bitset<26> letters;
  std::vector<std::int32_t> g10;  // ten times the G numbers
  std::vector<std::int32_t> m10;
  std::size_t tool_digits = 0;
  bool tool_is_pair = false;  // T0707
  bool h_has_point = false;

  [[nodiscard]] bool has(char letter) const { return letters[static_cast<std::size_t>(letter - 'A')]; }
  [[nodiscard]] bool g(double number) const {
    return std::ranges::find(g10, static_cast<std::int32_t>(std::lround(number * 10.0))) != g10.end();
  }
  [[nodiscard]] bool m(int number) const { return std::ranges::find(m10, number * 10) != m10.end(); }
  // Words of these blocks are arguments or data, not axes.
  [[nodiscard]] bool is_call() const { return g(65) || g(66) || g(66.1) || g(10) || m(98) || g(4) || g(68) || g(68.2); }
};

// A piece of the text at a time: tokens take ten times its bytes.
class BlockScan {
 public:
  BlockScan(const text::Source& source, const Grammar& grammar) : rest_(source.text()), grammar_(grammar) {}

  std::optional<Block> next() {
    if (at_ >= tokens_.size() && !take_piece()) return std::nullopt;
    Block block;
    block.line = line_;
    char letter = 0;
    bool comma = false;        // stands before this token
    bool folder_line = false;  // &F=/USER/ of a memory dump: the letters are no addresses
    while (at_ < tokens_.size()) {
      const ir::Token& token = tokens_[at_++];
      const std::string_view written = token.span.in(text_);
      if (token.kind == ir::TokenKind::eob) {
        if (written != ";") ++line_;
        break;
      }
      folder_line |= written == "&";
      if (folder_line) continue;
      const bool after_comma = std::exchange(comma, written == "," || (comma && token.kind == ir::TokenKind::white));
      if (token.kind == ir::TokenKind::address && after_comma) {
        letter = 0;  // ,C ,R ,A: a corner or an angle
      } else if (token.kind == ir::TokenKind::address) {
        letter = written.front();
        block.letters.set(static_cast<std::size_t>(letter - 'A'));
      } else if (token.kind == ir::TokenKind::number) {
        number(block, letter, written);
        letter = 0;
      } else if (token.kind != ir::TokenKind::white && written != "-" && written != "+") {
        letter = 0;
      }
    }
    return block;
  }

 private:
  static void number(Block& block, char letter, std::string_view written) {
    if (letter == 'T') block.tool_digits = written.size();
    if (letter == 'T') block.tool_is_pair = written.size() == 4 && written.substr(0, 2) == written.substr(2);
    if (letter == 'H') block.h_has_point = written.contains('.');
    if (letter != 'G' && letter != 'M') return;
    const auto value = text::parse_number(written);
    if (!value || *value > 9999.0) return;
    (letter == 'G' ? block.g10 : block.m10).push_back(static_cast<std::int32_t>(std::lround(*value * 10.0)));
  }

  // Whole lines, each with all of its EOB. False: the text is used up.
  bool take_piece() {
    constexpr std::size_t kBytes = std::size_t{64} * 1024;
    std::size_t end = std::min(kBytes, rest_.size());
    do {
      end = std::min(rest_.find('\n', end), rest_.size() - 1) + 1;
    } while (end < rest_.size() && rest_[end] == '\r');
    text_ = rest_.substr(0, end);
    rest_.remove_prefix(text_.size());
    tokens_.clear();
    at_ = 0;
    lex(text_, grammar_, tokens_);
    return !tokens_.empty();
  }

  std::string_view rest_;
  const Grammar& grammar_;
  std::string_view text_;  // that the tokens are of
  std::vector<ir::Token> tokens_;
  std::size_t at_ = 0;
  std::uint32_t line_ = 1;
};

bool is_lathe(const Block& b) {
  const bool turning_cycle = std::ranges::any_of(b.g10, [](std::int32_t g) { return g >= 700 && g <= 760; });
  if (b.tool_digits == 4 && !b.m(6)) return true;
  const bool length = b.g(43) || b.g(44) || b.g(49) || b.has('D');
  if (b.h_has_point && !length && !b.is_call() && !b.has('Y')) return true;
  if (b.g(32) || (b.g(50) && b.has('S'))) return true;
  if (turning_cycle && ((b.has('P') && b.has('Q') && !b.has('Y')) || (b.has('U') && b.has('R')))) return true;
  // With G90 or G91 in the block a U or W alone is an axis of its own: U and W of lathes are increments. G17 with U
  // chooses among parallel axes.
  const bool single = !b.has('X') && !b.has('Z') && b.has('U') != b.has('W');
  const bool alone = ((b.g(90) || b.g(91)) && single) || b.g(17);
  return !b.is_call() && !b.has('Y') && (b.has('U') || b.has('W')) && !alone && !b.g(28) && !b.g(30);
}

bool changes_by_code(const Block& b) { return b.m(6) && !b.tool_is_pair; }
bool is_mill(const Block& b) {
  if (b.is_call()) return false;
  const bool drilling = (b.g(81) || b.g(82) || b.g(73)) && b.has('R');
  return b.has('Y') || b.g(43) || b.g(44) || changes_by_code(b) || drilling;
}
// A few lathes change their tools by M06, too.
bool is_mill_by_change(Block b) {
  const bool changes = changes_by_code(b);
  b.m10.clear();
  return changes && !is_mill(b);
}
bool cuts_shape(const Block& b) { return (b.g(70) || b.g(71) || b.g(72)) && b.has('P') && b.has('Q') && !b.has('Y'); }
bool hints_at_mill(const Block& b) { return !b.is_call() && (b.g(49) || b.g(17)); }

using SystemLines = std::array<ir::SystemEvidence, 3>;  // the first line for each system

// What the block says of the system, and what it only hints at; each code may be of another one.
void note_systems(const Block& b, SystemLines& lines, SystemLines& hints) {
  const auto add = [&](SystemLines& to, ir::GSystem system, bool says, std::string_view code) {
    ir::SystemEvidence& first = to[static_cast<std::size_t>(system)];
    if (says && first.line == 0) first = {system, b.line, std::string(code)};
  };
  const auto note = [&](ir::GSystem system, bool says, std::string_view code) { add(lines, system, says, code); };
  const auto hint = [&](ir::GSystem system, bool says, std::string_view code) { add(hints, system, says, code); };
  const bool words = b.has('X') || b.has('Z') || b.has('U') || b.has('W') || b.has('P') || b.has('R');
  const bool drills = std::ranges::any_of(b.g10, [](std::int32_t g) { return g >= 800 && g <= 890; });
  note(ir::GSystem::c, b.g(70) && !words, "G70");
  note(ir::GSystem::c, b.g(71) && !words, "G71");
  note(ir::GSystem::c, b.g(24), "G24");
  note(ir::GSystem::b, b.g(91), "G91");
  note(ir::GSystem::b, b.g(95), "G95");
  note(ir::GSystem::b, b.g(33), "G33");
  note(ir::GSystem::b, b.g(92) && b.has('S') && !words, "G92 S");
  hint(ir::GSystem::b, b.g(90) && !words, "G90");
  hint(ir::GSystem::b, b.g(94) && !words, "G94");
  note(ir::GSystem::a, b.g(50) && b.has('S'), "G50 S");
  note(ir::GSystem::a, b.g(32), "G32");
  hint(ir::GSystem::a, b.g(98) && !drills, "G98");
  hint(ir::GSystem::a, b.g(99) && !drills, "G99");
  note(ir::GSystem::a, !b.is_call() && b.has('U'), "U");
  note(ir::GSystem::a, !b.is_call() && b.has('W'), "W");
}

// Those that are named, the earliest first. Systems B and C differ in other codes than these.
std::vector<ir::SystemEvidence> named_systems(const SystemLines& lines) {
  std::vector<ir::SystemEvidence> named;
  for (const ir::SystemEvidence& one : lines)
    if (one.line != 0) named.push_back(one);
  std::ranges::stable_sort(named, {}, &ir::SystemEvidence::line);
  return named;
}

// What all blocks together say.
struct Evidence {
  std::optional<ir::MachineKind> kind;
  std::uint32_t kind_line = 0;
  bool by_change = false;  // … a mill by M06 alone
  std::uint32_t mill_hint_line = 0;
  bool is_mill_turn = false;
  std::uint32_t profile_line = 0;  // first block with X and Z
  bool has_y = false;
  SystemLines systems;
  SystemLines hints;     // of the system, where nothing says it
  std::bitset<26> axes;  // letters of blocks that are no calls
};

Evidence evidence_of(const text::Source& source, const Grammar& grammar) {
  Evidence e;
  BlockScan scan(source, grammar);
  while (const auto block = scan.next()) {
    if (!e.kind && is_lathe(*block)) e.kind = ir::MachineKind::lathe, e.kind_line = block->line;
    if (!e.kind && is_mill(*block)) {
      e.kind = ir::MachineKind::mill, e.kind_line = block->line;
      e.by_change = is_mill_by_change(*block);
    } else if (e.by_change && !e.has_y && !e.is_mill_turn && cuts_shape(*block)) {
      e.kind = ir::MachineKind::lathe, e.kind_line = block->line;
      e.by_change = false;
    }
    if (e.mill_hint_line == 0 && hints_at_mill(*block)) e.mill_hint_line = block->line;
    const bool mill_turn = std::ranges::any_of(block->g10, [&codes = grammar.mill_turn_codes](std::int32_t g) {
      return std::ranges::find(codes, g) != codes.end();
    });
    if (mill_turn) {
      e.kind = ir::MachineKind::mill_turn;
      if (!std::exchange(e.is_mill_turn, true)) e.kind_line = block->line;
    }
    note_systems(*block, e.systems, e.hints);
    if (block->is_call()) continue;
    e.axes |= block->letters;
    e.has_y |= block->has('Y');
    if (e.profile_line == 0 && block->has('X') && block->has('Z')) e.profile_line = block->line;
  }
  return e;
}

std::string axes_of(const Evidence& e, const ir::Control& usual) {
  const bool mill = usual.kind == ir::MachineKind::mill;
  std::string axes;
  for (const char letter : ir::kAxisLetters) {
    const bool used = e.axes[static_cast<std::size_t>(letter - 'A')];
    const bool increment_used = letter == 'C' && !mill && e.axes['H' - 'A'];
    const bool may_be_axis = mill || letter < 'U' || letter > 'W';
    if (usual.axes.contains(letter) || (used && may_be_axis) || increment_used) axes.push_back(letter);
  }
  return axes;
}

}  // namespace

ir::Control infer_control(const text::Source& source, const Grammar& grammar, UsualControl control) {
  Evidence e = evidence_of(source, grammar);
  if (!e.kind && e.mill_hint_line != 0) {
    e.kind = ir::MachineKind::mill;
    e.kind_line = e.mill_hint_line;
  }
  const bool profile = !e.kind && e.profile_line != 0 && !e.has_y;
  const ir::MachineKind kind = profile ? ir::MachineKind::lathe : e.kind.value_or(ir::MachineKind::mill);
  std::vector<ir::SystemEvidence> systems = named_systems(e.systems);
  if (systems.empty()) systems = named_systems(e.hints);
  // Nothing decides between two: A is the usual one, and whoever uses the control says that it is not certain.
  const bool is_clear = systems.size() == 1;
  ir::Control result = control(kind, is_clear ? systems.front().system : ir::GSystem::a);
  if (kind == ir::MachineKind::lathe && systems.size() > 1) result.contradiction = {systems[0], systems[1]};
  result.because_line = profile ? e.profile_line : e.kind_line;
  result.axes = axes_of(e, result);
  return result;
}

}  // namespace dripfeed::macro_b
