# Asks nm for the undefined symbols of built archives and refuses those that reach what layers.txt fences off for their folder:
# evidence beyond the includes.   symbols.py ROOT TOP ARCHIVE...   where TOP is dialects, checks or protocol.
import fnmatch
import os
import re
import subprocess
import sys

import table
import tree

SKIPPED = 77


def faults(root, top, archives):
    kinds = table.load(root).fences[top]
    reaches = [(re.compile(fnmatch.translate(pattern)), kind) for pattern, kind in _patterns(root) if kind in kinds]
    found = []
    for archive in archives:
        if not os.path.exists(archive):
            found.append(f'{archive} is not built')
            continue
        for symbol in undefined(archive):
            kind = next((kind for pattern, kind in reaches if pattern.match(symbol)), None)
            if kind:
                found.append(f'{os.path.basename(archive)} reaches a {kind}: {symbol}')
    return found


def _patterns(root):
    for line in tree.read(root, 'tests/lint/symbols.txt').splitlines():
        kind, *patterns = line.split('#')[0].split() or [None]
        for pattern in patterns:
            # nm prints calls of C++ with their arguments; a C name stands alone.
            yield pattern.replace('[', '[[]'), kind


def undefined(archive):
    """The demangled undefined symbols of an object or archive, each once, without their versions."""
    out = subprocess.run(['nm', '-C', '--undefined-only', archive], check=True, capture_output=True, text=True).stdout
    return sorted({m[1].split('@')[0] for m in re.finditer(r'^\s+[Uwv] (.+)$', out, re.M)})


if __name__ == '__main__':
    if len(sys.argv) < 4:
        print('no archive is built yet: skipped')
        sys.exit(SKIPPED)
    tree.finish('symbols', faults(sys.argv[1], sys.argv[2], sys.argv[3:]))
