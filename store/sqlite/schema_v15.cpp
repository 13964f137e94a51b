// Never edited once it was published.
#include "store/sqlite/schema_v15.h"

namespace dripfeed::sqlite {

// One owner, one living file of a name. `content` is empty once it was removed, so that the bytes may go.
const char* const kSchemaV15 = R"sql(
CREATE TABLE attachment (
  id INTEGER PRIMARY KEY, program INTEGER REFERENCES program (id), family TEXT REFERENCES family (name),
  part TEXT REFERENCES part (number), work_order INTEGER REFERENCES work_order (id),
  name TEXT NOT NULL CHECK (name <> ''), media_type TEXT NOT NULL CHECK (media_type <> ''),
  sha256 TEXT NOT NULL CHECK (length(sha256) = 64), content TEXT REFERENCES content (sha256),
  bytes INTEGER NOT NULL CHECK (bytes >= 0), added_by TEXT NOT NULL, added_at_ms INTEGER NOT NULL,
  removed_by TEXT NOT NULL DEFAULT '', removed_reason TEXT NOT NULL DEFAULT '',
  removed_at_ms INTEGER NOT NULL DEFAULT 0,
  CHECK ((program IS NOT NULL) + (family IS NOT NULL) + (part IS NOT NULL) + (work_order IS NOT NULL) = 1),
  CHECK ((content IS NULL) = (removed_at_ms <> 0)), CHECK ((removed_at_ms = 0) = (removed_reason = '')),
  CHECK (content IS NULL OR content = sha256)) STRICT;
CREATE UNIQUE INDEX attachment_of_program ON attachment (program, name)
  WHERE program IS NOT NULL AND removed_at_ms = 0;
CREATE UNIQUE INDEX attachment_of_family ON attachment (family, name) WHERE family IS NOT NULL AND removed_at_ms = 0;
CREATE UNIQUE INDEX attachment_of_part ON attachment (part, name) WHERE part IS NOT NULL AND removed_at_ms = 0;
CREATE UNIQUE INDEX attachment_of_order ON attachment (work_order, name)
  WHERE work_order IS NOT NULL AND removed_at_ms = 0;
CREATE INDEX attachment_content ON attachment (content) WHERE content IS NOT NULL;
CREATE TRIGGER attachment_update BEFORE UPDATE ON attachment
WHEN OLD.removed_at_ms <> 0 OR
     (NEW.id, NEW.program, NEW.family, NEW.part, NEW.work_order, NEW.name, NEW.media_type, NEW.sha256, NEW.bytes,
      NEW.added_by, NEW.added_at_ms)
     IS NOT (OLD.id, OLD.program, OLD.family, OLD.part, OLD.work_order, OLD.name, OLD.media_type, OLD.sha256,
             OLD.bytes, OLD.added_by, OLD.added_at_ms)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER attachment_delete BEFORE DELETE ON attachment BEGIN SELECT RAISE(ABORT, 'append-only'); END;

-- A content keeps its bytes as long as an attachment refers to it, too.
CREATE TRIGGER content_chunk_delete_attached BEFORE DELETE ON content_chunk
WHEN EXISTS (SELECT 1 FROM content JOIN attachment a ON a.content = content.sha256 WHERE content.id = OLD.content)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
)sql";

}  // namespace dripfeed::sqlite
