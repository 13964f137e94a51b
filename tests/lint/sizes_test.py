# Shows that long files and long functions are named, and that a long class or a table is not taken for a function.
import unittest

import bad_tree
import sizes

LONG = '  x();\n' * 61


class Sizes(bad_tree.BadTree):
    def test_a_long_file(self):
        self.write('store/blob.cpp', '//\n' * 401)
        self.assert_refused(sizes.warnings, 'store/blob.cpp: 401 lines')

    def test_a_long_function(self):
        self.write('store/blob.cpp', f'namespace a {{\nint Blob::grow(int n) const {{\n{LONG}}}\n}}  // namespace a\n')
        self.assert_refused(sizes.warnings, 'store/blob.cpp:2: Blob::grow has 63 lines')

    def test_a_long_method_inside_a_class(self):
        self.write('store/blob.h', f'class Blob {{\n void grow(struct Size s) {{\n{LONG}}}\n}};\n')
        self.assert_refused(sizes.warnings, 'grow has 63 lines')

    def test_what_is_no_function(self):
        rows = '  {"a", f(1)},\n' * 61
        self.write('store/table.cpp', f'const Row kRows[] = {{\n{rows}}};\n')
        self.write('store/blob.h', 'class Blob {\n' + ' int f() { return 1; }\n' * 61 + '};\n')
        self.assert_clean(sizes.warnings)


if __name__ == '__main__':
    unittest.main()
