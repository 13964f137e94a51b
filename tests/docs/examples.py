# The examples of docs/diagnostics.md do what stands there: `dripfeed check` finds the diagnostic in the first program and not in the
# second.
#   examples.py DRIPFEED [ROOT]
import concurrent.futures
import json
import os
import re
import subprocess
import sys

import pages

EXAMPLE = re.compile(r'^(This program has it|This one does not)(?: \(([\w-]+)\))?:\n\n```nc\n(.*?)^```$', re.M | re.S)
# What only a machine, a delivery or another option of the golden brings about.
ELSEWHERE = {'not-in-drip-mode': ['--drip']}


def examples(text):
    """Tuples (id, dialect, program, whether it has the diagnostic)."""
    for section in re.split(r'^## ', text, flags=re.M)[1:]:
        name = section.split('\n', 1)[0].strip()
        dialect = None
        for sentence, stated, program in EXAMPLE.findall(section):
            dialect = stated or dialect
            yield name, dialect, program, sentence == 'This program has it'


def ids_found(dripfeed, dialect, program, options):
    done = subprocess.run([dripfeed, 'check', '-', '--json', '--dialect', dialect, *options], input=program.encode(), capture_output=True, timeout=30)
    file = json.loads(done.stdout)['files'][0]
    checks = [file[name] for name in ('envelope', 'gouge', 'accuracy', 'timing') if file.get(name)]
    return {one['id'] for one in file['diagnostics']} | {one['id'] for check in checks for one in check.get('findings', [])}


def fault_of(dripfeed, example):
    name, dialect, program, has_it = example
    if (name in ids_found(dripfeed, dialect, program, ELSEWHERE.get(name, []))) == has_it:
        return None
    return f'{name} ({dialect}): {"is not found in its example" if has_it else "is found in the example without it"}\n{program}'


def faults(dripfeed, text):
    all_of_them = list(examples(text))
    if not all_of_them:
        return ['no example at all']
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return [fault for fault in pool.map(lambda one: fault_of(dripfeed, one), all_of_them) if fault]


if __name__ == '__main__':
    page = pages.root_of(sys.argv, 2) / 'docs/diagnostics.md'
    pages.finish('examples', faults(sys.argv[1], page.read_text(encoding='utf-8')))
