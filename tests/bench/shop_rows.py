"""Rows of a shop of twenty years, written into a store past the server: programs with revisions, their texts, jobs and ledger rows. They come from
one generator, and go into SQLite or into PostgreSQL. The store has to have one program, one release and one job already: the facts of a text and the
columns that do not matter here are copied from them."""

import hashlib
import random
import sqlite3
import subprocess

THINGS = ["PUMP", "HOUSING", "FLANGE", "SHAFT", "BRACKET", "VALVE", "PISTON", "COVER", "GEAR", "ADAPTER", "BUSHING", "MANIFOLD"]
STEPS = ["ROUGH", "FINISH", "DRILL 8.5", "TAP M10", "FACE MILL D63", "CHAMFER", "SECOND SIDE", "CHECK CLAMPS"]
DAY_MS = 24 * 3600 * 1000
STATES = ["done"] * 8 + ["interrupted", "cancelled"]
SPAN_MS = 20 * 365 * DAY_MS
BYTES_A_ROW = 800
MARK_EVERY = 256  # as store/sql/ledger_table.cpp
NUMBERED = ("program", "content", "job", "ledger", "text_release")


class SqliteSink:
    def __init__(self, data):
        self.database = sqlite3.connect(next(data.glob("*.db")), isolation_level=None)
        self.database.execute("PRAGMA synchronous = OFF")
        self.database.execute("PRAGMA cache_size = -1000000")
        self.database.execute("BEGIN")

    def one(self, table):
        """Its newest row, without a column where there is none."""
        cursor = self.database.execute(f"SELECT * FROM {table} ORDER BY 1 DESC LIMIT 1")
        return dict(zip([column[0] for column in cursor.description], cursor.fetchone() or ()))

    def add(self, table, names, rows):
        self.database.executemany(f"INSERT INTO {table} ({', '.join(names)}) VALUES ({', '.join('?' * len(names))})", rows)

    def end(self):
        self.database.execute("COMMIT")
        self.database.close()


class PostgresqlSink:
    """COPY, by psql."""

    def __init__(self, url):
        self.command = ["psql", "-q", "-X", "-v", "ON_ERROR_STOP=1", url]

    def one(self, table):
        sql = f"SELECT * FROM {table} ORDER BY 1 DESC LIMIT 1"
        out = subprocess.run([*self.command, "-A", "-F", "\x1f", "-R", "\x1e", "-c", sql, "-P", "footer=off", "-P", "null=\x01"], check=True,
                             capture_output=True, text=True).stdout
        names, *rows = (row.rstrip("\n").split("\x1f") for row in out.split("\x1e"))
        return {name: None if value == "\x01" else value for name, value in zip(names, rows[0] if rows else ())}

    def add(self, table, names, rows):
        # Without triggers, as a restored backup is written.
        sql = ["-c", "SET session_replication_role = replica", "-c", f"COPY {table} ({', '.join(names)}) FROM STDIN"]
        psql = subprocess.Popen([*self.command, *sql], stdin=subprocess.PIPE, text=True)
        for row in rows:
            psql.stdin.write("\t".join(map(self.cell, row)) + "\n")
        psql.stdin.close()
        if psql.wait() != 0:
            raise RuntimeError(f"COPY {table} ended with {psql.returncode}")

    @staticmethod
    def cell(value):
        if value is None:
            return "\\N"
        if isinstance(value, bytes):
            return "\\\\x" + value.hex()
        return str(value).replace("\\", "\\\\").replace("\t", "\\t").replace("\n", "\\n").replace("\r", "\\r")

    def end(self):
        numbers = [f"SELECT setval(pg_get_serial_sequence('{table}', 'id'), (SELECT max(id) FROM {table}))" for table in NUMBERED]
        for sql in [*numbers, "VACUUM ANALYZE"]:
            subprocess.run([*self.command, "-c", sql], check=True, stdout=subprocess.DEVNULL)


def name_of(program):
    pick = random.Random(program)
    return f"{pick.choice(THINGS)}-{pick.choice(THINGS)}-{program:06}"


def text_of(program, revision):
    """A short program; a revision has another number in one of its moves."""
    pick = random.Random(program)
    lines = ["%", f"O{program % 9000 + 1000:04}({name_of(program)})", "G21 G90 G54 G00 X0. Y0.", f"T{program % 40 + 1:02} M06", f"({pick.choice(STEPS)})"]
    lines += [f"G01 X{pick.randrange(400)}.{pick.randrange(1000):03} Y{pick.randrange(400)}. F{100 + pick.randrange(20)}" for _ in range(20)]
    lines[8] += f"\nG01 X{revision}. Z{program % 90}."
    return ("\n".join(lines) + "\nM30\n%\n").encode()


class Shop:
    """What is written, for a store that `sink` leads to."""

    def __init__(self, sink, programs, revisions, ledger_rows, rows_a_job, machines, now_ms):
        self.sink, self.programs, self.machines, self.now_ms = sink, programs, machines, now_ms
        self.each = max(1, revisions // programs)
        self.jobs, self.rows_a_job = ledger_rows // rows_a_job, rows_a_job
        self.seen = {table: sink.one(table) for table in (*NUMBERED, "program_revision")}
        self.first = {table: int(self.seen[table].get("id", 0)) + 1 for table in NUMBERED}

    def write(self):
        self.texts()
        self.releases_and_jobs()
        self.ledger()
        self.sink.end()

    def copied(self, table, names, rows):
        """Rows as the one that is there, but for the columns `names`."""
        all_names = list(self.seen[table])
        columns = [all_names.index(name) for name in names]

        def row(values):
            made = list(self.seen[table].values())
            for column, value in zip(columns, values):
                made[column] = value
            return made
        self.sink.add(table, all_names, map(row, rows))

    def numbered(self):
        """Number of a content, program, revision, text."""
        for n in range(self.programs * self.each):
            program, revision = self.first["program"] + n // self.each, n % self.each + 1
            yield self.first["content"] + n, program, revision, text_of(program, revision)

    def texts(self):
        """Chunks before their contents: a content that has its hash takes no more of them."""
        change = int(self.seen["program"]["change_number"]) + 1
        self.sink.add("content_chunk", ["content", "n", "data"], ((at, 0, text) for at, _, _, text in self.numbered()))
        self.sink.add("content", ["id", "sha256", "bytes"], ((at, sha256(text), len(text)) for at, _, _, text in self.numbered()))
        self.copied("program", ["id", "name", "revision", "change_number", "folder"],
                    ((self.first["program"] + n, name_of(self.first["program"] + n), self.each, change + n, f"customer{n % 200}") for n in range(self.programs)))
        self.copied("program_revision", ["program", "revision", "sha256", "places_sha256", "blocks", "at_ms"],
                    ((program, revision, sha256(text), None, text.count(b"\n"), self.now_ms - revision * DAY_MS) for _, program, revision, text in self.numbered()))

    def release(self, n):
        """Number of the release of the nth job, its program and machine: the jobs go round the programs."""
        n %= self.programs
        return self.first["text_release"] + n, self.first["program"] + n, self.machines[n % len(self.machines)]

    def releases_and_jobs(self):
        newest = [sha256(text_of(self.first["program"] + n, self.each)) for n in range(self.programs)]
        self.copied("text_release", ["id", "program", "revision", "sha256", "machine", "state"],
                    ((*self.release(n)[:2], self.each, newest[n], self.release(n)[2], "approved") for n in range(self.programs)))

        def job(n):
            release, program, machine = self.release(n)
            begun = self.now_ms - SPAN_MS + n * SPAN_MS // self.jobs
            times = begun, begun + 1000, begun + 2000, begun + 2000 + self.rows_a_job * 1000
            return self.first["job"] + n, release, program, self.each, newest[n % self.programs], machine, BYTES_A_ROW * self.rows_a_job, STATES[n % 10], 0, *times
        self.copied("job", ["id", "text_release", "program", "revision", "sha256", "machine", "bytes_total", "state", "torn", "created_at_ms", "armed_at_ms",
                            "started_at_ms", "ended_at_ms"], map(job, range(self.jobs)))

    def ledger(self):
        def rows():
            for n in range(self.jobs):
                begun = self.now_ms - SPAN_MS + n * SPAN_MS // self.jobs + 2000
                for seq in range(1, self.rows_a_job + 1):
                    at, passed = self.first["ledger"] + n * self.rows_a_job + seq - 1, seq * BYTES_A_ROW
                    yield at, self.first["job"] + n, seq, begun + seq * 1000, passed, passed, passed, passed, "", at - 1 if seq > 1 else None
        self.sink.add("ledger", ["id", "job", "seq", "at_ms", "handed", "clocked", "confirmed", "reserve", "note", "previous"], rows())
        self.sink.add("ledger_mark", ["job", "seq", "ledger"], ((row[1], row[2], row[0]) for row in rows() if row[2] % MARK_EVERY == 0))
        self.sink.add("ledger_head", ["job", "last", "seq", "at_ms", "handed", "clocked", "confirmed", "reserve"],
                      ((row[1], row[0], *row[2:8]) for row in rows() if row[2] == self.rows_a_job))


def sha256(text):
    return hashlib.sha256(text).hexdigest()
