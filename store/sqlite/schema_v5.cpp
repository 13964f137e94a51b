// Never edited once it was published.
#include "store/sqlite/schema_v5.h"

namespace dripfeed::sqlite {

const char* const kSchemaV5 = R"sql(
CREATE TABLE answer (
  id INTEGER PRIMARY KEY, machine TEXT NOT NULL REFERENCES machine (name), bytes_total INTEGER NOT NULL CHECK (bytes_total >= 0),
  state TEXT NOT NULL CHECK (state IN ('sending', 'whole', 'torn')), reason TEXT NOT NULL DEFAULT '',
  begun_at_ms INTEGER NOT NULL, ended_at_ms INTEGER NOT NULL DEFAULT 0,
  confirmed_by TEXT NOT NULL DEFAULT '', confirm_reason TEXT NOT NULL DEFAULT '', confirmed_at_ms INTEGER NOT NULL DEFAULT 0,
  CHECK ((state = 'sending') = (ended_at_ms = 0))) STRICT;
CREATE INDEX answer_machine ON answer (machine, id);
CREATE INDEX answer_torn ON answer (machine) WHERE state = 'torn' AND confirmed_at_ms = 0;
CREATE INDEX answer_sending ON answer (id) WHERE state = 'sending';

-- An answer ends once, and a torn one is confirmed once.
CREATE TRIGGER answer_update BEFORE UPDATE ON answer
WHEN (NEW.id, NEW.machine, NEW.bytes_total, NEW.begun_at_ms) IS NOT (OLD.id, OLD.machine, OLD.bytes_total, OLD.begun_at_ms)
  OR (OLD.state <> 'sending' AND (NEW.state, NEW.reason, NEW.ended_at_ms) IS NOT (OLD.state, OLD.reason, OLD.ended_at_ms))
  OR OLD.confirmed_at_ms <> 0
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER answer_delete BEFORE DELETE ON answer BEGIN SELECT RAISE(ABORT, 'append-only'); END;
)sql";

}  // namespace dripfeed::sqlite
