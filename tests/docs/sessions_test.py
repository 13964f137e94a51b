# Shows that the test of sessions refuses an output that is not the one shown, and takes the forms that pages use.
import unittest

import sessions

BINARY = '/bin/true'  # only its folder counts


def block(*lines):
    return '\n'.join(['```console', *lines, '```', ''])


class Sessions(unittest.TestCase):
    def assert_refused(self, text, wanted):
        found = sessions.faults_of('a.md', text, BINARY)
        self.assertTrue(any(wanted in fault for fault in found), f'{wanted!r} is not among {found}')

    def assert_clean(self, text):
        self.assertEqual([], sessions.faults_of('a.md', text, BINARY))

    def test_another_output(self):
        self.assert_refused(block('$ echo one', 'two'), 'a.md:2: echo one')
        self.assert_refused(block('$ echo one'), 'a.md:2')
        self.assert_refused(block('$ printf "a\\nb\\n"', 'a'), 'a.md:2')
        self.assert_refused(block('$ echo one', '…', 'two'), 'a.md:2')
        self.assert_refused(block('$ echo one two', 'two …'), 'a.md:2')
        self.assert_refused('\n\n' + block('$ true', '$ echo x', 'y'), 'a.md:5: echo x')

    def test_not_tested(self):
        self.assert_refused('```\n$ echo one\ntwo\n```\n', 'not marked console')
        self.assert_refused(block('one'), 'without a command')

    def test_good_sessions(self):
        self.assert_clean(block('$ echo one', 'one', '$ printf "a\\nb\\nc\\n"', '…', 'b', '…'))
        self.assert_clean(block('$ echo one two', 'one …', '$ echo x >&2', 'x', '$ true'))
        self.assert_clean(block('$ for i in 1 2; do', '>   echo $i', '> done > f', '$ cat f', '1', '2'))
        self.assert_clean(block('$ echo a > f') + block('$ cat f', 'a'))


if __name__ == '__main__':
    unittest.main()
