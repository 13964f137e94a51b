# Shows that the test of commands refuses one that fails, prints something else or has no row, and what does not end well. The program is a script.
import pathlib
import re
import shutil
import stat
import tempfile
import time
import unittest

import commands
from commands import NotRun, Run
from computer import Computer

SCRIPT = '''#!/bin/sh
case "$1" in
  serve) trap 'exit 3' TERM; echo '[log] begins'; echo 'dripfeed is at http://127.0.0.1:1234/ '"$*"; while :; do sleep 0.05; done;;
  *) echo "$*"; read -r line && echo "read $line";;
esac
exit 0
'''


class Commands(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix='dripfeed_commands_'))
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / 'bin').mkdir()
        (self.folder / 'bin/dripfeed').write_text(SCRIPT, encoding='utf-8')
        (self.folder / 'bin/dripfeed').chmod(stat.S_IRWXU)
        self.computer = Computer(self.folder / 'root', self.folder / 'bin/dripfeed')
        self.addCleanup(self.computer.stop)
        self.reasons = []

    def faults(self, text, *rows):
        return list(commands.faults_of('a.md', f'# A page\n\n```sh\n{text}\n```\n', rows, self.computer, self.reasons.append))

    def test_what_it_prints(self):
        self.assertEqual([], self.faults('dripfeed check a  # a text', Run('dripfeed check', r'check a\n')))
        self.assertEqual([], self.faults('dripfeed user', Run('dripfeed user', r'user\nread secret\n', given='secret\n')))
        for shows in (r'check b\n', '', r'check'):
            self.assertIn('but not', self.faults('dripfeed check a', Run('dripfeed check', shows))[0])

    def test_what_fails(self):
        self.assertIn('ended with 1', self.faults('false', Run('false'))[0])
        self.assertIn('ended with 1', self.faults('cat no-file', Run('cat', r'(?s).*'))[0])

        def wrong(computer):
            raise AssertionError('another answer')
        self.assertIn('AssertionError: another answer', self.faults('true', Run('true', after=wrong))[0])

    def test_rows(self):
        self.assertIn('1 command lines and 0 rows', self.faults('true')[0])
        self.assertIn('1 command lines and 2 rows', self.faults('true', Run('true'), Run('false'))[0])
        self.assertIn('is not what the row has', self.faults('true', Run('false'))[0])
        self.assertEqual([], self.faults('true\nfalse', Run('true'), NotRun('false', 'it fails')))
        self.assertEqual(['not run: a.md:4: false: it fails'], self.reasons)

    def test_places_and_addresses(self):
        self.computer.server, self.computer.database = 'http://127.0.0.1:5', '/run/pg'
        root = self.folder / 'root'
        for shown, wanted in (('cat /etc/dripfeed/a > /mnt/b', f'cat {root}/etc/dripfeed/a > {root}/mnt/b'), ('--link pty:/tmp/a', f'--link pty:{root}/tmp/a'),
                              ('curl https://dnc.shop:8443/api/v1 a/tmp/b', 'curl http://127.0.0.1:5/api/v1 a/tmp/b'),
                              ('--store postgresql://dripfeed@db.shop/dripfeed', '--store postgresql://dripfeed@/dripfeed?host=/run/pg')):
            self.assertEqual(wanted, self.computer.adapted(shown))

    def test_what_goes_on_running(self):
        shows = r'dripfeed is at http://127\.0\.0\.1:1234/ serve --data data --listen 127\.0\.0\.1:0\n'
        self.assertEqual([], self.faults('dripfeed serve --data data', Run('dripfeed serve', shows)))
        self.assertEqual('http://127.0.0.1:1234', self.computer.server)
        begun = time.monotonic()
        faults = self.computer.stop()
        self.assertTrue(time.monotonic() - begun < 10 and re.fullmatch(r'dripfeed serve .* ended with 3', faults[0]), faults)


if __name__ == '__main__':
    unittest.main()
