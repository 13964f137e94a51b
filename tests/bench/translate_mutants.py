#!/usr/bin/env python3
"""Faults put into the translator, one at a time: a test must fail for each.

  tests/bench/translate_mutants.py COPY --build COMMAND --tests BINARY ... [--filter SUITES] [--list] [--count 200] [--seed 1] [--jobs 2] [--folders F ...]

COPY is a copy of the source tree that may be spoilt: the script writes into it. All mutants are built at once: each has a number, and the
environment names the one that is on. COMMAND builds COPY (run in it); lines of mutants that do not compile are taken back, and it is run again. The tests
are run once to see which suites reach which mutants; then each mutant runs the suites that reach it until one test fails. A mutant is a condition that is
negated, an operand of && or || that does not count, a call that is left out, a whole number that is one more, or true that is returned for false.
Lists those that survive, and those that no test reaches; exits 1 when there are any.
"""

import argparse
import collections
import concurrent.futures
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile

FOLDERS = ["dialects/compile/translate", "dialects/compile/plain", "dialects/passes"]
HEADER = """// Which mutant is on: the environment says it. With DRIPFEED_MUTANTS those that were reached are written there at the end.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <vector>

namespace dripfeed {

struct Mutants {
  int on = std::getenv("DRIPFEED_MUTANT") != nullptr ? std::atoi(std::getenv("DRIPFEED_MUTANT")) : -1;
  const char* reached_file = std::getenv("DRIPFEED_MUTANTS");
  std::vector<bool> reached = std::vector<bool>(100'000);
  Mutants() = default;
  Mutants(const Mutants&) = delete;
  Mutants& operator=(const Mutants&) = delete;
  ~Mutants() {
    if (reached_file == nullptr) return;
    std::FILE* file = std::fopen(reached_file, "w");
    for (std::size_t i = 0; i < reached.size(); ++i)
      if (reached[i]) std::fprintf(file, "%zu\\n", i);
    std::fclose(file);
  }
};
inline Mutants& mutants() {
  static Mutants all;
  return all;
}
inline bool mutant(int n) {
  Mutants& all = mutants();
  if (all.reached_file != nullptr) all.reached[static_cast<std::size_t>(n)] = true;
  return all.on == n;
}

}  // namespace dripfeed
"""


def blanked(text):
    """The code with comments and literals as blanks, of the same length."""
    pattern = r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\''
    return re.sub(pattern, lambda m: re.sub(r"[^\n]", " ", m[0]), text, flags=re.S)


def closing(code, at):
    """The bracket that closes the one at `at`."""
    depth = 0
    for i in range(at, len(code)):
        depth += (code[i] in "([{") - (code[i] in ")]}")
        if depth == 0:
            return i
    return -1


def operand_end(code, at, stops):
    depth = 0
    for i in range(at, len(code)):
        if depth == 0 and (code[i] in ");,?:]}" or any(code.startswith(stop, i) for stop in stops)):
            return i if code[i : i + 2] != "::" and code[i - 1 : i + 1] != "::" else operand_end(code, i + 2, stops)
        depth += (code[i] in "([{") - (code[i] in ")]}")
    return -1


def places(text):
    """[(begin, end, text with {} for the number, what)] of all mutants of a file."""
    code, found = blanked(text), []
    def add(begin, end, form, what):
        found.append((begin, end, form, what))
    for m in re.finditer(r"\b(?:if|while) \(", code):
        end = closing(code, m.end() - 1)
        inner = code[m.end() : end]
        if end > 0 and ";" not in inner and not re.match(r"\s*(const |auto |std::optional<)", inner) and " = " not in inner:
            add(m.end(), end, "dripfeed::mutant({}) != static_cast<bool>(@)", "condition negated")
    for m in re.finditer(r" (&&|\|\|)\s+", code):
        end = operand_end(code, m.end(), ["&&", "||"] if m[1] == "&&" else ["||"])
        if end > 0:
            add(m.end(), end, "(dripfeed::mutant({}) || (@))" if m[1] == "&&" else "(!dripfeed::mutant({}) && (@))", f"operand of {m[1]} without effect")
    for m in re.finditer(r"^ +((?!return|throw|delete|else|case|co_|using|static_assert|EXPECT)[a-z_][\w.\->:]*\([^;{}]*\);)$", code, re.M):
        before = code[: m.start(1)].rstrip()
        if before.endswith((";", "{", "}")) and not re.match(r"\w+(::\w+)* \w", m[1]):
            add(m.start(1), m.end(1), "if (!dripfeed::mutant({})) @", "call left out")
    for m in re.finditer(r"(?<=[-+<>=] )(\d+)(?=[;) ,])|(?<=[-+<>=] )(\d+)U(?=[;) ,])", code):
        line = code[code.rfind("\n", 0, m.start()) : code.find("\n", m.start())]
        if "constexpr" not in line and not re.search(r"^\s+(?:std::)?\w+(?:::\w+)* \w+ = \d+U?;", line.strip("\n")) and not line.strip().startswith(("case", "static")):
            add(m.start(), m.end(), "(@ + (dripfeed::mutant({}) ? 1 : 0))", "number one more")
    for m in re.finditer(r"\breturn (true|false);", code):
        add(m.start(1), m.end(1), "dripfeed::mutant({}) != @", "true for false, or false for true")
    return found


def is_in_function(code, at):
    """Not in a table or at the level of the file."""
    return code.rfind("\n}", 0, at) < code.rfind(") {\n", 0, at) or code.rfind("\n}", 0, at) < code.rfind(" const {\n", 0, at)


def original_of(path):
    kept = path.with_suffix(".cpp.original")
    return (kept if kept.exists() else path).read_text()


def choose(copy, folders, count, chance):
    every = []
    for folder in folders:
        for path in sorted((copy / folder).glob("*.cpp")):
            text = original_of(path)
            code = blanked(text)
            every += [(path, *place) for place in places(text) if is_in_function(code, place[0])]
    # Those that overlap could not stand in one text.
    chance.shuffle(every)
    taken, chosen = collections.defaultdict(list), []
    for one in every:
        if all(one[2] <= begin or end <= one[1] for begin, end in taken[one[0]]):
            taken[one[0]].append((one[1], one[2]))
            chosen.append(one)
        if len(chosen) == count:
            break
    return chosen, len(every)


def write(copy, chosen, dropped):
    originals = {}
    for number, (path, begin, end, form, _) in sorted(enumerate(chosen), key=lambda item: -item[1][1]):
        text = originals.setdefault(path, original_of(path))
        if not path.with_suffix(".cpp.original").exists():
            path.with_suffix(".cpp.original").write_text(text)
        if number in dropped:
            continue
        originals[path] = text[:begin] + form.replace("{}", str(number)).replace("@", text[begin:end]) + text[end:]
    for path, text in originals.items():
        made = re.sub(r'^(#include )', r'#include "dialects/text/mutant.h"\n\1', text, count=1, flags=re.M)
        if not path.exists() or path.read_text() != made:
            path.write_text(made)


def build(copy, command, chosen):
    """Numbers of mutants that do not compile."""
    (copy / "dialects/text/mutant.h").write_text(HEADER)
    dropped = set()
    while True:
        write(copy, chosen, dropped)
        done = subprocess.run(command, shell=True, cwd=copy, capture_output=True, text=True)
        if done.returncode == 0:
            return dropped
        before = len(dropped)
        for name, line in set(re.findall(r"([\w/.]+\.cpp):(\d+):\d+: error", done.stdout + done.stderr)):
            for path in {one[0] for one in chosen if str(one[0]).endswith(name.split("/main/")[-1])}:
                lines = path.read_text().split("\n")[max(0, int(line) - 2) : int(line) + 1]
                dropped |= {int(n) for text in lines for n in re.findall(r"dripfeed::mutant\((\d+)\)", text)}
        if len(dropped) == before:
            sys.exit("it does not build:\n" + (done.stdout + done.stderr)[-3000:])


def suites_of(binary, pattern):
    listed = subprocess.run([binary, "--gtest_list_tests", f"--gtest_filter={pattern}"], capture_output=True, text=True).stdout
    return [(binary, line.split("#")[0].strip()) for line in listed.splitlines() if line and not line.startswith((" ", "Running"))]


def run(binary, pattern, **environment):
    try:
        done = subprocess.run([binary, f"--gtest_filter={pattern}", "--gtest_fail_fast", "--gtest_brief=1"], capture_output=True, timeout=300, env={**os.environ, **environment})
        return done.returncode
    except subprocess.TimeoutExpired:
        return -1


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("copy", type=pathlib.Path)
    options.add_argument("--build", required=True)
    options.add_argument("--tests", required=True, nargs="+")
    options.add_argument("--filter", default="*")
    options.add_argument("--folders", nargs="+", default=FOLDERS)
    options.add_argument("--count", type=int, default=200)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--jobs", type=int, default=2)
    options.add_argument("--list", action="store_true", help="print the mutants, build nothing")
    given = options.parse_args()
    chosen, total = choose(given.copy, given.folders, given.count, random.Random(given.seed))
    def describe(number):
        path, begin, end, _, what = chosen[number]
        text = original_of(path)
        return f"{path.relative_to(given.copy)}:{text.count(chr(10), 0, begin) + 1}: {what}: {' '.join(text[begin:end].split())[:110]}"
    if given.list:
        print("\n".join(describe(n) for n in range(len(chosen))))
        return print(f"{len(chosen)} of {total}")
    dropped = build(given.copy, given.build, chosen)
    suites = [suite for binary in given.tests for suite in suites_of(binary, given.filter)]
    reached = collections.defaultdict(list)
    with tempfile.TemporaryDirectory() as folder:
        def record(suite):
            binary, name = suite
            file = pathlib.Path(folder) / f"{pathlib.Path(binary).name}_{name.strip('.').replace('/', '_')}"
            if run(binary, name + "*", DRIPFEED_MUTANTS=str(file)) != 0:
                sys.exit(f"{name} fails without a mutant")
            return suite, [int(n) for n in file.read_text().split()] if file.exists() else []
        with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
            for suite, numbers in pool.map(record, suites):
                for number in numbers:
                    reached[number].append(suite)
    live = [n for n in range(len(chosen)) if n not in dropped]
    def kill(number):
        return number, any(run(binary, name + "*", DRIPFEED_MUTANT=str(number)) != 0 for binary, name in reached[number])
    survivors, killed = [], 0
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        for number, is_dead in pool.map(kill, [n for n in live if reached[n]]):
            killed += is_dead
            if not is_dead:
                survivors.append(number)
                print("survives:", describe(number), flush=True)
    not_reached = [n for n in live if not reached[n]]
    for number in not_reached:
        print("not reached:", describe(number))
    print(f"{len(chosen)} of {total} mutants, seed {given.seed}: {len(dropped)} do not compile, {killed} killed, {len(survivors)} survive, {len(not_reached)} not reached")
    sys.exit(1 if survivors or not_reached else 0)


if __name__ == "__main__":
    main()
