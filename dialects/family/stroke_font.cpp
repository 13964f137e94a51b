// A glyph is a text: "xy" by "xy", '|' where the tool is lifted.
#include "dialects/family/stroke_font.h"

#include <algorithm>
#include <array>

namespace dripfeed::family {

namespace {

struct GlyphRow {
  char letter;
  std::string_view strokes;
};
constexpr auto kGlyphs = std::to_array<GlyphRow>({
    {' ', ""},
    {'+', "03 43|21 25"},
    {',', "10 21"},
    {'-', "03 43"},
    {'.', "20 21"},
    {'/', "00 46"},
    {'0', "10 01 05 16 36 45 41 30 10|11 35"},
    {'1', "14 26 20|10 30"},
    {'2', "05 16 36 45 44 00 40"},
    {'3', "05 16 36 45 44 33 13|33 42 41 30 10 01"},
    {'4', "30 36 02 42"},
    {'5', "46 06 03 33 42 41 30 10 01"},
    {'6', "45 36 16 05 01 10 30 41 42 33 03"},
    {'7', "06 46 10"},
    {'8', "13 04 05 16 36 45 44 33 13 02 01 10 30 41 42 33"},
    {'9', "01 10 30 41 45 36 16 05 04 13 43"},
    {'A', "00 26 40|13 33"},
    {'B', "00 06 36 45 44 33 03|33 42 41 30 00"},
    {'C', "45 36 16 05 01 10 30 41"},
    {'D', "00 06 26 44 42 20 00"},
    {'E', "46 06 00 40|03 33"},
    {'F', "46 06 00|03 33"},
    {'G', "45 36 16 05 01 10 30 41 43 23"},
    {'H', "00 06|40 46|03 43"},
    {'I', "10 30|20 26|16 36"},
    {'J', "01 10 30 41 46"},
    {'K', "00 06|46 03 40"},
    {'L', "06 00 40"},
    {'M', "00 06 23 46 40"},
    {'N', "00 06 40 46"},
    {'O', "10 01 05 16 36 45 41 30 10"},
    {'P', "00 06 36 45 44 33 03"},
    {'Q', "10 01 05 16 36 45 41 30 10|22 40"},
    {'R', "00 06 36 45 44 33 03|23 40"},
    {'S', "01 10 30 41 42 33 13 04 05 16 36 45"},
    {'T', "06 46|26 20"},
    {'U', "06 01 10 30 41 46"},
    {'V', "06 20 46"},
    {'W', "06 10 24 30 46"},
    {'X', "00 46|06 40"},
    {'Y', "06 23 46|23 20"},
    {'Z', "06 46 00 40"},
});

const GlyphRow* glyph_of(char c) {
  const char capital = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  const auto row = std::ranges::find(kGlyphs, capital, &GlyphRow::letter);
  return row == kGlyphs.end() ? nullptr : &*row;
}

}  // namespace

bool has_glyph(char c) { return glyph_of(c) != nullptr; }

std::vector<Stroke> strokes_of(char c) {
  std::vector<Stroke> out;
  const GlyphRow* glyph = glyph_of(c);
  if (glyph == nullptr || glyph->strokes.empty()) return out;
  const auto unit = [](char digit) { return static_cast<double>(digit - '0'); };
  out.emplace_back();
  for (std::string_view rest = glyph->strokes; !rest.empty();) {
    out.back().push_back({unit(rest[0]), unit(rest[1])});
    rest.remove_prefix(2);
    if (rest.empty()) break;
    if (rest.front() == '|') out.emplace_back();
    rest.remove_prefix(1);
  }
  return out;
}

}  // namespace dripfeed::family
