// Never edited once it was published.
#include "store/sqlite/schema_v11.h"

namespace dripfeed::sqlite {

// AUTOINCREMENT: a number of an event that was forgotten never comes back. A delivery goes with its event or webhook.
const char* const kSchemaV11 = R"sql(
CREATE TABLE event (
  seq INTEGER PRIMARY KEY AUTOINCREMENT, topic TEXT NOT NULL, word TEXT NOT NULL CHECK (word <> ''),
  subject INTEGER NOT NULL, machine TEXT NOT NULL, job INTEGER NOT NULL, program INTEGER NOT NULL,
  revision INTEGER NOT NULL, cause TEXT NOT NULL, body TEXT NOT NULL, actor TEXT NOT NULL, at_ms INTEGER NOT NULL) STRICT;
CREATE INDEX event_time ON event (at_ms);
CREATE TRIGGER event_update BEFORE UPDATE ON event BEGIN SELECT RAISE(ABORT, 'append-only'); END;

CREATE TABLE event_reader (
  name TEXT PRIMARY KEY CHECK (name <> ''), seen INTEGER NOT NULL CHECK (seen >= 0)) STRICT, WITHOUT ROWID;

CREATE TABLE webhook (
  id INTEGER PRIMARY KEY AUTOINCREMENT, url TEXT NOT NULL CHECK (url <> ''), types TEXT NOT NULL CHECK (types <> ''),
  description TEXT NOT NULL, enabled INTEGER NOT NULL CHECK (enabled IN (0, 1)),
  is_local INTEGER NOT NULL CHECK (is_local IN (0, 1)), secret TEXT NOT NULL CHECK (secret <> ''),
  old_secret TEXT NOT NULL DEFAULT '', old_until_ms INTEGER NOT NULL DEFAULT 0, why_disabled TEXT NOT NULL DEFAULT '',
  created_by TEXT NOT NULL, created_at_ms INTEGER NOT NULL, changed_at_ms INTEGER NOT NULL,
  seen INTEGER NOT NULL CHECK (seen >= 0), missed INTEGER NOT NULL DEFAULT 0,
  CHECK ((old_secret = '') = (old_until_ms = 0)), CHECK (enabled = 0 OR why_disabled = '')) STRICT;

CREATE TABLE webhook_delivery (
  id INTEGER PRIMARY KEY AUTOINCREMENT, webhook INTEGER NOT NULL REFERENCES webhook (id) ON DELETE CASCADE,
  event INTEGER NOT NULL REFERENCES event (seq) ON DELETE CASCADE,
  state TEXT NOT NULL CHECK (state IN ('pending', 'delivered', 'dead')), attempts INTEGER NOT NULL DEFAULT 0,
  next_at_ms INTEGER NOT NULL, last_at_ms INTEGER NOT NULL DEFAULT 0, last_status INTEGER NOT NULL DEFAULT 0,
  last_error TEXT NOT NULL DEFAULT '', CHECK ((state = 'pending') = (next_at_ms <> 0)),
  UNIQUE (webhook, event)) STRICT;
CREATE INDEX webhook_delivery_event ON webhook_delivery (event);
CREATE INDEX webhook_delivery_due ON webhook_delivery (webhook, next_at_ms, event) WHERE state = 'pending';
CREATE INDEX webhook_delivery_delivered ON webhook_delivery (last_at_ms) WHERE state = 'delivered';
CREATE INDEX webhook_delivery_dead ON webhook_delivery (webhook, event) WHERE state = 'dead';

CREATE TABLE work_order (
  id INTEGER PRIMARY KEY, number TEXT NOT NULL CHECK (number <> ''), operation TEXT NOT NULL,
  part TEXT NOT NULL CHECK (part <> ''), quantity INTEGER NOT NULL CHECK (quantity > 0),
  machine TEXT REFERENCES machine (name), due_at_ms INTEGER NOT NULL, priority INTEGER NOT NULL CHECK (priority >= 0),
  metadata TEXT NOT NULL, state TEXT NOT NULL CHECK (state IN ('open', 'held', 'done', 'cancelled')),
  reason TEXT NOT NULL, revision INTEGER NOT NULL, created_by TEXT NOT NULL, created_at_ms INTEGER NOT NULL,
  changed_at_ms INTEGER NOT NULL, UNIQUE (number, operation)) STRICT;
CREATE INDEX work_order_state ON work_order (state, id);
CREATE INDEX work_order_part ON work_order (part, id);
CREATE TRIGGER work_order_delete BEFORE DELETE ON work_order BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER work_order_update BEFORE UPDATE ON work_order
WHEN (NEW.id, NEW.number, NEW.operation, NEW.created_by, NEW.created_at_ms)
     IS NOT (OLD.id, OLD.number, OLD.operation, OLD.created_by, OLD.created_at_ms)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;

CREATE TABLE parts_report (
  work_order INTEGER NOT NULL REFERENCES work_order (id), n INTEGER NOT NULL,
  good INTEGER NOT NULL CHECK (good >= 0), scrap INTEGER NOT NULL CHECK (scrap >= 0), note TEXT NOT NULL,
  actor TEXT NOT NULL, at_ms INTEGER NOT NULL, PRIMARY KEY (work_order, n)) STRICT, WITHOUT ROWID;
CREATE TRIGGER parts_report_update BEFORE UPDATE ON parts_report BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER parts_report_delete BEFORE DELETE ON parts_report BEGIN SELECT RAISE(ABORT, 'append-only'); END;

ALTER TABLE job ADD COLUMN work_order INTEGER REFERENCES work_order (id);
CREATE INDEX job_work_order ON job (work_order, state) WHERE work_order IS NOT NULL;
CREATE TRIGGER job_work_order_update BEFORE UPDATE OF work_order ON job
WHEN NEW.work_order IS NOT OLD.work_order BEGIN SELECT RAISE(ABORT, 'append-only'); END;
)sql";

}  // namespace dripfeed::sqlite
