// Real programs of other people against the readers and validators: for every file of DIR/<dialect>/ the tokens tile
// the bytes, the same dialect converts to the same bytes, no truncation stops a reader, and the validator ends; what is
// printed again makes the same motions; as a family it renders to its bytes; read without its plain moves it does the
// same. Prints, for each dialect, how many files
// have no error and how often each diagnostic came. What a diagnostic is worth is for a person to judge, from the list:
//
//   DRIPFEED_CORPUS=DIR ctest --test-dir build/dev -R real_programs -V
//   build/dev/real_programs DIR [--list FILE | --list-all FILE] [--only PART] [--broken PART] [--every-length BYTES]...
//
// --list: FILE gets a line for each diagnostic of a file that has errors: severity, id, file:line:column, text, the
// line; --list-all: of every file.
// --only: files whose path holds PART. --broken: files that are wrong on purpose: read, but left out of the figures.
// --every-length: a file is broken off after each of its first BYTES bytes, not at 50 places only (takes as long as
// reading the square of their number).
// Environment: DRIPFEED_CORPUS stands for DIR, DRIPFEED_CORPUS_BROKEN for one --broken. Without DIR it ends with 77:
// skipped.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/shared_definitions.h"
#include "dialects/compile/translate/convert.h"
#include "dialects/text/number.h"
#include "dialects/text/upper_case.h"
#include "tests/corpus/reprint.h"
#include "tests/corpus/thin.h"
#include "tests/corpus/wrapped.h"

namespace {

using namespace dripfeed;
namespace fs = std::filesystem;

constexpr int kSkipped = 77;
constexpr std::size_t kTruncations = 50;  // of each file, spread over its whole length

struct Options {
  fs::path folder;
  std::string list;
  bool list_all = false;  // of files without errors, too
  std::string only;
  std::vector<std::string> broken;
  std::size_t every_length = 0;  // bytes of each file that it is broken off after, one by one
};

// What one folder of programs gave.
struct Tally {
  std::size_t files = 0;
  std::size_t clean = 0;  // files without an error
  std::size_t broken = 0;
  std::size_t lines = 0;
  std::size_t warnings = 0;
  std::size_t wrapped = 0;     // files with numbers that a family gives as parameters
  std::size_t parameters = 0;  // of those
  struct Count {
    std::size_t times = 0;
    std::size_t files = 0;
  };
  // Errors first. One diagnostic may have two severities: an error where all is known, a warning where not.
  std::map<std::pair<text::Severity, std::string_view>, Count, std::greater<>> diagnostics;
};

std::string read_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// "sinumerik" is the folder of sinumerik-840d, "fanuc" that of fanuc.
const compile::Dialect* dialect_of_folder(std::string_view folder) {
  for (const compile::Dialect& dialect : compile::dialects()) {
    if (dialect.name == folder || dialect.name.starts_with(std::string(folder) + "-")) return &dialect;
  }
  return nullptr;
}

std::optional<std::string> fault_of(const ir::Program& program, std::string_view text) {
  std::uint32_t end = 0;
  for (const ir::Token& token : program.tokens) {
    if (token.span.begin != end) return fmt::format("a gap between the tokens at byte {}", end);
    end = token.span.end;
  }
  if (end != text.size()) return fmt::format("the tokens end at byte {} of {}", end, text.size());
  if (ir::print_same(program) != text) return "the program prints back other bytes";
  return std::nullopt;
}

class Corpus {
 public:
  explicit Corpus(const Options& options) : options_(options) {
    if (!options.list.empty()) list_.open(options.list);
  }

  // Exit code.
  int check() {
    std::set<fs::path> folders;
    for (const auto& entry : fs::directory_iterator(options_.folder)) {
      if (entry.is_directory()) folders.insert(entry.path());
    }
    for (const fs::path& folder : folders) {
      const std::string name = folder.filename().string();
      if (const compile::Dialect* dialect = dialect_of_folder(name)) {
        check_folder(folder, *dialect);
      } else {
        fmt::print("{}: no such dialect, left out\n", name);
      }
    }
    if (files_ == 0) fmt::print("no program of a known dialect in {}\n", options_.folder.string());
    fmt::print("{} beginnings of {} files read\n", cuts_, files_);
    fmt::print("{} lines were left out and run from the text\n", thin_lines_);
    fmt::print("slowest: {} ms, {}\n", text::format_fixed(slowest_ms_, 0), slowest_);
    return faults_ == 0 && files_ > 0 ? 0 : 1;
  }

 private:
  void check_folder(const fs::path& folder, const compile::Dialect& dialect) {
    std::set<fs::path> paths;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.is_regular_file() && entry.path().string().contains(options_.only)) paths.insert(entry.path());
    }
    Tally tally;
    for (const fs::path& path : paths) check_file(path, dialect, tally);
    print(folder.filename().string(), tally);
  }

  void check_file(const fs::path& path, const compile::Dialect& dialect, Tally& tally) {
    const auto begin = std::chrono::steady_clock::now();
    const std::string name = fs::relative(path, options_.folder).string();
    const text::Source source(name, read_file(path));
    const ir::Control control = compile::with_definitions(dialect.infer_control(source), definitions_next_to(path));
    ir::ReadResult read = dialect.read(source, control);
    if (const auto fault = fault_of(read.program, source.text())) complain(name, *fault);
    std::vector<text::Diagnostic> found = std::move(read.diagnostics);
    std::ranges::move(dialect.validate(read.program, control, ir::Delivery::memory), std::back_inserter(found));
    const compile::ConvertRequest same{.source = source, .from = control, .to = control};
    if (!text::has_error(found)) {
      if (const auto fault = corpus::reprint_fault(source, read.program, dialect, control)) complain(name, *fault);
    }
    if (compile::convert(same).text != source.text()) complain(name, "the same dialect converts to other bytes");
    if (const auto fault = corpus::thin_fault(source, dialect, control, thin_lines_)) complain(name, *fault);
    wrap(source, dialect, control, tally);
    cut(source, dialect, control);
    count(source, found, tally);
    note_time(name, std::chrono::steady_clock::now() - begin);
  }

  // Definition files in the program's folder, and in one named DEF next to it, as a control keeps them.
  static compile::FindText definitions_next_to(const fs::path& program) {
    return [program](std::string_view name) -> std::optional<text::Source> {
      const fs::path own = program.parent_path();
      for (const fs::path& folder : {own, own.parent_path() / "DEF"}) {
        std::error_code error;
        for (const auto& entry : fs::directory_iterator(folder, error)) {
          const bool is_definition = text::upper_case(entry.path().extension().string()) == ".DEF";
          if (is_definition && text::upper_case(entry.path().stem().string()) == name)
            return text::Source(entry.path().string(), read_file(entry.path()));
        }
      }
      return std::nullopt;
    };
  }

  void wrap(const text::Source& source, const compile::Dialect& dialect, const ir::Control& control, Tally& tally) {
    const corpus::Wrapped made = corpus::wrap(source, dialect, control);
    if (made.fault) complain(source.name(), *made.fault);
    if (made.parameters == 0) return;
    ++tally.wrapped;
    tally.parameters += made.parameters;
  }

  // The beginning of a program, broken off anywhere, is read like any other text.
  void cut(const text::Source& source, const compile::Dialect& dialect, const ir::Control& control) {
    const std::size_t whole = source.text().size();
    const std::size_t each = std::min(options_.every_length, whole);
    for (std::size_t size = 0; size < each; ++size) cut_at(size, source, dialect, control);
    for (std::size_t i = 0; i < kTruncations; ++i) {
      const std::size_t size = whole * i / kTruncations;
      if (size >= each) cut_at(size, source, dialect, control);
    }
  }

  void cut_at(std::size_t size, const text::Source& source, const compile::Dialect& dialect,
              const ir::Control& control) {
    ++cuts_;
    const text::Source part(source.name(), std::string(source.text().substr(0, size)));
    const ir::ReadResult read = dialect.read(part, control);
    if (const auto fault = fault_of(read.program, part.text())) {
      complain(source.name(), fmt::format("cut at {}: {}", size, *fault));
    }
    static_cast<void>(dialect.validate(read.program, control, ir::Delivery::drip));
  }

  void count(const text::Source& source, const std::vector<text::Diagnostic>& found, Tally& tally) {
    ++files_;
    const auto holds = [&](const std::string& part) { return source.name().contains(part); };
    if (std::ranges::any_of(options_.broken, holds)) {
      ++tally.broken;
      return;
    }
    ++tally.files;
    tally.lines += source.line_count();
    const bool wrong = text::has_error(found);
    if (!wrong) ++tally.clean;
    std::set<std::pair<text::Severity, std::string_view>> seen;
    for (const text::Diagnostic& diagnostic : found) {
      const std::string_view id = text::row_of(diagnostic.id).name;
      const std::pair key(diagnostic.severity, id);
      Tally::Count& count = tally.diagnostics[key];
      ++count.times;
      if (seen.insert(key).second) ++count.files;
      if (diagnostic.severity == text::Severity::warning) ++tally.warnings;
      if ((wrong || options_.list_all) && list_.is_open()) list(source, diagnostic, id);
    }
  }

  void list(const text::Source& source, const text::Diagnostic& diagnostic, std::string_view id) {
    const text::Position at = source.position(diagnostic.span.begin);
    list_ << fmt::format("{}\t{}\t{}:{}:{}\t{}\t{}\n", name_of(diagnostic.severity), id, source.name(), at.line,
                         at.column, message_of(diagnostic), source.line(at.line));
  }

  void complain(const std::string& name, std::string_view fault) {
    ++faults_;
    fmt::print("FAULT {}: {}\n", name, fault);
  }

  void note_time(const std::string& name, std::chrono::steady_clock::duration passed) {
    const double ms = std::chrono::duration<double, std::milli>(passed).count();
    if (ms <= slowest_ms_) return;
    slowest_ms_ = ms;
    slowest_ = name;
  }

  static void print(const std::string& folder, const Tally& tally) {
    if (tally.files + tally.broken == 0) return;
    const double share =
        100.0 * static_cast<double>(tally.clean) / static_cast<double>(std::max<std::size_t>(1, tally.files));
    const double warnings =
        100.0 * static_cast<double>(tally.warnings) / static_cast<double>(std::max<std::size_t>(1, tally.lines));
    fmt::print("{}: {} files, {} without error ({} %), {} warnings in 100 lines", folder, tally.files, tally.clean,
               text::format_fixed(share, 1), text::format_fixed(warnings, 2));
    if (tally.broken > 0) fmt::print(", {} more that are wrong on purpose", tally.broken);
    fmt::print("\n  as families: {} files with {} parameters\n", tally.wrapped, tally.parameters);
    for (const auto& [key, count] : tally.diagnostics) {
      fmt::print("  {:7} {:28} {:6} in {:4} files\n", name_of(key.first), key.second, count.times, count.files);
    }
  }

  const Options& options_;
  std::ofstream list_;
  std::size_t files_ = 0;
  std::size_t cuts_ = 0;
  std::size_t thin_lines_ = 0;
  std::size_t faults_ = 0;
  double slowest_ms_ = 0.0;
  std::string slowest_ = "none";
};

Options options_of(int count, char** arguments) {
  Options options;
  if (const char* folder = std::getenv("DRIPFEED_CORPUS")) options.folder = folder;
  if (const char* broken = std::getenv("DRIPFEED_CORPUS_BROKEN")) options.broken.emplace_back(broken);
  for (int i = 1; i < count; ++i) {
    const std::string_view word = arguments[i];
    const bool more = i + 1 < count;
    if (word == "--list" && more) {
      options.list = arguments[++i];
    } else if (word == "--list-all" && more) {
      options.list = arguments[++i];
      options.list_all = true;
    } else if (word == "--only" && more) {
      options.only = arguments[++i];
    } else if (word == "--broken" && more) {
      options.broken.emplace_back(arguments[++i]);
    } else if (word == "--every-length" && more) {
      options.every_length = std::strtoull(arguments[++i], nullptr, 10);
    } else {
      options.folder = word;
    }
  }
  return options;
}

}  // namespace

int main(int count, char** arguments) {
  const Options options = options_of(count, arguments);
  if (options.folder.empty()) {
    fmt::print("skipped: DRIPFEED_CORPUS names no folder of real programs\n");
    return kSkipped;
  }
  if (!fs::is_directory(options.folder)) {
    fmt::print(stderr, "{} is no folder\n", options.folder.string());
    return 2;
  }
  return Corpus(options).check();
}
