# How a dialect spells its cycles and its system variables stands in its own folder alone: everybody else asks for what a cycle does
# (ir/called_cycle.h) or what a variable holds (ir::SystemValue, ir::SystemUse).
import re
import sys

import tree

CYCLE = re.compile(r'"(?:CYCLE|HOLES|POCKET|SLOT|LONGHOLE)\d*\b')
# "$P_EP"; not the line of an archive that names a folder.
VARIABLE = re.compile(r'"\$(?!PATH)[A-Z]')
OWN = ('dialects/sinumerik/',)


def faults(root):
    found = []
    for path in tree.files(root, ('dialects', 'checks', 'protocol', 'server'), tree.CODE):
        if path.startswith(OWN):
            continue
        for line, literal in tree.strings(tree.without_comments(tree.read(root, path))):
            if CYCLE.match(literal):
                found.append(f'{path}:{line}: spells a cycle of a dialect: {literal}')
            if VARIABLE.match(literal):
                found.append(f'{path}:{line}: spells a system variable of a dialect: {literal}')
    return found


if __name__ == '__main__':
    tree.finish('spellings', faults(tree.root_of(sys.argv)))
