# Shows that the test of documents refuses one that its program does not take, and one that it does not know. The programs are scripts.
import pathlib
import shutil
import stat
import tempfile
import unittest

import documents

SCRIPT = '''#!/bin/sh
grep -q '"port"' "$3" && { echo 'no option has the name port' >&2; exit 2; }
grep -q "$PWD/" "$3" || { echo 'the folder is not its own' >&2; exit 2; }
'''


def block(language, text):
    return f'# A page\n\n```{language}\n{text}\n```\n'


class Documents(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix='dripfeed_documents_'))
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / 'dripfeed').write_text(SCRIPT, encoding='utf-8')
        (self.folder / 'dripfeed').chmod(stat.S_IRWXU)

    def faults(self, text, *readers):
        return list(documents.faults_of('a.md', text, str(self.folder / 'dripfeed'), readers))

    def test_options(self):
        self.assertEqual([], self.faults(block('json', '{"data": "/var/lib/dripfeed/data"}'), documents.options_faults))
        self.assertEqual(['a.md:4: dripfeed serve --config refuses it: no option has the name port'],
                         self.faults(block('json', '{"data": "x", "port": 1}'), documents.options_faults))

    def test_questions(self):
        self.assertEqual(['a.md:4: is not the question that tests/api/hook.py compares'], self.faults(block('json', '{"type": "job.done"}'), documents.question_faults))

    def test_editors(self):
        settings = '{"glspc.server.command": "other", "glspc.server.commandArguments": ["lsp"]}'
        self.assertEqual(["a.md:4: starts other ['lsp']"], self.faults(block('json', settings), documents.editor_faults))

    def test_scripts(self):
        self.assertEqual([], self.faults(block('js', 'import { a } from "b";\na(1);')))
        self.assertTrue('a.md:4: node refuses it' in self.faults(block('js', 'const a = (;'))[0])

    def test_what_is_not_known(self):
        self.assertIn('does not know', self.faults(block('json', '{}'))[0])
        self.assertIn('JSONDecodeError', self.faults(block('json', '{'), documents.question_faults)[0])
        self.assertEqual(['a.md: 1 reader(s) without a block'], self.faults('# A page\n', documents.event_faults))


if __name__ == '__main__':
    unittest.main()
