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
)sql";

}  // namespace dripfeed::sqlite
