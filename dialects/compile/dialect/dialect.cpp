// The table of dialects. What only SINUMERIK has (no G-code systems but in ISO mode) is evened out here.
#include "dialects/compile/dialect/dialect.h"

#include <algorithm>
#include <array>

#include "dialects/compile/dialect/iso_mode.h"
#include "dialects/compile/dialect/readers.h"
#include "dialects/fanuc/fanuc.h"
#include "dialects/haas/haas.h"
#include "dialects/haas/marks.h"
#include "dialects/linuxcnc/linuxcnc.h"
#include "dialects/macro_b/tables/language_words.h"
#include "dialects/macro_b/tables/marks.h"
#include "dialects/mazak/marks.h"
#include "dialects/mazak/mazak.h"
#include "dialects/mitsubishi/marks.h"
#include "dialects/mitsubishi/mitsubishi.h"
#include "dialects/sinumerik/sinumerik.h"
#include "dialects/sinumerik/tables/language_words.h"
#include "dialects/sinumerik/tables/marks.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::compile {

namespace {

// Siemens mode knows no G-code systems; ISO mode of a lathe does.
ir::Control sinumerik_control(ir::MachineKind kind, ir::GSystem g_system) {
  ir::Control control = sinumerik::control(kind);
  control.g_system = kind == ir::MachineKind::mill ? ir::GSystem::a : g_system;
  return control;
}

template <const macro_b::Grammar& (*grammar)()>
std::vector<ir::LanguageWord> words_by() {
  return macro_b::language_words(grammar());
}

// A control with '#' variables.
template <macro_b::UsualControl control, const macro_b::Grammar& (*grammar)()>
constexpr Dialect numbered(std::string_view name, std::string_view title) {
  using S = macro_b::Stages<control, grammar>;
  return {name,        title,    control,  S::infer_control,   S::read,          S::plain_scanner,
          S::validate, S::raise, S::print, S::append_position, words_by<grammar>};
}

constexpr std::array kDialects = {
    numbered<fanuc::control, fanuc::grammar>("fanuc", "Fanuc Custom Macro B"),
    numbered<haas::control, haas::grammar>("haas", "Haas NGC"),
    numbered<mazak::control, mazak::grammar>("mazak", "Mazak EIA/ISO"),
    numbered<mitsubishi::control, mitsubishi::grammar>("mitsubishi-m80", "Mitsubishi M70, M80"),
    Dialect{"sinumerik-840d", "SINUMERIK 840D sl", sinumerik_control, sinumerik::infer_control, read_sinumerik,
            sinumerik::plain_scanner, validate_sinumerik, sinumerik::raise, sinumerik::print,
            sinumerik::append_position, sinumerik::language_words, CommentStyle::semicolon, sinumerik::standard_cycle,
            sinumerik::add_definitions, true},
};

std::vector<ir::LanguageWord> no_words() { return {}; }

constexpr Dialect kLinuxCnc = {"linuxcnc",
                               "LinuxCNC",
                               linuxcnc::control,
                               linuxcnc::infer_control,
                               linuxcnc::read,
                               linuxcnc::plain_scanner,
                               linuxcnc::validate,
                               nullptr,
                               nullptr,
                               nullptr,
                               no_words};

constexpr std::string_view kFanuc = "fanuc";
constexpr std::string_view kSinumerik = "sinumerik-840d";

// Among the controls that read as Fanuc's do.
struct FamilyMarks {
  std::span<const ir::DialectMark> (*marks)();
  std::string_view dialect;
};
constexpr FamilyMarks kFamily[] = {
    {haas::marks, "haas"}, {mazak::marks, "mazak"}, {mitsubishi::marks, "mitsubishi-m80"}};
constexpr std::uint32_t kLinesLookedAt = 5000;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view without_number(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  if (line.size() > 1 && (line[0] == 'N' || line[0] == 'n') && is_digit(line[1])) {
    line.remove_prefix(std::min(line.find_first_not_of("0123456789", 1), line.size()));
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  }
  return line;
}

// "R5=" and "O1234" have digits in them.
std::string_view by_numbered_head(std::string_view line) {
  const std::size_t end = line.find_first_not_of("0123456789", 1);
  if (line.size() < 2 || end == 1) return {};
  if (line[0] == 'O') return kFanuc;
  return line[0] == 'R' && end != std::string_view::npos && line[end] == '=' ? kSinumerik : std::string_view();
}

struct Endings {
  std::span<const std::string_view> (*endings)();
  std::string_view dialect;
};
constexpr Endings kEndings[] = {{sinumerik::file_endings, kSinumerik}, {mazak::file_endings, "mazak"}};

std::string_view dialect_of_name(std::string_view name) {
  const std::string capitals = text::upper_case(name);
  for (const Endings& of : kEndings)
    for (const std::string_view ending : of.endings())
      if (capitals.ends_with(ending)) return of.dialect;
  return {};
}

// Of a SINUMERIK, small letters and capitals are the same; inside a line they may be words of a comment.
std::string_view dialect_of_line(std::string_view line) {
  const std::string_view block = without_number(line);
  const std::string capitals = text::upper_case(block);
  if (const std::string_view by_head = by_numbered_head(capitals); !by_head.empty()) return by_head;
  const auto begins = [&](const ir::DialectMark& mark) { return mark.at_start && capitals.starts_with(mark.text); };
  const auto holds = [&](const ir::DialectMark& mark) { return !mark.at_start && block.contains(mark.text); };
  if (std::ranges::any_of(macro_b::marks(), begins)) return kFanuc;
  if (std::ranges::any_of(sinumerik::marks(), begins) || std::ranges::any_of(sinumerik::marks(), holds))
    return kSinumerik;
  return std::ranges::any_of(macro_b::marks(), holds) ? kFanuc : std::string_view();
}

std::string_view dialect_of_family(const text::Source& source) {
  const std::uint32_t lines = std::min<std::uint32_t>(static_cast<std::uint32_t>(source.line_count()), kLinesLookedAt);
  for (std::uint32_t line = 1; line <= lines; ++line) {
    const std::string_view text = source.line(line);
    for (const FamilyMarks& of : kFamily)
      for (const ir::DialectMark& mark : of.marks())
        if (text.contains(mark.text)) return of.dialect;
  }
  return kFanuc;
}

}  // namespace

std::span<const Dialect> dialects() { return kDialects; }

const Dialect* find_dialect(std::string_view name) {
  const auto found = std::ranges::find(kDialects, name, &Dialect::name);
  return found == kDialects.end() ? nullptr : &*found;
}

const Dialect* find_reader(std::string_view name) { return name == kLinuxCnc.name ? &kLinuxCnc : find_dialect(name); }

const Dialect& infer_dialect(const text::Source& source) {
  if (const std::string_view named = dialect_of_name(source.name()); !named.empty()) return *find_dialect(named);
  const std::uint32_t lines = source.line_count();
  for (std::uint32_t line = 1; line <= lines; ++line) {
    const std::string_view found = dialect_of_line(source.line(line));
    if (found == kFanuc) break;
    if (!found.empty()) return *find_dialect(found);
  }
  return *find_dialect(dialect_of_family(source));
}

}  // namespace dripfeed::compile
