// Never edited once it was published.
#include "store/sqlite/schema_v10.h"

namespace dripfeed::sqlite {

// Sessions are no record: the table is made anew with those that are there.
const char* const kSchemaV10 = R"sql(
CREATE TABLE machine_group (
  name TEXT PRIMARY KEY CHECK (name <> ''), four_eyes INTEGER NOT NULL CHECK (four_eyes IN (0, 1))) STRICT;
ALTER TABLE machine ADD COLUMN machine_group TEXT REFERENCES machine_group (name);
CREATE INDEX machine_by_group ON machine (machine_group) WHERE machine_group IS NOT NULL;

CREATE TABLE account (
  id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE CHECK (name <> ''),
  role TEXT NOT NULL CHECK (role IN ('viewer', 'operator', 'programmer', 'approver', 'admin')),
  password TEXT NOT NULL DEFAULT '', pin TEXT NOT NULL DEFAULT '',
  failures INTEGER NOT NULL DEFAULT 0 CHECK (failures >= 0), locked_until_ms INTEGER NOT NULL DEFAULT 0,
  disabled_at_ms INTEGER NOT NULL DEFAULT 0, revision INTEGER NOT NULL,
  created_by TEXT NOT NULL, created_at_ms INTEGER NOT NULL) STRICT;
CREATE TABLE account_grant (
  account INTEGER NOT NULL REFERENCES account (id), machine_group TEXT NOT NULL REFERENCES machine_group (name),
  role TEXT NOT NULL CHECK (role IN ('viewer', 'operator', 'programmer', 'approver', 'admin')),
  PRIMARY KEY (account, machine_group)) STRICT, WITHOUT ROWID;
CREATE INDEX account_grant_group ON account_grant (machine_group);
CREATE TRIGGER account_delete BEFORE DELETE ON account BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER account_update BEFORE UPDATE ON account
WHEN (NEW.id, NEW.name, NEW.created_by, NEW.created_at_ms) IS NOT (OLD.id, OLD.name, OLD.created_by, OLD.created_at_ms)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;

ALTER TABLE token ADD COLUMN account INTEGER REFERENCES account (id);
ALTER TABLE token ADD COLUMN scope TEXT NOT NULL DEFAULT '';
ALTER TABLE token ADD COLUMN expires_at_ms INTEGER NOT NULL DEFAULT 0 CHECK (expires_at_ms >= 0);
DROP TRIGGER token_update;
CREATE TRIGGER token_update BEFORE UPDATE ON token
WHEN OLD.revoked_at_ms <> 0
     OR (NEW.id, NEW.name, NEW.role, NEW.hash, NEW.created_by, NEW.created_at_ms, NEW.account, NEW.scope,
         NEW.expires_at_ms)
     IS NOT (OLD.id, OLD.name, OLD.role, OLD.hash, OLD.created_by, OLD.created_at_ms, OLD.account, OLD.scope,
             OLD.expires_at_ms)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;

CREATE TABLE signed_in (
  hash TEXT PRIMARY KEY CHECK (hash <> ''), token INTEGER REFERENCES token (id),
  account INTEGER REFERENCES account (id), secret TEXT NOT NULL CHECK (secret IN ('', 'password', 'pin')),
  opened_at_ms INTEGER NOT NULL, used_at_ms INTEGER NOT NULL CHECK (used_at_ms >= opened_at_ms),
  CHECK ((token IS NULL) <> (account IS NULL)), CHECK ((account IS NULL) = (secret = ''))) STRICT, WITHOUT ROWID;
INSERT INTO signed_in (hash, token, secret, opened_at_ms, used_at_ms)
  SELECT hash, token, '', opened_at_ms, used_at_ms FROM browser_session;
DROP TABLE browser_session;
ALTER TABLE signed_in RENAME TO browser_session;
CREATE INDEX browser_session_token ON browser_session (token, used_at_ms);
CREATE INDEX browser_session_account ON browser_session (account, used_at_ms);
)sql";

}  // namespace dripfeed::sqlite
