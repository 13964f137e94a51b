// Codes by what they do, words by what they mean. Each block's codes and words are written anew; a code gets the name
// by which SINUMERIK calls it, so that the printer needs no table.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "dialects/ir/frame_use.h"
#include "dialects/ir/transformation_use.h"
#include "dialects/passes/rigid_taps.h"
#include "dialects/passes/tool_flow.h"
#include "dialects/sinumerik/codes.h"
#include "dialects/sinumerik/name_index.h"
#include "dialects/sinumerik/raise.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;
using ir::StatementKind;

struct CodeName {
  Function function;
  std::string_view name;
};
// Functions with one name, whatever their argument.
constexpr auto kNames = std::to_array<CodeName>({
    {Function::rapid, "G0"},
    {Function::linear, "G1"},
    {Function::arc_cw, "G2"},
    {Function::arc_ccw, "G3"},
    {Function::thread, "G33"},
    {Function::tap, "G331"},
    {Function::tap_retract, "G332"},
    {Function::dwell, "G4"},
    {Function::exact_stop_once, "G9"},
    {Function::exact_stop_mode, "G60"},
    {Function::continuous_path, "G64"},
    {Function::plane_xy, "G17"},
    {Function::plane_zx, "G18"},
    {Function::plane_yz, "G19"},
    {Function::unit_inch, "G700"},
    {Function::unit_mm, "G710"},
    {Function::absolute, "G90"},
    {Function::incremental, "G91"},
    {Function::feed_per_min, "G94"},
    {Function::feed_per_rev, "G95"},
    {Function::feed_inverse_time, "G93"},
    {Function::diameter_on, "DIAMON"},
    {Function::diameter_off, "DIAMOF"},
    {Function::diameter_absolute_only, "DIAM90"},
    {Function::machine_coordinates, "SUPA"},
    {Function::local_shift, "TRANS"},
    {Function::local_shift_add, "ATRANS"},
    {Function::comp_off, "G40"},
    {Function::comp_left, "G41"},
    {Function::comp_right, "G42"},
    {Function::tool_change, "M6"},
    {Function::surface_speed_on, "G96"},
    {Function::surface_speed_off, "G97"},
    {Function::spindle_cw, "M3"},
    {Function::spindle_ccw, "M4"},
    {Function::spindle_stop, "M5"},
    {Function::spindle_orient, "M19"},
    {Function::coolant_mist, "M7"},
    {Function::coolant_flood, "M8"},
    {Function::coolant_off, "M9"},
    {Function::program_stop, "M0"},
    {Function::optional_stop, "M1"},
    {Function::program_end, "M2"},
    {Function::program_end_rewind, "M30"},
    {Function::subprogram_end, "M17"},
});

// What the other controls need and SINUMERIK does without: cycles are off, a tool's length acts with its edge.
constexpr Function kNeedless[] = {Function::cycle_off, Function::return_to_initial, Function::return_to_r,
                                  Function::no_effect};

bool is_length(Address a) {
  return a == Address::x || a == Address::y || a == Address::z || a == Address::u || a == Address::v ||
         a == Address::w || a == Address::i || a == Address::j || a == Address::k || a == Address::r;
}
// G75, with the words that it wants.
bool is_fixed_point(const ir::Code& c) {
  return c.function == Function::reference_return && c.name != ir::StringId::none;
}
bool is_angle(Address a) { return a <= Address::c || a == Address::direct_angle; }

class BlockRaiser {
 public:
  explicit BlockRaiser(const Raising& raising)
      : raising_(raising),
        program_(raising.program),
        inch_(raising.from.semantics.power_on_unit == Function::unit_inch) {
    if (raising.is_own() || raising.from.semantics.tool_word != ir::ToolWord::number) return;
    const passes::ToolFlow flow(program_);
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      const passes::ToolState* before = flow.before(i);
      tools_.push_back(before == nullptr ? passes::ToolState() : flow.after(i, *before));
    }
  }

  void run() {
    old_codes_.swap(program_.codes);
    old_words_.swap(program_.words);
    for (index_ = 0; index_ < program_.statements.size(); ++index_) {
      const ir::Statement& s = program_.statements[index_];
      const bool ends = s.kind == StatementKind::program_end;
      if (s.kind != StatementKind::block && !(ends && s.payload != ir::kNoIndex)) continue;
      rewrite(program_.blocks[s.payload], s.span);
    }
  }

 private:
  void rewrite(ir::Block& block, text::Span span) {
    const ir::Block old = block;
    if (old.rest_level != 0) raising_.cannot("block skip inside a block", span);
    codes_ = std::span(old_codes_).subspan(old.first_code, old.code_count);
    words_ = std::span(old_words_).subspan(old.first_word, old.word_count);
    block.first_code = static_cast<std::uint32_t>(program_.codes.size());
    block.first_word = first_word_ = static_cast<std::uint32_t>(program_.words.size());
    dwell_ = has(Function::dwell);
    if (has(Function::unit_inch)) inch_ = true;
    if (has(Function::unit_mm)) inch_ = false;
    follow_offsets();
    for (const ir::Code& c : codes_) code(c);
    for (const ir::Code& c : codes_) {
      if (c.group != ModalGroup::motion) continue;
      arc_is_modal_ = c.function == Function::arc_cw || c.function == Function::arc_ccw;
      thread_is_modal_ = c.function == Function::thread || c.function == Function::thread_changing;
      lead_changes_ = c.function == Function::thread_changing;
    }
    if (lead_changes_ && !raising_.is_own() && moves()) changing_thread(span);
    for (const ir::Word& w : words_) word(w);
    if (!tools_.empty() && find(Address::d) == nullptr) numberless_compensation(span);
    if (!raising_.is_own()) doubled(block.first_word);
    block.code_count = static_cast<std::uint32_t>(program_.codes.size()) - block.first_code;
    block.word_count = static_cast<std::uint32_t>(program_.words.size()) - block.first_word;
  }

  // X and U of one lathe block would both be X.
  void doubled(std::uint32_t first_word) {
    const auto words = std::span(program_.words).subspan(first_word);
    for (std::size_t i = 1; i < words.size(); ++i) {
      const auto same = [&](const ir::Word& w) {
        return w.address == words[i].address && w.extension == words[i].extension && w.address != Address::other;
      };
      if (std::ranges::any_of(words.first(i), same))
        raising_.cannot("the second word of one address in a block", words[i].span);
    }
  }

  [[nodiscard]] bool has(Function function) const {
    return std::ranges::find(codes_, function, &ir::Code::function) != codes_.end();
  }
  [[nodiscard]] const ir::Word* find(Address address) const {
    const auto found = std::ranges::find(words_, address, &ir::Word::address);
    return found == words_.end() ? nullptr : &*found;
  }

  [[nodiscard]] bool moves() const {
    return std::ranges::any_of(words_, [](const ir::Word& w) {
      return (w.address >= Address::u && w.address <= Address::z) || w.address <= Address::c;
    });
  }

  void add(ir::Code code, std::string_view name) {
    code.name = program_.strings.add(name);
    program_.codes.push_back(code);
  }
  void add_word(Address address, ir::ExpressionId value, text::Span span) {
    ir::Word w;
    w.address = address;
    w.value = value;
    w.span = span;
    program_.words.push_back(w);
  }

  // Codes of the own language keep what they are called: G642 and G64 do the same here and not on the machine.
  void own_code(const ir::Code& c) {
    std::string written;
    for (const char ch : raising_.text_of(c.span))
      if (ch != ' ' && ch != '\t') written += to_upper(ch);
    const bool is_m = c.letter == 'M' && written.find_first_not_of("M0123456789") == std::string::npos;
    const GCode* row = find_code_as_written(written);
    if (row != nullptr && row->row.function != c.function) return;  // the feed mode that G96 brings along
    if (row != nullptr) {
      add(c, row->row.name);
    } else if (is_m && c.function != Function::machine_function) {
      add(c, name_of(c));
    } else if (c.function == Function::transformation) {
      raising_.cannot(written, c.span);  // its arguments are no words
    } else if (c.function == Function::not_modelled || c.function == Function::no_effect) {
      program_.codes.push_back(c);
    } else {
      add(c, name_of(c));
    }
  }

  [[nodiscard]] std::string name_of(const ir::Code& c) const {
    if (c.function == Function::work_offset) return name_of_offset(c.argument);
    if (c.function == Function::machine_function) return "M" + std::to_string(c.argument);
    if (const std::string_view frame = name_of_frame(c); !frame.empty()) return std::string(frame);
    if (passes::is_floating_tap(c)) return "G63";
    if (c.function == Function::unit_inch && c.argument == 1) return "G70";
    if (c.function == Function::unit_mm && c.argument == 1) return "G71";
    const auto row = std::ranges::find(kNames, c.function, &CodeName::function);
    return row == kNames.end() ? std::string() : std::string(row->name);
  }

  static std::string_view name_of_frame(const ir::Code& c) {
    struct Row {
      Function function;
      std::string_view adds;
      std::string_view replaces;
    };
    static constexpr Row kFrames[] = {{Function::rotate, "AROT", "ROT"},
                                      {Function::scale, "ASCALE", "SCALE"},
                                      {Function::mirror, "AMIRROR", "MIRROR"}};
    const auto* const row = std::ranges::find(kFrames, c.function, &Row::function);
    if (row == std::end(kFrames)) return {};
    return c.argument == ir::kFrameAdds ? row->adds : c.argument == ir::kFrameReplaces ? row->replaces : "";
  }

  // G54 to G57; the fifth and sixth of the others are G505 and G506, and their further ones (above 100) follow those.
  static std::string name_of_offset(int number) {
    constexpr int kExtended = 100;
    constexpr int kLast = 99;
    const int own = number > kExtended ? number - kExtended + 6 : number;
    if (own < 0 || own > kLast) return {};
    if (own == 0) return "G500";
    return "G" + std::to_string(own <= 4 ? 53 + own : 500 + own);
  }

  void code(const ir::Code& c) {
    if (c.number != ir::ExpressionId::none) {
      if (c.letter == 'M') return program_.codes.push_back(c);
      return raising_.cannot("a computed G code", c.span);
    }
    if (is_fixed_point(c)) return program_.codes.push_back(c);  // settled
    if (raising_.is_own()) return own_code(c);
    if (c.function == Function::transformation && raising_.program.strings.at(c.name).starts_with("TRA"))
      return program_.codes.push_back(c);  // settled
    // What would begin it is refused: by itself it ends nothing.
    if (c.function == Function::transformation && c.argument == ir::kTransformationEnds) return;
    if (std::ranges::find(kNeedless, c.function) != std::end(kNeedless)) return;
    if (ir::ends_frame(c.function, c.argument)) return;
    if (c.function == Function::thread_changing) return;  // written in each block that moves
    if (c.function == Function::length_offset_plus) return length_offset(c);
    if (c.function == Function::length_offset_off) return add_word(Address::d, constant(0.0), c.span);
    if (c.function == Function::set_coordinates && speed_limit()) return;
    const std::string name = name_of(c);
    if (name.empty()) {
      const std::string_view written = raising_.text_of(c.span);
      return raising_.cannot(written.empty() ? std::string(ir::name_of(c.function)) : std::string(written), c.span);
    }
    add(c, name);
  }

  // G34 or G35 by the sign of the change, G33 where it is 0. The lead and its change are said in each block.
  void changing_thread(text::Span span) {
    const ir::Word* k = find(Address::k);
    const std::optional<double> change = k == nullptr ? std::nullopt : literal(*k);
    if (!change) return raising_.cannot("a thread whose lead changes by a value that its block does not say", span);
    if (find(Address::f) == nullptr && find(Address::i) == nullptr)
      return raising_.cannot("a thread whose lead changes, without its lead in the block", span);
    ir::Code code;
    code.function = Function::thread_changing;
    code.group = ModalGroup::motion;
    code.letter = 'G';
    code.span = span;
    add(code, *change > 0.0 ? "G34" : *change < 0.0 ? "G35" : "G33");
  }
  // A number as it is written, with its sign and in the unit of lengths.
  [[nodiscard]] std::optional<double> literal(const ir::Word& w) const {
    if (w.value == ir::ExpressionId::none) return std::nullopt;
    const ir::Expression& e = program_.at(w.value);
    if (e.op == ir::Operator::constant) return e.value;
    if (e.op != ir::Operator::negate || program_.at(e.a).op != ir::Operator::constant) return std::nullopt;
    return -program_.at(e.a).value;
  }

  // G50 S3000, G92 S3000: a limit when no axis is in the block.
  [[nodiscard]] bool speed_limit() const {
    return find(Address::s) != nullptr &&
           std::ranges::none_of(words_, [](const ir::Word& w) { return is_length(w.address) || is_angle(w.address); });
  }

  // G43 H6 is edge 1 of tool 6: lengths belong to the tool here. Another number than the tool's is another tool's
  // length.
  void length_offset(const ir::Code& c) {
    const ir::Word* h = find(Address::h);
    if (h == nullptr) return raising_.cannot("G43 whose H was said before", c.span);
    const bool constant_h = program_.at(h->value).op == ir::Operator::constant;
    if (!constant_h) return raising_.cannot("a tool length with a computed number", c.span);
    const double number = program_.at(h->value).value;
    if (number == 0.0) {
      length_ = Length::off;
      return add_word(Address::d, constant(0.0), h->span);
    }
    if (is_tool(number, "the length offset of another tool", h->span)) add_edge(h->span);
  }

  // Whether the number is that of the tool in the spindle; otherwise it is told.
  bool is_tool(double number, std::string_view otherwise, text::Span span) {
    if (tools_.empty()) {
      if (number != tool_) raising_.cannot(std::string(otherwise), span);
      return number == tool_;
    }
    using Known = passes::ToolState::Known;
    const passes::ToolState& state = tools_[index_];
    if (state.in.known == Known::differs) {
      raising_.cannot("an offset beside a tool that is not known here, or not the same on all ways here,", span);
      return false;
    }
    const ir::Expression* tool = state.in.known == Known::tool ? &program_.at(state.in.value) : nullptr;
    const bool same = tool != nullptr && tool->op == ir::Operator::constant && tool->value == number;
    if (!same) raising_.cannot(std::string(otherwise), span);
    if (same && state.caller != ir::kNoIndex) {
      raising_.report(text::DiagnosticId::unknown_modal_state, span,
                      {"the tool in the spindle", "it is taken as the one of T above, which what line " +
                                                      std::to_string(program_.statements[state.caller].line) +
                                                      " calls may have changed"});
      raising_.diagnostics.back().severity = text::Severity::warning;
    }
    return same;
  }

  ir::ExpressionId constant(double value) { return program_.add_constant(value, {}, false); }

  void word(ir::Word w) {
    if (raising_.is_own()) return program_.words.push_back(w);
    const ir::Semantics& from = raising_.from.semantics;
    if (w.value == ir::ExpressionId::none) return;
    if (std::ranges::any_of(codes_, is_fixed_point)) return program_.words.push_back(w);
    if (dwell_) return dwell_word(w);
    w.value = in_units(w);
    if (from.incremental_letters_uvw) incremental_letter(w);
    const bool no_address = w.address == Address::other || w.address == Address::e || w.address == Address::l ||
                            w.address == Address::o || w.address == Address::p || w.address == Address::q;
    if (no_address) return raising_.cannot("the word " + std::string(raising_.text_of(w.span)), w.span);
    if (w.address == Address::t) return tool_word(w);
    if (w.address == Address::h && has(Function::length_offset_plus)) return;
    if (w.address == Address::h && !tools_.empty()) return modal_length(w);
    // A compensation number of the other control is the edge of its own tool here.
    if (w.address == Address::d && !from.d_selects_edge) return edge(w);
    if (w.address == Address::s && has(Function::set_coordinates)) w.address = Address::spindle_limit;
    // A thread's lead is K along Z and I along X here, F elsewhere.
    if (lead_changes_ && !moves() && w.address == Address::f)
      return raising_.cannot("a feed that is given while the lead of a thread changes", w.span);
    if (lead_changes_ && moves() && w.address == Address::k) {
      w.address = Address::f;
      w.value = program_.add_constant(std::abs(literal(w).value_or(0.0)), w.span);
      if (program_.at(w.value).value == 0.0) return;  // G33
    } else if (w.address == Address::f && thread_is_modal_ && moves()) {
      const bool along_z = find(Address::z) != nullptr || (from.incremental_letters_uvw && find(Address::w) != nullptr);
      w.address = along_z ? Address::k : Address::i;
    }
    if (w.address == Address::r && from.arc_radius_is_r) {
      if (!arc_is_modal_) return raising_.cannot("the word R", w.span);
      w.address = Address::arc_radius;
    }
    program_.words.push_back(w);
  }

  // X100 without a point is 100 increments on a machine that is set so.
  ir::ExpressionId in_units(const ir::Word& w) {
    const ir::Semantics& from = raising_.from.semantics;
    const ir::Expression e = program_.at(w.value);
    if (from.decimal_mode != ir::DecimalMode::least_increment || e.op != ir::Operator::constant || e.has_point)
      return w.value;
    // Ten times finer in inch: X1000 is 0.1 inch where it is 1 mm.
    const double per_unit = std::nearbyint(1.0 / from.least_increment_mm) * (inch_ ? 10.0 : 1.0);
    if (is_length(w.address)) return program_.add_constant(e.value / per_unit, e.span);
    if (is_angle(w.address)) return program_.add_constant(e.value * from.least_increment_deg, e.span);
    return w.value;
  }

  // G4 F seconds. The others say P milliseconds, or X or U seconds.
  void dwell_word(const ir::Word& w) {
    const ir::Semantics& from = raising_.from.semantics;
    const ir::Expression e = program_.at(w.value);
    const bool per_thousand = w.address == Address::p || ((w.address == Address::x || w.address == Address::u) &&
                                                          from.decimal_mode == ir::DecimalMode::least_increment &&
                                                          e.op == ir::Operator::constant && !e.has_point);
    const bool seconds_word = w.address == Address::p || w.address == Address::x || w.address == Address::u ||
                              w.address == Address::f || w.address == Address::s;
    if (!seconds_word) return raising_.cannot("a dwell by another word than its time", w.span);
    if (!from.dwell_p_is_ms || !(per_thousand || w.address == Address::x || w.address == Address::u))
      return program_.words.push_back(w);
    if (!per_thousand) return add_word(Address::f, w.value, w.span);
    const ir::ExpressionId seconds =
        e.op == ir::Operator::constant ? program_.add_constant(e.value / 1000.0, e.span)
                                       : program_.add_operator(ir::Operator::divide, w.value, constant(1000.0), e.span);
    add_word(Address::f, seconds, w.span);
  }

  void tool_word(const ir::Word& w) {
    const ir::Expression e = program_.at(w.value);
    const bool number = e.op == ir::Operator::constant;
    if (number) tool_ = e.value;
    if (raising_.from.semantics.tool_word != ir::ToolWord::number_and_offset) {
      program_.words.push_back(w);
      return;
    }
    if (!number) return raising_.cannot("a computed tool word", w.span);
    // T0606: tool 6 with its own offset is edge 1, T0600 is no offset; the offset of another tool has no counterpart.
    const auto both = static_cast<std::int64_t>(e.value);
    const std::int64_t tool = both / 100;
    const std::int64_t offset = both % 100;
    tool_ = static_cast<double>(tool);
    if (tool != 0) add_word(Address::t, constant(static_cast<double>(tool)), w.span);
    if (offset == 0) return add_word(Address::d, constant(0.0), w.span);
    if (tool != 0 && offset != tool) return raising_.cannot("the offset of another tool", w.span);
    add_word(Address::d, constant(1.0), w.span);
  }

  // What is in effect, in the order of the text.
  void follow_offsets() {
    if (has(Function::length_offset_plus)) length_ = Length::on;
    if (has(Function::length_offset_off)) length_ = Length::off;
    if (has(Function::comp_off)) compensates_ = false;
    if (starts_compensation()) compensates_ = true;
  }
  [[nodiscard]] bool starts_compensation() const { return has(Function::comp_left) || has(Function::comp_right); }

  // The radius of the tool in the spindle needs no number here. D0 would take its length away, too, and another D bring
  // it in.
  void edge(const ir::Word& w) {
    const ir::Expression e = program_.at(w.value);
    constexpr std::string_view kOther = "a compensation number that is not the tool's";
    if (e.op != ir::Operator::constant) return raising_.cannot(std::string(kOther), w.span);
    number_ = e.value;
    if (e.value == 0.0) {
      if (compensates_) raising_.cannot("compensation without a radius (D0)", w.span);
      return;
    }
    if (!is_tool(e.value, kOther, w.span)) return;
    if (length_ == Length::off)
      return raising_.cannot("a radius where the length is off, which D would bring in again,", w.span);
    add_edge(w.span);
  }
  void numberless_compensation(text::Span span) {
    if (!starts_compensation() || !number_) return;
    if (*number_ == 0.0) return raising_.cannot("compensation without a radius (D0)", span);
    (void)is_tool(*number_, "the compensation number of another tool, which is still in effect,", span);
  }
  // D1, which a block says once.
  void add_edge(text::Span span) {
    const auto own = std::span(program_.words).subspan(first_word_);
    const bool is_said = std::ranges::any_of(
        own, [&](const ir::Word& w) { return w.address == Address::d && program_.at(w.value).value == 1.0; });
    if (!is_said) add_word(Address::d, constant(1.0), span);
  }

  // H behind G43: another length, or none.
  void modal_length(const ir::Word& w) {
    const ir::Expression e = program_.at(w.value);
    if (length_ != Length::on || e.op != ir::Operator::constant) return raising_.cannot("H without G43", w.span);
    if (e.value != 0.0) {
      (void)is_tool(e.value, "the length offset of another tool", w.span);
      return;
    }
    length_ = Length::off;
    add_word(Address::d, constant(0.0), w.span);
  }

  const Raising& raising_;
  ir::Program& program_;
  std::vector<ir::Code> old_codes_;
  std::vector<ir::Word> old_words_;
  std::span<const ir::Code> codes_;
  std::span<const ir::Word> words_;
  bool inch_;  // in the order of the text
  bool dwell_ = false;
  bool arc_is_modal_ = false;
  bool thread_is_modal_ = false;
  bool lead_changes_ = false;             // … by G34
  double tool_ = -1.0;                    // of T0606: the last one called, in the order of the text
  std::vector<passes::ToolState> tools_;  // behind each statement, where T is a number alone
  std::uint32_t index_ = 0;
  std::uint32_t first_word_ = 0;  // of the block at hand
  // In the order of the text.
  enum class Length : std::uint8_t { unsaid, on, off };
  Length length_ = Length::unsaid;
  bool compensates_ = false;
  std::optional<double> number_;  // of D
};

}  // namespace

void incremental_letter(ir::Word& w) {
  struct Letters {
    Address incremental;
    Address axis;
  };
  static constexpr Letters kLetters[] = {
      {Address::u, Address::x}, {Address::v, Address::y}, {Address::w, Address::z}, {Address::h, Address::c}};
  const auto* const row = std::ranges::find(kLetters, w.address, &Letters::incremental);
  if (row == std::end(kLetters)) return;
  w.address = row->axis;
  w.mode = ir::WordMode::incremental;
}

void raise_blocks(const Raising& raising) { BlockRaiser(raising).run(); }

}  // namespace dripfeed::sinumerik
