// Never edited once it was published.
#include "store/sqlite/schema_v3.h"

namespace dripfeed::sqlite {

const char* const kSchemaV3 = R"sql(
CREATE TABLE receipt (
  id INTEGER PRIMARY KEY, machine TEXT NOT NULL REFERENCES machine (name), name TEXT NOT NULL CHECK (name <> ''),
  style TEXT NOT NULL, sha256 TEXT NOT NULL REFERENCES content (sha256), raw_bytes INTEGER NOT NULL CHECK (raw_bytes >= 0),
  code TEXT NOT NULL, ended_by TEXT NOT NULL,
  state TEXT NOT NULL CHECK (state IN ('stored', 'quarantined', 'accepted', 'discarded')), reason TEXT NOT NULL,
  at_ms INTEGER NOT NULL, program INTEGER, revision INTEGER,
  decided_by TEXT NOT NULL DEFAULT '', decided_reason TEXT NOT NULL DEFAULT '', decided_at_ms INTEGER NOT NULL DEFAULT 0,
  FOREIGN KEY (program, revision) REFERENCES program_revision (program, revision),
  CHECK ((program IS NULL) = (revision IS NULL)), CHECK ((state = 'accepted') = (program IS NOT NULL))) STRICT;
CREATE INDEX receipt_machine ON receipt (machine, id);
CREATE INDEX receipt_content ON receipt (sha256);

CREATE TABLE request (
  id INTEGER PRIMARY KEY, machine TEXT NOT NULL REFERENCES machine (name), verb TEXT NOT NULL, argument TEXT NOT NULL,
  body TEXT NOT NULL, outcome TEXT NOT NULL, detail TEXT NOT NULL, job INTEGER REFERENCES job (id),
  at_ms INTEGER NOT NULL) STRICT;
CREATE INDEX request_machine ON request (machine, id);

ALTER TABLE job ADD COLUMN read_back TEXT NOT NULL DEFAULT '';

CREATE TRIGGER receipt_update BEFORE UPDATE ON receipt
WHEN OLD.decided_at_ms <> 0 OR (NEW.id, NEW.machine, NEW.name, NEW.style, NEW.sha256, NEW.raw_bytes, NEW.code, NEW.ended_by,
     NEW.reason, NEW.at_ms) IS NOT (OLD.id, OLD.machine, OLD.name, OLD.style, OLD.sha256, OLD.raw_bytes, OLD.code, OLD.ended_by,
     OLD.reason, OLD.at_ms)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER receipt_delete BEFORE DELETE ON receipt BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER request_update BEFORE UPDATE ON request BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER request_delete BEFORE DELETE ON request BEGIN SELECT RAISE(ABORT, 'append-only'); END;

-- A content keeps its bytes as long as a receipt refers to it, too.
CREATE TRIGGER content_chunk_delete_received BEFORE DELETE ON content_chunk
WHEN EXISTS (SELECT 1 FROM content JOIN receipt r ON r.sha256 = content.sha256 WHERE content.id = OLD.content)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
)sql";

}  // namespace dripfeed::sqlite
