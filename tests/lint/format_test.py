# Shows that a source that is not formatted is refused.
import os
import shutil
import sys
import unittest

import bad_tree
import format as format_lint


class Format(bad_tree.BadTree):
    def setUp(self):
        super().setUp()
        shutil.copy(os.path.join(bad_tree.HERE, '..', '..', '.clang-format'), self.root)

    def test_formatted_and_not(self):
        self.write('store/blob.h', 'int grow(int n);\n')
        self.assert_clean(format_lint.faults)
        self.write('store/blob.cpp', 'int  grow( int n ){return n;}\n')
        self.assert_refused(format_lint.faults, 'store/blob.cpp:1')


if __name__ == '__main__':
    if not shutil.which(format_lint.PROGRAM):
        print(f'{format_lint.PROGRAM} is not installed: skipped')
        sys.exit(format_lint.SKIPPED)
    unittest.main()
