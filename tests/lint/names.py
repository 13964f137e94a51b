# What a file may be called and how it begins: no name that says nothing, `#pragma once` in each header, a comment at the top of
# each source, and no path of a developer's machine in the tree.
import os
import re
import sys

import tree

WORDS = {'manager', 'managers', 'util', 'utils', 'utility', 'utilities', 'helper', 'helpers', 'process', 'processor'}
ENDINGS = re.compile(r'_(?:impl|more|part\d*)$')
SOURCES = {'.cpp': ('//', '/*'), '.h': ('//', '/*'), '.ts': ('//', '/*'), '.tsx': ('//', '/*'), '.js': ('//', '/*'),
           '.mjs': ('//', '/*'), '.css': ('/*',), '.py': ('#', '"""'), '.sh': ('#',)}
# Written in pieces, so that this file does not name them.
ELSEWHERE = re.compile(r'(?<!\w)/' + r'work/|\.\./' + 'shared')
BINARY = ('.png', '.ico', '.woff2', '.db', '.gz', '.zst', '.bin', '.lock', '.svg')


def faults(root):
    found = []
    for path in tree.files(root):
        found += [f'{path}: {fault}' for fault in _of_name(os.path.basename(path))]
        if not path.endswith(BINARY):
            found += [f'{path}{fault}' for fault in _of_text(path, tree.read(root, path))]
    return found


def _of_name(name):
    stem, ending = os.path.splitext(name)
    found = [f'the word {word} says nothing' for word in re.split(r'[_\-.]', stem.lower()) if word in WORDS]
    if ENDINGS.search(stem):
        found.append('a piece of another file: name what is in it')
    if ending == '.inc':
        found.append('an .inc file')
    return found


def _of_text(path, text):
    found = [f':{tree.line_of(text, m.start())}: names a place outside the repository: {m[0]}' for m in ELSEWHERE.finditer(text)]
    if path.endswith('.h') and not re.search(r'^#pragma once$', text, re.M):
        found.append(': a header without #pragma once')
    marks = SOURCES.get(os.path.splitext(path)[1])
    first = re.sub(r'^#![^\n]*\n', '', text).lstrip('\ufeff')
    if marks and not first.startswith(marks):
        found.append(': does not begin with a comment that says what it is')
    return found


if __name__ == '__main__':
    tree.finish('names', faults(tree.root_of(sys.argv)))
