// Version 1 of the schema. States and roles stand in it by name. What must never change is held by triggers, so that no
// query of ours, nor a person with the sqlite3 shell, changes it by accident. All tables of revisions are refused both
// UPDATE and DELETE; tables of heads (machine, family, part, program, ledger_head) say which revision is the newest.
#include "store/sqlite/schema_v1.h"

namespace dripfeed::sqlite {

const char* const kSchemaV1 = R"sql(
CREATE TABLE machine (name TEXT PRIMARY KEY CHECK (name <> ''), revision INTEGER NOT NULL) STRICT;
CREATE TABLE machine_revision (
  machine TEXT NOT NULL REFERENCES machine (name), revision INTEGER NOT NULL CHECK (revision > 0),
  profile TEXT NOT NULL, actor TEXT NOT NULL, at_ms INTEGER NOT NULL,
  PRIMARY KEY (machine, revision)) STRICT;

CREATE TABLE family (name TEXT PRIMARY KEY CHECK (name <> ''), revision INTEGER NOT NULL) STRICT;
CREATE TABLE family_revision (
  family TEXT NOT NULL REFERENCES family (name), revision INTEGER NOT NULL CHECK (revision > 0),
  body TEXT NOT NULL, actor TEXT NOT NULL, at_ms INTEGER NOT NULL,
  PRIMARY KEY (family, revision)) STRICT;

CREATE TABLE part (number TEXT PRIMARY KEY CHECK (number <> ''), revision INTEGER NOT NULL) STRICT;
CREATE TABLE part_revision (
  part TEXT NOT NULL REFERENCES part (number), revision INTEGER NOT NULL CHECK (revision > 0),
  family TEXT NOT NULL, family_revision INTEGER NOT NULL, part_values TEXT NOT NULL,
  actor TEXT NOT NULL, at_ms INTEGER NOT NULL,
  PRIMARY KEY (part, revision),
  FOREIGN KEY (family, family_revision) REFERENCES family_revision (family, revision)) STRICT;
CREATE INDEX part_revision_family ON part_revision (family, part);

-- sha256 is NULL while the content is being written.
CREATE TABLE content (
  id INTEGER PRIMARY KEY, sha256 TEXT UNIQUE CHECK (length(sha256) = 64), bytes INTEGER NOT NULL CHECK (bytes >= 0)) STRICT;
CREATE TABLE content_chunk (
  content INTEGER NOT NULL REFERENCES content (id), n INTEGER NOT NULL CHECK (n >= 0), data BLOB NOT NULL,
  PRIMARY KEY (content, n)) STRICT;

CREATE TABLE program (
  id INTEGER PRIMARY KEY, name TEXT NOT NULL CHECK (name <> ''), dialect TEXT NOT NULL, revision INTEGER NOT NULL) STRICT;
CREATE INDEX program_name ON program (name);
CREATE TABLE program_revision (
  program INTEGER NOT NULL REFERENCES program (id), revision INTEGER NOT NULL CHECK (revision > 0),
  sha256 TEXT NOT NULL REFERENCES content (sha256), places_sha256 TEXT REFERENCES content (sha256),
  blocks INTEGER NOT NULL CHECK (blocks >= 0), facts TEXT NOT NULL,
  origin TEXT NOT NULL CHECK (origin IN ('uploaded', 'rendered')),
  family TEXT, family_revision INTEGER, part TEXT, part_revision INTEGER, part_values TEXT NOT NULL,
  machine TEXT, machine_revision INTEGER, mode TEXT NOT NULL,
  actor TEXT NOT NULL, at_ms INTEGER NOT NULL,
  PRIMARY KEY (program, revision),
  FOREIGN KEY (family, family_revision) REFERENCES family_revision (family, revision),
  FOREIGN KEY (part, part_revision) REFERENCES part_revision (part, revision),
  FOREIGN KEY (machine, machine_revision) REFERENCES machine_revision (machine, revision),
  CHECK ((family IS NULL) = (family_revision IS NULL)), CHECK ((part IS NULL) = (part_revision IS NULL)),
  CHECK ((machine IS NULL) = (machine_revision IS NULL)), CHECK (origin <> 'rendered' OR family IS NOT NULL)) STRICT;
CREATE INDEX program_revision_sha256 ON program_revision (sha256);
CREATE INDEX program_revision_places ON program_revision (places_sha256) WHERE places_sha256 IS NOT NULL;
CREATE INDEX program_revision_family ON program_revision (family) WHERE family IS NOT NULL;
CREATE INDEX program_revision_part ON program_revision (part, program) WHERE part IS NOT NULL;

CREATE TABLE verdict (
  id INTEGER PRIMARY KEY, program INTEGER NOT NULL, revision INTEGER NOT NULL, sha256 TEXT NOT NULL,
  machine TEXT NOT NULL, machine_revision INTEGER NOT NULL,
  delivery TEXT NOT NULL CHECK (delivery IN ('drip', 'memory')),
  outcome TEXT NOT NULL CHECK (outcome IN ('pass', 'warn', 'fail', 'unknown')),
  stale INTEGER NOT NULL CHECK (stale IN (0, 1)), report TEXT NOT NULL, actor TEXT NOT NULL, at_ms INTEGER NOT NULL,
  FOREIGN KEY (program, revision) REFERENCES program_revision (program, revision),
  FOREIGN KEY (machine, machine_revision) REFERENCES machine_revision (machine, revision)) STRICT;
CREATE INDEX verdict_text ON verdict (sha256, machine, delivery);
CREATE INDEX verdict_program ON verdict (program);
CREATE INDEX verdict_machine ON verdict (machine);
CREATE TABLE waiver (
  verdict INTEGER NOT NULL REFERENCES verdict (id), n INTEGER NOT NULL,
  name TEXT NOT NULL CHECK (name <> ''), reason TEXT NOT NULL CHECK (reason <> ''), at_ms INTEGER NOT NULL,
  PRIMARY KEY (verdict, n)) STRICT;

-- "release" is a word of SQL.
CREATE TABLE text_release (
  id INTEGER PRIMARY KEY, program INTEGER NOT NULL, revision INTEGER NOT NULL, sha256 TEXT NOT NULL,
  machine TEXT NOT NULL REFERENCES machine (name), delivery TEXT NOT NULL CHECK (delivery IN ('drip', 'memory')),
  state TEXT NOT NULL CHECK (state IN ('draft', 'in_review', 'proving', 'approved', 'obsolete')),
  transfers_allowed INTEGER NOT NULL CHECK (transfers_allowed >= 0),
  transfers_done INTEGER NOT NULL CHECK (transfers_done >= 0),
  created_by TEXT NOT NULL, created_at_ms INTEGER NOT NULL,
  approved_by TEXT NOT NULL, sign_off TEXT NOT NULL, changed_at_ms INTEGER NOT NULL,
  FOREIGN KEY (program, revision) REFERENCES program_revision (program, revision)) STRICT;
CREATE UNIQUE INDEX text_release_valid ON text_release (sha256, machine, delivery) WHERE state <> 'obsolete';
CREATE INDEX text_release_program ON text_release (program);
CREATE INDEX text_release_machine ON text_release (machine);
CREATE TABLE release_step (
  text_release INTEGER NOT NULL REFERENCES text_release (id), n INTEGER NOT NULL,
  from_state TEXT NOT NULL, to_state TEXT NOT NULL, actor TEXT NOT NULL, note TEXT NOT NULL, at_ms INTEGER NOT NULL,
  PRIMARY KEY (text_release, n)) STRICT;

CREATE TABLE job (
  id INTEGER PRIMARY KEY, text_release INTEGER NOT NULL REFERENCES text_release (id),
  program INTEGER NOT NULL, revision INTEGER NOT NULL, sha256 TEXT NOT NULL,
  machine TEXT NOT NULL REFERENCES machine (name), delivery TEXT NOT NULL CHECK (delivery IN ('drip', 'memory')),
  link TEXT NOT NULL, bytes_total INTEGER NOT NULL CHECK (bytes_total >= 0),
  state TEXT NOT NULL CHECK (state IN ('queued', 'armed', 'feeding', 'held', 'draining', 'done', 'failed', 'cancelled',
                                       'interrupted')),
  reason TEXT NOT NULL, created_by TEXT NOT NULL, armed_by TEXT NOT NULL,
  created_at_ms INTEGER NOT NULL, armed_at_ms INTEGER NOT NULL, started_at_ms INTEGER NOT NULL, ended_at_ms INTEGER NOT NULL,
  torn INTEGER NOT NULL CHECK (torn IN (0, 1)),
  confirmed_by TEXT NOT NULL, confirm_reason TEXT NOT NULL, confirmed_at_ms INTEGER NOT NULL,
  FOREIGN KEY (program, revision) REFERENCES program_revision (program, revision)) STRICT;
-- A line feeds one job.
CREATE UNIQUE INDEX job_line ON job (machine) WHERE state IN ('armed', 'feeding', 'held', 'draining');
CREATE INDEX job_torn ON job (machine) WHERE torn = 1 AND confirmed_at_ms = 0;
CREATE INDEX job_machine ON job (machine);
CREATE INDEX job_state ON job (state);

-- Rows of all lines lie one behind the other, as they are committed, so that a commit for many lines writes few pages.
-- A job's rows are found from the last one back (previous), or from every 256th (ledger_mark).
CREATE TABLE ledger (
  id INTEGER PRIMARY KEY, job INTEGER NOT NULL REFERENCES job (id), seq INTEGER NOT NULL CHECK (seq > 0),
  at_ms INTEGER NOT NULL, handed INTEGER NOT NULL, clocked INTEGER NOT NULL, confirmed INTEGER NOT NULL,
  reserve INTEGER NOT NULL, note TEXT NOT NULL, previous INTEGER) STRICT;
CREATE TABLE ledger_head (
  job INTEGER PRIMARY KEY REFERENCES job (id), last INTEGER, seq INTEGER NOT NULL, at_ms INTEGER NOT NULL,
  handed INTEGER NOT NULL, clocked INTEGER NOT NULL, confirmed INTEGER NOT NULL, reserve INTEGER NOT NULL) STRICT;
CREATE TABLE ledger_mark (
  job INTEGER NOT NULL, seq INTEGER NOT NULL, ledger INTEGER NOT NULL, PRIMARY KEY (job, seq)) STRICT, WITHOUT ROWID;

CREATE TABLE audit (
  seq INTEGER PRIMARY KEY, at_ms INTEGER NOT NULL, actor TEXT NOT NULL, action TEXT NOT NULL, subject TEXT NOT NULL,
  detail TEXT NOT NULL, previous_hash TEXT NOT NULL, hash TEXT NOT NULL) STRICT;
CREATE INDEX audit_subject ON audit (subject);

CREATE TABLE token (
  id INTEGER PRIMARY KEY, name TEXT NOT NULL CHECK (name <> ''),
  role TEXT NOT NULL CHECK (role IN ('viewer', 'operator', 'programmer', 'approver', 'admin')),
  hash TEXT NOT NULL UNIQUE CHECK (hash <> ''), created_by TEXT NOT NULL, created_at_ms INTEGER NOT NULL,
  revoked_at_ms INTEGER NOT NULL) STRICT;

CREATE TABLE reply (
  actor TEXT NOT NULL, route TEXT NOT NULL, reply_key TEXT NOT NULL CHECK (reply_key <> ''), request_sha256 TEXT NOT NULL,
  status INTEGER NOT NULL, headers TEXT NOT NULL, body TEXT NOT NULL, at_ms INTEGER NOT NULL,
  PRIMARY KEY (actor, route, reply_key)) STRICT;
CREATE INDEX reply_at ON reply (at_ms);

CREATE TRIGGER machine_revision_update BEFORE UPDATE ON machine_revision BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER machine_revision_delete BEFORE DELETE ON machine_revision BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER family_revision_update BEFORE UPDATE ON family_revision BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER family_revision_delete BEFORE DELETE ON family_revision BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER part_revision_update BEFORE UPDATE ON part_revision BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER part_revision_delete BEFORE DELETE ON part_revision BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER program_revision_update BEFORE UPDATE ON program_revision BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER program_revision_delete BEFORE DELETE ON program_revision BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER waiver_update BEFORE UPDATE ON waiver BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER waiver_delete BEFORE DELETE ON waiver BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER release_step_update BEFORE UPDATE ON release_step BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER release_step_delete BEFORE DELETE ON release_step BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER ledger_update BEFORE UPDATE ON ledger BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER ledger_delete BEFORE DELETE ON ledger BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER audit_update BEFORE UPDATE ON audit BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER audit_delete BEFORE DELETE ON audit BEGIN SELECT RAISE(ABORT, 'append-only'); END;

-- Verdicts only grow stale; releases and jobs keep what they were made for; tokens are only revoked.
CREATE TRIGGER verdict_update BEFORE UPDATE ON verdict
WHEN NEW.stale < OLD.stale OR (NEW.id, NEW.program, NEW.revision, NEW.sha256, NEW.machine, NEW.machine_revision, NEW.delivery,
     NEW.outcome, NEW.report, NEW.actor, NEW.at_ms) IS NOT (OLD.id, OLD.program, OLD.revision, OLD.sha256, OLD.machine,
     OLD.machine_revision, OLD.delivery, OLD.outcome, OLD.report, OLD.actor, OLD.at_ms)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER verdict_delete BEFORE DELETE ON verdict BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER text_release_update BEFORE UPDATE ON text_release
WHEN (NEW.id, NEW.program, NEW.revision, NEW.sha256, NEW.machine, NEW.delivery, NEW.created_by, NEW.created_at_ms)
     IS NOT (OLD.id, OLD.program, OLD.revision, OLD.sha256, OLD.machine, OLD.delivery, OLD.created_by, OLD.created_at_ms)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER text_release_delete BEFORE DELETE ON text_release BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER job_update BEFORE UPDATE ON job
WHEN (NEW.id, NEW.text_release, NEW.program, NEW.revision, NEW.sha256, NEW.machine, NEW.delivery, NEW.link, NEW.bytes_total,
      NEW.created_by, NEW.created_at_ms)
     IS NOT (OLD.id, OLD.text_release, OLD.program, OLD.revision, OLD.sha256, OLD.machine, OLD.delivery, OLD.link,
             OLD.bytes_total, OLD.created_by, OLD.created_at_ms)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER job_delete BEFORE DELETE ON job BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER token_update BEFORE UPDATE ON token
WHEN OLD.revoked_at_ms <> 0 OR (NEW.id, NEW.name, NEW.role, NEW.hash, NEW.created_by, NEW.created_at_ms)
     IS NOT (OLD.id, OLD.name, OLD.role, OLD.hash, OLD.created_by, OLD.created_at_ms)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER token_delete BEFORE DELETE ON token BEGIN SELECT RAISE(ABORT, 'append-only'); END;

-- A content is open while it is written, then it keeps its bytes as long as a program refers to it.
CREATE TRIGGER content_update BEFORE UPDATE ON content WHEN OLD.sha256 IS NOT NULL
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER content_chunk_insert BEFORE INSERT ON content_chunk
WHEN (SELECT sha256 FROM content WHERE id = NEW.content) IS NOT NULL
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER content_chunk_update BEFORE UPDATE ON content_chunk BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER content_chunk_delete BEFORE DELETE ON content_chunk
WHEN EXISTS (SELECT 1 FROM content JOIN program_revision r ON r.sha256 = content.sha256 WHERE content.id = OLD.content)
  OR EXISTS (SELECT 1 FROM content JOIN program_revision r ON r.places_sha256 = content.sha256 WHERE content.id = OLD.content)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
)sql";

}  // namespace dripfeed::sqlite
