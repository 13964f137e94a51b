// Codes come first, then axes, the rest in the order of the block, M functions last.
#include "dialects/sinumerik/writer/print_block.h"

#include <algorithm>

#include "dialects/ir/axis_letters.h"
#include "dialects/ir/polynomial_words.h"
#include "dialects/sinumerik/sinumerik.h"
#include "dialects/sinumerik/tables/codes.h"
#include "dialects/sinumerik/tables/name_index.h"
#include "dialects/text/number.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Address;

constexpr int kPlainDecimals = 6;
constexpr int kComputedDecimals = 4;

bool is_of_axis(Address a) { return ir::is_axis(a) || a == Address::named_axis; }
// Values with a decimal point always: positions and what belongs to them.
bool has_point(Address a) {
  return is_of_axis(a) || (a >= Address::i && a <= Address::k) || a == Address::arc_radius || a == Address::chamfer ||
         a == Address::chamfer_length || (a >= Address::via_i && a <= Address::modal_rounding) ||
         a == Address::rounding || a == Address::named_axis;
}

std::string_view name_of(Address a) {
  switch (a) {
    case Address::arc_radius: return "CR";
    case Address::opening_angle: return "AR";
    case Address::spindle_limit: return "LIMS";
    case Address::polar_angle: return "AP";
    case Address::polar_radius: return "RP";
    case Address::turns: return "TURN";
    case Address::chamfer: return "CHR";
    case Address::chamfer_length: return "CHF";
    case Address::via_i: return "I1";
    case Address::via_j: return "J1";
    case Address::via_k: return "K1";
    case Address::modal_rounding: return "RNDM";
    case Address::frame_angle: return "RPL";
    case Address::measuring: return "MEAS";
    case Address::direct_angle: return "ANG";
    case Address::rounding: return "RND";
    case Address::contour_offset: return "OFFN";
    case Address::block_feed: return "FB";
    case Address::point_weight: return "PW";
    case Address::knot_distance: return "PL";
    case Address::spline_degree: return "SD";
    case Address::poly_x2:  // printed together: PO[X]=(…)
    case Address::poly_x3:
    case Address::poly_x4:
    case Address::poly_x5:
    case Address::poly_y2:
    case Address::poly_y3:
    case Address::poly_y4:
    case Address::poly_y5:
    case Address::poly_z2:
    case Address::poly_z3:
    case Address::poly_z4:
    case Address::poly_z5:
    case Address::named_axis:
    case Address::other_speed:  // printed as S with its number
    case Address::other:
    case Address::count_:
    case Address::a:
    case Address::b:
    case Address::c:
    case Address::d:
    case Address::e:
    case Address::f:
    case Address::g:
    case Address::h:
    case Address::i:
    case Address::j:
    case Address::k:
    case Address::l:
    case Address::m:
    case Address::n:
    case Address::o:
    case Address::p:
    case Address::q:
    case Address::r:
    case Address::s:
    case Address::t:
    case Address::u:
    case Address::v:
    case Address::w:
    case Address::x:
    case Address::y:
    case Address::z: return {};
  }
  return {};
}

void separated(std::string& out, const std::string& word) {
  if (word.empty()) return;
  if (!out.empty()) out += ' ';
  out += word;
}

// Computed values get the decimals that the trace has, and an inch one more than the control has for a millimetre;
// written ones keep theirs.
int decimals_of_position(bool computed, const ir::Control& control) {
  return std::max(control.limits.linear_decimals + 1, computed ? kComputedDecimals : kPlainDecimals);
}

bool is_coded_mode(std::string_view name) {
  constexpr std::string_view kModes[] = {"CAC", "CIC", "CDC", "CACP", "CACN", "DAC", "DIC", "RAC", "RIC"};
  return std::ranges::find(kModes, name) != std::end(kModes);
}

}  // namespace

void BlockPrinter::append(std::string& out, const ir::Block& b) const {
  const auto codes = program_.codes_of(b);
  const auto words = program_.words_of(b);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    // G96 was read as two codes of one place.
    const bool twin = i + 1 < codes.size() && !codes[i].span.empty() && codes[i].span == codes[i + 1].span;
    if (!is_m(codes[i]) && !twin) separated(out, code(codes[i]));
  }
  for (const ir::Word& w : words)
    if (is_of_axis(w.address)) separated(out, word(w, words));
  for (const ir::Word& w : words)
    if (!is_of_axis(w.address) && !ir::is_coefficient(w.address)) separated(out, word(w, words));
  for (const ir::Code& c : codes)
    if (is_m(c)) separated(out, code(c));
}

bool BlockPrinter::is_m(const ir::Code& c) const {
  if (c.name != ir::StringId::none) {
    const std::string_view name = program_.strings.at(c.name);
    return name.size() > 1 && name.front() == 'M' && is_digit(name[1]);
  }
  return c.letter == 'M';
}

std::string BlockPrinter::code(const ir::Code& c) const {
  if (c.name != ir::StringId::none) return std::string(program_.strings.at(c.name));
  if (c.number != ir::ExpressionId::none) {
    std::string out = "M=";
    expressions_.append(out, c.number);
    return out;
  }
  if (c.function == ir::Function::machine_function) return "M" + std::to_string(c.argument);
  // A program that was read and not raised: its codes are named by the table.
  for (const GCode& g : g_codes())
    if (g.row.function == c.function && g.row.argument == c.argument && g.row.number10 >= 0)
      return std::string(g.row.name);
  for (const GCode& g : named_codes())
    if (g.row.function == c.function) return std::string(g.row.name);
  for (const ir::CodeRow& m : m_code_rows())
    if (m.function == c.function) return std::string(m.name);
  return {};
}

// ",a2,a3" of PO[X]=(xe,a2,a3); empty where the axis has no polynomial.
std::string BlockPrinter::coefficients(ir::Address axis, std::span<const ir::Word> words) const {
  if (axis < Address::x || axis > Address::z) return {};
  const std::size_t number = static_cast<std::size_t>(axis) - static_cast<std::size_t>(Address::x);
  std::string out;
  for (std::size_t power = ir::kFirstPower; power <= ir::kLastPower; ++power) {
    const auto found = std::ranges::find(words, ir::coefficient_of(number, power), &ir::Word::address);
    if (found == words.end()) break;
    out += ',';
    expressions_.append(out, found->value);
  }
  return out;
}

std::string BlockPrinter::word(const ir::Word& w, std::span<const ir::Word> words) const {
  std::string head;
  const std::string polynomial = coefficients(w.address, words);
  const bool letter = w.address <= Address::z;
  if (letter) {
    head = std::string(1, static_cast<char>('A' + static_cast<int>(w.address)));
    if (w.extension != 0) head += std::to_string(w.extension);
  } else if (w.address == Address::named_axis) {
    head = "AX[";
    expressions_.append(head, w.axis);
    head += ']';
  } else if (w.name != ir::StringId::none) {
    head = program_.strings.at(w.name);
  } else {
    head = name_of(w.address);
  }
  const bool kept_mode = letter && w.name != ir::StringId::none;  // DC, ACP, ACN
  const std::string_view mode = kept_mode                             ? program_.strings.at(w.name)
                                : w.mode == ir::WordMode::absolute    ? "AC"
                                : w.mode == ir::WordMode::incremental ? "IC"
                                                                      : std::string_view();
  if (w.address == Address::other && w.mode == ir::WordMode::as_modal && is_coded_mode(head))
    return std::string(w.span.in(program_.source.text()));
  const ir::Expression& e = program_.at(w.value);
  const bool plain = e.op == ir::Operator::constant && mode.empty() && letter && w.extension == 0;
  std::string out = polynomial.empty() ? head : "PO[" + head + "]";
  if (!plain || !polynomial.empty()) out += '=';
  if (!polynomial.empty()) out += '(';
  if (!mode.empty()) out += std::string(mode) + "(";
  // A parameter of curves, not a length: powers of it are taken.
  if (e.op == ir::Operator::constant && w.address != Address::knot_distance) {
    const bool position = has_point(w.address);
    text::append_word_number(out, e.value, position ? position_decimals(e) : kPlainDecimals, !position);
  } else {
    expressions_.append(out, w.value);
  }
  if (!mode.empty()) out += ')';
  if (!polynomial.empty()) out += polynomial + ')';
  return out;
}

int BlockPrinter::position_decimals(const ir::Expression& e) const {
  return decimals_of_position(e.span.empty(), control_);
}

void append_position(std::string& out, Address axis, double value, const ir::Control& control) {
  out.push_back(ir::letter_of(axis));
  text::append_word_number(out, value, decimals_of_position(true, control), false);
}

}  // namespace dripfeed::sinumerik
