// The punches of a control come with line feeds alone; a file has the ends of whatever wrote it.
#include "server/app/library/split_text.h"

#include <algorithm>

#include "dialects/text/source.h"
#include "protocol/receive/program_name.h"

namespace dripfeed::app {

namespace {

struct Lines {
  std::string text;      // ends as LF
  std::string_view end;  // as the file had the first one
};

Lines with_line_feeds(std::string_view text) {
  Lines lines{.text = {}, .end = "\n"};
  lines.text.reserve(text.size());
  while (!text.empty()) {
    const std::size_t at = std::min(text.find_first_of("\r\n"), text.size());
    lines.text += text.substr(0, at);
    if (at == text.size()) break;
    const std::size_t length = text::eob_length(text, at);
    if (lines.text.find('\n') == std::string::npos) lines.end = text.substr(at, length);
    lines.text += '\n';
    text.remove_prefix(at + length);
  }
  return lines;
}

std::string with_ends(std::string_view text, std::string_view end) {
  std::string out;
  for (const char c : text) {
    if (c == '\n')
      out += end;
    else
      out += c;
  }
  return out;
}

}  // namespace

std::vector<SplitProgram> split_text(std::string_view text) {
  const Lines lines = with_line_feeds(text);
  std::vector<SplitProgram> programs;
  for (const std::string& one : receive::split_programs(lines.text)) {
    const auto name = receive::find_name(one);
    const bool is_named = name && name->style != receive::NameStyle::comment;
    programs.push_back({.name = is_named ? name->name : std::string(),
                        .comment = std::string(receive::first_comment(one, receive::kNameLines)),
                        .text = with_ends(one, lines.end)});
  }
  if (programs.size() == 1) programs.front().text = text;
  return programs;
}

}  // namespace dripfeed::app
