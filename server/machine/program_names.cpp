// Sources: SINUMERIK 840D sl programming manual (inner names _N_NAME_MPF, files NAME.MPF); Fanuc: O and four or eight
// digits, leading zeros do not count; Haas .NC, Mazak .EIA as their folders have them (file_drop.cpp).
#include "server/machine/program_names.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace dripfeed::machine {

namespace {

constexpr std::string_view kInner = "_N_";  // SINUMERIK's folder tree
// SPF is another program of the same name: it keeps its ending.
constexpr std::array<std::string_view, 7> kEndings = {"_MPF", ".MPF", ".NC", ".EIA", ".TXT", ".MIN", ".PRG"};
constexpr std::string_view kDigits = "0123456789";

std::string upper(std::string_view text) {
  std::string out;
  for (const char c : text) out += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return out;
}

// "0042" of O0042, :42 and 42; empty where it is not a number.
std::string_view digits_of(std::string_view name) {
  if (name.starts_with('O') || name.starts_with(':')) name.remove_prefix(1);
  return name.find_first_not_of(kDigits) == std::string_view::npos ? name : std::string_view();
}

std::string_view without_zeros(std::string_view digits) {
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size() - 1));
  return digits;
}

}  // namespace

std::string plain_program_name(std::string_view name) {
  std::string out = upper(name);
  if (out.starts_with(kInner)) out.erase(0, kInner.size());
  for (const std::string_view ending : kEndings) {
    if (out.size() <= ending.size() || !out.ends_with(ending)) continue;
    out.resize(out.size() - ending.size());
    break;
  }
  // A subprogram's two spellings are one.
  if (out.size() > 4 && out.ends_with(".SPF")) out[out.size() - 4] = '_';
  const std::string_view digits = digits_of(out);
  return digits.empty() ? out : std::string(without_zeros(digits));
}

std::vector<std::string> forms_of_program_name(std::string_view name) {
  std::vector<std::string> out = {std::string(name)};
  const auto add = [&](std::string form) {
    if (std::ranges::find(out, form) == out.end()) out.push_back(std::move(form));
  };
  const std::string plain = plain_program_name(name);
  if (plain.empty()) return out;
  std::vector<std::string> stems = {plain};
  if (const std::string_view digits = digits_of(plain); !digits.empty()) {
    stems = {fmt::format("O{:0>4}", digits), fmt::format("O{:0>8}", digits), fmt::format("O{}", digits), plain};
  }
  for (const std::string& stem : stems) add(stem);
  if (plain.ends_with("_SPF")) {
    add(fmt::format("{}.SPF", plain.substr(0, plain.size() - 4)));
    add(fmt::format("{}{}", kInner, plain));
    return out;
  }
  for (const std::string& stem : stems) {
    for (const std::string_view ending : kEndings) add(fmt::format("{}{}", stem, ending));
  }
  add(fmt::format("{}{}_MPF", kInner, plain));
  return out;
}

}  // namespace dripfeed::machine
