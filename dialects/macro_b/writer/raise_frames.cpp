// Here a point goes through the rotation, then the scale, then the mirror, then G52. A chain of frames is the same
// where it was built in the order TRANS, AMIRROR, ASCALE, AROT, each at most once:
//
//   TRANS X30 Y5         G69 / G52 X30. Y5. Z0.
//   AROT RPL=20          G68 X0. Y0. R20.
//   ROT RPL=20           G69 / G52 X0. Y0. Z0. / G68 X0. Y0. R20.
//   ATRANS X2            G52 X32. Y5. Z0., where the shift so far is of numbers
//
// What is in effect is followed in the order of the text; where paths meet it is not known until TRANS or ROT begins
// again, and only what adds to it is an error there.
#include "dialects/macro_b/writer/raise_frames.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "dialects/ir/frame_use.h"
#include "dialects/macro_b/writer/called_hole.h"
#include "dialects/passes/refusal.h"
#include "dialects/passes/rewrite.h"

namespace dripfeed::macro_b {

namespace {

using ir::Address;
using ir::ExpressionId;
using ir::Function;
using ir::StatementKind;

constexpr std::int16_t kWholeShift = 1;  // argument of local_shift: axes that are not named are not shifted
constexpr std::array kLengths = {Address::x, Address::y, Address::z};

// How far a chain was built: what comes before in the chain cannot be added after it.
enum class Stage : std::uint8_t { nothing, shift, mirror, scale, rotation, unknown };

class Frames {
 public:
  Frames(ir::Program& program, const ir::Control& to)
      : program_(program), to_(to), out_(program), plane_(Function::plane_xy) {
    for (const ir::Code& c : program.codes) {
      const auto at = place_of(c.function);
      if (at && c.argument != ir::kFrameAboutPoint && c.argument != ir::kFrameEnds) used_[*at] = true;
    }
  }

  std::vector<text::Diagnostic> run() {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      out_.at(i);
      statement_ = program_.statements[i];
      const bool joins = statement_.is_label ||
                         (statement_.kind >= StatementKind::if_begin && statement_.kind <= StatementKind::loop_end);
      if (joins || statement_.kind == StatementKind::call || statement_.kind == StatementKind::native)
        stage_ = Stage::unknown;
      if (statement_.kind == StatementKind::block)
        block(program_.blocks[statement_.payload]);
      else
        out_.keep();
    }
    out_.finish();
    return std::move(diagnostics_);
  }

 private:
  static std::optional<std::size_t> place_of(Function f) {
    if (f == Function::mirror) return 0;
    if (f == Function::scale) return 1;
    if (f == Function::rotate) return 2;
    return std::nullopt;
  }

  // By value: the arenas grow.
  void block(const ir::Block block) {
    const auto codes = program_.codes_of(block);
    for (const ir::Code& c : codes)
      if (c.group == ir::ModalGroup::plane) plane_ = c.function;
    // Numbers so far count another unit from here on.
    if (std::ranges::find(codes, ir::ModalGroup::unit, &ir::Code::group) != codes.end())
      for (std::optional<double>& shift : shift_)
        if (shift != 0.0) shift.reset();
    const auto frame = std::ranges::find_if(codes, [](const ir::Code& c) {
      return c.function == Function::local_shift || c.function == Function::local_shift_add ||
             c.function == Function::axial_shift || place_of(c.function).has_value();
    });
    if (frame == codes.end()) return out_.keep();
    const ir::Code code = *frame;
    const std::vector<ir::Word> words(program_.words_of(block).begin(), program_.words_of(block).end());
    if (code.function == Function::axial_shift) return cannot("an axial shift");
    if (code.function == Function::local_shift) {
      end_frames();
      stage_ = Stage::shift;
      take_shift(words);
      return out_.keep();
    }
    if (code.function == Function::local_shift_add) return add_shift(words);
    const bool replaces = code.argument == ir::kFrameReplaces;
    if (replaces) {
      end_frames();
      out_.emit_block({plain(Function::local_shift, kWholeShift)}, {});
      stage_ = Stage::nothing;
      shift_.fill(0.0);
    }
    const std::string_view name = program_.strings.at(code.name);
    const bool bare = std::ranges::none_of(
        words, [](const ir::Word& w) { return ir::is_axis(w.address) || w.address == Address::frame_angle; });
    if (bare) return;
    change(code.function, name, words);
  }

  // TRANS names the whole shift: what is left out is 0.
  void take_shift(const std::vector<ir::Word>& words) {
    shift_.fill(0.0);
    others_shifted_ = false;
    for (const ir::Word& w : words) {
      const auto* const axis = std::ranges::find(kLengths, w.address);
      if (axis == kLengths.end()) {
        others_shifted_ = true;
        continue;
      }
      const auto i = static_cast<std::size_t>(axis - kLengths.begin());
      shift_[i] = constant_value(program_, w.value);
    }
  }

  // ATRANS: the shift so far and the words, said as one. Of a shift that was computed nothing is known by now.
  void add_shift(const std::vector<ir::Word>& words) {
    if (stage_ == Stage::unknown)
      return cannot(passes::not_known("ATRANS, which adds to a frame that is not known here,"));
    if (stage_ > Stage::shift) return cannot("ATRANS after another part of the frame");
    const bool others = std::ranges::any_of(words, [](const ir::Word& w) {
      return ir::is_axis(w.address) && std::ranges::find(kLengths, w.address) == kLengths.end();
    });
    if (others || others_shifted_) return cannot("ATRANS of other axes than X, Y and Z");
    if (std::ranges::any_of(shift_, [](const auto& one) { return !one.has_value(); }))
      return cannot(passes::computed("ATRANS after a shift that is computed"));
    std::vector<ir::Word> sums;
    for (std::size_t i = 0; i < kLengths.size(); ++i) {
      const ir::Word* more = find(words, kLengths[i]);
      if (more == nullptr && *shift_[i] == 0.0) continue;
      sums.push_back(zero(kLengths[i]));
      sums.back().value = more == nullptr ? number(*shift_[i]) : sum_of(shift_[i], more->value);
    }
    out_.emit_block({plain(Function::local_shift, kWholeShift)}, sums);
    stage_ = Stage::shift;
  }
  // Of a shift and what comes to it; the shift is known afterwards where both are numbers.
  ExpressionId sum_of(std::optional<double>& shift, ExpressionId more) {
    const double before = *shift;
    const std::optional<double> added = constant_value(program_, more);
    shift = added ? std::optional(before + *added) : std::nullopt;
    if (shift) return number(*shift);
    return before == 0.0 ? more : program_.add_operator(ir::Operator::add, number(before), more);
  }
  ExpressionId number(double value) { return program_.add_constant(value, {}, true); }

  void change(Function function, std::string_view written, const std::vector<ir::Word>& words) {
    const Stage own = function == Function::mirror  ? Stage::mirror
                      : function == Function::scale ? Stage::scale
                                                    : Stage::rotation;
    const std::string name(written.empty() ? ir::name_of(function) : written);
    if (stage_ == Stage::unknown)
      return cannot(passes::not_known(name + ", which adds to a frame that is not known here,"));
    if (stage_ >= own) return cannot(name + " after another part of the frame");
    stage_ = own;
    if (function == Function::rotate) return rotate(name, words);
    if (function == Function::scale) return scale(words);
    std::vector<ir::Word> places;
    for (const Address axis : kLengths)
      if (find(words, axis) != nullptr) places.push_back(zero(axis));
    out_.emit_block({plain(Function::mirror, ir::kFrameAboutPoint)}, places);
  }

  // RPL, or the angle about the axis that stands on the plane.
  void rotate(const std::string& name, const std::vector<ir::Word>& words) {
    const Address normal = plane_ == Function::plane_zx   ? Address::y
                           : plane_ == Function::plane_yz ? Address::x
                                                          : Address::z;
    const ir::Word* angle = find(words, Address::frame_angle);
    if (angle == nullptr && words.size() == 1) angle = find(words, normal);
    if (angle == nullptr) return cannot(name + " about more than the axis on the plane");
    std::vector<ir::Word> turned;
    for (const Address axis : kLengths)
      if (axis != normal) turned.push_back(zero(axis));
    ir::Word by = *angle;
    by.address = Address::r;
    by.mode = ir::WordMode::as_modal;
    turned.push_back(by);
    out_.emit_block({plain(Function::rotate, ir::kFrameAboutPoint)}, turned);
  }

  void scale(const std::vector<ir::Word>& words) {
    constexpr std::array kFactors = {Address::i, Address::j, Address::k};
    std::vector<ir::Word> all;
    all.reserve(2 * kLengths.size());
    for (const Address axis : kLengths) all.push_back(zero(axis));
    for (std::size_t i = 0; i < kLengths.size(); ++i) {
      const ir::Word* factor = find(words, kLengths[i]);
      ir::Word w = factor == nullptr ? zero(kFactors[i]) : *factor;
      w.address = kFactors[i];
      w.mode = ir::WordMode::as_modal;
      if (factor == nullptr) w.value = program_.add_constant(1.0);
      ir::Expression& value = program_.expressions[static_cast<std::uint32_t>(w.value)];
      if (value.op == ir::Operator::constant) value.has_point = true;  // a factor, not a count of units
      all.push_back(w);
    }
    out_.emit_block({plain(Function::scale, ir::kFrameAboutPoint)}, all);
  }

  // Ends of the kinds that the program uses: others are never in effect.
  void end_frames() {
    constexpr std::array kKinds = {Function::mirror, Function::scale, Function::rotate};
    for (std::size_t i = kKinds.size(); i-- > 0;)
      if (used_[i]) out_.emit_block({plain(kKinds[i], ir::kFrameEnds)}, {});
  }

  static const ir::Word* find(const std::vector<ir::Word>& words, Address address) {
    const auto found = std::ranges::find(words, address, &ir::Word::address);
    return found == words.end() ? nullptr : &*found;
  }
  ir::Word zero(Address address) {
    ir::Word w;
    w.address = address;
    w.value = program_.add_constant(0.0);
    if (ir::is_axis(address)) w.mode = ir::WordMode::absolute;
    return w;
  }
  static ir::Code plain(Function function, std::int16_t argument) {
    ir::Code c;
    c.function = function;
    c.argument = argument;
    c.group = ir::ModalGroup::frame;
    return c;
  }
  void cannot(passes::Refusal what) {
    diagnostics_.push_back(passes::diagnose(std::move(what), statement_.span, to_.title));
  }

  ir::Program& program_;
  const ir::Control& to_;
  passes::Rewrite out_;
  std::vector<text::Diagnostic> diagnostics_;
  ir::Statement statement_;
  Function plane_;
  Stage stage_ = Stage::nothing;
  std::array<bool, 3> used_{};                                 // mirror, scale, rotation
  std::array<std::optional<double>, 3> shift_{0.0, 0.0, 0.0};  // of X, Y, Z where it is a number
  bool others_shifted_ = false;
};

}  // namespace

std::vector<text::Diagnostic> raise_frames(ir::Program& program, const ir::Control& to) {
  const bool any = std::ranges::any_of(program.codes, [](const ir::Code& c) {
    const bool changes =
        c.function == Function::rotate || c.function == Function::scale || c.function == Function::mirror;
    return c.function == Function::local_shift_add ||
           (changes && (c.argument == ir::kFrameAdds || c.argument == ir::kFrameReplaces));
  });
  return any ? Frames(program, to).run() : std::vector<text::Diagnostic>();
}

}  // namespace dripfeed::macro_b
