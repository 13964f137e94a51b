# Shows that the test of blocks refuses each kind of block that states what is not so, and one that no test looks at. The program is a
# script that answers --help and openapi; the trees are small ones.
import pathlib
import shutil
import stat
import tempfile
import unittest

import blocks

SCRIPT = '''#!/bin/sh
case "$*" in
  openapi) echo '{"paths": {"/api/v1/jobs": {}, "/api/v1/jobs/{id}": {}}}';;
  "serve --help") echo 'Usage: dripfeed serve'; echo '  --data TEXT  folder';;
  "user add --help") echo 'Usage: dripfeed user add'; echo '  --role TEXT  its role';;
  "user --help") echo 'Usage: dripfeed user';;
  check*--machine*) grep -q '"dialect"' "$4" || { echo 'dialect is missing' >&2; exit 2; };;
  *) exit 2;;
esac
'''


class Blocks(unittest.TestCase):
    def setUp(self):
        self.root = pathlib.Path(tempfile.mkdtemp(prefix='dripfeed_blocks_'))
        self.addCleanup(shutil.rmtree, self.root)
        self.write('dripfeed', SCRIPT).chmod(stat.S_IRWXU)
        self.write('deploy/run', 'case $1 in --smoke) ;; esac\n')
        self.write('deploy/families/ring.family', 'family ring\n  rapid x 0 mm  # first\n  cut x 1 mm\nend\n')
        self.write('dialects/family/lexer.cpp', 'constexpr auto kWords = {"param", "let"};\n')
        self.write('server/http/metrics.cpp', 'auto name = "dripfeed_jobs";\n')
        self.write('CMakePresets.json', '{"configurePresets": [{"name": "dev"}]}')
        self.binary = blocks.Binary(str(self.root / 'dripfeed'), self.root)

    def write(self, path, text):
        (self.root / path).parent.mkdir(parents=True, exist_ok=True)
        (self.root / path).write_text(text, encoding='utf-8')
        return self.root / path

    def faults(self, name, language, block):
        return list(blocks.of_block(name, language, block, self.binary))

    def assert_refused(self, wanted, *block):
        found = self.faults(*block)
        self.assertTrue(any(wanted in fault for fault in found), f'{wanted!r} is not among {found}')

    def test_commands(self):
        self.assertEqual([], self.faults('a.md', 'sh', 'dripfeed serve --data x  # a folder\ncat x && dripfeed user add olga --role viewer\n./deploy/run --smoke\ncmake --preset dev\n'))
        self.assert_refused('no command dripfeed feed', 'a.md', 'sh', 'dripfeed feed x\n')
        self.assert_refused('serve has no option --port', 'a.md', 'sh', 'dripfeed serve \\\n  --port 1\n')
        self.assert_refused('serve has no option --dat', 'a.md', 'sh', 'dripfeed serve --dat 1\n')
        self.assert_refused('user add has no option --group', 'a.md', 'sh', 'dripfeed user add --group a\n')
        self.assert_refused('there is no ./deploy/walk', 'a.md', 'sh', './deploy/walk\n')
        self.assert_refused('run has no option --fast', 'a.md', 'sh', './deploy/run --fast\n')
        self.assert_refused('no preset slow', 'a.md', 'sh', 'cmake --preset slow\n')
        self.assert_refused('brew is no command', 'a.md', 'sh', 'brew install x\n')

    def test_routes(self):
        self.assertEqual([], self.faults('a.md', 'sh', 'curl https://dnc.shop:8443/api/v1/jobs/7\n'))
        self.assert_refused('no route /api/v1/works', 'a.md', 'sh', 'curl http://127.0.0.1/api/v1/works\n')
        self.assert_refused('no route /api/v1/works', 'a.md', 'ts', 'await dnc.POST("/api/v1/works", {});\n')

    def test_documents(self):
        self.assertEqual([], self.faults('profiles.md', 'json', '{"dialect": "fanuc"}'))
        self.assert_refused('is not a profile: dialect is missing', 'profiles.md', 'json', '{"name": "a"}')
        self.assert_refused('is not JSON', 'profiles.md', 'json', '{')
        self.assert_refused('no test knows', 'other.md', 'json', '{}')
        self.assert_refused('no metric dripfeed_works', 'a.md', 'yaml', 'expr: rate(dripfeed_works_sum[5m]) / dripfeed_jobs_count\n')

    def test_families(self):
        self.assertEqual([], self.faults('a.md', 'family', 'rapid x 0 mm\n…\nend\n'))
        self.assert_refused('no family', 'a.md', 'family', 'cut x 1 mm\nrapid x 0 mm\n')
        self.assertEqual([], self.faults('a.md', 'ebnf', 'a = "param" | "let" | "(" ;'))
        self.assert_refused('no word const', 'a.md', 'ebnf', 'a = "const" ;')

    def test_figures(self):
        known = {'fleet.py'}
        page = '# M\n\n## Lines\n\n12 lines, by `tests/bench/fleet.py B --seconds 3`.\n\n## Words\n\nNo figure.\n'
        self.assertEqual([], list(blocks.figures_without_command('measurements.md', page, known)))
        self.assertEqual(1, len(list(blocks.figures_without_command('measurements.md', page + '## Store\n\n6 ms, by `hand`.\n', known))))
        table = '# D\n\n## Measured\n\n| what | figure | command |\n|---|---|---|\n| lines | 12 | `tests/bench/fleet.py` |\n'
        self.assertEqual([], list(blocks.figures_without_command('README.md', table, known)))
        self.assertEqual(1, len(list(blocks.figures_without_command('README.md', table + '| ms | 6 | by hand |\n', known))))

    def test_blocks_of_others(self):
        self.write('tests/e2e/neovim.py', 'the lines of docs/other.md\n')
        self.assert_refused('tests/e2e/neovim.py does not read this page', 'editor.md', 'lua', 'local x\n')
        self.assert_refused('no test looks at', 'a.md', 'rust', 'fn main() {}\n')
        self.assert_refused('no test looks at', 'a.md', '', 'something\n')

    def test_indented_blocks(self):
        self.assertEqual(['a.md:5: a block by indentation: write it between fences, with its language'],
                         list(blocks.indented('a.md', '# A\n\nText:\n\n    dripfeed check a.nc\n    dripfeed time a.nc\n')))
        self.assertEqual([], list(blocks.indented('a.md', '- one\n\n    of the list\n\nText\n    goes on\n\n```sh\n\n    dripfeed\n```\n')))


if __name__ == '__main__':
    unittest.main()
