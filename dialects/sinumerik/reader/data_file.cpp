// Endings of file names, which an archive writes after an underscore.
#include "dialects/sinumerik/reader/data_file.h"

#include <algorithm>

#include "dialects/sinumerik/tables/name_index.h"

namespace dripfeed::sinumerik {

namespace {

// The endings of data: definitions, initialization, machine and setting data, tools, magazines, offsets, R parameters.
constexpr std::string_view kDataEndings[] = {"DEF", "INI", "TEA", "SEA", "TOA", "TMA", "TOP", "TMP",
                                             "UFR", "RPA", "GUD", "PRO", "CEC", "EEC", "QEC"};

}  // namespace

bool ends_with(std::string_view name, std::string_view ending) {
  return name.size() > ending.size() && same_name(name.substr(name.size() - ending.size()), ending);
}

bool is_other_ending(std::string_view ending) {
  constexpr std::string_view kOthers[] = {"COM", "TXT", "XML", "BMP", "PNG", "ICO", "CSV", "LOG", "JOB",
                                          "WPD", "DIR", "ARC", "TCM", "HLP", "HTM", "DAT", "BIN", "BOT"};
  return std::ranges::any_of(kOthers, [ending](std::string_view known) { return same_name(known, ending); });
}

bool is_data_file(const ir::Program& program) {
  // "%_N_INITIAL_INI", or the name of the file.
  const auto head = std::ranges::find(program.tokens, ir::TokenKind::tape_mark, &ir::Token::kind);
  std::string_view name =
      head == program.tokens.end() ? std::string_view(program.source.name()) : head->span.in(program.source.text());
  while (!name.empty() && name.back() <= ' ') name.remove_suffix(1);
  return std::ranges::any_of(kDataEndings, [name](std::string_view ending) {
    return ends_with(name, ending) && (name[name.size() - 4] == '.' || name[name.size() - 4] == '_');
  });
}

}  // namespace dripfeed::sinumerik
