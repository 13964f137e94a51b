// Edits are carried out from the first to the last; one that begins inside another is left for the next time.
#include "server/app/library/fix_text.h"

#include <algorithm>

#include <fmt/format.h>

namespace dripfeed::app {

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

}  // namespace dripfeed::app
