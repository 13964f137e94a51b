# Shows that the test of the families' pictures sees another toolpath, a picture that is not there, and a page without it.
import os
import pathlib
import stat
import tempfile
import unittest

import families

FAMILY = 'family square "A square"\nmachine mill\n'
TRACE = '1 rapid X0.0000 Y0.0000 Z0.0000\n2 linear X{} Y0.0000 Z0.0000 F100.0000/min\n3 arc-ccw X0.0000 Y9.0000 Z0.0000 G17 I-9.0000 J0.0000\n'


class Families(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for name in ('deploy/families', 'docs/pictures'):
            (self.root / name).mkdir(parents=True)
        (self.root / 'deploy/families/square.family').write_text(FAMILY)
        (self.root / 'docs/families.md').write_text('![](pictures/family-square.svg)\n')

    def dripfeed(self, end):
        """A program that renders nothing and whose run has that trace."""
        path = self.root / 'dripfeed'
        path.write_text('#!/bin/sh\nif [ "$1" = run ]; then printf \'' + TRACE.format(end).replace('\n', '\\n') + '\'; fi\n')
        os.chmod(path, stat.S_IRWXU)
        return path

    def written(self, end):
        os.environ['UPDATE_DOCS'] = '1'
        self.addCleanup(os.environ.pop, 'UPDATE_DOCS', None)
        self.assertEqual([], families.faults(self.dripfeed(end), self.root))
        del os.environ['UPDATE_DOCS']

    def test_another_path_is_seen(self):
        self.written('9.0000')
        self.assertEqual([], families.faults(self.dripfeed('9.0000'), self.root))
        self.assertIn('is not current', families.faults(self.dripfeed('4.0000'), self.root)[0])

    def test_a_page_without_it_is_seen(self):
        self.written('9.0000')
        (self.root / 'docs/families.md').write_text('# Nothing\n')
        self.assertIn('does not show square', families.faults(self.dripfeed('9.0000'), self.root)[0])

    def test_an_arc_keeps_its_radius(self):
        pieces = families.chords([('rapid', {'X': 9.0, 'Y': 0.0}), ('arc-ccw', {'X': 0.0, 'Y': 9.0, 'I': -9.0, 'J': 0.0})])
        self.assertTrue(all(abs((x * x + y * y) ** 0.5 - 9) < 1e-9 for x, y, *_ in pieces[-1][1]))


if __name__ == '__main__':
    unittest.main()
