# For the lints' own tests: a small tree in a temporary folder, and a check that a lint finds in it what it should.
import contextlib
import io
import os
import shutil
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))


class BadTree(unittest.TestCase):
    def setUp(self):
        self.root = tempfile.mkdtemp(prefix='dripfeed_lint_')
        self.addCleanup(shutil.rmtree, self.root)

    def write(self, path, text):
        full = os.path.join(self.root, path)
        os.makedirs(os.path.dirname(full), exist_ok=True)
        with open(full, 'w', encoding='utf-8') as file:
            file.write(text)

    def copy_table(self, name):
        with open(os.path.join(HERE, name), encoding='utf-8') as file:
            self.write('tests/lint/' + name, file.read())

    def faults(self, lint, *arguments):
        with contextlib.redirect_stdout(io.StringIO()):
            return lint(self.root, *arguments)

    def assert_refused(self, lint, wanted, *arguments):
        found = self.faults(lint, *arguments)
        self.assertTrue(any(wanted in fault for fault in found), f'{wanted!r} is not among {found}')

    def assert_clean(self, lint, *arguments):
        self.assertEqual([], self.faults(lint, *arguments))
