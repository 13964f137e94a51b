# Counts the source files that take a costly header, directly or through headers of the project, and refuses too many: Beast
# costs 13 s a file, nlohmann-json 4 s.
import os
import re
import sys

import tree

# name, what it looks like, what of that does not count, how many source files may take it
LIMITS = (
    ('Beast', re.compile(r'<boost/beast\b'), None, 6),
    ('JSON', re.compile(r'<nlohmann/'), re.compile(r'<nlohmann/json_fwd\.hpp>'), 30),
)


def faults(root):
    includes = {path: [target for _, target in tree.includes(tree.read(root, path))]
                for path in tree.files(root, tree.TOPS + ('tests',), tree.CODE)}
    found = []
    for name, wanted, free, limit in LIMITS:
        takers = [path for path in includes if path.endswith('.cpp') and _takes(includes, path, wanted, free)]
        print(f'{name}: {len(takers)} of {limit} source files')
        if len(takers) > limit:
            found.append(f'{name} is in {len(takers)} source files, more than {limit}: {" ".join(takers)}')
    return found


def _takes(includes, path, wanted, free):
    seen, todo = set(), [path]
    while todo:
        file = todo.pop()
        for target in includes.get(file, ()):
            if wanted.match(target) and not (free and free.match(target)):
                return True
            name = target.strip('"')
            near = os.path.normpath(os.path.join(os.path.dirname(file), name))
            for other in (name, near):
                if other in includes and other not in seen:
                    seen.add(other)
                    todo.append(other)
    return False


if __name__ == '__main__':
    tree.finish('units', faults(tree.root_of(sys.argv)))
