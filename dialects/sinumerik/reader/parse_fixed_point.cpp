// G75 FP=1 X1=0 Z1=0: by rapid to a fixed point of the machine; the values say nothing, without FP it is the first
// (MD30600; programming manual, "Fixed point approach"). Where the profile says that this one is the reference point,
// it is what the other controls call G28; any other is only known to the machine.
#include <string_view>
#include <vector>

#include "dialects/ir/axis_letters.h"
#include "dialects/sinumerik/reader/parse.h"
#include "dialects/sinumerik/tables/codes.h"
#include "dialects/sinumerik/tables/whole_number.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Address;
using ir::TokenKind;

constexpr GCode kReference = {
    {"G75", 750, ir::Function::reference_return, 1, ir::ModalGroup::non_modal, "PG, G group 2"}, 2, WordUse::usual};

// X and X1, the usual name of its machine axis.
bool is_axis(std::string_view name) {
  return ir::kAxisLetters.contains(to_upper(name.front())) &&
         (name.size() == 1 || (name.size() == 2 && name[1] == '1'));
}

// What comes after G75, as far as it is a number of the fixed point and axes with numbers.
class FixedPoint {
 public:
  explicit FixedPoint(TokenCursor cursor) : cursor_(cursor) {}

  bool read() {
    while (!cursor_.at_block_end())
      if (!(cursor_.is_name("FP") ? fixed_point() : axis())) return false;
    return !axes_.empty();
  }
  [[nodiscard]] std::uint32_t number() const { return number_; }
  [[nodiscard]] const std::vector<ir::Word>& axes() const { return axes_; }
  [[nodiscard]] const TokenCursor& cursor() const { return cursor_; }

 private:
  bool fixed_point() {
    cursor_.advance();
    if (!cursor_.take('=') || cursor_.kind() != TokenKind::number) return false;
    const std::string_view written = cursor_.text();
    if (written.find_first_not_of("0123456789") != std::string_view::npos) return false;
    number_ = whole_number(written);
    cursor_.advance();
    return true;
  }

  // The approach to the intermediate point is none: an increment of nothing.
  bool axis() {
    const text::Span head = cursor_.span();
    if (cursor_.kind() != TokenKind::address || !is_axis(cursor_.text())) return false;
    const auto address = static_cast<Address>(to_upper(cursor_.first()) - 'A');
    const bool is_named = head.size() > 1;
    cursor_.advance();
    const bool equals = cursor_.take('=');
    if (is_named && !equals) return false;
    if (cursor_.is_symbol('-') || cursor_.is_symbol('+')) cursor_.advance();
    if (cursor_.kind() != TokenKind::number) return false;
    cursor_.advance();
    ir::Word word = ir::word(address, ir::ExpressionId::none);
    word.mode = ir::WordMode::incremental;
    word.span = {head.begin, cursor_.previous_end()};
    axes_.push_back(word);
    return true;
  }

  TokenCursor cursor_;
  std::uint32_t number_ = 1;
  std::vector<ir::Word> axes_;
};

}  // namespace

bool Parser::reference_approach(text::Span head) {
  if (control_.semantics.reference_fixed_point == 0 || lower_.has_pending_block()) return false;
  FixedPoint point(cursor_);
  if (!point.read() || static_cast<int>(point.number()) != control_.semantics.reference_fixed_point) return false;
  cursor_ = point.cursor();
  lower_.add_code(kReference, to_here(head));
  for (ir::Word word : point.axes()) {
    word.value = constant(0.0, word.span);
    lower_.add_word(word);
  }
  return true;
}

}  // namespace dripfeed::sinumerik
