# Every source is as clang-format-19 writes it. Skipped, and says so, where that version is not installed.
import os
import shutil
import subprocess
import sys

import tree

SKIPPED = 77
PROGRAM = 'clang-format-19'


def faults(root):
    paths = tree.files(root, tree.TOPS + ('tests',), tree.CODE)
    if not paths:
        return []
    run = subprocess.run([PROGRAM, '--dry-run', '-Werror', *paths], cwd=root, capture_output=True, text=True)
    lines = [line for line in run.stderr.splitlines() if ': error: ' in line]
    return lines if run.returncode == 0 or lines else [run.stderr]


if __name__ == '__main__':
    if not shutil.which(PROGRAM):
        print(f'{PROGRAM} is not installed: skipped')
        sys.exit(SKIPPED)
    tree.finish('format', faults(tree.root_of(sys.argv)))
