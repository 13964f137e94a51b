// One loop over the bytes: a letter with a constant is a word, codes are looked up in a flat index.
#include "dialects/macro_b/reader/scan.h"

#include <algorithm>
#include <array>
#include <utility>

#include "dialects/ir/block_scanner.h"
#include "dialects/ir/idle_code.h"
#include "dialects/macro_b/reader/call_words.h"
#include "dialects/macro_b/reader/lower.h"
#include "dialects/macro_b/reader/other_forms.h"
#include "dialects/text/scan_decimal.h"

namespace dripfeed::macro_b {

namespace {

using ir::Function;
using ir::ScannedBlock;

enum class Class : std::uint8_t { other, white, letter, eob, comment, tape_mark };

constexpr std::array<Class, 256> make_classes() {
  std::array<Class, 256> classes{};
  const auto set = [&](std::string_view characters, Class c) {
    for (const char character : characters) classes[static_cast<unsigned char>(character)] = c;
  };
  set("ABCDEFGHIJKLMNOPQRSTUVWXYZ", Class::letter);
  set("\n\r;", Class::eob);
  set("(", Class::comment);
  set("%", Class::tape_mark);
  set(" \t", Class::white);
  return classes;
}
constexpr std::array<Class, 256> kClasses = make_classes();
Class class_of(char c) { return kClasses[static_cast<unsigned char>(c)]; }

constexpr std::ptrdiff_t kShortPair = 4;  // digits of T0101

// Without the codes that make their block a call or data.
ir::PlainCodeIndex index_codes(const ir::Control& control, const Grammar& grammar, std::span<const ir::CodeRow> table,
                               char letter) {
  ir::PlainCodeIndex index;
  for (const ir::CodeRow& row : table)
    if (ir::is_plain(row.function) && !has_other_form(grammar, row.function) &&
        call_word(control, letter, row.number10) == CallWord::none)
      index.add(row);
  return index;
}

class Words {
 public:
  Words(const ir::Control& control, const Grammar& grammar)
      : most_digits_(control.limits.digits == 0 ? text::kScannedDigits : control.limits.digits),
        highest_block_number_(grammar.highest_block_number),
        g_codes_(index_codes(control, grammar, control.g_codes, 'G')),
        m_codes_(index_codes(control, grammar, control.m_codes, 'M')),
        pairs_by_digits_(grammar.long_tool_words && control.semantics.tool_word == ir::ToolWord::number_and_offset),
        second_tool_is_next_(grammar.second_tool_is_next),
        repeats_by_l_(grammar.repeat_letter == 'L'),
        a_may_be_an_angle_(control.kind == ir::MachineKind::lathe && !control.axes.contains('A')),
        control_(&control) {}

  [[nodiscard]] std::string_view name() const { return name_; }
  static bool ends_line(char eob) { return eob != ';'; }

  const char* scan(const char* at, ScannedBlock& block) {
    idles_ = false;
    has_tool_ = false;
    const std::size_t first_word = block.batch->words.size();
    while (at != nullptr) {
      switch (class_of(*at)) {
        case Class::white: ++at; break;
        case Class::eob:
          if (idles_) drop_idle_words(*block.batch, first_word);
          return at;
        case Class::letter:
          at = word(at, block);
          at_start_ = false;
          break;
        case Class::comment:
          at = comment(at, block);
          at_start_ = false;
          break;
        case Class::tape_mark: return std::exchange(at_start_, false) ? leader(at) : nullptr;
        case Class::other: return nullptr;
      }
    }
    return nullptr;
  }

 private:
  // G05.1 Q1, G08 P1: no words of a cycle that is in effect.
  static void drop_idle_words(ir::PlainBatch& batch, std::size_t first_word) {
    const auto is_own = [](const ir::PlainWord& w) { return ir::is_word_of_idle_code(w.address); };
    batch.words.erase(
        std::remove_if(batch.words.begin() + static_cast<std::ptrdiff_t>(first_word), batch.words.end(), is_own),
        batch.words.end());
  }

  // '%' before anything else, and what comes after it on its line.
  static const char* leader(const char* at) {
    while (*at != '\n' && *at != '\r') ++at;
    return at;
  }

  // A comment that ends on its line and holds nothing that the reader has a word for.
  static const char* comment(const char* at, const ScannedBlock& block) {
    for (++at; at < block.text_end && *at != ')'; ++at)
      if (*at == '(' || *at == '%' || *at == '\n' || *at == '\r') return nullptr;
    return at < block.text_end ? at + 1 : nullptr;
  }

  const char* word(const char* at, ScannedBlock& block) {
    const char letter = *at;
    const char* const begin = at++;
    while (class_of(*at) == Class::white) ++at;
    const bool minus = *at == '-';
    const bool is_signed = minus || *at == '+';
    if (is_signed) ++at;
    while (class_of(*at) == Class::white) ++at;
    const text::ScannedDecimal number = text::scan_decimal(at);
    if (number.end == nullptr || number.digits > most_digits_ || class_of(*number.end) == Class::other) return nullptr;
    if (letter == 'N' || letter == 'O') return is_signed ? nullptr : head(letter, number, block);
    block.take(begin, number.end);
    if (letter == 'T' && pairs_by_digits_ && number.end - at > kShortPair) return nullptr;
    if (letter == 'T' && second_tool_is_next_ && std::exchange(has_tool_, true)) return nullptr;
    if (letter == 'L' && repeats_by_l_) return nullptr;
    if (letter == 'E') return nullptr;  // of a thread or a cycle: the reader decides by the whole block
    if (letter == 'A' && a_may_be_an_angle_) return nullptr;
    if (letter == 'G' || letter == 'M') return minus ? nullptr : code(letter, number, block);
    block.add_word(static_cast<ir::Address>(letter - 'A'), minus ? -number.value : number.value, number.has_point);
    return number.end;
  }

  // Block numbers are labels, which nothing that is plain asks for. The first O of a text names it.
  const char* head(char letter, const text::ScannedDecimal& number, ScannedBlock& block) {
    if (number.has_point || number.mantissa == 0) return nullptr;
    if (block.first != nullptr) block.last = number.end;
    if (letter == 'N') return number.mantissa <= highest_block_number_ ? number.end : nullptr;
    if (!name_.empty() || block.first != nullptr) return nullptr;
    name_ = program_name(number.value);
    return number.end;
  }

  const char* code(char letter, const text::ScannedDecimal& number, ScannedBlock& block) {
    if (number.fraction > 1) return nullptr;
    const std::uint64_t number10 = number.fraction == 0 ? number.mantissa * 10 : number.mantissa;
    const ir::CodeRow* row = (letter == 'G' ? g_codes_ : m_codes_).find(number10);
    if (row == nullptr) return letter == 'M' ? builder_code(number, block) : nullptr;
    if (ir::ends_program(row->function)) return std::exchange(block.ends_program, true) ? nullptr : number.end;
    idles_ |= ir::idles(row->function, row->group);
    if (row->function == Function::no_effect) block.report(row->name, row->function);
    block.add_code(row->function, row->argument, row->group);
    return number.end;
  }

  // An M code without a row is the machine tool builder's.
  const char* builder_code(const text::ScannedDecimal& number, ScannedBlock& block) const {
    constexpr std::uint64_t kHighest = 9999;
    if (number.fraction != 0 || number.mantissa > kHighest) return nullptr;
    const auto number10 = static_cast<std::int32_t>(number.mantissa * 10);
    if (ir::find_code(control_->m_codes, number10) != nullptr) return nullptr;
    if (call_word(*control_, 'M', number10) != CallWord::none) return nullptr;
    const auto function = static_cast<std::int16_t>(number.mantissa);
    block.report(ir::name_of(Function::machine_function), Function::machine_function, function);
    block.add_code(Function::machine_function, function, ir::ModalGroup::none);
    return number.end;
  }

  std::uint32_t most_digits_;
  std::uint32_t highest_block_number_;
  ir::PlainCodeIndex g_codes_;
  ir::PlainCodeIndex m_codes_;
  bool pairs_by_digits_;  // T001001: how many are written counts
  bool second_tool_is_next_;
  bool repeats_by_l_;
  bool a_may_be_an_angle_;  // of a line: the reader decides by the whole block
  const ir::Control* control_;
  bool has_tool_ = false;  // the block at hand has a T
  bool idles_ = false;     // the block at hand has a code whose words do nothing
  bool at_start_ = true;   // nothing but blank lines so far
  std::string name_;
};

}  // namespace

std::unique_ptr<ir::PlainScanner> make_scanner(const ir::Control& control, const Grammar& grammar) {
  return std::make_unique<ir::BlockScanner<Words>>(Words(control, grammar));
}

}  // namespace dripfeed::macro_b
