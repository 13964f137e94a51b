// The short path of plain blocks: addresses of one letter with a constant, G and M codes by number, comments. Names,
// '=' and all that is computed are the reader's.
#include <algorithm>
#include <array>
#include <utility>

#include "dialects/ir/block_scanner.h"
#include "dialects/sinumerik/sinumerik.h"
#include "dialects/sinumerik/tables/codes.h"
#include "dialects/sinumerik/tables/name_index.h"
#include "dialects/text/scan_decimal.h"

namespace dripfeed::sinumerik {

namespace {

using ir::Function;
using ir::ScannedBlock;

constexpr std::string_view kPlainLetters = "ABCDFGIJKMNSTUVWXYZ";
constexpr std::uint32_t kMostDigits = 10;  // a constant of more is the reader's to judge

enum class Class : std::uint8_t { other, white, letter, eob, comment };

constexpr std::array<Class, 256> make_classes() {
  std::array<Class, 256> classes{};
  const auto set = [&](std::string_view characters, Class c) {
    for (const char character : characters) classes[static_cast<unsigned char>(character)] = c;
  };
  set(kPlainLetters, Class::letter);
  for (const char letter : kPlainLetters) classes[static_cast<unsigned char>(letter - 'A' + 'a')] = Class::letter;
  set("\n\r", Class::eob);
  set(";", Class::comment);
  set(" \t", Class::white);
  return classes;
}
constexpr std::array<Class, 256> kClasses = make_classes();
Class class_of(char c) { return kClasses[static_cast<unsigned char>(c)]; }

// Codes whose words mean what they usually do; G96 and G97 choose the feed as well.
ir::PlainCodeIndex index_g_codes() {
  ir::PlainCodeIndex index;
  for (const GCode& code : g_codes()) {
    const bool usual = code.words == WordUse::usual && code.row.group != ir::ModalGroup::surface_speed;
    if (usual && ir::is_plain(code.row.function)) index.add(code.row);
  }
  return index;
}

class Words {
 public:
  explicit Words(const ir::Control&) : g_codes_(index_g_codes()) {}

  [[nodiscard]] static std::string_view name() { return {}; }
  static bool ends_line(char) { return true; }

  const char* scan(const char* at, ScannedBlock& block) {
    seen_ = 0;
    while (at != nullptr) {
      switch (class_of(*at)) {
        case Class::white: ++at; break;
        case Class::eob: return at;
        case Class::comment:
          while (*at != '\n' && *at != '\r') ++at;
          break;
        case Class::letter: at = word(at, block); break;
        case Class::other: return nullptr;
      }
    }
    return nullptr;
  }

 private:
  const char* word(const char* at, ScannedBlock& block) {
    const char letter = *at >= 'a' ? static_cast<char>(*at - 'a' + 'A') : *at;
    const char* const begin = at++;
    const bool minus = *at == '-';
    const bool is_signed = minus || *at == '+';
    if (is_signed) ++at;
    const text::ScannedDecimal number = text::scan_decimal(at);
    if (number.end == nullptr || number.digits > kMostDigits || class_of(*number.end) == Class::other) return nullptr;
    const bool is_code = letter == 'G' || letter == 'M' || letter == 'N';
    if (is_code && (is_signed || number.has_point)) return nullptr;
    const std::uint32_t bit =
        1U << (static_cast<std::uint32_t>(letter - 'A') & 31U);  // of a letter: the classes see to that
    if (letter == 'N') {
      const bool heads = block.first == nullptr && (std::exchange(seen_, seen_ | bit) & bit) == 0;
      return heads && number.digits <= 8 ? number.end : nullptr;
    }
    if (block.ends_program) return nullptr;  // words after M30 belong to the block before it
    if (letter == 'M') return m_code(begin, number, block);
    block.take(begin, number.end);
    if (letter == 'G') return g_code(number, block);
    // An address twice in a block, and an edge or tool that is no whole number, are the reader's to judge.
    if ((std::exchange(seen_, seen_ | bit) & bit) != 0) return nullptr;
    if ((letter == 'D' || letter == 'T') && (number.has_point || is_signed)) return nullptr;
    block.add_word(static_cast<ir::Address>(letter - 'A'), minus ? -number.value : number.value, number.has_point);
    return number.end;
  }

  const char* g_code(const text::ScannedDecimal& number, ScannedBlock& block) const {
    const ir::CodeRow* row = g_codes_.find(number.mantissa * 10);
    if (row == nullptr) return nullptr;
    if (row->function == Function::no_effect) block.report(row->name, row->function);
    block.add_code(row->function, row->argument, row->group);
    return number.end;
  }

  static const char* m_code(const char* begin, const text::ScannedDecimal& number, ScannedBlock& block) {
    constexpr std::uint64_t kHighest = 9999;
    if (number.mantissa > kHighest) return nullptr;
    const ir::CodeRow* row = find_m_code(static_cast<std::uint32_t>(number.mantissa));
    if (row != nullptr && !ir::is_plain(row->function)) return nullptr;
    if (row != nullptr && ir::ends_program(row->function)) {
      if (block.first == nullptr) block.take(begin, number.end);  // the end is a statement of its own
      block.ends_program = true;
      return number.end;
    }
    block.take(begin, number.end);
    if (row == nullptr) {
      block.report(ir::name_of(Function::machine_function), Function::machine_function,
                   static_cast<std::int16_t>(number.mantissa));
      block.add_code(Function::machine_function, static_cast<std::int16_t>(number.mantissa), ir::ModalGroup::none);
      return number.end;
    }
    if (row->function == Function::no_effect) block.report(row->name, row->function);
    block.add_code(row->function, row->argument, row->group);
    return number.end;
  }

  ir::PlainCodeIndex g_codes_;
  std::uint32_t seen_ = 0;  // addresses of the block, a bit each
};

// In ISO mode no block is one of Siemens mode; nor where a code is a macro.
class NoPlainBlocks final : public ir::PlainScanner {
 public:
  ir::PlainScan scan(std::string_view, ir::PlainBatch&) override { return {0, ir::PlainStop::not_plain}; }
  [[nodiscard]] std::string_view name() const override { return {}; }
};

}  // namespace

// Whether a definition file gives a code another meaning: DEFINE M6 AS L6.
static bool redefines_codes(const ir::Control& control) {
  return control.shared != nullptr && std::ranges::any_of(control.shared->macros, [](const auto& macro) {
           return macro.first.size() > 1 && is_digit(macro.first[1]);
         });
}

std::unique_ptr<ir::PlainScanner> plain_scanner(const ir::Control& control) {
  if (control.semantics.starts_in_iso_mode || redefines_codes(control)) return std::make_unique<NoPlainBlocks>();
  return std::make_unique<ir::BlockScanner<Words>>(Words(control));
}

}  // namespace dripfeed::sinumerik
