// What is put into the library, and what is known of calls. Looking for words is in library_search.cpp.
#include "store/sqlite/library_table.h"

#include "store/sqlite/library_words.h"

namespace dripfeed::sqlite {
namespace {

using sql::Query;
using sql::Session;
using store::Id;
using store::LibraryEntry;
using store::Result;

void remove(Session& session, Id program) {
  session.run("DELETE FROM word WHERE rowid = ?", program);
  session.run("DELETE FROM head WHERE rowid = ?", program);
  session.run("DELETE FROM own_name WHERE program = ?", program);
  session.run("DELETE FROM call WHERE program = ?", program);
  session.run("DELETE FROM entry WHERE program = ?", program);
}

// Each word of all names once: those that a fault is looked for in are few, however many programs there are.
void add_name_words(Session& session, std::string_view name) {
  for (const std::string& word : name_words(name)) {
    if (!may_have_a_fault(word)) continue;
    session.run("INSERT OR IGNORE INTO name_word (word) VALUES (?)", word);
    if (session.changed_rows() == 0) continue;
    session.run("INSERT INTO name_piece (rowid, pieces) VALUES (?, ?)", session.last_id(), marked_word(word));
  }
}

void add(Session& session, const LibraryEntry& one) {
  session.run(
      "INSERT INTO entry (program, revision, change_number, sha256, name, is_archived, is_cut, not_read, "
      "computed_calls) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)",
      one.program, one.revision, one.change, one.sha256, one.name, one.is_archived ? 1U : 0U, one.is_cut ? 1U : 0U,
      one.not_read, one.computed_calls);
  session.run(
      "INSERT INTO word (rowid, name, numbers, labels, part, machines, comments, body) VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
      one.program, one.name, one.numbers, one.labels, one.part, one.machines, one.comments, one.text);
  session.run("INSERT INTO head (rowid, name, numbers, labels, part, machines, comments) VALUES (?, ?, ?, ?, ?, ?, ?)",
              one.program, one.name, one.numbers, one.labels, one.part, one.machines, one.comments);
  add_name_words(session, one.name);
  for (const std::string& name : one.names)
    session.run("INSERT OR IGNORE INTO own_name (name, program) VALUES (?, ?)", name, one.program);
  for (const store::ProgramCall& call : one.calls)
    session.run("INSERT OR IGNORE INTO call (program, name, kind, line) VALUES (?, ?, ?, ?)", one.program, call.name,
                call.kind, std::uint64_t{call.line});
}

store::ProgramCall read_call(Query& query) {
  store::ProgramCall call;
  call.name = query.text();
  call.kind = query.value<store::CallKind>();
  call.line = static_cast<std::uint32_t>(query.number());
  return call;
}

}  // namespace

// `body` and not `text`: the word is SQL's. Each search asks how many programs there are, so triggers count them.
const char* const kLibrarySchema = R"sql(
CREATE TABLE reached (
  id INTEGER PRIMARY KEY CHECK (id = 1), change_number INTEGER NOT NULL, programs INTEGER NOT NULL,
  cut INTEGER NOT NULL, not_read INTEGER NOT NULL) STRICT;
INSERT INTO reached VALUES (1, 0, 0, 0, 0);
CREATE TABLE entry (
  program INTEGER PRIMARY KEY, revision INTEGER NOT NULL, change_number INTEGER NOT NULL, sha256 TEXT NOT NULL,
  name TEXT NOT NULL, is_archived INTEGER NOT NULL, is_cut INTEGER NOT NULL, not_read TEXT NOT NULL,
  computed_calls INTEGER NOT NULL) STRICT;
CREATE TRIGGER entry_comes AFTER INSERT ON entry BEGIN
  UPDATE reached SET programs = programs + 1, cut = cut + NEW.is_cut, not_read = not_read + (NEW.not_read <> '');
END;
CREATE TRIGGER entry_goes AFTER DELETE ON entry BEGIN
  UPDATE reached SET programs = programs - 1, cut = cut - OLD.is_cut, not_read = not_read - (OLD.not_read <> '');
END;
CREATE VIRTUAL TABLE word USING fts5 (
  name, numbers, labels, part, machines, comments, body, tokenize = "unicode61 remove_diacritics 2");
CREATE VIRTUAL TABLE head USING fts5 (
  name, numbers, labels, part, machines, comments, tokenize = "unicode61 remove_diacritics 2");
CREATE TABLE name_word (id INTEGER PRIMARY KEY, word TEXT NOT NULL UNIQUE) STRICT;
CREATE VIRTUAL TABLE name_piece USING fts5 (pieces, tokenize = "trigram");
CREATE TABLE own_name (name TEXT NOT NULL, program INTEGER NOT NULL, PRIMARY KEY (name, program)) STRICT, WITHOUT ROWID;
CREATE INDEX own_name_program ON own_name (program);
CREATE TABLE call (
  program INTEGER NOT NULL, name TEXT NOT NULL, kind TEXT NOT NULL, line INTEGER NOT NULL,
  PRIMARY KEY (program, name, kind)) STRICT, WITHOUT ROWID;
CREATE INDEX call_name ON call (name);
)sql";

Result<store::LibraryState> LibraryTable::state() {
  return database_->read("library", [](Session& session) -> Result<store::LibraryState> {
    Query query(session, "SELECT change_number, programs, cut, not_read FROM reached");
    store::LibraryState state;
    if (!query.next()) return state;
    state.change = query.number();
    state.programs = query.number();
    state.cut = query.number();
    state.not_read = query.number();
    return state;
  });
}

Result<void> LibraryTable::put(const std::vector<LibraryEntry>& entries, std::uint64_t reached) {
  return database_->write("library", [&](Session& session) -> Result<void> {
    for (const LibraryEntry& one : entries) {
      remove(session, one.program);
      if (one.revision != 0) add(session, one);
    }
    session.run("UPDATE reached SET change_number = ?", reached);
    return {};
  });
}

Result<void> LibraryTable::clear() {
  return database_->write("library", [](Session& session) -> Result<void> {
    for (const std::string_view sql :
         {"DELETE FROM word", "DELETE FROM head", "DELETE FROM name_piece", "DELETE FROM name_word",
          "DELETE FROM own_name", "DELETE FROM call", "DELETE FROM entry", "UPDATE reached SET change_number = 0"})
      session.run(sql);
    return {};
  });
}

Result<std::vector<store::Caller>> LibraryTable::callers_of(Id program) {
  return database_->read("library", [&](Session& session) -> Result<std::vector<store::Caller>> {
    Query query(session,
                "SELECT c.program, c.name, c.kind, c.line FROM own_name o JOIN call c ON c.name = o.name "
                "WHERE o.program = ? ORDER BY c.program, c.line",
                program);
    std::vector<store::Caller> found;
    while (query.next()) {
      const Id caller = query.number();
      found.push_back({.program = caller, .call = read_call(query)});
    }
    return found;
  });
}

Result<store::KnownCalls> LibraryTable::calls_of(Id program) {
  return database_->read("library", [&](Session& session) -> Result<store::KnownCalls> {
    store::KnownCalls known;
    {
      Query query(session, "SELECT not_read, computed_calls FROM entry WHERE program = ?", program);
      known.is_known = query.next();
      if (!known.is_known) return known;
      known.not_read = query.text();
      known.computed = query.number();
    }
    Query query(session, "SELECT name, kind, line FROM call WHERE program = ? ORDER BY line, name", program);
    while (query.next()) known.calls.push_back(read_call(query));
    return known;
  });
}

Result<std::vector<Id>> LibraryTable::named(std::string_view name) {
  return database_->read("library", [&](Session& session) -> Result<std::vector<Id>> {
    Query query(session, "SELECT program FROM own_name WHERE name = ? ORDER BY program", name);
    std::vector<Id> found;
    while (query.next()) found.push_back(query.number());
    return found;
  });
}

}  // namespace dripfeed::sqlite
