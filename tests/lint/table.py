# Reads layers.txt: the rows, the groups of headers, the fences. Knows nothing of source files.
import os


class Table:
    def __init__(self, text):
        self.rows = {}       # folder or file -> (set of rows it may name, set of third-party groups)
        self.headers = {}    # prefix -> group
        self.system = {}     # standard header -> kind
        self.fences = {}     # top folder -> set of kinds
        self.dialects = set()
        self.open = set()
        for line in _joined(text):
            self._take(line)

    def _take(self, line):
        word, _, rest = line.partition(' ')
        names = rest.split()
        if word == 'row':
            folder, allowed, groups = (part.split() for part in rest.split(':'))
            self.rows[folder[0]] = (set(allowed), set(groups))
        elif word in ('header', 'system'):
            (self.headers if word == 'header' else self.system).update({name: names[0] for name in names[1:]})
        elif word == 'fence':
            self.fences[names[0]] = set(names[1:])
        elif word == 'dialect':
            self.dialects.update(names)
        elif word == 'open':
            self.open.update(names)
        else:
            raise ValueError(f'layers.txt: {line}')

    def row_of(self, path):
        """The row that speaks of a file: the longest prefix. A file's row takes its source file, too. None when there is none."""
        stem = os.path.splitext(path)[0]
        best = None
        for row in self.rows:
            inside = path.startswith(row + '/') or os.path.splitext(row)[0] == stem
            if inside and (best is None or len(row) > len(best)):
                best = row
        return best

    def named_by_tests_of(self, row):
        """The folder, its rooms, and what any of them may name."""
        own = {r for r in self.rows if r == row or r.startswith(row + '/')}
        return own.union(*(self.rows[r][0] for r in own))

    def group_of(self, header):
        prefixes = [p for p in self.headers if header == p or (p.endswith('/') and header.startswith(p))]
        return self.headers[max(prefixes, key=len)] if prefixes else None

    def fence_of(self, path):
        return self.fences.get(path.split('/')[0], set())

    def faults(self):
        """What is wrong with the table itself."""
        found = []
        groups = set(self.headers.values())
        for row, (allowed, used) in self.rows.items():
            found += [f'layers.txt: {row} names {name}, which has no row' for name in sorted(allowed - set(self.rows))]
            found += [f'layers.txt: {row} names the unknown group {name}' for name in sorted(used - groups)]
            for name in sorted(allowed):
                if row in self.dialects and name in self.dialects:
                    found.append(f'layers.txt: the dialect {row} names the dialect {name}')
                if name.startswith('dialects/') and not row.startswith('dialects/') and name not in self.open:
                    found.append(f'layers.txt: {row} names {name}, which is not open outside dialects')
        return found + [f'layers.txt: a cycle of rows: {" ".join(c)}' for c in cycles({r: a for r, (a, _) in self.rows.items()})]


def _joined(text):
    """Lines without comments; a line that starts with a blank continues the one before."""
    lines = []
    for line in text.splitlines():
        line = line.split('#')[0].rstrip()
        if line.startswith(' ') and lines:
            lines[-1] += ' ' + line.strip()
        elif line:
            lines.append(line)
    return lines


def cycles(edges):
    """Groups of nodes that reach one another, for a dict node -> nodes. Empty when there is no cycle."""
    reach = {node: _reach(edges, node) for node in edges}
    found = {tuple(sorted(n for n in reach[node] if node in reach.get(n, ()))) for node in edges if node in reach[node]}
    return sorted(found)


def _reach(edges, start):
    seen, todo = set(), list(edges.get(start, ()))
    while todo:
        node = todo.pop()
        if node not in seen:
            seen.add(node)
            todo += edges.get(node, ())
    return seen


def load(root):
    with open(os.path.join(root, 'tests/lint/layers.txt'), encoding='utf-8') as file:
        return Table(file.read())
