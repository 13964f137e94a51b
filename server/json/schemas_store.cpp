// The whole store: its room, whether it is sound, its backups.
#include "server/json/schemas.h"

namespace dripfeed::json {

namespace {

Members verification_members() {
  return {
      {"whole", flag("no fault was found")},
      {"audit", object("its chain", {{"rows", integer("that were read")},
                                     {"head", text("hash of the last row; note it elsewhere to notice a cut end")}})},
      {"ledger", object("of all transfers", {{"jobs", integer("with rows")}, {"rows", integer("that were read")}})},
      {"contents", object("texts, each read and compared with its hash",
                          {{"count", integer("of texts")}, {"bytes", integer("of all")}})},
      {"torn_machines", integer("machines with a torn block that wait for a person's confirmation")},
      {"faults", list_of(object("what is wrong", {{"subject", text("as \"job/7\"")}, {"what", text("a sentence")}}),
                         "none: the store is sound")}};
}

Schema holds() {
  return object("things in the backup", {{"machines", integer("in it")},
                                         {"families", integer("in it")},
                                         {"parts", integer("in it")},
                                         {"programs", integer("in it")},
                                         {"releases", integer("in it")},
                                         {"receipts", integer("in it")},
                                         {"tokens", integer("in it, without their secrets")}});
}

}  // namespace

Schemas store_schemas() {
  static constexpr std::string_view kEngines[] = {"sqlite", "postgresql"};
  return {
      {"StoreRoom", object("where the store is and what room it has",
                           {{"engine", one_of(kEngines, "that keeps it")},
                            {"folder", text("of the server, on its computer")},
                            {"bytes", or_null(integer("of the store's file; null: it is a database"))},
                            {"free_bytes", or_null(integer("of the disk of that folder; null: not known"))},
                            {"backups", or_null(text("folder of the backups; null: none are made here"))},
                            {"backups_free_bytes", or_null(integer("of the disk of the backups; null: not known"))},
                            {"why_no_backups", or_null(text("why none are made here; null: they are"))}})},
      {"StoreVerification", object("the whole store, read through", verification_members())},
      {"Backup",
       object("a backup in the server's folder for them",
              {{"name", text("of the file")}, {"bytes", integer("of the file")}, {"made_at_ms", time_ms("when")}})},
      {"BackupMade",
       object("a backup that was read through before it got its name",
              verification_members() + Members{{"backup", text("name of the file")},
                                               {"schema", integer("version of the store's tables")},
                                               {"bytes", integer("of the file")},
                                               {"holds", holds()},
                                               {"kept", or_null(text("always null: nothing was replaced"))}})},
  };
}

}  // namespace dripfeed::json
