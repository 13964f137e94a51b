# Holds each folder's CMakeLists.txt against layers.txt: a library is called as its folder, and links what its row lists, nothing
# more; a unit test links its folder and that folder's row. And each test that is a script is named in its folder's CMakeLists.txt.
import os
import re
import sys

import table
import tree

CALL = re.compile(r'\b(dripfeed_library|dripfeed_unit_test|target_link_libraries)\s*\(([^()]*)\)')
KEYWORDS = {'ROOMS', 'DEPENDS', 'SYSTEM', 'LINKS', 'SERIAL', 'LABELS', 'TIMEOUT', 'PUBLIC', 'PRIVATE', 'INTERFACE'}


def faults(root):
    rules = table.load(root)
    found = []
    for path in tree.files(root, tree.TOPS + ('tests',), ('CMakeLists.txt',)):
        folder = os.path.dirname(path)
        text = re.sub(r'#[^\n]*', '', tree.read(root, path))
        for call in CALL.finditer(text):
            words = call[2].split()
            found += [f'{path}: {fault}' for fault in _of_call(rules, folder, call[1], words)]
    return found + _forgotten(root)


def _forgotten(root):
    """Scripts that run as tests, and that no CMakeLists.txt names: no one would notice that they fail. Benches are run by hand."""
    lists = {os.path.dirname(path): tree.read(root, path) for path in tree.files(root, ('tests',), ('CMakeLists.txt',))}
    found = []
    for path in tree.files(root, ('tests',), ('.py',)):
        folder, name = os.path.split(path)
        is_run = folder in lists and folder != 'tests/bench' and "__name__ == " in tree.read(root, path)
        stem = name.removesuffix('.py')
        if is_run and not re.search(rf"\b({stem}|{stem.removesuffix('_test')})\b", lists[folder]):
            found.append(f'{path}: its CMakeLists.txt does not name it, so it never runs')
    return found


def _of_call(rules, folder, function, words):
    if function == 'dripfeed_unit_test':
        return _linked(rules, words[0], _after(words, 'LINKS'), itself=True)
    if function == 'target_link_libraries':
        ours = [w.removeprefix('dripfeed_') for w in words[1:] if w.startswith('dripfeed_') and w != 'dripfeed_flags']
        return _linked(rules, folder, ours, itself=True) if folder.split('/')[0] in tree.TOPS else []
    wrong = [] if words[0] == os.path.basename(folder) else [f'the library {words[0]} is not called as its folder']
    return wrong + _linked(rules, folder, _after(words, 'DEPENDS'), itself=False)


def _after(words, keyword):
    """The words between a keyword and the next one."""
    if keyword not in words:
        return []
    rest = words[words.index(keyword) + 1:]
    ends = [i for i, word in enumerate(rest) if word in KEYWORDS]
    return rest[:ends[0]] if ends else rest


def _linked(rules, folder, names, itself):
    own = [row for row in rules.rows if row == folder or row.startswith(folder + '/')]
    if not own:
        return [f'{folder} has no row in layers.txt']
    # A library of several rows (a folder's own and those of its files) may link what any of them names.
    allowed = set().union(*(rules.rows[row][0] for row in own)) | (set(own) if itself else set())
    return [f'{folder} links {name}, which its row does not list' for name in names if not _is_listed(name, allowed)]


def _is_listed(name, allowed):
    """`timing` is listed as checks/timing; `checks` and `app` also by a part of them: checks/machine.h, server/app/ports."""
    return any(name in row.split('/') for row in allowed)


if __name__ == '__main__':
    tree.finish('build_files', faults(tree.root_of(sys.argv)))
