// Edits are carried out from the first to the last; one that begins inside another is left for the next time.
#include "server/cli/fix_text.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

namespace dripfeed::cli {

FixedText fix_text(const text::Source& source, const std::vector<text::Diagnostic>& diagnostics) {
  std::vector<const text::Diagnostic*> with_edit;
  for (const text::Diagnostic& one : diagnostics)
    if (one.fix && one.elsewhere == nullptr) with_edit.push_back(&one);
  std::ranges::stable_sort(with_edit, {}, [](const text::Diagnostic* one) { return one->fix->replaced.begin; });
  FixedText fixed;
  std::size_t end = 0;
  for (const text::Diagnostic* one : with_edit) {
    const text::Edit& edit = *one->fix;
    if (edit.replaced.begin < end) {
      ++fixed.left;
      continue;
    }
    fixed.text.append(source.text().substr(end, edit.replaced.begin - end)).append(edit.text);
    end = edit.replaced.end;
    fixed.carried_out.push_back(one);
  }
  fixed.text.append(source.text().substr(end));
  return fixed;
}

std::string describe_edit(const text::Edit& edit, const text::Source& source) {
  const std::string_view old = edit.replaced.in(source.text());
  if (old.empty()) return fmt::format("add `{}`", edit.text);
  if (edit.text.empty()) return fmt::format("remove `{}`", old);
  return fmt::format("write `{}` in the place of `{}`", edit.text, old);
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
