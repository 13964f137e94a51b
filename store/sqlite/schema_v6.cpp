// Never edited once it was published.
#include "store/sqlite/schema_v6.h"

namespace dripfeed::sqlite {

// `closed` is what the others say, as a column that an index can have: closed ones are forgotten, open ones never. One
// open alarm has a machine, kind and text, so that two who raise at once cannot double it.
const char* const kSchemaV6 = R"sql(
CREATE TABLE alarm (
  id INTEGER PRIMARY KEY, machine TEXT NOT NULL REFERENCES machine (name),
  kind TEXT NOT NULL CHECK (kind <> ''), body TEXT NOT NULL CHECK (body <> ''),
  count INTEGER NOT NULL CHECK (count > 0), raised_at_ms INTEGER NOT NULL, last_at_ms INTEGER NOT NULL,
  cleared_at_ms INTEGER NOT NULL, acknowledged_by TEXT NOT NULL DEFAULT '', acknowledged_at_ms INTEGER NOT NULL DEFAULT 0,
  shelved_by TEXT NOT NULL DEFAULT '', shelved_until_ms INTEGER NOT NULL DEFAULT 0, shelf_reason TEXT NOT NULL DEFAULT '',
  job INTEGER REFERENCES job (id),
  closed INTEGER NOT NULL AS (cleared_at_ms <> 0 AND acknowledged_at_ms <> 0) STORED,
  CHECK ((acknowledged_by = '') = (acknowledged_at_ms = 0)),
  CHECK ((shelved_by = '') = (shelved_until_ms = 0) AND (shelf_reason = '') = (shelved_until_ms = 0))) STRICT;
CREATE UNIQUE INDEX alarm_open ON alarm (machine, kind, body) WHERE closed = 0;
CREATE INDEX alarm_lasting ON alarm (machine, kind) WHERE cleared_at_ms = 0;
CREATE INDEX alarm_shelved ON alarm (shelved_until_ms) WHERE shelved_until_ms <> 0;
CREATE INDEX alarm_time ON alarm (last_at_ms, id);
CREATE INDEX alarm_open_time ON alarm (last_at_ms, id) WHERE closed = 0;
CREATE INDEX alarm_closed_time ON alarm (last_at_ms, id) WHERE closed = 1;
CREATE INDEX alarm_machine_time ON alarm (machine, last_at_ms, id);
CREATE INDEX alarm_job ON alarm (job) WHERE job IS NOT NULL;

-- What it says of the past stays, and an open one stays.
CREATE TRIGGER alarm_update BEFORE UPDATE ON alarm
WHEN (NEW.id, NEW.machine, NEW.kind, NEW.body, NEW.raised_at_ms, NEW.job)
     IS NOT (OLD.id, OLD.machine, OLD.kind, OLD.body, OLD.raised_at_ms, OLD.job)
  OR OLD.closed = 1 AND (NEW.count, NEW.last_at_ms, NEW.cleared_at_ms, NEW.acknowledged_by, NEW.acknowledged_at_ms)
     IS NOT (OLD.count, OLD.last_at_ms, OLD.cleared_at_ms, OLD.acknowledged_by, OLD.acknowledged_at_ms)
  OR OLD.acknowledged_at_ms <> 0 AND NEW.acknowledged_at_ms IS NOT OLD.acknowledged_at_ms
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER alarm_delete BEFORE DELETE ON alarm WHEN OLD.closed = 0
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
)sql";

}  // namespace dripfeed::sqlite
