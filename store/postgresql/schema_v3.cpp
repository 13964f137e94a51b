// Version 3 of the schema: several servers on one store, and how far their journals are booked. Never edited once it
// was published.
#include "store/postgresql/schema_v3.h"

namespace dripfeed::postgresql {

const char* const kSchemaV3 = R"sql(
CREATE TABLE journal (
  name bytewise PRIMARY KEY CHECK (length(name) = 64), booked BIGINT NOT NULL CHECK (booked >= 0));
CREATE TABLE node (
  name bytewise PRIMARY KEY CHECK (name <> ''), epoch BIGINT NOT NULL, url bytewise NOT NULL DEFAULT '',
  program_version bytewise NOT NULL DEFAULT '', started_at_ms BIGINT NOT NULL, seen_at_ms BIGINT NOT NULL);
CREATE TABLE line_lease (
  machine bytewise PRIMARY KEY REFERENCES machine (name), node bytewise NOT NULL REFERENCES node (name),
  number BIGINT NOT NULL CHECK (number > 0), since_ms BIGINT NOT NULL, given_by bytewise NOT NULL,
  reason bytewise NOT NULL);
CREATE INDEX line_lease_node ON line_lease (node);

-- Who wrote it: a node follows what the others do.
ALTER TABLE event ADD COLUMN node bytewise NOT NULL DEFAULT coalesce(current_setting('dripfeed.node', true), '');
CREATE FUNCTION tell_nodes() RETURNS TRIGGER LANGUAGE plpgsql AS
  $$ BEGIN NOTIFY dripfeed_event; RETURN NULL; END $$;
CREATE TRIGGER event_news AFTER INSERT ON event FOR EACH STATEMENT EXECUTE FUNCTION tell_nodes();

CREATE FUNCTION now_ms() RETURNS BIGINT LANGUAGE sql AS
  $$ SELECT CAST(floor(extract(epoch FROM clock_timestamp()) * 1000) AS BIGINT) $$;

-- A server that lost a line moves no job on it, whatever it holds true: each connection that writes has its node's name.
CREATE FUNCTION keep_lease() RETURNS TRIGGER LANGUAGE plpgsql AS $$
BEGIN
  IF EXISTS (SELECT 1 FROM line_lease WHERE machine = NEW.machine
             AND node <> coalesce(current_setting('dripfeed.node', true), '')) THEN
    RAISE EXCEPTION 'the line of % is another node''s', NEW.machine USING ERRCODE = 'DF002';
  END IF;
  RETURN NEW;
END $$;
CREATE TRIGGER job_lease BEFORE UPDATE OF state ON job FOR EACH ROW
WHEN (NEW.state IN ('armed', 'feeding', 'held', 'draining') AND NEW.state <> OLD.state)
EXECUTE FUNCTION keep_lease();
)sql";

}  // namespace dripfeed::postgresql
