# Runs the sessions of README and docs: fenced blocks marked `console`. A line `$ command` (continued by lines `> …`) is run by bash
# with the built dripfeed in the PATH, all blocks of a page in one empty folder; what follows is its output, standard error first as it
# comes. A line `…` stands for any lines, a line that ends in … for its beginning.
#   sessions.py DRIPFEED [ROOT]
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import pages

SECONDS = 30


def commands(block):
    """Triples (line in the block, command, expected lines)."""
    found = []
    for number, line in enumerate(block.splitlines()):
        if line.startswith('$ '):
            found.append((number, [line[2:]], []))
        elif line.startswith('> ') and found and not found[-1][2]:
            found[-1][1].append(line[2:])
        elif found:
            found[-1][2].append(line)
    return [(number, '\n'.join(command), expected) for number, command, expected in found]


def pattern(expected):
    """What the output must match as a whole."""
    parts = []
    for line in expected:
        if line.strip() == '…':
            parts.append(r'(?:.*\n)*?')
        elif line.endswith('…'):
            parts.append(re.escape(line[:-1].rstrip()) + r'.*\n')
        else:
            parts.append(re.escape(line.rstrip()) + r'[ \t]*\n')
    return re.compile(''.join(parts))


def output_of(command, folder, dripfeed):
    environment = dict(os.environ, PATH=f'{pathlib.Path(dripfeed).resolve().parent}:{os.environ["PATH"]}', LC_ALL='C.UTF-8')
    done = subprocess.run(['bash', '-c', command], cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, timeout=SECONDS)
    text = done.stdout.decode('utf-8', 'replace')
    return text if not text or text.endswith('\n') else text + '\n'


def faults_of(name, text, dripfeed):
    found = []
    with tempfile.TemporaryDirectory(prefix='dripfeed_docs_') as folder:
        for line, language, block in pages.blocks(text):
            if language != 'console':
                if re.search(r'^\$ ', block, re.M):
                    found.append(f'{name}:{line}: a session that is not marked console is not tested')
                continue
            steps = commands(block)
            if not steps:
                found.append(f'{name}:{line}: a console block without a command')
            for number, command, expected in steps:
                output = output_of(command, folder, dripfeed)
                if not pattern(expected).fullmatch(output):
                    found.append(f'{name}:{line + number}: {command.splitlines()[0]}\n--- shown\n' + '\n'.join(expected) +
                                 f'\n--- printed\n{output}---')
    return found


def main(arguments):
    found, count = [], 0
    for path in pages.pages(pages.root_of(arguments, 2)):
        text = path.read_text(encoding='utf-8')
        count += sum(language == 'console' for _, language, _ in pages.blocks(text))
        found += faults_of(path.name, text, arguments[1])
    if not count:
        found.append('no session at all')
    pages.finish('sessions', found)


if __name__ == '__main__':
    main(sys.argv)
