"""The sentences that have ids (server/json/sentences.cpp) against the code that uses them: the code has each row's sentence somewhere, and each
sentence of alarms and refusals at a machine has a row. Run as `sentences.py ROOT`."""

import pathlib
import re
import sys

LITERAL = r'"(?:[^"\\]|\\.)*"'
FOLDERS = ["server/app", "server/http", "server/io", "server/json", "server/oidc", "store", "protocol/feed"]
FILES = ["server/cli/command_maintenance.cpp"]  # a process of the server: its sentences are answers
# Files whose refusals people at machines meet. What only programmers of clients meet stays as it is written.
WORDED = ["out/alarms.cpp", "application.cpp", "jobs/job_follower.cpp", "jobs/jobs.cpp", "lines/lines.cpp", "lines/kept_link.cpp", "lines/feed_line.cpp"]


def texts(source):
    """Adjacent literals of a source as one, `{}` for what is put in."""
    found = []
    for run in re.finditer(rf"{LITERAL}(?:\s*{LITERAL})*", source):
        found.append("".join(one.replace('\\"', '"') for one in re.findall(r'"((?:[^"\\]|\\.)*)"', run.group())))
    return found


def rows(root):
    table = (root / "server/json/sentences.cpp").read_text()
    return [(i, p.replace('\\"', '"')) for i, p in re.findall(r'Row\{\s*"(\w+)",\s*"((?:[^"\\]|\\.)*)"', re.sub(r'"\s*\n\s*"', "", table))]


def shape(pattern):
    """Without the names of what is put in, and without what follows the last fixed words."""
    return re.sub(r"\{[^}]*\}", "{}", pattern)


def said_somewhere(pattern, said):
    """Each of its parts: a sentence may be put together of several."""
    parts = [part.strip(" :") for part in re.split(r"\{\}|; | \(|: ", shape(pattern))]
    return all(any(part in one for one in said) for part in parts if len(part) >= 8)


def refusals(source):
    """The sentence of each fail(), raise() and unexpected() that begins with a literal."""
    for call in re.finditer(rf"(?:fail\(ErrorCode::\w+,|std::unexpected\(|alarms_\.raise\([^;]*?,)\s*(?:std::string\(|fmt::format\()?\s*({LITERAL}(?:\s*{LITERAL})*)", source):
        yield texts(call.group(1))[0]


def faults(root):
    root = pathlib.Path(root)
    table = rows(root)
    files = [file for folder in FOLDERS for file in sorted((root / folder).rglob("*.[ch]*")) if file.name != "sentences.cpp"]
    files += [root / name for name in FILES if (root / name).exists()]
    said = [text for file in files for text in texts(file.read_text())]
    found = [f"{i}: no code says \"{p}\"" for i, p in table if not said_somewhere(p, said)]
    found += [f"{i} has two rows" for i in {i for i, _ in table} if sum(1 for other, _ in table if other == i) > 1]
    known = [re.compile(".*".join(re.escape(part) for part in shape(p).split("{}"))) for _, p in table]
    for name in WORDED:
        for sentence in refusals((root / "server/app" / name).read_text()):
            plain = sentence.replace("{}", "x") + ("x" if sentence.endswith(" ") else "")
            if " " in plain.replace("x", "").strip() and not any(one.fullmatch(plain) for one in known):
                found.append(f"server/app/{name}: \"{sentence}\" has no row in server/json/sentences.cpp")
    return found


if __name__ == "__main__":
    wrong = faults(sys.argv[1])
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)
