# Shows that the lint of phrases refuses them in docs, messages and the page's words, in comments and names of tests, and leaves code and names alone.
import unittest

import bad_tree
import phrases

GOOD = '{"a.b": "A person arms the job."}'


class Phrases(bad_tree.BadTree):
    def setUp(self):
        super().setUp()
        self.write('README.md', '# Name\n')
        self.write('web/src/i18n/en.json', GOOD)

    def test_docs(self):
        self.write('docs/a.md', 'one\nWhat differs is told.\n')
        self.assert_refused(phrases.faults, 'docs/a.md:2: is told')
        self.write('docs/a.md', 'Known on all ways, by a figure of holes.\n')
        self.assert_refused(phrases.faults, 'docs/a.md:1: ways')
        self.assert_refused(phrases.faults, 'figure of holes')

    def test_messages(self):
        for sentence in ('the feed behind it', 'a pole beside a code', 'a way out', 'nobody armed it', 'it goes to 5', 'held against the part', 'a move beyond all places'):
            self.write('dialects/text/a.cpp', f'// What it is.\nauto a = "{sentence}";\n')
            self.assert_refused(phrases.faults, 'dialects/text/a.cpp:2')

    def test_comments(self):
        self.write('server/app/a.h', '#pragma once\nint a();  // what it is worth\n// A fault of it is\n// told to a person.\n')
        self.assert_refused(phrases.faults, 'server/app/a.h:3: is told')
        self.write('server/app/a.h', '#pragma once\nint nobody = 0;  // `nobody` of the system, and a port behind a proxy\n')
        self.assert_clean(phrases.faults)

    def test_comments_of_sources(self):
        for comment in ('The block behind it.', 'Tells who has it.', 'The way to the part.', 'words beside it', 'a pole on all ways', 'It gives way.'):
            self.write('dialects/text/a.cpp', f'// {comment}\nint a = 0;\n')
            self.assert_refused(phrases.faults, 'dialects/text/a.cpp:1')
        for comment in ('A port behind a device server.', 'Cannot be told apart.'):
            self.write('dialects/text/a.cpp', f'// {comment}\nint a = 0;\n')
            self.assert_clean(phrases.faults)

    def test_names_of_tests(self):
        for name in ('AFaultIsSaid', 'HoldsNobodyUp', 'TellsWhoWaits', 'WhatStandsBehindIt'):
            self.write('tests/unit/a_test.cpp', f'TEST(Text, {name}) {{\n')
            self.assert_refused(phrases.faults, name)
        self.write('tests/unit/a_test.cpp', 'TEST_F(Told, ATellerOfWayside) {\n')
        self.assert_clean(phrases.faults)

    def test_comments_of_python(self):
        for text in ('# nobody is there\n', 'def a():\n    """One of them, and what\n    stands behind it."""\n'):
            self.write('tests/api/a.py', text)
            self.assert_refused(phrases.faults, 'tests/api/a.py')
        self.write('tests/api/a.py', '# `nobody` of the system, behind the real nginx\nprint("nobody")\n')
        self.assert_clean(phrases.faults)

    def test_dialogs_and_goldens(self):
        for path, text in (('tests/wire/feed/a.dialog', '== silence behind the end\n'), ('tests/golden/fanuc/a/b.nc', '%\nO0001(ORACLE: WORDS BESIDE M99)\n'),
                           ('tests/golden/sinumerik/a/b.mpf', '; oracle: known on all ways\n')):
            self.write(path, text)
            self.assert_refused(phrases.faults, path)
            self.write(path, 'DEF REAL WAY\nG1 X=WAY\n')
        self.assert_clean(phrases.faults)

    def test_comments_of_the_page(self):
        self.write('web/src/a.ts', 'export const a = 1; // drawn anew\n')
        self.assert_refused(phrases.faults, 'web/src/a.ts:1: anew')
        self.write('web/src/a.ts', "// The text beside its picture.\nexport const nobody = 'nobody';\n")
        self.assert_clean(phrases.faults)

    def test_page(self):
        self.write('web/src/i18n/en.json', '{"a.b": "Somebody must look."}')
        self.assert_refused(phrases.faults, 'en.json: a.b: Somebody')

    def test_good_texts(self):
        self.write('docs/a.md', 'A server behind a proxy. `nobody` is a user. Always known, in one place.\n')
        self.write('docs/style.md', 'not: somebody\n')
        self.write('dialects/text/a.cpp', '// What it is.\n#include "dialects/text/beside.h"\nauto a = "comparison-with-logic";\n')
        self.assert_clean(phrases.faults)


if __name__ == '__main__':
    unittest.main()
