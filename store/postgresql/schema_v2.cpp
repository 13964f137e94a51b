// Version 2 of the schema: indexes, and what must never change, held by triggers as in SQLite. Never edited once it was
// published.
#include "store/postgresql/schema_v2.h"

namespace dripfeed::postgresql {

const char* const kSchemaV2 = R"sql(
CREATE INDEX part_revision_family ON part_revision (family, part);
CREATE INDEX program_name ON program (name);
CREATE INDEX program_revision_sha256 ON program_revision (sha256);
CREATE INDEX program_revision_places ON program_revision (places_sha256) WHERE places_sha256 IS NOT NULL;
CREATE INDEX program_revision_family ON program_revision (family) WHERE family IS NOT NULL;
CREATE INDEX program_revision_part ON program_revision (part, program) WHERE part IS NOT NULL;
CREATE INDEX verdict_text ON verdict (sha256, machine, delivery);
CREATE INDEX verdict_program ON verdict (program);
CREATE INDEX verdict_machine ON verdict (machine);
CREATE UNIQUE INDEX text_release_valid ON text_release (sha256, machine, delivery) WHERE state <> 'obsolete';
CREATE INDEX text_release_program ON text_release (program);
CREATE INDEX text_release_machine ON text_release (machine);
CREATE UNIQUE INDEX job_line ON job (machine) WHERE state IN ('armed', 'feeding', 'held', 'draining');
CREATE INDEX job_machine ON job (machine);
CREATE INDEX job_state ON job (state);
CREATE INDEX audit_subject ON audit (subject);
CREATE INDEX reply_at ON reply (at_ms);
CREATE INDEX receipt_machine ON receipt (machine, id);
CREATE INDEX receipt_content ON receipt (sha256);
CREATE INDEX request_machine ON request (machine, id);
CREATE INDEX job_torn ON job (machine, torn, confirmed_at_ms) WHERE torn = 1 AND confirmed_at_ms = 0;
CREATE INDEX answer_machine ON answer (machine, id);
CREATE INDEX answer_torn ON answer (machine) WHERE state = 'torn' AND confirmed_at_ms = 0;
CREATE INDEX answer_sending ON answer (id) WHERE state = 'sending';
CREATE UNIQUE INDEX alarm_open ON alarm (machine, kind, body) WHERE closed = 0;
CREATE INDEX alarm_lasting ON alarm (machine, kind) WHERE cleared_at_ms = 0;
CREATE INDEX alarm_shelved ON alarm (shelved_until_ms) WHERE shelved_until_ms <> 0;
CREATE INDEX alarm_time ON alarm (last_at_ms, id);
CREATE INDEX alarm_open_time ON alarm (last_at_ms, id) WHERE closed = 0;
CREATE INDEX alarm_closed_time ON alarm (last_at_ms, id) WHERE closed = 1;
CREATE INDEX alarm_machine_time ON alarm (machine, last_at_ms, id);
CREATE INDEX alarm_job ON alarm (job) WHERE job IS NOT NULL;
CREATE INDEX job_queue ON job (machine, queue_rank, id) WHERE state = 'queued';
CREATE INDEX job_ended ON job (machine, ended_at_ms);
CREATE INDEX program_change ON program (change_number);
CREATE INDEX program_folder ON program (folder) WHERE folder <> '';
CREATE INDEX program_tag_tag ON program_tag (tag, program);
CREATE INDEX job_program ON job (program, id);
CREATE INDEX machine_by_group ON machine (machine_group) WHERE machine_group IS NOT NULL;
CREATE INDEX account_grant_group ON account_grant (machine_group);
CREATE INDEX browser_session_token ON browser_session (token, used_at_ms);
CREATE INDEX browser_session_account ON browser_session (account, used_at_ms);
CREATE INDEX event_time ON event (at_ms);
CREATE INDEX webhook_delivery_event ON webhook_delivery (event);
CREATE INDEX webhook_delivery_due ON webhook_delivery (webhook, next_at_ms, event) WHERE state = 'pending';
CREATE INDEX webhook_delivery_delivered ON webhook_delivery (last_at_ms) WHERE state = 'delivered';
CREATE INDEX webhook_delivery_dead ON webhook_delivery (webhook, event) WHERE state = 'dead';
CREATE INDEX work_order_state ON work_order (state, id);
CREATE INDEX work_order_part ON work_order (part, id);
CREATE INDEX job_work_order ON job (work_order, state) WHERE work_order IS NOT NULL;

-- SQLite has this one: texts of a group in one.
CREATE FUNCTION join_texts(so_far TEXT, next TEXT, mark TEXT) RETURNS TEXT LANGUAGE sql IMMUTABLE AS
  $$ SELECT CASE WHEN so_far IS NULL THEN next ELSE so_far || mark || next END $$;
CREATE AGGREGATE group_concat(TEXT, TEXT) (SFUNC = join_texts, STYPE = TEXT);

CREATE FUNCTION refuse_change() RETURNS TRIGGER LANGUAGE plpgsql AS
  $$ BEGIN RAISE EXCEPTION 'append-only' USING ERRCODE = 'DF001'; END $$;

-- Rows that stay as they are, and rows that stay.
DO $$
DECLARE name TEXT;
BEGIN
  FOREACH name IN ARRAY ARRAY[
    'machine_revision', 'family_revision', 'part_revision', 'program_revision', 'waiver', 'release_step',
    'ledger', 'audit', 'request', 'parts_report', 'verdict_call', 'verdict_point', 'content_chunk', 'event'] LOOP
    EXECUTE format('CREATE TRIGGER %I BEFORE UPDATE ON %I FOR EACH ROW EXECUTE FUNCTION refuse_change()',
                   name || '_update', name);
  END LOOP;
  FOREACH name IN ARRAY ARRAY[
    'machine_revision', 'family_revision', 'part_revision', 'program_revision', 'waiver', 'release_step',
    'ledger', 'audit', 'request', 'parts_report', 'verdict_call', 'verdict_point', 'verdict', 'text_release',
    'job', 'token', 'receipt', 'answer', 'account', 'work_order'] LOOP
    EXECUTE format('CREATE TRIGGER %I BEFORE DELETE ON %I FOR EACH ROW EXECUTE FUNCTION refuse_change()',
                   name || '_delete', name);
    EXECUTE format('CREATE TRIGGER %I BEFORE TRUNCATE ON %I EXECUTE FUNCTION refuse_change()', name || '_empty', name);
  END LOOP;
END $$;

CREATE TRIGGER verdict_update BEFORE UPDATE ON verdict FOR EACH ROW
WHEN (NEW.stale < OLD.stale OR (NEW.id, NEW.program, NEW.revision, NEW.sha256, NEW.machine, NEW.machine_revision,
      NEW.delivery, NEW.outcome, NEW.report, NEW.actor, NEW.at_ms) IS DISTINCT FROM (OLD.id, OLD.program,
      OLD.revision, OLD.sha256, OLD.machine, OLD.machine_revision, OLD.delivery, OLD.outcome, OLD.report, OLD.actor,
      OLD.at_ms))
EXECUTE FUNCTION refuse_change();
CREATE TRIGGER text_release_update BEFORE UPDATE ON text_release FOR EACH ROW
WHEN ((NEW.id, NEW.program, NEW.revision, NEW.sha256, NEW.machine, NEW.delivery, NEW.created_by, NEW.created_at_ms)
      IS DISTINCT FROM (OLD.id, OLD.program, OLD.revision, OLD.sha256, OLD.machine, OLD.delivery, OLD.created_by,
      OLD.created_at_ms))
EXECUTE FUNCTION refuse_change();
CREATE TRIGGER job_update BEFORE UPDATE ON job FOR EACH ROW
WHEN ((NEW.id, NEW.text_release, NEW.program, NEW.revision, NEW.sha256, NEW.machine, NEW.delivery, NEW.link,
      NEW.bytes_total, NEW.created_by, NEW.created_at_ms) IS DISTINCT FROM (OLD.id, OLD.text_release, OLD.program,
      OLD.revision, OLD.sha256, OLD.machine, OLD.delivery, OLD.link, OLD.bytes_total, OLD.created_by,
      OLD.created_at_ms))
EXECUTE FUNCTION refuse_change();
CREATE TRIGGER content_update BEFORE UPDATE ON content FOR EACH ROW
WHEN (OLD.sha256 IS NOT NULL)
EXECUTE FUNCTION refuse_change();
CREATE TRIGGER receipt_update BEFORE UPDATE ON receipt FOR EACH ROW
WHEN (OLD.decided_at_ms <> 0 OR (NEW.id, NEW.machine, NEW.name, NEW.style, NEW.sha256, NEW.raw_bytes, NEW.code,
      NEW.ended_by, NEW.reason, NEW.at_ms) IS DISTINCT FROM (OLD.id, OLD.machine, OLD.name, OLD.style, OLD.sha256,
      OLD.raw_bytes, OLD.code, OLD.ended_by, OLD.reason, OLD.at_ms))
EXECUTE FUNCTION refuse_change();
CREATE TRIGGER answer_update BEFORE UPDATE ON answer FOR EACH ROW
WHEN ((NEW.id, NEW.machine, NEW.bytes_total, NEW.begun_at_ms) IS DISTINCT FROM (OLD.id, OLD.machine,
      OLD.bytes_total, OLD.begun_at_ms) OR (OLD.state <> 'sending' AND (NEW.state, NEW.reason, NEW.ended_at_ms) IS
      DISTINCT FROM (OLD.state, OLD.reason, OLD.ended_at_ms)) OR OLD.confirmed_at_ms <> 0)
EXECUTE FUNCTION refuse_change();
CREATE TRIGGER alarm_update BEFORE UPDATE ON alarm FOR EACH ROW
WHEN ((NEW.id, NEW.machine, NEW.kind, NEW.body, NEW.raised_at_ms, NEW.job) IS DISTINCT FROM (OLD.id, OLD.machine,
      OLD.kind, OLD.body, OLD.raised_at_ms, OLD.job) OR OLD.closed = 1 AND (NEW.count, NEW.last_at_ms,
      NEW.cleared_at_ms, NEW.acknowledged_by, NEW.acknowledged_at_ms) IS DISTINCT FROM (OLD.count, OLD.last_at_ms,
      OLD.cleared_at_ms, OLD.acknowledged_by, OLD.acknowledged_at_ms) OR OLD.acknowledged_at_ms <> 0 AND
      NEW.acknowledged_at_ms IS DISTINCT FROM OLD.acknowledged_at_ms)
EXECUTE FUNCTION refuse_change();
CREATE TRIGGER alarm_delete BEFORE DELETE ON alarm FOR EACH ROW
WHEN (OLD.closed = 0)
EXECUTE FUNCTION refuse_change();
CREATE TRIGGER account_update BEFORE UPDATE ON account FOR EACH ROW
WHEN ((NEW.id, NEW.name, NEW.created_by, NEW.created_at_ms) IS DISTINCT FROM (OLD.id, OLD.name, OLD.created_by,
      OLD.created_at_ms))
EXECUTE FUNCTION refuse_change();
CREATE TRIGGER token_update BEFORE UPDATE ON token FOR EACH ROW
WHEN (OLD.revoked_at_ms <> 0 OR (NEW.id, NEW.name, NEW.role, NEW.hash, NEW.created_by, NEW.created_at_ms,
      NEW.account, NEW.scope, NEW.expires_at_ms) IS DISTINCT FROM (OLD.id, OLD.name, OLD.role, OLD.hash,
      OLD.created_by, OLD.created_at_ms, OLD.account, OLD.scope, OLD.expires_at_ms))
EXECUTE FUNCTION refuse_change();
CREATE TRIGGER work_order_update BEFORE UPDATE ON work_order FOR EACH ROW
WHEN ((NEW.id, NEW.number, NEW.operation, NEW.created_by, NEW.created_at_ms) IS DISTINCT FROM (OLD.id, OLD.number,
      OLD.operation, OLD.created_by, OLD.created_at_ms))
EXECUTE FUNCTION refuse_change();
CREATE TRIGGER job_work_order_update BEFORE UPDATE OF work_order ON job FOR EACH ROW
WHEN (NEW.work_order IS DISTINCT FROM OLD.work_order)
EXECUTE FUNCTION refuse_change();
CREATE TRIGGER text_release_restart_update BEFORE UPDATE OF restart_of, restart_line ON text_release FOR EACH ROW
WHEN ((NEW.restart_of, NEW.restart_line) IS DISTINCT FROM (OLD.restart_of, OLD.restart_line))
EXECUTE FUNCTION refuse_change();

-- A content is open while it is written, then it keeps its bytes as long as a program or a receipt refers to it.
CREATE FUNCTION refuse_chunk_insert() RETURNS TRIGGER LANGUAGE plpgsql AS $$
BEGIN
  IF (SELECT sha256 FROM content WHERE id = NEW.content) IS NOT NULL THEN
    RAISE EXCEPTION 'append-only' USING ERRCODE = 'DF001';
  END IF;
  RETURN NEW;
END $$;
CREATE TRIGGER content_chunk_insert BEFORE INSERT ON content_chunk
FOR EACH ROW EXECUTE FUNCTION refuse_chunk_insert();
CREATE FUNCTION refuse_chunk_delete() RETURNS TRIGGER LANGUAGE plpgsql AS $$
BEGIN
  IF EXISTS (SELECT 1 FROM content c WHERE c.id = OLD.content AND (
      EXISTS (SELECT 1 FROM program_revision r WHERE r.sha256 = c.sha256)
      OR EXISTS (SELECT 1 FROM program_revision r WHERE r.places_sha256 = c.sha256)
      OR EXISTS (SELECT 1 FROM receipt r WHERE r.sha256 = c.sha256))) THEN
    RAISE EXCEPTION 'append-only' USING ERRCODE = 'DF001';
  END IF;
  RETURN OLD;
END $$;
CREATE TRIGGER content_chunk_delete BEFORE DELETE ON content_chunk
FOR EACH ROW EXECUTE FUNCTION refuse_chunk_delete();
CREATE TRIGGER content_chunk_empty BEFORE TRUNCATE ON content_chunk EXECUTE FUNCTION refuse_change();
)sql";

}  // namespace dripfeed::postgresql
