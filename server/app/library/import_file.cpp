// Of a dump each program is a row.
#include "server/app/library/import_file.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "server/app/library/split_text.h"

namespace dripfeed::app {

namespace {

// Programs of one dump by the names that they give themselves. A name that comes again with another text is numbered,
// so that none is lost.
class NamesOfDump {
 public:
  explicit NamesOfDump(std::string file) : file_(std::move(file)) {}

  std::string name_of(const SplitProgram& program, std::size_t place) {
    std::string own = program.name.empty() ? fmt::format("{} {}", file_, place) : program.name;
    std::vector<std::string_view>& texts = texts_[own];
    const auto same = std::ranges::find(texts, program.text);
    const auto nth = (same - texts.begin()) + 1;
    if (same == texts.end()) texts.emplace_back(program.text);
    return nth > 1 ? fmt::format("{} {}", own, nth) : own;
  }

 private:
  std::string file_;
  std::map<std::string, std::vector<std::string_view>> texts_;
};

// As an editor or a system leaves them: not meant to be seen.
bool is_hidden(std::string_view path) {
  const auto is_dots = [](std::string_view name) { return name == "." || name == ".."; };
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    const std::string_view name = path.substr(begin, end - begin);
    if (name.starts_with('.') && !is_dots(name)) return true;
    begin = end + 1;
  }
  return false;
}

ImportRow skipped(const FileToImport& file, std::string why) {
  return {.file = file.path,
          .kind = "file",
          .of = {.outcome = ImportOutcome::skipped, .why = std::move(why), .bytes = file.bytes.size()}};
}

}  // namespace

PlaceOfFile place_of_file(std::string_view path, std::string_view under) {
  const std::size_t slash = path.rfind('/');
  const bool has_folder = slash != std::string_view::npos;
  std::string folder(under);
  if (has_folder) folder.append(folder.empty() ? "" : "/").append(path.substr(0, slash));
  return {.folder = std::move(folder), .file = std::string(has_folder ? path.substr(slash + 1) : path)};
}

void import_file(Importer& importer, const FileToImport& file, const OnImported& on_imported) {
  if (is_hidden(file.path)) return on_imported(skipped(file, "is hidden"));
  if (std::string why = why_no_program(file.bytes); !why.empty()) return on_imported(skipped(file, std::move(why)));
  const PlaceOfFile place = place_of_file(file.path, file.under);
  const std::string name = file.keeps_ending ? place.file : program_name_of(place.file);
  const auto programs = split_text(file.bytes);
  if (programs.size() < 2)
    return on_imported(
        {.file = file.path, .of = importer.import({.name = name, .folder = place.folder, .text = file.bytes})});
  const std::string folder = place.folder.empty() ? name : place.folder + "/" + name;
  NamesOfDump names(name);
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const std::string own = names.name_of(programs[i], i + 1);
    on_imported({.file = file.path, .of = importer.import({.name = own, .folder = folder, .text = programs[i].text})});
  }
}

}  // namespace dripfeed::app
