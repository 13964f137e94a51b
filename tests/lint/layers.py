# Reads every #include of the product and refuses what layers.txt does not list: an edge, a cycle between folders, a relative
# include, a third-party header, a folder without a row, and in the fenced folders whatever gives a clock, socket, file or thread.
import os
import re
import sys

import table
import tree

CLOCK = re.compile(r'\b\w*_clock\s*::\s*now\b')


def faults(root):
    rules = table.load(root)
    found = rules.faults()
    edges = {}
    for path in tree.files(root, tree.TOPS, tree.CODE):
        row = rules.row_of(path)
        if row is None:
            found.append(f'{path}: no row of layers.txt speaks of this file')
            continue
        found += _of_file(root, rules, path, row, edges)
    found += _of_unit_tests(root, rules)
    return found + [f'cycle between folders: {" ".join(c)}' for c in table.cycles(edges)]


def _of_file(root, rules, path, row, edges):
    text = tree.read(root, path)
    found = []
    for line, target in tree.includes(text):
        fault = _of_include(root, rules, path, row, target, edges)
        if fault:
            found.append(f'{path}:{line}: {fault}')
    if 'clock' in rules.fence_of(path):
        code = tree.code_only(text)
        found += [f'{path}:{tree.line_of(code, m.start())}: reads a clock: {m[0]}' for m in CLOCK.finditer(code)]
    return found


def _of_include(root, rules, path, row, target, edges):
    if re.fullmatch(r'"[^"]+"', target):
        return _of_own(root, rules, row, target[1:-1], edges)
    if re.fullmatch(r'<[^>]+>', target):
        return _of_foreign(root, rules, path, row, target[1:-1])
    return f'an include that is not a name: {target}'


def _of_own(root, rules, row, name, edges):
    if '..' in name.split('/') or name.startswith('./') or not os.path.isfile(os.path.join(root, name)):
        return f'"{name}" is no full path from the root'
    other = rules.row_of(name)
    if other is None:
        return f'"{name}" belongs to no row of layers.txt'
    if other == row:
        return None
    edges.setdefault(row, set()).add(other)
    return None if other in rules.rows[row][0] else f'{row} may not name {other} ("{name}")'


def _of_foreign(root, rules, path, row, name):
    if os.path.isfile(os.path.join(root, name)):
        return f'<{name}> is a header of this project: write it in quotes'
    kind = rules.system.get(name)
    if kind:
        return f'<{name}> gives a {kind}, which {path.split("/")[0]} may not have' if kind in rules.fence_of(path) else None
    group = rules.group_of(name)
    if group is None:
        standard = re.fullmatch(r'\w+', name)
        return None if standard else f'<{name}> is in no group of layers.txt'
    return None if group in rules.rows[row][1] else f'{row} may not use {group} (<{name}>)'


def _of_unit_tests(root, rules):
    """A unit test names its own folder with its rooms and what they may name, nothing else of the product."""
    found = []
    for path in tree.files(root, ('tests/unit',), tree.CODE):
        row = rules.row_of(path.removeprefix('tests/unit/'))
        for line, target in tree.includes(tree.read(root, path)):
            name = target.strip('"')
            if row is None or not target.startswith('"') or name.split('/')[0] not in tree.TOPS:
                continue
            other = rules.row_of(name)
            if other not in rules.named_by_tests_of(row):
                found.append(f'{path}:{line}: a unit test of {row} may not name {other} ("{name}")')
    return found


if __name__ == '__main__':
    tree.finish('layers', faults(tree.root_of(sys.argv)))
