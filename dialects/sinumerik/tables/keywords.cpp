// The table of reserved words, and the spelling and rank of operators. The references are to the lists of statements
// and predefined procedures and functions in the Programming Manuals Fundamentals and Job Planning.
#include "dialects/sinumerik/tables/keywords.h"

#include <algorithm>
#include <array>
#include <vector>

#include "dialects/sinumerik/tables/name_index.h"
#include "dialects/sinumerik/tables/vocabulary.h"

namespace dripfeed::sinumerik {

namespace {

using enum ir::Operator;

constexpr Keyword infix(std::string_view name, ir::Operator op, std::uint8_t rank) {
  return {.name = name, .role = Role::infix, .op = op, .rank = rank};
}
constexpr Keyword prefix(std::string_view name, ir::Operator op) {
  return {.name = name, .role = Role::prefix, .op = op, .rank = kUnaryRank};
}
constexpr Keyword function(std::string_view name, ir::Operator op) {
  return {.name = name, .role = Role::function, .op = op};
}
constexpr Keyword address(std::string_view name, ir::Address address) {
  return {.name = name, .role = Role::address, .address = address};
}
constexpr Keyword statement(std::string_view name, Verb verb, Effect effect = Effect::unknown) {
  return {.name = name, .role = Role::statement, .verb = verb, .effect = effect};
}
constexpr Keyword type(std::string_view name, ir::ValueType value_type) {
  return {.name = name, .role = Role::type, .type = value_type};
}

// clang-format off
constexpr auto kKeywords = std::to_array<Keyword>({
  // infix operators and their level
  infix("DIV", integer_divide, 2),
  infix("MOD", modulo, 2),
  infix("B_AND", bit_and, 4),
  infix("B_XOR", bit_xor, 5),
  infix("B_OR", bit_or, 6),
  infix("AND", logic_and, 7),
  infix("XOR", logic_xor, 8),
  infix("OR", logic_or, 9),
  prefix("NOT", logic_not),
  prefix("B_NOT", bit_not),
  // functions
  function("SIN", sin),
  function("COS", cos),
  function("TAN", tan),
  function("ASIN", asin),
  function("ACOS", acos),
  function("ATAN2", atan2),
  function("SQRT", sqrt),
  function("POT", square),
  function("ABS", abs),
  function("LN", ln),
  function("EXP", exp),
  function("ROUND", round),
  function("TRUNC", truncate),
  function("ROUNDUP", round_up),
  function("MINVAL", minimum),
  function("MAXVAL", maximum),
  function("BOUND", bound),
  function("STRLEN", string_length),
  function("NUMBER", to_number),
  function("TOUPPER", to_upper),
  function("TOLOWER", to_lower),
  function("ISVAR", is_variable),
  function("ISNUMBER", is_number),
  function("INDEX", find_text),
  function("RINDEX", find_text_last),
  function("MINDEX", find_any),
  function("SUBSTR", substring),
  function("AXNAME", to_axis),
  function("AXSTRING", to_string),
  function("CTRANS", frame_shift),
  function("CFINE", frame_shift),
  function("CROT", frame_turn),
  function("CRPL", frame_turn),
  function("CSCALE", frame_scale),
  function("CMIRROR", frame_mirror),
  // constants
  {"TRUE", Role::constant},
  {"FALSE", Role::constant},
  // words with names
  address("CR", ir::Address::arc_radius),
  address("AR", ir::Address::opening_angle),
  address("LIMS", ir::Address::spindle_limit),
  address("AP", ir::Address::polar_angle),
  address("RP", ir::Address::polar_radius),
  address("TURN", ir::Address::turns),
  address("CHF", ir::Address::chamfer_length),
  address("CHR", ir::Address::chamfer),
  address("RND", ir::Address::rounding),
  address("RNDM", ir::Address::modal_rounding),
  address("RPL", ir::Address::frame_angle),
  address("ANG", ir::Address::direct_angle),
  address("OFFN", ir::Address::contour_offset),
  address("FB", ir::Address::block_feed),
  address("PW", ir::Address::point_weight),
  address("PL", ir::Address::knot_distance),
  address("SD", ir::Address::spline_degree),
  address("MEAS", ir::Address::measuring),
  address("MEAW", ir::Address::measuring),
  // statements
  statement("IF", Verb::if_word),
  statement("ELSE", Verb::else_word),
  statement("ENDIF", Verb::end_if),
  statement("WHILE", Verb::while_word),
  statement("ENDWHILE", Verb::end_while),
  statement("FOR", Verb::for_word),
  statement("ENDFOR", Verb::end_for),
  statement("LOOP", Verb::loop),
  statement("ENDLOOP", Verb::end_loop),
  statement("REPEAT", Verb::repeat),
  statement("REPEATB", Verb::repeat_block),
  statement("UNTIL", Verb::until),
  statement("CASE", Verb::case_word),
  statement("GOTO", Verb::go_to),
  statement("GOTOF", Verb::go_to_forward),
  statement("GOTOB", Verb::go_to_backward),
  statement("GOTOC", Verb::go_to_tolerant),
  statement("GOTOS", Verb::go_to_start),
  statement("DEF", Verb::define),
  statement("PROC", Verb::procedure),
  statement("EXTERN", Verb::declare),
  statement("MSG", Verb::message),
  statement("SETAL", Verb::alarm),
  statement("CALL", Verb::call, Effect::moves),
  statement("MCALL", Verb::call_modal),
  statement("PCALL", Verb::call_path),
  statement("EXTCALL", Verb::call_external),
  statement("ISOCALL", Verb::call_iso),
  statement("EXECSTRING", Verb::execute),
  statement("DEFINE", Verb::macro),
  statement("RET", Verb::return_word, Effect::moves),
  // types
  type("INT", ir::ValueType::integer),
  type("REAL", ir::ValueType::real),
  type("BOOL", ir::ValueType::boolean),
  type("CHAR", ir::ValueType::character),
  type("STRING", ir::ValueType::string),
  type("AXIS", ir::ValueType::axis),
  type("FRAME", ir::ValueType::frame),
});
// clang-format on

struct Sign {
  ir::Operator op;
  std::string_view spelling;
  std::uint8_t rank;
};
constexpr Sign kSigns[] = {
    {multiply, "*", 2},        {divide, "/", 2},      {add, "+", 3},   {subtract, "-", 3},     {concatenate, "<<", 10},
    {equal, "==", 11},         {not_equal, "<>", 11}, {less, "<", 11}, {less_equal, "<=", 11}, {greater, ">", 11},
    {greater_equal, ">=", 11},
};

}  // namespace

std::span<const Keyword> keywords() {
  static const std::vector<Keyword> rows = [] {
    std::vector<Keyword> all(kKeywords.begin(), kKeywords.end());
    for (const WordList& list : vocabulary())
      for (const std::string_view name : list.names)
        all.push_back({.name = name, .role = list.role, .effect = list.effect});
    return all;
  }();
  return rows;
}

const Keyword* find_keyword(std::string_view name) {
  static const NameIndex index = index_of(keywords(), [](const Keyword& k) { return k.name; });
  const std::uint32_t found = index.find(name);
  return found == NameIndex::kNotFound ? nullptr : &keywords()[found];
}

std::uint8_t rank_of(ir::Operator op) {
  for (const Sign& sign : kSigns)
    if (sign.op == op) return sign.rank;
  const auto word =
      std::ranges::find_if(kKeywords, [op](const Keyword& k) { return k.role == Role::infix && k.op == op; });
  return word == kKeywords.end() ? std::uint8_t{0} : word->rank;
}

std::string_view spelling_of(ir::Operator op) {
  for (const Sign& sign : kSigns)
    if (sign.op == op) return sign.spelling;
  const auto word = std::ranges::find_if(kKeywords, [op](const Keyword& k) {
    return (k.role == Role::infix || k.role == Role::prefix || k.role == Role::function) && k.op == op;
  });
  return word == kKeywords.end() ? std::string_view() : word->name;
}

}  // namespace dripfeed::sinumerik
