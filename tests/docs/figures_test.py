# Shows that the test of figures refuses a figure without a command, and a command that is not there.
import pathlib
import shutil
import tempfile
import unittest

import figures

README = '# Name\n\n## Measured\n\n| what | figure | command |\n|---|---|---|\n| speed | 7 | {} |\n\n## More\n'
MEASUREMENTS = '# Measurements\n\n## Speed\n\n7 a second ({}).\n\n## Words\n\nNo figure.\n'


class Figures(unittest.TestCase):
    def setUp(self):
        self.root = pathlib.Path(tempfile.mkdtemp(prefix='dripfeed_figures_'))
        self.addCleanup(shutil.rmtree, self.root)
        for path in ('tests/bench/run.py', 'tests/bench/speed.cpp'):
            self.write(path, '')

    def write(self, path, text):
        (self.root / path).parent.mkdir(parents=True, exist_ok=True)
        (self.root / path).write_text(text, encoding='utf-8')

    def found(self, in_readme='`tests/bench/run.py`', in_docs='`tests/bench/run.py`'):
        self.write('README.md', README.format(in_readme))
        self.write('docs/measurements.md', MEASUREMENTS.format(in_docs))
        return figures.faults(self.root)

    def test_no_command(self):
        for bad in ('by hand', '', 'tests/bench/run.py', '`tests/bench/gone.py`', '`slow`', '`tests/bench`'):
            self.assertEqual(['README.md: no command for: speed'], self.found(in_readme=bad))
            self.assertEqual(['docs/measurements.md: no command for the figures of: Speed'], self.found(in_docs=bad))

    def test_no_table(self):
        self.write('docs/measurements.md', '# Measurements\n')
        self.write('README.md', '# Name\n')
        self.assertEqual(['README.md: no table under "Measured"'], figures.faults(self.root))

    def test_commands(self):
        for good in ('`tests/bench/run.py --seed 1`', '`speed`', '`build/dev/dripfeed time a.nc`', '`numeric_gouge_programs`', '`python3 ./tests/bench/run.py`'):
            self.assertEqual([], self.found(good, good))


if __name__ == '__main__':
    unittest.main()
