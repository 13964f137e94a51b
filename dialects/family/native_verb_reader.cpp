// native DIALECT "TEXT" ... changes nothing, motion, feed: the last resort, for what the language has no verb for.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "dialects/family/body_reader.h"

namespace dripfeed::family {

void BodyReader::native() {
  NativeVerb out;
  if (family_.natives.size() == kMostNatives)
    return cursor_.syntax(verb_, fmt::format("a family has {} native blocks at most", kMostNatives));
  if (open_drills_ > 0) return cursor_.syntax(verb_, "native text does not stand among holes");
  do {
    const text::Span at = cursor_.peek().span;
    std::string dialect = cursor_.expect_hyphenated("a language such as fanuc, or changes");
    if (cursor_.line_failed()) return;
    if (out.find(dialect) != nullptr) return cursor_.syntax(at, fmt::format("{} is given twice", dialect));
    auto text = cursor_.accept_string();
    if (!text || text->find_first_not_of(' ') == std::string::npos)
      return cursor_.expected("one block of that language, in quotes");
    out.rows.push_back({std::move(dialect), std::move(*text)});
  } while (!cursor_.at_word("changes") && !cursor_.at_line_end());
  if (!cursor_.expect_word("changes")) return;
  if (!cursor_.accept_word("nothing")) {
    do {
      const bool is_motion = cursor_.at_word("motion");
      if (!is_motion && !cursor_.at_word("feed")) return cursor_.expected("nothing, motion or feed");
      cursor_.advance();
      (is_motion ? out.changes_motion : out.changes_feed) = true;
    } while (cursor_.accept_symbol(","));
  }
  if (cursor_.line_failed() || !cursor_.at_line_end()) return;
  out.span = {verb_.begin, cursor_.last_span().end};
  Step stands = step(StepKind::native);
  stands.number = static_cast<std::int32_t>(family_.natives.size());
  family_.natives.push_back(std::move(out));
  add(std::move(stands));
}

}  // namespace dripfeed::family
