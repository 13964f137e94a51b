# Words that do not explain an identifier: in C++ none of its parts may be one of them. docs/style.md has the words to write instead.
import re
import sys

import tree

WORDS = {'anew', 'ballast', 'beside', 'keeper', 'nobody', 'somebody', 'tell', 'tells', 'told', 'unsaid', 'untold', 'said'}
FOLDERS = tree.TOPS + ('tests',)
NAME = re.compile(r'[A-Za-z_]\w*')
PART = re.compile(r'[A-Z]?[a-z]+|[A-Z]+(?![a-z])|\d+')


def faults(root):
    found = []
    for path in tree.files(root, FOLDERS, tree.CODE):
        code = tree.code_only(tree.read(root, path))
        first = {}
        for match in NAME.finditer(code):
            first.setdefault(match[0], match.start())
        for name, at in first.items():
            word = next((part.lower() for part in PART.findall(name) if part.lower() in WORDS), None)
            if word:
                found.append(f'{path}:{tree.line_of(code, at)}: {name}: the word "{word}" does not explain it')
    return found


if __name__ == '__main__':
    tree.finish('identifiers', faults(tree.root_of(sys.argv)))
