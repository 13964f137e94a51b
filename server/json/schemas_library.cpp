// Searches, where a program is used, and files that are attached.
#include "server/app/library/shop_files.h"
#include "server/json/records.h"
#include "server/json/schemas.h"

namespace dripfeed::json {

namespace {

Schema waiting() { return integer("changes of programs that are not in the library yet"); }

Members call_members() {
  return {{"called", text("the name that the call has for it")},
          {"kind", one_of(store::kNames<store::CallKind>, "of call")},
          {"line", integer("of the first such call in the text that calls")}};
}

Members program_members() {
  return {{"program", integer("its id")}, {"name", text("of the program")}, {"is_archived", flag("it was put aside")}};
}

Schema hit() {
  return object(
      "a program that was found",
      {{"is_similar", flag("its name is nearly what was looked for; otherwise all words were found in it")},
       {"snippet",
        list_of(object("a piece", {{"text", text("of what was found")}, {"is_hit", flag("it was looked for")}}),
                "one after the other: the place where most of it stands")},
       {"program", reference("Program")}});
}

Schema search_result() {
  return object("programs by words, a page of them",
                {{"items", list_of(hit(), "best first")},
                 {"next", or_null(text("for `after` of the next page; null: the last"))},
                 {"programs", integer("that are looked through")},
                 {"waiting", waiting()},
                 {"cut", integer("programs so long that not all of their moves are looked through")}});
}

Schema uses() {
  const Schema part = object("a part from which it was rendered", {{"number", text("of the part")},
                                                                   {"part_revision", integer("of the part's values")},
                                                                   {"revision", integer("of the program's text")}});
  const Schema machine = object(
      "a machine with a release or a job of it",
      {{"machine", text("its name")}, {"releases", integer("in this answer")}, {"jobs", integer("in this answer")}});
  return object(
      "where a program is used",
      {{"parts", list_of(part, "newest first")},
       {"machines", list_of(machine, "by name")},
       {"releases", list_of(reference("Release"), "newest first, 100 at most")},
       {"has_more_releases", flag("there are older ones")},
       {"jobs", list_of(reference("Job"), "newest first, 100 at most")},
       {"has_more_jobs", flag("there are older ones")},
       {"called_by",
        list_of(object("a program whose call finds this one by its name", program_members() + call_members()),
                "100 at most")},
       {"calls", list_of(object("a call in this program",
                                call_members() + Members{{"programs", list_of(object("a stored program of this name",
                                                                                     program_members()),
                                                                              "none: it is not stored here")}}),
                         "in the order of the text, 100 at most")},
       {"computed_calls", integer("calls in it that name their program by a value")},
       {"calls_not_known", or_null(text("why its calls are not all of them; null: they are"))},
       {"waiting", waiting()},
       {"unread", integer("programs that could not be read as a whole: what they call is not known")}});
}

Schema attachment() {
  return object(
      "a file of a program, family, part or order",
      {{"id", integer("of the attachment")},
       {"program", or_null(integer("whose file it is, by its id; null: not of a program"))},
       {"family", or_null(text("whose file it is, by its name; null: not of a family"))},
       {"part", or_null(text("whose file it is, by its number; null: not of a part"))},
       {"order", or_null(integer("whose file it is, by its id; null: not of an order"))},
       {"name", text("of the file")},
       {"media_type", text("as whoever attached it stated it")},
       {"bytes", integer("of the file")},
       {"sha256", text("of the file, in hexadecimal")},
       {"added_by", text("who attached it")},
       {"added_at_ms", time_ms("when")},
       {"removed", or_null(object("who removed it; null: it is there",
                                  {{"by", text("who did")}, {"reason", text("why")}, {"at_ms", time_ms("when")}}))}});
}

Schema import_report() {
  return object("what became of a file",
                {{"added", integer("programs that are new")},
                 {"revised", integer("programs that got a revision")},
                 {"same", integer("programs that were there with this text")},
                 {"skipped", integer("programs or files that were left alone")},
                 {"failed", integer("programs that could not be stored")},
                 {"only_looked", flag("nothing was stored: this is what an import would give")},
                 {"items", list_of(object("one program, or a file that has none",
                                          {{"file", text("its path as given")},
                                           {"kind", one_of(app::kImportKinds, "of thing")},
                                           {"outcome", one_of(app::kImportOutcomes, "what became of it")},
                                           {"why", or_null(text("it was skipped or failed; null: it was not"))},
                                           {"why_said", or_null(reference("Said"))},
                                           {"name", or_null(text("of the program"))},
                                           {"folder", or_null(text("of the library; null: none"))},
                                           {"dialect", or_null(text("of the program"))},
                                           {"program", or_null(integer("its id; null: none was stored"))},
                                           {"revision", or_null(integer("that has the text; null: none"))},
                                           {"bytes", integer("of the text")},
                                           {"sha256", or_null(text("of the text"))}}),
                                   "in the order of the file")}});
}

}  // namespace

Schemas library_schemas() {
  return {{"SearchResult", search_result()},
          {"ProgramUses", uses()},
          {"ImportReport", import_report()},
          {"Attachment", attachment()}};
}

}  // namespace dripfeed::json
