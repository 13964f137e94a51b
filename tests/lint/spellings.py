# How a dialect spells its cycles stands in its own folder alone: everybody else asks for what a cycle does (ir/called_cycle.h).
import re
import sys

import tree

CYCLE = re.compile(r'"(?:CYCLE|HOLES|POCKET|SLOT|LONGHOLE)\d*\b')
# The marks by which a text shows whose it is.
ALLOWED = ('dialects/sinumerik/', 'dialects/compile/dialect/dialect.cpp')


def faults(root):
    found = []
    for path in tree.files(root, ('dialects', 'checks', 'protocol', 'server'), tree.CODE):
        if path.startswith(ALLOWED):
            continue
        for line, literal in tree.strings(tree.without_comments(tree.read(root, path))):
            if CYCLE.match(literal):
                found.append(f'{path}:{line}: spells a cycle of a dialect: {literal}')
    return found


if __name__ == '__main__':
    tree.finish('spellings', faults(tree.root_of(sys.argv)))
