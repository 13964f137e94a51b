// Codes by what they do, words by what they mean. Each block's codes and words are rewritten; a code gets the name
// by which SINUMERIK calls it, so that the printer needs no table.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "dialects/ir/axis_letters.h"
#include "dialects/ir/frame_use.h"
#include "dialects/ir/idle_code.h"
#include "dialects/ir/transformation_use.h"
#include "dialects/passes/refusal.h"
#include "dialects/sinumerik/tables/code_names.h"
#include "dialects/sinumerik/tables/codes.h"
#include "dialects/sinumerik/tables/name_index.h"
#include "dialects/sinumerik/writer/raise.h"
#include "dialects/sinumerik/writer/tool_offsets.h"
#include "dialects/text/number.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;
using ir::StatementKind;

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
bool is_angle(Address a) { return ir::is_rotary_axis(a) || a == Address::direct_angle; }

class BlockRaiser {
 public:
  explicit BlockRaiser(const Raising& raising)
      : raising_(raising),
        program_(raising.program),
        tools_(raising),
        inch_(raising.from.semantics.power_on_unit == Function::unit_inch) {}

  void run() {
    old_codes_.swap(program_.codes);
    old_words_.swap(program_.words);
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      const ir::Statement& s = program_.statements[i];
      const bool ends = s.kind == StatementKind::program_end;
      if (s.kind != StatementKind::block && !(ends && s.payload != ir::kNoIndex)) continue;
      rewrite(i, program_.blocks[s.payload], s.span);
    }
  }

 private:
  void rewrite(std::uint32_t statement, ir::Block& block, text::Span span) {
    const ir::Block old = block;
    if (old.rest_level != 0) raising_.cannot(passes::at_switch("block skip inside a block"), span);
    codes_ = std::span(old_codes_).subspan(old.first_code, old.code_count);
    words_ = std::span(old_words_).subspan(old.first_word, old.word_count);
    block.first_code = static_cast<std::uint32_t>(program_.codes.size());
    block.first_word = static_cast<std::uint32_t>(program_.words.size());
    dwell_ = has(Function::dwell);
    loses_code_ = false;
    if (has(Function::unit_inch)) inch_ = true;
    if (has(Function::unit_mm)) inch_ = false;
    tools_.begin_block(statement, block.first_word, codes_, words_);
    for (const ir::Code& c : codes_) code(c);
    for (const ir::Code& c : codes_) {
      if (c.group != ModalGroup::motion) continue;
      arc_is_modal_ = c.function == Function::arc_cw || c.function == Function::arc_ccw;
      thread_is_modal_ = c.function == Function::thread || c.function == Function::thread_changing;
      lead_changes_ = c.function == Function::thread_changing;
    }
    if (lead_changes_ && !raising_.is_own() && moves()) changing_thread(span);
    for (const ir::Word& w : words_) word(w);
    tools_.end_block(span);
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
        raising_.cannot(passes::together("the second word of one address in a block"), words[i].span);
    }
  }

  [[nodiscard]] bool has(Function function) const {
    return std::ranges::find(codes_, function, &ir::Code::function) != codes_.end();
  }
  [[nodiscard]] const ir::Word* find(Address address) const {
    const auto found = std::ranges::find(words_, address, &ir::Word::address);
    return found == words_.end() ? nullptr : &*found;
  }

  [[nodiscard]] bool moves() const { return std::ranges::any_of(words_, ir::is_axis, &ir::Word::address); }

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
      add(c, name_of_code(c));
    } else if (c.function == Function::transformation) {
      raising_.cannot(written, c.span);  // its arguments are no words
    } else if (c.function == Function::not_modelled || c.function == Function::no_effect ||
               c.function == Function::other_spindle || c.function == Function::main_spindle) {
      program_.codes.push_back(c);  // by their names
    } else {
      add(c, name_of_code(c));
    }
  }

  void code(const ir::Code& c) {
    if (c.number != ir::ExpressionId::none) {
      if (c.letter == 'M') return program_.codes.push_back(c);
      return raising_.cannot(passes::computed("a computed G code"), c.span);
    }
    if (is_fixed_point(c)) return program_.codes.push_back(c);  // settled
    if (raising_.is_own()) return own_code(c);
    if (c.function == Function::transformation && raising_.program.strings.at(c.name).starts_with("TRA"))
      return program_.codes.push_back(c);  // settled
    if (c.function == Function::transformation && begins_by_y()) return transformation(c);
    // What would begin it is refused: by itself it ends nothing.
    if (c.function == Function::transformation && c.argument == ir::kTransformationEnds) return;
    if (c.function == Function::no_effect || c.function == Function::continuous_path) warn_of_lost_code(c);
    if (std::ranges::find(kNeedless, c.function) != std::end(kNeedless)) return;
    if (ir::ends_frame(c.function, c.argument)) return;
    if (c.function == Function::thread_changing) return;  // written in each block that moves
    if (c.function == Function::length_offset_plus) return tools_.length_on(c);
    if (c.function == Function::length_offset_off) return tools_.length_off(c);
    if (c.function == Function::set_coordinates && speed_limit()) return;
    const std::string name = name_of_code(c);
    if (name.empty()) {
      const std::string_view written = raising_.text_of(c.span);
      return raising_.cannot(written.empty() ? std::string(ir::name_of(c.function)) : std::string(written), c.span);
    }
    add(c, name);
  }

  // Of a program that was built: its faces and cylinders are those of here, without a name.
  [[nodiscard]] bool begins_by_y() const {
    return std::ranges::any_of(old_codes_, [](const ir::Code& c) {
      return c.function == Function::transformation && c.name == ir::StringId::none &&
             (c.argument == ir::kFaceByY || c.argument == ir::kCylinderByY);
    });
  }
  void transformation(const ir::Code& c) {
    if (c.argument == ir::kTransformationEnds) return add(c, "TRAFOOF");
    if (c.argument == ir::kFaceByY) return add(c, "TRANSMIT");
    const ir::Word* diameter = find(Address::r);
    const std::optional<double> value = diameter == nullptr ? std::nullopt : literal(*diameter);
    if (!value) return raising_.cannot(passes::computed("a cylinder whose diameter is computed"), c.span);
    add(c, fmt::format("TRACYL({})", text::format_shortest(*value)));
  }

  // Look-ahead, smoothing, high precision of the other control, with their words.
  void warn_of_lost_code(const ir::Code& c) {
    if (c.name == ir::StringId::none || c.group == ModalGroup::frame) return;
    loses_code_ = true;
    raising_.cannot(std::string(program_.strings.at(c.name)), c.span);
    raising_.diagnostics.back().severity = text::Severity::warning;
  }

  // G34 or G35 by the sign of the change, G33 where it is 0. The lead and its change are stated in each block.
  void changing_thread(text::Span span) {
    const ir::Word* k = find(Address::k);
    const std::optional<double> change = k == nullptr ? std::nullopt : literal(*k);
    if (!change)
      return raising_.cannot(passes::not_known("a thread whose lead changes by a value that its block does not state"),
                             span);
    if (find(Address::f) == nullptr && find(Address::i) == nullptr)
      return raising_.cannot(passes::not_known("a thread whose lead changes, without its lead in the block"), span);
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

  ir::ExpressionId constant(double value) { return program_.add_constant(value, {}, false); }

  void word(ir::Word w) {
    if (raising_.is_own()) return program_.words.push_back(w);
    const ir::Semantics& from = raising_.from.semantics;
    if (w.value == ir::ExpressionId::none) return;
    if (std::ranges::any_of(codes_, is_fixed_point)) return program_.words.push_back(w);
    if (loses_code_ && ir::is_word_of_idle_code(w.address)) return;
    if (dwell_) return dwell_word(w);
    if (w.address == Address::r && has(Function::transformation)) return;  // in its brackets
    w.value = in_units(w);
    incremental_letter(w, raising_.from);
    const bool no_address = w.address == Address::other || w.address == Address::e || w.address == Address::l ||
                            w.address == Address::o || w.address == Address::p || w.address == Address::q;
    if (no_address) return raising_.cannot("the word " + std::string(raising_.text_of(w.span)), w.span);
    if (w.address == Address::t) return tools_.tool(w);
    if (w.address == Address::h && has(Function::length_offset_plus)) return;
    if (w.address == Address::h && tools_.follows_spindle()) return tools_.length_number(w);
    // A compensation number of the other control is the edge of its own tool here.
    if (w.address == Address::d && !from.d_selects_edge) return tools_.compensation_number(w);
    if (w.address == Address::s && has(Function::set_coordinates)) w.address = Address::spindle_limit;
    // A thread's lead is K along Z and I along X here, F elsewhere.
    if (lead_changes_ && !moves() && w.address == Address::f)
      return raising_.cannot(passes::together("a feed that is given while the lead of a thread changes"), w.span);
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

  const Raising& raising_;
  ir::Program& program_;
  ToolOffsets tools_;
  std::vector<ir::Code> old_codes_;
  std::vector<ir::Word> old_words_;
  std::span<const ir::Code> codes_;
  std::span<const ir::Word> words_;
  // In the order of the text.
  bool inch_;
  bool dwell_ = false;
  bool loses_code_ = false;
  bool arc_is_modal_ = false;
  bool thread_is_modal_ = false;
  bool lead_changes_ = false;  // … by G34
};

}  // namespace

void incremental_letter(ir::Word& w, const ir::Control& from) {
  const std::optional<char> axis = ir::incremented_axis(from, ir::letter_of(w.address));
  if (!axis) return;
  w.address = static_cast<Address>(*axis - 'A');
  w.mode = ir::WordMode::incremental;
}

void raise_blocks(const Raising& raising) { BlockRaiser(raising).run(); }

}  // namespace dripfeed::sinumerik
