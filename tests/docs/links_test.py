# Shows that the test of links refuses each dead link, anchor and path, and a README that is too long.
import pathlib
import shutil
import tempfile
import unittest

import links


class Links(unittest.TestCase):
    def setUp(self):
        self.root = pathlib.Path(tempfile.mkdtemp(prefix='dripfeed_links_'))
        self.addCleanup(shutil.rmtree, self.root)
        self.write('README.md', '# Name\n\n[a](docs/a.md)\n')
        self.write('docs/a.md', '# A page: `code`, and more\n')

    def write(self, path, text):
        (self.root / path).parent.mkdir(parents=True, exist_ok=True)
        (self.root / path).write_text(text, encoding='utf-8')

    def assert_refused(self, wanted):
        found = links.faults(self.root)
        self.assertTrue(any(wanted in fault for fault in found), f'{wanted!r} is not among {found}')

    def test_dead_links(self):
        self.write('docs/a.md', 'one\n[b](b.md)\n')
        self.assert_refused('a.md:2: there is no b.md')
        self.write('docs/a.md', '[a](../README.md#nothing)\n')
        self.assert_refused('has no heading #nothing')
        self.write('docs/a.md', '![picture](no.png)\n')
        self.assert_refused('there is no no.png')

    def test_dead_paths(self):
        self.write('docs/a.md', 'See `dialects/text/none.cpp` or `tests/bench/none.py --seed 1`.\n')
        self.assert_refused('there is no file dialects/text/none.cpp')
        self.assert_refused('there is no file tests/bench/none.py')

    def test_readme(self):
        self.write('README.md', '[a](docs/a.md)\n' * 151)
        self.assert_refused('151 lines')
        self.write('README.md', '[a](docs/a.md)\n' + 'x' * 161 + '\n')
        self.assert_refused('README.md:2: 161 characters')
        self.write('docs/b.md', '')
        self.assert_refused('no link to docs/b.md')

    def test_good_pages(self):
        self.write('server/app/jobs/jobs.h', '')
        self.write('docs/a.md', '# A page: `code`, and more\n\n[x](#a-page-code-and-more) [y](../README.md#name) [z](https://a.b/c)\n'
                   '`server/app/jobs/jobs.h`, `server/app`, `text/plain`, `program/7`, `build/dev/dripfeed`, `GET /api/v1/jobs`\n'
                   '```sh\n[a](b.md)\n# No heading\n```\n')
        self.assertEqual([], links.faults(self.root))


if __name__ == '__main__':
    unittest.main()
