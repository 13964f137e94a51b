# Words that do not explain an identifier: in C++ none of its parts may be one of them, and in Python none of those in PYTHON. docs/style.md has the
# words to write instead.
import io
import re
import sys
import tokenize

import tree

WORDS = {'anew', 'ballast', 'behind', 'beside', 'keeper', 'nobody', 'somebody', 'tell', 'tells', 'told', 'unsaid', 'untold', 'said', 'way', 'ways'}
# What a program or a person said is a name in many tests; `tell()` is a method of files.
PYTHON = WORDS - {'said', 'tell'}
# Of 3964, where one side yields: the key of the profile and the action that it leads to.
IDIOMS = {'give_way', 'gives_way'}
FOLDERS = tree.TOPS + ('tests',)
NAME = re.compile(r'[A-Za-z_]\w*')
PART = re.compile(r'[A-Z]?[a-z]+|[A-Z]+(?![a-z])|\d+')


def faults(root):
    found = []
    for path in tree.files(root, FOLDERS, tree.CODE):
        code = tree.code_only(tree.read(root, path))
        names = ((match[0], match.start()) for match in NAME.finditer(code))
        faults_here = _of_names(names, WORDS)
        found += [f'{path}:{tree.line_of(code, at)}: {fault}' for at, fault in faults_here]
    for path in tree.files(root, ('tests', 'deploy'), ('.py',)):
        tokens = tokenize.generate_tokens(io.StringIO(tree.read(root, path)).readline)
        names = ((token.string, token.start[0]) for token in tokens if token.type == tokenize.NAME)
        found += [f'{path}:{line}: {fault}' for line, fault in _of_names(names, PYTHON)]
    return found


def _of_names(names, words):
    """Where each name with one of the words stands first, and what is wrong with it."""
    first = {}
    for name, at in names:
        first.setdefault(name, at)
    for name, at in first.items():
        word = next((part.lower() for part in PART.findall(name) if part.lower() in words), None)
        if word and name not in IDIOMS:
            yield at, f'{name}: the word "{word}" does not explain it'


if __name__ == '__main__':
    tree.finish('identifiers', faults(tree.root_of(sys.argv)))
