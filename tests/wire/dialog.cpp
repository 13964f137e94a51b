// Reads dialog files and the small notations in them.
#include "tests/wire/dialog.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace dripfeed::wire {
namespace {

constexpr std::array<std::pair<std::string_view, unsigned char>, 19> kNames{{
    {"NUL", 0x00}, {"SOH", 0x01}, {"STX", 0x02}, {"ETX", 0x03}, {"EOT", 0x04}, {"ACK", 0x06},  {"LF", 0x0A},
    {"CR", 0x0D},  {"DLE", 0x10}, {"DC1", 0x11}, {"DC2", 0x12}, {"DC3", 0x13}, {"DC3P", 0x93}, {"DC4", 0x14},
    {"NAK", 0x15}, {"SYN", 0x16}, {"CAN", 0x18}, {"SUB", 0x1A}, {"DEL", 0x7F},
}};

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

char escaped(char c) {
  switch (c) {
    case 'n': return '\n';
    case 'r': return '\r';
    default: return c;
  }
}

class Reader {
 public:
  explicit Reader(std::string file) : file_(std::move(file)) {}

  void line(const std::string& text, int number) {
    const std::string content = trimmed(text);
    if (content.empty() || content[0] == '#') return;
    if (content.starts_with("==")) {
      dialogs_.push_back({.name = trimmed(std::string_view(content).substr(2)), .steps = {}});
      return;
    }
    if (dialogs_.empty()) fail(number, "a step before the first ==");
    Dialog& now = dialogs_.back();
    if (content.starts_with("after ")) {
      const std::string name = trimmed(std::string_view(content).substr(6));
      const auto before = std::ranges::find(dialogs_, name, &Dialog::name);
      if (before == dialogs_.end() || &*before == &now) fail(number, "no such dialog: " + name);
      now.steps.insert(now.steps.end(), before->steps.begin(), before->steps.end());
      return;
    }
    if (content.starts_with("set ")) {
      now.steps.push_back({.kind = 's', .rest = content.substr(4), .file = file_, .line = number});
      return;
    }
    if (std::string_view("><@!*=~").find(content[0]) == std::string_view::npos) fail(number, "not a step: " + content);
    now.steps.push_back(
        {.kind = content[0], .rest = trimmed(std::string_view(content).substr(1)), .file = file_, .line = number});
  }

  std::vector<Dialog> take() { return std::move(dialogs_); }

 private:
  [[noreturn]] void fail(int number, const std::string& what) const {
    throw std::runtime_error(file_ + ":" + std::to_string(number) + ": " + what);
  }

  std::string file_;
  std::vector<Dialog> dialogs_;
};

}  // namespace

std::vector<Dialog> load_dialogs(std::string_view folder) {
  const std::filesystem::path path = std::filesystem::path(DRIPFEED_SOURCE_DIR) / "tests" / "wire" / folder;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(path)) {
    if (entry.path().extension() == ".dialog") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  std::vector<Dialog> all;
  for (const auto& file : files) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error("cannot read " + file.string());
    Reader reader(file.filename().string());
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) reader.line(line, number);
    for (Dialog& dialog : reader.take()) {
      dialog.name = file.stem().string() + ": " + dialog.name;
      all.push_back(std::move(dialog));
    }
  }
  return all;
}

std::vector<std::string> words(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::vector<std::string> all;
  for (std::string word; in >> word;) all.push_back(word);
  return all;
}

std::chrono::nanoseconds duration(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::int64_t>, 5> kUnits{
      {{"ns", 1}, {"us", 1'000}, {"ms", 1'000'000}, {"s", 1'000'000'000}, {"min", 60'000'000'000}}};
  if (text.starts_with('+')) text.remove_prefix(1);
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const std::string_view unit = text.substr(static_cast<std::size_t>(end - text.data()));
  for (const auto& [name, ns] : kUnits) {
    if (error == std::errc{} && unit == name) return std::chrono::nanoseconds(number * ns);
  }
  throw std::runtime_error("not a duration: " + std::string(text));
}

std::string characters(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == ' ') {
      ++i;
    } else if (text[i] == '"') {
      for (++i; i < text.size() && text[i] != '"'; ++i) out += text[i] == '\\' ? escaped(text[++i]) : text[i];
      ++i;
    } else {
      const std::string_view word = text.substr(i, text.find(' ', i) - i);
      i += word.size();
      const auto named = std::ranges::find(kNames, word, &std::pair<std::string_view, unsigned char>::first);
      unsigned value = 0;
      if (named != kNames.end()) {
        value = named->second;
      } else if (std::from_chars(word.data(), word.data() + word.size(), value, 16).ptr != word.data() + word.size()) {
        throw std::runtime_error("not a character: " + std::string(word));
      }
      out += static_cast<char>(value);
    }
  }
  return out;
}

}  // namespace dripfeed::wire
