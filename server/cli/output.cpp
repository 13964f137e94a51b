// A text is written whole or the command fails: half a program must not look like one.
#include "server/cli/output.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "server/app/library/fix_text.h"
#include "server/cli/logging.h"

namespace dripfeed::cli {

namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

void print_error(std::string_view sentence) { say(sentence); }

void print_error(const app::Error& error) {
  std::string text = error.text;
  const bool is_in_sentence =  // the only one, with its place
      error.places.size() == 1 && !error.places.front().pointer.empty() &&
      text.ends_with(fmt::format("{} {}", error.places.front().pointer, error.places.front().text));
  for (const app::ErrorPlace& place : error.places) {
    if (is_in_sentence) break;
    text += place.pointer.empty() ? fmt::format("\n  line {}, column {}: {}", place.line, place.column, place.text)
                                  : fmt::format("\n  {} {}", place.pointer, place.text);
  }
  print_error(text);
}

void print_diagnostics(const std::vector<text::Diagnostic>& diagnostics, const text::Source& source,
                       std::string_view control) {
  print_diagnostics(diagnostics, source, control, {});
}

void print_diagnostics(const std::vector<text::Diagnostic>& diagnostics, const text::Source& source,
                       std::string_view control, const LineOrigin& origin) {
  text::DiagnosticFold fold;
  for (const text::Diagnostic& diagnostic : diagnostics) {
    if (!fold.shows(diagnostic)) continue;
    fmt::print(stderr, "{}", text::format_diagnostic(diagnostic, source, control));
    const text::Source& in = diagnostic.elsewhere == nullptr ? source : *diagnostic.elsewhere;
    if (diagnostic.fix) fmt::print(stderr, "  fix: {}\n", app::describe_edit(*diagnostic.fix, in));
    if (origin && diagnostic.elsewhere == nullptr) {
      const std::string from = origin(source.position(diagnostic.span.begin).line);
      if (!from.empty()) fmt::print(stderr, "  from: {}\n", from);
    }
    print_help(diagnostic.id);
  }
  print_folded(fold, source.name());
}

void print_help(text::DiagnosticId id) {
  static std::set<text::DiagnosticId> printed;
  if (printed.insert(id).second) fmt::print(stderr, "  help: {}\n", text::row_of(id).help);
}

void print_folded(const text::DiagnosticFold& fold, std::string_view name) {
  for (const text::DiagnosticFold::Row& row : fold.folded()) fmt::print(stderr, "{}", text::format_folded(row, name));
}

void print_not_validated(std::string_view file) {
  fmt::print(stderr,
             "{}: not validated: it is so long that it was run while it was read; dripfeed check looks at all of it\n",
             file);
}

bool write_output(const std::string& path, std::string_view text) {
  return write_output_by(
      path, [text](std::FILE* file) { return std::fwrite(text.data(), 1, text.size(), file) == text.size(); });
}

bool write_output_by(const std::string& path, const std::function<bool(std::FILE*)>& write) {
  if (path.empty() || path == "-") {
    if (write(stdout) && std::fflush(stdout) == 0) return true;
    print_error(fmt::format("standard output: {}", std::strerror(errno)));
    return false;
  }
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "wb"));
  if (file && write(file.get()) && std::fflush(file.get()) == 0) return true;
  const std::string why = std::strerror(errno);
  // The beginning of a program must not lie where a control might fetch it as one.
  std::error_code failed;
  const bool is_removed =
      file && std::filesystem::is_regular_file(path, failed) && std::filesystem::remove(path, failed);
  print_error(fmt::format("{}: {}{}", path, why, is_removed ? "; nothing of it is left" : ""));
  return false;
}

std::string replace_file(const std::string& path, const std::string& text) {
  namespace fs = std::filesystem;
  std::error_code failed;
  const std::string fresh = path + ".fixed";
  if (fs::exists(fresh, failed)) return fmt::format("{} is there already", fresh);
  {
    std::ofstream file(fresh, std::ios::binary);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    file.flush();
    if (!file) return fmt::format("{} cannot be written", fresh);
  }
  const fs::file_status old = fs::status(path, failed);
  if (!failed) fs::permissions(fresh, old.permissions(), failed);
  if (!failed) fs::rename(fresh, path, failed);
  if (!failed) return {};
  const std::string why = failed.message();
  fs::remove(fresh, failed);
  return fmt::format("{}: {}", path, why);
}

}  // namespace dripfeed::cli
