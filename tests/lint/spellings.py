# How a dialect spells its cycles and its system variables stands in its own folder alone: everybody else asks for what a cycle does
# (ir/called_cycle.h) or what a variable holds (ir::SystemValue, ir::SystemUse). Nor does it compare names of dialects: what differs is a
# fact in the control's table (ir::Semantics). The registry in dialects/compile/dialect knows them all.
import re
import sys

import tree

CYCLE = re.compile(r'"(?:CYCLE|HOLES|POCKET|SLOT|LONGHOLE)\d*\b')
# "$P_EP"; not the line of an archive that names a folder.
VARIABLE = re.compile(r'"\$(?!PATH)[A-Z]')
# "fanuc"; not a set of characters of that name.
DIALECTS = ('fanuc', 'haas', 'linuxcnc', 'mazak', 'mitsubishi', 'sinumerik')
NAME = re.compile(r'^"(?:fanuc|haas|linuxcnc|mazak|mitsubishi-m80|sinumerik-840d)"$')
NAMED = tuple(f'dialects/{one}/' for one in DIALECTS) + ('dialects/compile/dialect/',)
OWN = ('dialects/sinumerik/',)


def faults(root):
    found = []
    for path in tree.files(root, ('dialects', 'checks', 'protocol', 'server'), tree.CODE):
        literals = list(tree.strings(tree.without_comments(tree.read(root, path))))
        if path.startswith(('dialects/', 'checks/')) and not path.startswith(NAMED):
            found += [f'{path}:{line}: names a dialect: {one}' for line, one in literals if NAME.match(one)]
        if path.startswith(OWN):
            continue
        for line, literal in literals:
            if CYCLE.match(literal):
                found.append(f'{path}:{line}: spells a cycle of a dialect: {literal}')
            if VARIABLE.match(literal):
                found.append(f'{path}:{line}: spells a system variable of a dialect: {literal}')
    return found


if __name__ == '__main__':
    tree.finish('spellings', faults(tree.root_of(sys.argv)))
