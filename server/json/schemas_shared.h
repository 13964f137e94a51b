// What several documents have in common.
#pragma once

#include "dialects/text/diagnostic.h"
#include "server/json/enumerators.h"
#include "server/json/schemas.h"

namespace dripfeed::json {

inline Members created() {
  return {{"created_by", text("who made it")}, {"created_at_ms", time_ms("when it was made")}};
}

inline Schema severity() { return one_of(names_of<text::Severity>(text::name_of), "how bad it is"); }
inline Schema control_alarm() { return or_null(text("by which the control itself would name it")); }

inline Schema diagnostics_schema(std::string of) {
  return list_of(
      object("a fault in a text", {{"id", text("of the kind of fault")},
                                   {"severity", severity()},
                                   {"file", or_null(text("the called program that it is in; null: the text itself"))},
                                   {"line", integer("from 1")},
                                   {"column", integer("from 1, in bytes")},
                                   {"column_chars", integer("from 1, in characters")},
                                   {"text", text("one sentence")},
                                   {"alarm", control_alarm()}}),
      std::move(of));
}

}  // namespace dripfeed::json
