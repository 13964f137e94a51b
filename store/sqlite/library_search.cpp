// Four lists, one after the other, each with the newest program first: all words are in its name and numbers; in what
// is known of it (labels, part, machines, comments); anywhere; its name is nearly right. A row of one list is in none
// that follows. So an order needs no figure that changes with other programs, and a page is read from where it begins:
// however many programs have a word, those of one page are looked at. A cursor is the list and its last row: "2.42".
#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "store/sql/paging.h"
#include "store/sqlite/library_table.h"
#include "store/sqlite/library_words.h"

namespace dripfeed::sqlite {
namespace {

using sql::Query;
using sql::Session;
using store::ErrorCode;
using store::Id;
using store::LibraryHit;
using store::Result;

constexpr char kHitBegin = '\x02';
constexpr char kHitEnd = '\x03';

enum class List : std::uint8_t { name, head, text, near };
constexpr std::uint32_t kLists = 4;

// ?1 what is looked for, ?2 what the lists before have (as they look for it), ?3 the row before, ?4 the archive, too,
// ?5 how many. Each row is looked up in `entry`: IN would make a list of all programs first.
constexpr std::array<std::string_view, kLists> kSql = {
    "SELECT head.rowid, snippet(head, -1, char(2), char(3), '…', 12) FROM head WHERE head MATCH ?1 AND ?2 = '' "
    "AND head.rowid < ?3 AND (?4 = 1 OR EXISTS (SELECT 1 FROM entry WHERE program = head.rowid AND is_archived = 0)) "
    "ORDER BY rowid DESC LIMIT ?5",
    "SELECT head.rowid, snippet(head, -1, char(2), char(3), '…', 12) FROM head WHERE head MATCH ?1 "
    "AND rowid NOT IN (SELECT rowid FROM head WHERE head MATCH ?2) "
    "AND head.rowid < ?3 AND (?4 = 1 OR EXISTS (SELECT 1 FROM entry WHERE program = head.rowid AND is_archived = 0)) "
    "ORDER BY rowid DESC LIMIT ?5",
    "SELECT word.rowid, snippet(word, -1, char(2), char(3), '…', 12) FROM word WHERE word MATCH ?1 "
    "AND rowid NOT IN (SELECT rowid FROM head WHERE head MATCH ?2) "
    "AND word.rowid < ?3 AND (?4 = 1 OR EXISTS (SELECT 1 FROM entry WHERE program = word.rowid AND is_archived = 0)) "
    "ORDER BY rowid DESC LIMIT ?5",
    "SELECT head.rowid, name FROM head WHERE head MATCH ?1 "
    "AND rowid NOT IN (SELECT rowid FROM word WHERE word MATCH ?2) "
    "AND head.rowid < ?3 AND (?4 = 1 OR EXISTS (SELECT 1 FROM entry WHERE program = head.rowid AND is_archived = 0)) "
    "ORDER BY rowid DESC LIMIT ?5"};

// Words of names that have most pieces in common are looked at letter by letter.
constexpr std::uint32_t kMostNear = 100;
constexpr std::string_view kNearWords =
    "SELECT w.word FROM name_piece JOIN name_word w ON w.id = name_piece.rowid WHERE name_piece MATCH ?1 "
    "ORDER BY bm25(name_piece) LIMIT ?2";

struct Cursor {
  std::uint32_t list = 0;
  Id before = std::numeric_limits<std::int64_t>::max();
};

template <class Number>
bool take_number(std::string_view& text, Number& into) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), into);
  if (error != std::errc{}) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

std::optional<Cursor> read_cursor(std::string_view text) {
  Cursor cursor;
  if (text.empty()) return cursor;
  if (!take_number(text, cursor.list) || cursor.list >= kLists || !text.starts_with('.')) return std::nullopt;
  text.remove_prefix(1);
  if (!take_number(text, cursor.before) || !text.empty()) return std::nullopt;
  if (cursor.before > static_cast<Id>(std::numeric_limits<std::int64_t>::max())) return std::nullopt;
  return cursor;
}

std::vector<store::SnippetPart> parts_of(std::string_view marked) {
  std::vector<store::SnippetPart> parts;
  bool is_hit = false;
  while (!marked.empty()) {
    const std::size_t end = std::min(marked.find(is_hit ? kHitEnd : kHitBegin), marked.size());
    if (end > 0) parts.push_back({.text = std::string(marked.substr(0, end)), .is_hit = is_hit});
    marked.remove_prefix(std::min(marked.size(), end + 1));
    is_hit = !is_hit;
  }
  return parts;
}

struct Found {
  std::uint32_t list = 0;
  LibraryHit hit{};
};

class Search {
 public:
  Search(Session& session, std::vector<SearchTerm> terms, bool with_archived)
      : session_(session),
        terms_(std::move(terms)),
        in_head_(match_of(terms_, Reach::head)),
        in_text_(match_of(terms_, Reach::text)),
        archived_(with_archived ? 1U : 0U) {}

  void add(const Cursor& from, std::uint32_t rows, std::vector<Found>& into) {
    const auto list = static_cast<List>(from.list);
    const std::string wanted = list == List::name   ? fmt::format("{{name numbers}} : ({})", in_head_)
                               : list == List::head ? in_head_
                               : list == List::text ? in_text_
                                                    : near_names();
    if (wanted.empty()) return;
    const std::string before = list == List::name   ? std::string()
                               : list == List::head ? fmt::format("{{name numbers}} : ({})", in_head_)
                               : list == List::text ? in_head_
                                                    : in_text_;
    Query query(session_, kSql[from.list], wanted, before, from.before, archived_, rows);
    while (query.next()) {
      Found& one = into.emplace_back();
      one.list = from.list;
      one.hit.program = query.number();
      one.hit.snippet = parts_of(query.text());
      one.hit.is_similar = list == List::near;
    }
  }

 private:
  // Each word as it is, or one that is nearly it; "" where no word has another one.
  std::string near_names() {
    std::string out;
    bool has_other = false;
    for (const SearchTerm& term : terms_) {
      std::string any = term.in_head;
      for (const std::string& other : near_words(term.word)) {
        has_other = true;
        any += fmt::format(" OR \"{}\"", other);
      }
      out += fmt::format("{}({})", out.empty() ? "" : " AND ", any);
    }
    return has_other ? fmt::format("{{name}} : ({})", out) : std::string();
  }

  std::vector<std::string> near_words(const std::string& word) {
    std::vector<std::string> found;
    if (!may_have_a_fault(word) || name_words(word).size() != 1) return found;
    Query query(session_, kNearWords, pieces_of(word), kMostNear);
    while (query.next()) {
      std::string other = query.text();
      if (is_near(word, other)) found.push_back(std::move(other));
    }
    return found;
  }

  Session& session_;
  std::vector<SearchTerm> terms_;
  std::string in_head_;
  std::string in_text_;
  std::uint32_t archived_;
};

}  // namespace

Result<store::Page<LibraryHit>> LibraryTable::search(std::string_view words, const store::PageRequest& page,
                                                     bool with_archived) {
  return database_->read("library", [&](Session& session) -> Result<store::Page<LibraryHit>> {
    const auto rows = sql::rows_of(page);
    if (!rows) return std::unexpected(rows.error());
    const auto cursor = read_cursor(page.after);
    if (!cursor) return session.refuse(ErrorCode::invalid_value, fmt::format("no cursor of a search: {}", page.after));
    std::vector<SearchTerm> terms = terms_of(words);
    if (terms.empty()) return session.refuse(ErrorCode::invalid_value, "there is no letter and no digit to look for");
    Search search(session, std::move(terms), with_archived);
    std::vector<Found> found;
    for (Cursor at = *cursor; at.list < kLists && found.size() < *rows; at = {.list = at.list + 1})
      search.add(at, static_cast<std::uint32_t>(*rows - found.size()), found);
    store::Page<LibraryHit> out;
    if (found.size() > page.limit) {
      found.resize(page.limit);
      out.next = fmt::format("{}.{}", found.back().list, found.back().hit.program);
    }
    for (Found& one : found) {
      Query query(session, "SELECT revision FROM entry WHERE program = ?", one.hit.program);
      if (query.next()) one.hit.revision = query.number();
      out.items.push_back(std::move(one.hit));
    }
    return out;
  });
}

}  // namespace dripfeed::sqlite
