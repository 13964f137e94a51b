// Deleted programs, as in version 16 of SQLite. Never edited once it was published.
#include "store/postgresql/schema_v5.h"

namespace dripfeed::postgresql {

const char* const kSchemaV5 = R"sql(
ALTER TABLE program ADD COLUMN deleted_at_ms BIGINT NOT NULL DEFAULT 0 CHECK (deleted_at_ms >= 0),
  ADD COLUMN deleted_by bytewise NOT NULL DEFAULT '', ADD COLUMN delete_reason bytewise NOT NULL DEFAULT '';
DROP TRIGGER program_revision_delete ON program_revision;
CREATE FUNCTION refuse_revision_delete() RETURNS TRIGGER LANGUAGE plpgsql AS $$
BEGIN
  IF NOT EXISTS (SELECT 1 FROM program WHERE id = OLD.program AND deleted_at_ms <> 0) THEN
    RAISE EXCEPTION 'append-only' USING ERRCODE = 'DF001';
  END IF;
  RETURN OLD;
END $$;
CREATE TRIGGER program_revision_delete BEFORE DELETE ON program_revision
FOR EACH ROW EXECUTE FUNCTION refuse_revision_delete();
CREATE INDEX receipt_program ON receipt (program, revision) WHERE program IS NOT NULL;
CREATE INDEX verdict_call_program ON verdict_call (program, revision);
)sql";

}  // namespace dripfeed::postgresql
