PRAGMA foreign_keys = OFF;
PRAGMA application_id = 0x44524950;
CREATE TABLE migration (version INTEGER PRIMARY KEY, name TEXT NOT NULL, sha256 TEXT NOT NULL) STRICT;
CREATE TABLE machine (name TEXT PRIMARY KEY CHECK (name <> ''), revision INTEGER NOT NULL, machine_group TEXT REFERENCES machine_group (name)) STRICT;
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
CREATE TABLE content (
  id INTEGER PRIMARY KEY, sha256 TEXT UNIQUE CHECK (length(sha256) = 64), bytes INTEGER NOT NULL CHECK (bytes >= 0)) STRICT;
CREATE TABLE content_chunk (
  content INTEGER NOT NULL REFERENCES content (id), n INTEGER NOT NULL CHECK (n >= 0), data BLOB NOT NULL,
  PRIMARY KEY (content, n)) STRICT;
CREATE TABLE program (
  id INTEGER PRIMARY KEY, name TEXT NOT NULL CHECK (name <> ''), dialect TEXT NOT NULL, revision INTEGER NOT NULL, folder TEXT NOT NULL DEFAULT '', archived_at_ms INTEGER NOT NULL DEFAULT 0 CHECK (archived_at_ms >= 0), archived_by TEXT NOT NULL DEFAULT '', archive_reason TEXT NOT NULL DEFAULT '', change_number INTEGER NOT NULL DEFAULT 0 CHECK (change_number >= 0), deleted_at_ms INTEGER NOT NULL DEFAULT 0 CHECK (deleted_at_ms >= 0), deleted_by TEXT NOT NULL DEFAULT '', delete_reason TEXT NOT NULL DEFAULT '') STRICT;
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
CREATE TABLE verdict (
  id INTEGER PRIMARY KEY, program INTEGER NOT NULL, revision INTEGER NOT NULL, sha256 TEXT NOT NULL,
  machine TEXT NOT NULL, machine_revision INTEGER NOT NULL,
  delivery TEXT NOT NULL CHECK (delivery IN ('drip', 'memory')),
  outcome TEXT NOT NULL CHECK (outcome IN ('pass', 'warn', 'fail', 'unknown')),
  stale INTEGER NOT NULL CHECK (stale IN (0, 1)), report TEXT NOT NULL, actor TEXT NOT NULL, at_ms INTEGER NOT NULL, rules TEXT NOT NULL DEFAULT '',
  FOREIGN KEY (program, revision) REFERENCES program_revision (program, revision),
  FOREIGN KEY (machine, machine_revision) REFERENCES machine_revision (machine, revision)) STRICT;
CREATE TABLE waiver (
  verdict INTEGER NOT NULL REFERENCES verdict (id), n INTEGER NOT NULL,
  name TEXT NOT NULL CHECK (name <> ''), reason TEXT NOT NULL CHECK (reason <> ''), at_ms INTEGER NOT NULL, point TEXT NOT NULL DEFAULT '', expires_at_ms INTEGER NOT NULL DEFAULT 0,
  PRIMARY KEY (verdict, n)) STRICT;
CREATE TABLE text_release (
  id INTEGER PRIMARY KEY, program INTEGER NOT NULL, revision INTEGER NOT NULL, sha256 TEXT NOT NULL,
  machine TEXT NOT NULL REFERENCES machine (name), delivery TEXT NOT NULL CHECK (delivery IN ('drip', 'memory')),
  state TEXT NOT NULL CHECK (state IN ('draft', 'in_review', 'proving', 'approved', 'obsolete')),
  transfers_allowed INTEGER NOT NULL CHECK (transfers_allowed >= 0),
  transfers_done INTEGER NOT NULL CHECK (transfers_done >= 0),
  created_by TEXT NOT NULL, created_at_ms INTEGER NOT NULL,
  approved_by TEXT NOT NULL, sign_off TEXT NOT NULL, changed_at_ms INTEGER NOT NULL, restart_of INTEGER REFERENCES text_release (id), restart_line INTEGER NOT NULL DEFAULT 0 CHECK ((restart_of IS NULL) = (restart_line = 0)),
  FOREIGN KEY (program, revision) REFERENCES program_revision (program, revision)) STRICT;
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
  confirmed_by TEXT NOT NULL, confirm_reason TEXT NOT NULL, confirmed_at_ms INTEGER NOT NULL, expires_at_ms INTEGER NOT NULL DEFAULT 0 CHECK (expires_at_ms >= 0), read_back TEXT NOT NULL DEFAULT '', queue_rank INTEGER NOT NULL DEFAULT 0 CHECK (queue_rank >= 0), reason_id TEXT NOT NULL DEFAULT '', held_ms INTEGER CHECK (held_ms >= 0), work_order INTEGER REFERENCES work_order (id), holds INTEGER CHECK (holds >= 0), line_ms INTEGER CHECK (line_ms >= 0), forecast_ms INTEGER CHECK (forecast_ms >= 0), not_before_ms INTEGER NOT NULL DEFAULT 0 CHECK (not_before_ms >= 0), choice INTEGER REFERENCES job (id), end_check TEXT NOT NULL DEFAULT '', end_confirmed_by TEXT NOT NULL DEFAULT '', end_note TEXT NOT NULL DEFAULT '', end_confirmed_at_ms INTEGER NOT NULL DEFAULT 0 CHECK (end_confirmed_at_ms >= 0), hold_by TEXT NOT NULL DEFAULT '', hold_reason TEXT NOT NULL DEFAULT '', retry_of INTEGER REFERENCES job (id),
  FOREIGN KEY (program, revision) REFERENCES program_revision (program, revision)) STRICT;
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
CREATE TABLE token (
  id INTEGER PRIMARY KEY, name TEXT NOT NULL CHECK (name <> ''),
  role TEXT NOT NULL CHECK (role IN ('viewer', 'operator', 'programmer', 'approver', 'admin')),
  hash TEXT NOT NULL UNIQUE CHECK (hash <> ''), created_by TEXT NOT NULL, created_at_ms INTEGER NOT NULL,
  revoked_at_ms INTEGER NOT NULL, account INTEGER REFERENCES account (id), scope TEXT NOT NULL DEFAULT '', expires_at_ms INTEGER NOT NULL DEFAULT 0 CHECK (expires_at_ms >= 0)) STRICT;
CREATE TABLE reply (
  actor TEXT NOT NULL, route TEXT NOT NULL, reply_key TEXT NOT NULL CHECK (reply_key <> ''), request_sha256 TEXT NOT NULL,
  status INTEGER NOT NULL, headers TEXT NOT NULL, body TEXT NOT NULL, at_ms INTEGER NOT NULL,
  PRIMARY KEY (actor, route, reply_key)) STRICT;
CREATE TABLE receipt (
  id INTEGER PRIMARY KEY, machine TEXT NOT NULL REFERENCES machine (name), name TEXT NOT NULL CHECK (name <> ''),
  style TEXT NOT NULL, sha256 TEXT NOT NULL REFERENCES content (sha256), raw_bytes INTEGER NOT NULL CHECK (raw_bytes >= 0),
  code TEXT NOT NULL, ended_by TEXT NOT NULL,
  state TEXT NOT NULL CHECK (state IN ('stored', 'quarantined', 'accepted', 'discarded')), reason TEXT NOT NULL,
  at_ms INTEGER NOT NULL, program INTEGER, revision INTEGER,
  decided_by TEXT NOT NULL DEFAULT '', decided_reason TEXT NOT NULL DEFAULT '', decided_at_ms INTEGER NOT NULL DEFAULT 0,
  FOREIGN KEY (program, revision) REFERENCES program_revision (program, revision),
  CHECK ((program IS NULL) = (revision IS NULL)), CHECK ((state = 'accepted') = (program IS NOT NULL))) STRICT;
CREATE TABLE request (
  id INTEGER PRIMARY KEY, machine TEXT NOT NULL REFERENCES machine (name), verb TEXT NOT NULL, argument TEXT NOT NULL,
  body TEXT NOT NULL, outcome TEXT NOT NULL, detail TEXT NOT NULL, job INTEGER REFERENCES job (id),
  at_ms INTEGER NOT NULL) STRICT;
CREATE TABLE answer (
  id INTEGER PRIMARY KEY, machine TEXT NOT NULL REFERENCES machine (name), bytes_total INTEGER NOT NULL CHECK (bytes_total >= 0),
  state TEXT NOT NULL CHECK (state IN ('sending', 'whole', 'torn')), reason TEXT NOT NULL DEFAULT '',
  begun_at_ms INTEGER NOT NULL, ended_at_ms INTEGER NOT NULL DEFAULT 0,
  confirmed_by TEXT NOT NULL DEFAULT '', confirm_reason TEXT NOT NULL DEFAULT '', confirmed_at_ms INTEGER NOT NULL DEFAULT 0,
  CHECK ((state = 'sending') = (ended_at_ms = 0))) STRICT;
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
CREATE TABLE program_tag (
  program INTEGER NOT NULL REFERENCES program (id), tag TEXT NOT NULL CHECK (tag <> ''),
  PRIMARY KEY (program, tag)) STRICT, WITHOUT ROWID;
CREATE TABLE machine_group (
  name TEXT PRIMARY KEY CHECK (name <> ''), four_eyes INTEGER NOT NULL CHECK (four_eyes IN (0, 1)), operator_sign_off INTEGER NOT NULL DEFAULT 1 CHECK (operator_sign_off IN (0, 1))) STRICT;
CREATE TABLE account (
  id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE CHECK (name <> ''),
  role TEXT NOT NULL CHECK (role IN ('viewer', 'operator', 'programmer', 'approver', 'admin')),
  password TEXT NOT NULL DEFAULT '', pin TEXT NOT NULL DEFAULT '',
  failures INTEGER NOT NULL DEFAULT 0 CHECK (failures >= 0), locked_until_ms INTEGER NOT NULL DEFAULT 0,
  disabled_at_ms INTEGER NOT NULL DEFAULT 0, revision INTEGER NOT NULL,
  created_by TEXT NOT NULL, created_at_ms INTEGER NOT NULL, provider TEXT NOT NULL DEFAULT '', provider_subject TEXT NOT NULL DEFAULT '') STRICT;
CREATE TABLE account_grant (
  account INTEGER NOT NULL REFERENCES account (id), machine_group TEXT NOT NULL REFERENCES machine_group (name),
  role TEXT NOT NULL CHECK (role IN ('viewer', 'operator', 'programmer', 'approver', 'admin')),
  PRIMARY KEY (account, machine_group)) STRICT, WITHOUT ROWID;
CREATE TABLE "browser_session" (
  hash TEXT PRIMARY KEY CHECK (hash <> ''), token INTEGER REFERENCES token (id),
  account INTEGER REFERENCES account (id), secret TEXT NOT NULL CHECK (secret IN ('', 'password', 'pin')),
  opened_at_ms INTEGER NOT NULL, used_at_ms INTEGER NOT NULL CHECK (used_at_ms >= opened_at_ms), by_provider INTEGER NOT NULL DEFAULT 0 CHECK (by_provider IN (0, 1)),
  CHECK ((token IS NULL) <> (account IS NULL)), CHECK ((account IS NULL) = (secret = ''))) STRICT, WITHOUT ROWID;
CREATE TABLE event (
  seq INTEGER PRIMARY KEY AUTOINCREMENT, topic TEXT NOT NULL, word TEXT NOT NULL CHECK (word <> ''),
  subject INTEGER NOT NULL, machine TEXT NOT NULL, job INTEGER NOT NULL, program INTEGER NOT NULL,
  revision INTEGER NOT NULL, cause TEXT NOT NULL, body TEXT NOT NULL, actor TEXT NOT NULL, at_ms INTEGER NOT NULL) STRICT;
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
CREATE TABLE work_order (
  id INTEGER PRIMARY KEY, number TEXT NOT NULL CHECK (number <> ''), operation TEXT NOT NULL,
  part TEXT NOT NULL CHECK (part <> ''), quantity INTEGER NOT NULL CHECK (quantity > 0),
  machine TEXT REFERENCES machine (name), due_at_ms INTEGER NOT NULL, priority INTEGER NOT NULL CHECK (priority >= 0),
  metadata TEXT NOT NULL, state TEXT NOT NULL CHECK (state IN ('open', 'held', 'done', 'cancelled')),
  reason TEXT NOT NULL, revision INTEGER NOT NULL, created_by TEXT NOT NULL, created_at_ms INTEGER NOT NULL,
  changed_at_ms INTEGER NOT NULL, UNIQUE (number, operation)) STRICT;
CREATE TABLE parts_report (
  work_order INTEGER NOT NULL REFERENCES work_order (id), n INTEGER NOT NULL,
  good INTEGER NOT NULL CHECK (good >= 0), scrap INTEGER NOT NULL CHECK (scrap >= 0), note TEXT NOT NULL,
  actor TEXT NOT NULL, at_ms INTEGER NOT NULL, PRIMARY KEY (work_order, n)) STRICT, WITHOUT ROWID;
CREATE TABLE verdict_call (
  verdict INTEGER NOT NULL REFERENCES verdict (id), name TEXT NOT NULL CHECK (name <> ''),
  program INTEGER NOT NULL, revision INTEGER NOT NULL, PRIMARY KEY (verdict, name),
  FOREIGN KEY (program, revision) REFERENCES program_revision (program, revision)) STRICT, WITHOUT ROWID;
CREATE TABLE verdict_point (
  verdict INTEGER NOT NULL REFERENCES verdict (id), n INTEGER NOT NULL, text TEXT NOT NULL CHECK (text <> ''),
  PRIMARY KEY (verdict, n)) STRICT, WITHOUT ROWID;
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
INSERT INTO migration VALUES (1,'first','3abb161952f9b38cce1d276752d72105593f263d36be3c166a5f1aa9b33342b1');
INSERT INTO migration VALUES (2,'arming expires','f13dc8d21737d4740f28dd7b2bb6a5dbd94e148fc3a06115b624c91a16e7b548');
INSERT INTO migration VALUES (3,'receipts','671aa55427840186b63f8fa01debc6181110f354518b5bb6644b5029812dcc70');
INSERT INTO migration VALUES (4,'torn jobs by index','f6c526a50606ff0315e1ec513bd900e4196b904eeabb0335eae3cff8bcd1f6bb');
INSERT INTO migration VALUES (5,'answers are booked','44021872ea22c01643f252c7d39d34ad3dc1373c16e4cc383d05b1b8093e8c55');
INSERT INTO migration VALUES (6,'alarms','c2e4b2fd412af621e85a5cbaac0feb3d9cd8e4ca9bd2fcc0f2cecea5d9d1a84c');
INSERT INTO migration VALUES (7,'browser sessions','fb03fe1531e759ff83a60a27a5ecda14014fcf16cec3186e3ae913a72109fce7');
INSERT INTO migration VALUES (8,'queue order','428becfd4cc06ad129dc28f607c38f677ffde5818887aeb98ca516ecd07d5102');
INSERT INTO migration VALUES (9,'labels of programs','891d57f36c0b2b1dc6a0ad9bc38790f17f4f847d0372f9abd3e252cf9f404576');
INSERT INTO migration VALUES (10,'users','b9327188dd16cc45c1c2e7ccff71a2318a53fdebe9b386ac744e4e50a1083897');
INSERT INTO migration VALUES (11,'webhooks and orders','8bb3eb06d3455539dde6d26e52c902169cf7c80d565e7c345eb053b855a3d60c');
INSERT INTO migration VALUES (12,'called programs of verdicts','1fb59c011b3f554477fa3d3405fe88090275671fc85d236a21ce8f149e476936');
INSERT INTO migration VALUES (13,'restarts','9bd2005b76be2ede77de86531f73121bc7fe053da948433cb200796e77e12234');
INSERT INTO migration VALUES (14,'waivers of points','a47efca3e9f8d12c2f8be3d9f3d473aaae767c13adb54af7a757415444a9c733');
INSERT INTO migration VALUES (15,'attachments','1b12f155c6958ca2363e7cdcfc3aa3dff99c38f2c198081fb794fa04f3da6b51');
INSERT INTO migration VALUES (16,'deleted programs','348e082aef9357e849e0664124d7705311db1d7720e7f1fd1bd5757499451d78');
INSERT INTO migration VALUES (17,'plans and ends of jobs','9342ec8de1f48fcc26679931baeaa49f36f9e0cb4537957eb45780cee382df2a');
INSERT INTO migration VALUES (18,'users of a provider','2f1ef83f796727e91eb664b4742785023bb0ba33c4105ee2ce6873cad543de70');
INSERT INTO migration VALUES (19,'rules of verdicts','c1088ed0329d2010859919c4b9eff3f904779db732f3162965cc25e53fd809d2');
INSERT INTO migration VALUES (20,'sign-off of operators','7f9b8a8a87046235407463976080ba5624af4a88467b88e01e355f7d24fe4564');
INSERT INTO machine VALUES ('mill-1',1,'mills');
INSERT INTO machine_revision VALUES ('mill-1',1,'profile','tester',1000);
INSERT INTO family VALUES ('roll',1);
INSERT INTO family_revision VALUES ('roll',1,'family roll
','tester',1000);
INSERT INTO part VALUES ('R-100',1);
INSERT INTO part_revision VALUES ('R-100',1,'roll',1,'{}','tester',1000);
INSERT INTO content VALUES (1,'425baad3c5d0f1eb3c6dcef0377599712a4b5310480795fe51a998d97b769de1',17);
INSERT INTO content VALUES (2,'c55f1d01d5fc241cf36e19e9fd394bcf7f1b2153403d3c7a2fb38105047e7fa2',27);
INSERT INTO content VALUES (3,'d1d47ca349a4552de786b6b202bc58d2a08ecc87b8bd3443b4e341a29c40400f',11);
INSERT INTO content VALUES (4,'80c40ef6a9aa674540b0738743ffd83134a8e0fddeba68a33e2a8d764b8d1944',11);
INSERT INTO content VALUES (5,'ef99cf8220619a13832a7aaec9e90b5817b31255ac01cc9c9cd7cfcc7e49c62f',13);
INSERT INTO content VALUES (6,'f73d5f7a8fa46360460ebea34bace98d53032ad936b26da160f2b30ab5a4d54e',11);
INSERT INTO content_chunk VALUES (1,0,X'250A286D696C6C2D31290A4D33300A250A');
INSERT INTO content_chunk VALUES (2,0,X'706C61636573206F6620250A286D696C6C2D31290A4D33300A250A');
INSERT INTO content_chunk VALUES (3,0,X'250A4F370A4D33300A250A');
INSERT INTO content_chunk VALUES (4,0,X'250A4F390A4D33300A250A');
INSERT INTO content_chunk VALUES (5,0,X'61207365747570207368656574');
INSERT INTO content_chunk VALUES (6,0,X'250A4F380A4D33300A250A');
INSERT INTO program VALUES (1,'O0100','fanuc',1,'acme',0,'','',3,0,'','');
INSERT INTO program VALUES (2,'O9','fanuc',1,'',1000,'tester','of an old machine',6,0,'','');
INSERT INTO program VALUES (3,'O8','fanuc',1,'',12,'tester','sold',9,13,'tester','nothing is left of it');
INSERT INTO program_revision VALUES (1,1,'425baad3c5d0f1eb3c6dcef0377599712a4b5310480795fe51a998d97b769de1','c55f1d01d5fc241cf36e19e9fd394bcf7f1b2153403d3c7a2fb38105047e7fa2',2,'facts','rendered','roll',1,'R-100',1,'{}','mill-1',1,'explicit','tester',1000);
INSERT INTO program_revision VALUES (2,1,'80c40ef6a9aa674540b0738743ffd83134a8e0fddeba68a33e2a8d764b8d1944',NULL,1,'','uploaded',NULL,NULL,NULL,NULL,'',NULL,NULL,'','tester',1000);
INSERT INTO verdict VALUES (1,1,1,'425baad3c5d0f1eb3c6dcef0377599712a4b5310480795fe51a998d97b769de1','mill-1',1,'drip','pass',0,'report','tester',1000,'rules 1');
INSERT INTO text_release VALUES (1,1,1,'425baad3c5d0f1eb3c6dcef0377599712a4b5310480795fe51a998d97b769de1','mill-1','drip','approved',1,0,'tester',1000,'approver','first piece measured',1000,NULL,0);
INSERT INTO text_release VALUES (2,2,1,'80c40ef6a9aa674540b0738743ffd83134a8e0fddeba68a33e2a8d764b8d1944','mill-1','drip','draft',0,0,'tester',1000,'','',1000,1,2);
INSERT INTO release_step VALUES (1,1,'draft','in_review','tester','',1000);
INSERT INTO release_step VALUES (1,2,'in_review','proving','reviewer','',1000);
INSERT INTO release_step VALUES (1,3,'proving','approved','approver','first piece measured',1000);
INSERT INTO job VALUES (1,1,1,1,'425baad3c5d0f1eb3c6dcef0377599712a4b5310480795fe51a998d97b769de1','mill-1','drip','serial:/dev/ttyS0',100,'held','step of a test','tester','tester',1000,1000,1000,0,0,'','',0,0,'',1,'',NULL,NULL,NULL,NULL,NULL,0,NULL,'','','',0,'','',NULL);
INSERT INTO ledger VALUES (1,1,1,5,0,0,0,96,'armed',NULL);
INSERT INTO ledger_head VALUES (1,1,1,5,0,0,0,96);
INSERT INTO audit VALUES (1,1000,'tester','machine.add','machine/mill-1','revision 1 sha256 1900eab6c028483d7126599ee6f50de0d27907b5c65fa90524580b4b0f9852b0','','ba15d579638669ceb93e759fbdf4414d941845d7e03e458f353afbd32734bdd1');
INSERT INTO audit VALUES (2,1000,'tester','family.add','family/roll','revision 1 sha256 e7494d537ecf8c2e5f071f1f4f3cde32ab0b277820aee18ee54e916b0b9feae3','ba15d579638669ceb93e759fbdf4414d941845d7e03e458f353afbd32734bdd1','8a8220691b1c71348917ed30b34cfc283913d5ce299c0363a882efdf82a4f40c');
INSERT INTO audit VALUES (3,1000,'tester','part.add','part/R-100','revision 1 of family roll revision 1 sha256 44136fa355b3678a1146ad16f7e8649e94fb4fc21fe77e8310c060f61caaff8a','8a8220691b1c71348917ed30b34cfc283913d5ce299c0363a882efdf82a4f40c','82cd620dbb9b13b555c555505f1499fca93e4da1e051517f6bda7347ec1fb78c');
INSERT INTO audit VALUES (4,1000,'tester','program.add','program/1','revision 1 sha256 425baad3c5d0f1eb3c6dcef0377599712a4b5310480795fe51a998d97b769de1 rendered','82cd620dbb9b13b555c555505f1499fca93e4da1e051517f6bda7347ec1fb78c','cc6a2f7292e2bd453a5b6f63800865017d495c7b19f35fe9abe854219767fe22');
INSERT INTO audit VALUES (5,1000,'tester','verdict.add','verdict/1','pass for text 425baad3c5d0f1eb3c6dcef0377599712a4b5310480795fe51a998d97b769de1 on mill-1 revision 1 by drip, report sha256 845e91831319e89c4d656bdb80c278ac09a7230d61e5dfd2e1b1fbb436ac8917, rules rules 1','cc6a2f7292e2bd453a5b6f63800865017d495c7b19f35fe9abe854219767fe22','51bc2d31d0e26baa2ca9185e33106e7bfd812ccd4818f683a17a8b6492abb03f');
INSERT INTO audit VALUES (6,1000,'tester','release.add','release/1','text 425baad3c5d0f1eb3c6dcef0377599712a4b5310480795fe51a998d97b769de1 for mill-1 by drip','51bc2d31d0e26baa2ca9185e33106e7bfd812ccd4818f683a17a8b6492abb03f','ad49b4dd1f4c956209f6dc3e25e6baab81fb7d11207096c6af5f7768f01aa4c7');
INSERT INTO audit VALUES (7,1000,'tester','release.move','release/1','draft to in_review: ','ad49b4dd1f4c956209f6dc3e25e6baab81fb7d11207096c6af5f7768f01aa4c7','da766fbe0e21c5114b657af8aa7e4ae0b5fb53e2b45a5416a0a5f86e970084b8');
INSERT INTO audit VALUES (8,1000,'reviewer','release.move','release/1','in_review to proving: ','da766fbe0e21c5114b657af8aa7e4ae0b5fb53e2b45a5416a0a5f86e970084b8','05e0e9696457e850ff2ada4895fa8ea99ac29e4aeea5b7ad98a581fcaf51b73f');
INSERT INTO audit VALUES (9,1000,'tester','group.put','group/of mill-1','mill-1; approved without an operator''s sign-off','05e0e9696457e850ff2ada4895fa8ea99ac29e4aeea5b7ad98a581fcaf51b73f','64daadf31d8eb1bb50ff016edc4e44024e3adb63acb329424d47be5531a106c7');
INSERT INTO audit VALUES (10,1000,'approver','release.move','release/1','proving to approved: first piece measured','64daadf31d8eb1bb50ff016edc4e44024e3adb63acb329424d47be5531a106c7','a65dc76ede5c8ccd1941b56e3e3404405b562781d45af32c13248e9e9cbe7588');
INSERT INTO audit VALUES (11,1000,'tester','group.remove','group/of mill-1','','a65dc76ede5c8ccd1941b56e3e3404405b562781d45af32c13248e9e9cbe7588','04910756a45b778e65db1e1d091c3630d6592da02646bac7e8beca480453f695');
INSERT INTO audit VALUES (12,1000,'tester','job.add','job/1','release 1 text 425baad3c5d0f1eb3c6dcef0377599712a4b5310480795fe51a998d97b769de1 to mill-1','04910756a45b778e65db1e1d091c3630d6592da02646bac7e8beca480453f695','ad15eccdad8311158cce37554b37cd64230efe970f4d57bddaa60b52c99b46a7');
INSERT INTO audit VALUES (13,1000,'tester','job.move','job/1','queued to armed: step of a test','ad15eccdad8311158cce37554b37cd64230efe970f4d57bddaa60b52c99b46a7','ecfc289a4b98384547431741355b364b1b433fc62c479fb979b3f6aeddbf1bbb');
INSERT INTO audit VALUES (14,1000,'tester','job.move','job/1','armed to feeding: step of a test','ecfc289a4b98384547431741355b364b1b433fc62c479fb979b3f6aeddbf1bbb','008a8a2fa6bd9297058762e65efaab2a4892fed9a97adb3c70bf50382944fdb3');
INSERT INTO audit VALUES (15,1000,'tester','group.put','group/mills','mill-1; four eyes; approved without an operator''s sign-off','008a8a2fa6bd9297058762e65efaab2a4892fed9a97adb3c70bf50382944fdb3','f7376bfa817d86506a31cea5129001017d66038d85fbf02e5c8eeef89e44f597');
INSERT INTO audit VALUES (16,1000,'tester','user.add','user/olga','viewer, operator on mills','f7376bfa817d86506a31cea5129001017d66038d85fbf02e5c8eeef89e44f597','744d0b4d0ea168ba0733aa6a85942921d40e0fed42786382eccc029e687ec6c4');
INSERT INTO audit VALUES (17,1000,'tester','user.secret','user/olga','pin set','744d0b4d0ea168ba0733aa6a85942921d40e0fed42786382eccc029e687ec6c4','3db4eab3baa16c7cec98b2da8b22e84d748fc457b2af0e49767eb32bfdab942f');
INSERT INTO audit VALUES (18,1000,'dripfeed','user.add','user/dora','operator, of https://login.shop','3db4eab3baa16c7cec98b2da8b22e84d748fc457b2af0e49767eb32bfdab942f','957be68f6181336cbba7c26571e388899a1ca273f4d3a9bb71a2ebfb563a84d5');
INSERT INTO audit VALUES (19,1000,'tester','order.add','order/1','5 of R-1','957be68f6181336cbba7c26571e388899a1ca273f4d3a9bb71a2ebfb563a84d5','58b124ba62efbe2710147baf919b1b78415364977985ccd57cd16762d6984033');
INSERT INTO audit VALUES (20,1000,'tester','order.parts','order/1','2 good, 0 scrap: ','58b124ba62efbe2710147baf919b1b78415364977985ccd57cd16762d6984033','1ba75c7db8c139acf7f739b9904d8f4a1515279c0156c9ce0f92e9e42294506b');
INSERT INTO audit VALUES (21,1000,'tester','token.add','token/1','mes as operator','1ba75c7db8c139acf7f739b9904d8f4a1515279c0156c9ce0f92e9e42294506b','f70b4a6ae85b7a7e62268ba2e5b464d355ff55911113a8cda01267d8e9fa6ca9');
INSERT INTO audit VALUES (22,1000,'mill-1','receipt.add','receipt/1','O7 from mill-1 sha256 d1d47ca349a4552de786b6b202bc58d2a08ecc87b8bd3443b4e341a29c40400f stored','f70b4a6ae85b7a7e62268ba2e5b464d355ff55911113a8cda01267d8e9fa6ca9','90d656412def07c811ec9469cb9edf8c583d4bdc31a56e51618f717224aedc68');
INSERT INTO audit VALUES (23,1000,'mill-1','request.load','machine/mill-1','request 1 42: armed, job 1','90d656412def07c811ec9469cb9edf8c583d4bdc31a56e51618f717224aedc68','751869438e659e4eec0e8ca3acc81c57e6c2175400ddd1fec30143148181529a');
INSERT INTO audit VALUES (24,8,'olga','alarm.acknowledge','alarm/1','torn_block on mill-1, 1 times: a block is torn','751869438e659e4eec0e8ca3acc81c57e6c2175400ddd1fec30143148181529a','9355dd55222fc4fb9cd2fe347f13e6ec3b10fc02f8466ded003ba325577296bc');
INSERT INTO audit VALUES (25,1000,'tester','program.label','program/1','tags pump; folder acme','9355dd55222fc4fb9cd2fe347f13e6ec3b10fc02f8466ded003ba325577296bc','97952c5363a51b83ca417ea416f6ee203fbb352ad0f2986ca39b1626b3ad2edb');
INSERT INTO audit VALUES (26,1000,'tester','program.add','program/2','revision 1 sha256 80c40ef6a9aa674540b0738743ffd83134a8e0fddeba68a33e2a8d764b8d1944 uploaded','97952c5363a51b83ca417ea416f6ee203fbb352ad0f2986ca39b1626b3ad2edb','7666f709e62e31b4593b8e6c069d838eb9fe174e2a61f4c7d521b1552983cad9');
INSERT INTO audit VALUES (27,1000,'tester','release.add','release/2','text 80c40ef6a9aa674540b0738743ffd83134a8e0fddeba68a33e2a8d764b8d1944 for mill-1 by drip that continues release 1 at line 2','7666f709e62e31b4593b8e6c069d838eb9fe174e2a61f4c7d521b1552983cad9','6f32869b768e17a7453f66bfcdbfb469c48c264b9143971541dcaed3d6a358b4');
INSERT INTO audit VALUES (28,1000,'tester','program.archive','program/2','of an old machine','6f32869b768e17a7453f66bfcdbfb469c48c264b9143971541dcaed3d6a358b4','ecd767136a2028e6a7ac3c51979bbdfa198bf05b6ce6add486dd440eb21d52d7');
INSERT INTO audit VALUES (29,9,'tester','webhook.add','webhook/1','enabled https://mes.shop/in for job.*','ecd767136a2028e6a7ac3c51979bbdfa198bf05b6ce6add486dd440eb21d52d7','68037266d0998689516db2781dc0ed5a067f335d999d3efe7131971b3413cea6');
INSERT INTO audit VALUES (30,10,'tester','webhook.ping','webhook/1','','68037266d0998689516db2781dc0ed5a067f335d999d3efe7131971b3413cea6','7478d668995f299082f7f34c7f5b1dc8575d41fdf037ebc561563f3c9bb03502');
INSERT INTO audit VALUES (31,11,'tester','attachment.add','attachment/1','sheet.pdf of program/1 sha256 ef99cf8220619a13832a7aaec9e90b5817b31255ac01cc9c9cd7cfcc7e49c62f','7478d668995f299082f7f34c7f5b1dc8575d41fdf037ebc561563f3c9bb03502','872277fbc5abc62322c8a78f8a9a689131924f2b76738ea49361a75d060322f2');
INSERT INTO audit VALUES (32,1000,'tester','program.add','program/3','revision 1 sha256 f73d5f7a8fa46360460ebea34bace98d53032ad936b26da160f2b30ab5a4d54e uploaded','872277fbc5abc62322c8a78f8a9a689131924f2b76738ea49361a75d060322f2','d3af516fdfda3575729a21ed52362838fe3843d28c04f253a013723852305589');
INSERT INTO audit VALUES (33,12,'tester','program.archive','program/3','sold','d3af516fdfda3575729a21ed52362838fe3843d28c04f253a013723852305589','be356ecc6c600fe2300ab7ac91e56bab9a370d4d9d4929046138800bda5c8ac7');
INSERT INTO audit VALUES (34,13,'tester','program.delete','program/3','O8 of folder "", 1 revisions erased: nothing is left of it','be356ecc6c600fe2300ab7ac91e56bab9a370d4d9d4929046138800bda5c8ac7','71b1209dc12d0cc260c7a86be3b1fef1c9009fef8622a1421aecf7a018061cb4');
INSERT INTO token VALUES (1,'mes','operator','hash','tester',1000,0,NULL,'',0);
INSERT INTO reply VALUES ('mes','POST /jobs','k','x',201,'','body',5);
INSERT INTO receipt VALUES (1,'mill-1','O7','number','d1d47ca349a4552de786b6b202bc58d2a08ecc87b8bd3443b4e341a29c40400f',14,'iso','punch_off','stored','',1000,NULL,NULL,'','',0);
INSERT INTO request VALUES (1,'mill-1','load','42','%','armed','job 1',1,1000);
INSERT INTO answer VALUES (1,'mill-1',40,'sending','',6,0,'','',0);
INSERT INTO alarm VALUES (1,'mill-1','torn_block','a block is torn',1,7,7,0,'olga',8,'',0,'',1);
INSERT INTO program_tag VALUES (1,'pump');
INSERT INTO machine_group VALUES ('mills',1,0);
INSERT INTO account VALUES (1,'olga','viewer','','pin''s hash',0,0,0,1,'tester',1000,'','');
INSERT INTO account VALUES (2,'dora','operator','','',0,0,0,1,'dripfeed',1000,'https://login.shop','s-3');
INSERT INTO account_grant VALUES (1,'mills','operator');
INSERT INTO browser_session VALUES ('cookie',1,NULL,'',9,9,0);
INSERT INTO browser_session VALUES ('of dora',NULL,2,'password',9,9,1);
INSERT INTO event VALUES (1,'program','added',1,'mill-1',0,1,1,'','O0100','tester',1000);
INSERT INTO event VALUES (2,'release','draft',1,'mill-1',0,1,1,'','','tester',1000);
INSERT INTO event VALUES (3,'release','in_review',1,'mill-1',0,1,1,'','','tester',1000);
INSERT INTO event VALUES (4,'release','proving',1,'mill-1',0,1,1,'','','reviewer',1000);
INSERT INTO event VALUES (5,'release','approved',1,'mill-1',0,1,1,'','first piece measured','approver',1000);
INSERT INTO event VALUES (6,'job','queued',1,'mill-1',1,1,1,'','','tester',1000);
INSERT INTO event VALUES (7,'job','armed',1,'mill-1',1,1,1,'','step of a test','tester',1000);
INSERT INTO event VALUES (8,'job','feeding',1,'mill-1',1,1,1,'','step of a test','tester',1000);
INSERT INTO event VALUES (9,'order','added',1,'',0,0,0,'','A-1','tester',1000);
INSERT INTO event VALUES (10,'order','parts',1,'',0,0,0,'','A-1','tester',1000);
INSERT INTO event VALUES (11,'receipt','stored',1,'mill-1',0,0,0,'','O7','mill-1',1000);
INSERT INTO event VALUES (12,'alarm','raised',1,'mill-1',1,0,0,'torn_block','a block is torn','dripfeed',7);
INSERT INTO event VALUES (13,'alarm','acknowledged',1,'mill-1',1,0,0,'torn_block','a block is torn','olga',8);
INSERT INTO event VALUES (14,'program','added',2,'',0,2,1,'','O9','tester',1000);
INSERT INTO event VALUES (15,'release','draft',2,'mill-1',0,2,1,'','','tester',1000);
INSERT INTO event VALUES (16,'program','archived',2,'',0,2,1,'','O9','tester',1000);
INSERT INTO event VALUES (17,'webhook','ping',1,'',0,0,0,'','','tester',10);
INSERT INTO event VALUES (18,'program','added',3,'',0,3,1,'','O8','tester',1000);
INSERT INTO event VALUES (19,'program','archived',3,'',0,3,1,'','O8','tester',12);
INSERT INTO event VALUES (20,'program','deleted',3,'',0,3,0,'','O8','tester',13);
INSERT INTO event_reader VALUES ('mqtt',1);
INSERT INTO webhook VALUES (1,'https://mes.shop/in','job.*','',1,0,'whsec_x','',0,'','tester',9,9,16,0);
INSERT INTO webhook_delivery VALUES (1,1,17,'pending',0,10,0,0,'');
INSERT INTO work_order VALUES (1,'A-1','20','R-1',5,NULL,0,0,'{}','open','',1,'tester',1000,1000);
INSERT INTO parts_report VALUES (1,1,2,0,'','tester',1000);
INSERT INTO attachment VALUES (1,1,NULL,NULL,NULL,'sheet.pdf','application/pdf','ef99cf8220619a13832a7aaec9e90b5817b31255ac01cc9c9cd7cfcc7e49c62f','ef99cf8220619a13832a7aaec9e90b5817b31255ac01cc9c9cd7cfcc7e49c62f',13,'tester',11,'','',0);
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
CREATE TRIGGER machine_revision_update BEFORE UPDATE ON machine_revision BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER machine_revision_delete BEFORE DELETE ON machine_revision BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER family_revision_update BEFORE UPDATE ON family_revision BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER family_revision_delete BEFORE DELETE ON family_revision BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER part_revision_update BEFORE UPDATE ON part_revision BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER part_revision_delete BEFORE DELETE ON part_revision BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER program_revision_update BEFORE UPDATE ON program_revision BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER waiver_update BEFORE UPDATE ON waiver BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER waiver_delete BEFORE DELETE ON waiver BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER release_step_update BEFORE UPDATE ON release_step BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER release_step_delete BEFORE DELETE ON release_step BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER ledger_update BEFORE UPDATE ON ledger BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER ledger_delete BEFORE DELETE ON ledger BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER audit_update BEFORE UPDATE ON audit BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER audit_delete BEFORE DELETE ON audit BEGIN SELECT RAISE(ABORT, 'append-only'); END;
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
CREATE TRIGGER token_delete BEFORE DELETE ON token BEGIN SELECT RAISE(ABORT, 'append-only'); END;
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
CREATE INDEX receipt_machine ON receipt (machine, id);
CREATE INDEX receipt_content ON receipt (sha256);
CREATE INDEX request_machine ON request (machine, id);
CREATE TRIGGER receipt_update BEFORE UPDATE ON receipt
WHEN OLD.decided_at_ms <> 0 OR (NEW.id, NEW.machine, NEW.name, NEW.style, NEW.sha256, NEW.raw_bytes, NEW.code, NEW.ended_by,
     NEW.reason, NEW.at_ms) IS NOT (OLD.id, OLD.machine, OLD.name, OLD.style, OLD.sha256, OLD.raw_bytes, OLD.code, OLD.ended_by,
     OLD.reason, OLD.at_ms)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER receipt_delete BEFORE DELETE ON receipt BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER request_update BEFORE UPDATE ON request BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER request_delete BEFORE DELETE ON request BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER content_chunk_delete_received BEFORE DELETE ON content_chunk
WHEN EXISTS (SELECT 1 FROM content JOIN receipt r ON r.sha256 = content.sha256 WHERE content.id = OLD.content)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE INDEX job_torn ON job (machine, torn, confirmed_at_ms) WHERE torn = 1 AND confirmed_at_ms = 0;
CREATE INDEX answer_machine ON answer (machine, id);
CREATE INDEX answer_torn ON answer (machine) WHERE state = 'torn' AND confirmed_at_ms = 0;
CREATE INDEX answer_sending ON answer (id) WHERE state = 'sending';
CREATE TRIGGER answer_update BEFORE UPDATE ON answer
WHEN (NEW.id, NEW.machine, NEW.bytes_total, NEW.begun_at_ms) IS NOT (OLD.id, OLD.machine, OLD.bytes_total, OLD.begun_at_ms)
  OR (OLD.state <> 'sending' AND (NEW.state, NEW.reason, NEW.ended_at_ms) IS NOT (OLD.state, OLD.reason, OLD.ended_at_ms))
  OR OLD.confirmed_at_ms <> 0
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER answer_delete BEFORE DELETE ON answer BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE UNIQUE INDEX alarm_open ON alarm (machine, kind, body) WHERE closed = 0;
CREATE INDEX alarm_lasting ON alarm (machine, kind) WHERE cleared_at_ms = 0;
CREATE INDEX alarm_shelved ON alarm (shelved_until_ms) WHERE shelved_until_ms <> 0;
CREATE INDEX alarm_time ON alarm (last_at_ms, id);
CREATE INDEX alarm_open_time ON alarm (last_at_ms, id) WHERE closed = 0;
CREATE INDEX alarm_closed_time ON alarm (last_at_ms, id) WHERE closed = 1;
CREATE INDEX alarm_machine_time ON alarm (machine, last_at_ms, id);
CREATE INDEX alarm_job ON alarm (job) WHERE job IS NOT NULL;
CREATE TRIGGER alarm_update BEFORE UPDATE ON alarm
WHEN (NEW.id, NEW.machine, NEW.kind, NEW.body, NEW.raised_at_ms, NEW.job)
     IS NOT (OLD.id, OLD.machine, OLD.kind, OLD.body, OLD.raised_at_ms, OLD.job)
  OR OLD.closed = 1 AND (NEW.count, NEW.last_at_ms, NEW.cleared_at_ms, NEW.acknowledged_by, NEW.acknowledged_at_ms)
     IS NOT (OLD.count, OLD.last_at_ms, OLD.cleared_at_ms, OLD.acknowledged_by, OLD.acknowledged_at_ms)
  OR OLD.acknowledged_at_ms <> 0 AND NEW.acknowledged_at_ms IS NOT OLD.acknowledged_at_ms
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER alarm_delete BEFORE DELETE ON alarm WHEN OLD.closed = 0
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE INDEX job_queue ON job (machine, queue_rank, id) WHERE state = 'queued';
CREATE INDEX job_ended ON job (machine, ended_at_ms);
CREATE INDEX program_change ON program (change_number);
CREATE INDEX program_folder ON program (folder) WHERE folder <> '';
CREATE INDEX program_tag_tag ON program_tag (tag, program);
CREATE INDEX job_program ON job (program, id);
CREATE INDEX machine_by_group ON machine (machine_group) WHERE machine_group IS NOT NULL;
CREATE INDEX account_grant_group ON account_grant (machine_group);
CREATE TRIGGER account_delete BEFORE DELETE ON account BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER account_update BEFORE UPDATE ON account
WHEN (NEW.id, NEW.name, NEW.created_by, NEW.created_at_ms) IS NOT (OLD.id, OLD.name, OLD.created_by, OLD.created_at_ms)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER token_update BEFORE UPDATE ON token
WHEN OLD.revoked_at_ms <> 0
     OR (NEW.id, NEW.name, NEW.role, NEW.hash, NEW.created_by, NEW.created_at_ms, NEW.account, NEW.scope,
         NEW.expires_at_ms)
     IS NOT (OLD.id, OLD.name, OLD.role, OLD.hash, OLD.created_by, OLD.created_at_ms, OLD.account, OLD.scope,
             OLD.expires_at_ms)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE INDEX browser_session_token ON browser_session (token, used_at_ms);
CREATE INDEX browser_session_account ON browser_session (account, used_at_ms);
CREATE INDEX event_time ON event (at_ms);
CREATE TRIGGER event_update BEFORE UPDATE ON event BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE INDEX webhook_delivery_event ON webhook_delivery (event);
CREATE INDEX webhook_delivery_due ON webhook_delivery (webhook, next_at_ms, event) WHERE state = 'pending';
CREATE INDEX webhook_delivery_delivered ON webhook_delivery (last_at_ms) WHERE state = 'delivered';
CREATE INDEX webhook_delivery_dead ON webhook_delivery (webhook, event) WHERE state = 'dead';
CREATE INDEX work_order_state ON work_order (state, id);
CREATE INDEX work_order_part ON work_order (part, id);
CREATE TRIGGER work_order_delete BEFORE DELETE ON work_order BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER work_order_update BEFORE UPDATE ON work_order
WHEN (NEW.id, NEW.number, NEW.operation, NEW.created_by, NEW.created_at_ms)
     IS NOT (OLD.id, OLD.number, OLD.operation, OLD.created_by, OLD.created_at_ms)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER parts_report_update BEFORE UPDATE ON parts_report BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER parts_report_delete BEFORE DELETE ON parts_report BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE INDEX job_work_order ON job (work_order, state) WHERE work_order IS NOT NULL;
CREATE TRIGGER job_work_order_update BEFORE UPDATE OF work_order ON job
WHEN NEW.work_order IS NOT OLD.work_order BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER verdict_call_update BEFORE UPDATE ON verdict_call BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER verdict_call_delete BEFORE DELETE ON verdict_call BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER text_release_restart_update BEFORE UPDATE OF restart_of, restart_line ON text_release
WHEN (NEW.restart_of, NEW.restart_line) IS NOT (OLD.restart_of, OLD.restart_line)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER verdict_point_update BEFORE UPDATE ON verdict_point BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER verdict_point_delete BEFORE DELETE ON verdict_point BEGIN SELECT RAISE(ABORT, 'append-only'); END;
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
CREATE TRIGGER content_chunk_delete_attached BEFORE DELETE ON content_chunk
WHEN EXISTS (SELECT 1 FROM content JOIN attachment a ON a.content = content.sha256 WHERE content.id = OLD.content)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER program_revision_delete BEFORE DELETE ON program_revision
WHEN NOT EXISTS (SELECT 1 FROM program WHERE id = OLD.program AND deleted_at_ms <> 0)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE INDEX receipt_program ON receipt (program, revision) WHERE program IS NOT NULL;
CREATE INDEX verdict_call_program ON verdict_call (program, revision);
CREATE INDEX job_end_time ON job (ended_at_ms) WHERE ended_at_ms <> 0;
CREATE INDEX job_choice ON job (choice, state) WHERE choice IS NOT NULL;
CREATE INDEX job_end_waits ON job (machine, id)
  WHERE end_check <> '' AND end_confirmed_at_ms = 0 AND started_at_ms <> 0 AND ended_at_ms <> 0;
CREATE TRIGGER job_plan_update BEFORE UPDATE OF choice, end_check, end_confirmed_by, end_note, end_confirmed_at_ms ON job
WHEN NEW.end_check IS NOT OLD.end_check OR (OLD.choice IS NOT NULL AND NEW.choice IS NOT OLD.choice)
     OR (OLD.end_confirmed_at_ms <> 0 AND (NEW.end_confirmed_by, NEW.end_note, NEW.end_confirmed_at_ms)
         IS NOT (OLD.end_confirmed_by, OLD.end_note, OLD.end_confirmed_at_ms))
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE UNIQUE INDEX account_of_provider ON account (provider, provider_subject) WHERE provider <> '';
CREATE TRIGGER account_provider_update BEFORE UPDATE OF provider, provider_subject ON account
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER verdict_rules_update BEFORE UPDATE OF rules ON verdict
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE INDEX job_release ON job (text_release, started_at_ms) WHERE state = 'done';
