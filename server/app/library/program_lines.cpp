// Lines end as they do everywhere: LF, CR LF, CR and LF CR CR count one each.
#include "server/app/library/program_lines.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "dialects/text/number.h"
#include "dialects/text/source.h"

namespace dripfeed::app {

namespace {

constexpr std::size_t kPiece = store::kChunkBytes;
constexpr std::size_t kLongestEob = 3;
constexpr std::size_t kLongestShown = 4096;
constexpr std::uint64_t kMarkEvery = store::kChunkBytes;
constexpr std::uint64_t kWalked = 8192;  // so near, places are walked rather than halved

// Lines of a stored text, one after the other from a place where one begins.
class LineWalk {
 public:
  LineWalk(store::Contents& contents, std::string_view sha256, std::uint64_t offset)
      : contents_(contents), sha256_(sha256), read_to_(offset) {}

  // Where the next line begins.
  [[nodiscard]] std::uint64_t offset() const { return read_to_ - (buffer_.size() - at_); }
  // The next line; false at the end. `text` gets its beginning, where it is given.
  Result<bool> next(std::string* text = nullptr) {
    if (text != nullptr) text->clear();
    bool any = false;
    for (;;) {
      const std::size_t eob = std::string_view(buffer_).find_first_of("\r\n", at_);
      const bool is_whole = eob != std::string::npos && (is_over_ || eob + kLongestEob <= buffer_.size());
      if (is_whole) {
        take(eob, text);
        at_ = eob + text::eob_length(buffer_, eob);
        return true;
      }
      if (eob == std::string::npos) {
        any = any || at_ < buffer_.size();
        take(buffer_.size(), text);
      }
      if (is_over_) return any;
      if (auto more = fill(); !more) return std::unexpected(more.error());
    }
  }

 private:
  void take(std::size_t to, std::string* text) {
    if (text != nullptr && text->size() <= kLongestShown)
      text->append(buffer_, at_, std::min(to - at_, kLongestShown + 1 - text->size()));
    at_ = to;
  }
  Result<void> fill() {
    buffer_.erase(0, at_);
    at_ = 0;
    const std::size_t left = buffer_.size();
    buffer_.resize(left + kPiece);
    const auto count = lift(contents_.read(sha256_, read_to_, std::span(buffer_).subspan(left)));
    if (!count) return std::unexpected(count.error());
    buffer_.resize(left + *count);
    read_to_ += *count;
    is_over_ = *count == 0;
    return {};
  }

  store::Contents& contents_;
  std::string sha256_;
  std::uint64_t read_to_;
  std::string buffer_;
  std::size_t at_ = 0;
  bool is_over_ = false;
};

std::string_view take_column(std::string_view& row) {
  const std::string_view column = row.substr(0, row.find('\t'));
  row.remove_prefix(std::min(row.size(), column.size() + 1));
  return column;
}

std::uint64_t number_of(std::string_view text) {
  std::uint64_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

// A row of the places: text offset, printed line, family line, name=value of what is set.
struct PlaceRow {
  std::uint64_t line = 0;
  std::uint64_t origin = 0;
  std::string_view values;
};
PlaceRow place_of(std::string_view row) {
  take_column(row);
  const std::uint64_t line = number_of(take_column(row));
  const std::uint64_t origin = number_of(take_column(row));
  return {.line = line, .origin = origin, .values = row};
}

std::map<std::string, double> values_of(std::string_view columns) {
  std::map<std::string, double> values;
  while (!columns.empty()) {
    const std::string_view column = take_column(columns);
    const std::size_t equals = column.find('=');
    const auto value = equals == std::string_view::npos ? std::nullopt : text::parse_number(column.substr(equals + 1));
    if (value) values.emplace(column.substr(0, equals), *value);
  }
  return values;
}

// Where the row of this line lies, or one before it: a place at which a row begins.
Result<std::uint64_t> find_place(store::Contents& contents, const store::Content& places, std::uint64_t line) {
  std::uint64_t low = 0;
  std::uint64_t high = places.bytes;
  std::string row;
  while (high - low > kWalked) {
    const std::uint64_t middle = low + (high - low) / 2;
    LineWalk walk(contents, places.sha256, middle);
    if (auto rest = walk.next(); !rest) return std::unexpected(rest.error());  // of a row that began before
    const std::uint64_t begin = walk.offset();
    const auto found = walk.next(&row);
    if (!found) return std::unexpected(found.error());
    if (*found && begin < high && place_of(row).line <= line) {
      low = begin;
    } else {
      high = middle;
    }
  }
  return low;
}

}  // namespace

Result<LineReading::IndexPtr> LineReading::index_of(const std::string& sha256) {
  {
    const std::lock_guard lock(mutex_);
    const auto known = std::ranges::find(kept_, sha256, &std::pair<std::string, IndexPtr>::first);
    if (known != kept_.end()) {
      std::rotate(known, known + 1, kept_.end());
      return kept_.back().second;
    }
  }
  auto index = std::make_shared<Index>();
  index->marks.emplace_back(1, 0);
  LineWalk walk(store_.contents(), sha256, 0);
  for (;;) {
    const auto more = walk.next();
    if (!more) return std::unexpected(more.error());
    if (!*more) break;
    ++index->lines;
    if (walk.offset() - index->marks.back().second >= kMarkEvery)
      index->marks.emplace_back(index->lines + 1, walk.offset());
  }
  const std::lock_guard lock(mutex_);
  if (kept_.size() >= kKept) kept_.erase(kept_.begin());
  kept_.emplace_back(sha256, index);
  return index;
}

Result<void> LineReading::add_texts(const std::string& sha256, const Index& index, std::uint64_t from,
                                    std::uint32_t count, std::vector<ProgramLine>& lines) {
  const auto after = std::ranges::upper_bound(index.marks, from, {}, &std::pair<std::uint64_t, std::uint64_t>::first);
  const auto& [line_there, offset] = *std::prev(after);
  LineWalk walk(store_.contents(), sha256, offset);
  for (std::uint64_t line = line_there; line < from + count; ++line) {
    std::string text;
    const auto more = walk.next(line < from ? nullptr : &text);
    if (!more) return std::unexpected(more.error());
    if (!*more) break;
    if (line < from) continue;
    if (text.size() > kLongestShown) {
      text.resize(kLongestShown);
      text += " …";
    }
    lines.push_back({.line = line, .text = std::move(text), .family_line = {}, .family_text = {}, .values = {}});
  }
  return {};
}

Result<void> LineReading::add_places(const store::ProgramRevision& revision, std::vector<ProgramLine>& lines) {
  if (revision.places_sha256.empty() || lines.empty()) return {};
  const auto places = lift(store_.contents().find(revision.places_sha256));
  if (!places) return std::unexpected(places.error());
  const auto begin = find_place(store_.contents(), *places, lines.front().line);
  if (!begin) return std::unexpected(begin.error());
  LineWalk walk(store_.contents(), revision.places_sha256, *begin);
  std::string row;
  for (;;) {
    const auto more = walk.next(&row);
    if (!more) return std::unexpected(more.error());
    if (!*more) return {};
    const PlaceRow place = place_of(row);
    if (place.line > lines.back().line) return {};
    if (place.line < lines.front().line) continue;
    ProgramLine& line = lines[static_cast<std::size_t>(place.line - lines.front().line)];
    line.values = values_of(place.values);
    if (place.origin > 0) line.family_line = place.origin;
  }
}

// The revision of the family that was rendered, whatever it is now.
void LineReading::add_family(const store::Origin& origin, std::vector<ProgramLine>& lines) {
  if (origin.family.empty()) return;
  const auto family = store_.families().get(origin.family, origin.family_revision);
  if (!family) return;
  const text::Source source(family->name, family->text);
  for (ProgramLine& line : lines) {
    if (!line.family_line || *line.family_line > source.line_count()) continue;
    line.family_text = source.line(static_cast<std::uint32_t>(*line.family_line));
  }
}

Result<ProgramLines> LineReading::lines(const store::ProgramRevision& revision, std::uint64_t from,
                                        std::uint32_t count) {
  const auto index = index_of(revision.sha256);
  if (!index) return std::unexpected(index.error());
  ProgramLines found{.count_all = (*index)->lines, .lines = {}};
  if (auto texts = add_texts(revision.sha256, **index, from, count, found.lines); !texts)
    return std::unexpected(texts.error());
  if (auto places = add_places(revision, found.lines); !places) return std::unexpected(places.error());
  add_family(revision.origin, found.lines);
  return found;
}

}  // namespace dripfeed::app
