# Shows that the lint of names refuses each name and each beginning that it is there to refuse.
import unittest

import bad_tree
import names

GOOD = '// What it is.\n#pragma once\n'


class Names(bad_tree.BadTree):
    def test_names_that_say_nothing(self):
        for name in ('job_manager.h', 'utils.h', 'string_util.h', 'test_helper.h', 'process.h', 'post-process.h'):
            self.write(f'server/app/{name}', GOOD)
            self.assert_refused(names.faults, f'{name}: the word')

    def test_pieces_of_files(self):
        for name in ('lexer_impl.h', 'lexer_more.h', 'lexer_part2.h'):
            self.write(f'dialects/fanuc/{name}', GOOD)
            self.assert_refused(names.faults, f'{name}: a piece of another file')
        self.write('dialects/fanuc/codes.inc', '')
        self.assert_refused(names.faults, 'an .inc file')

    def test_beginnings(self):
        self.write('store/blob.h', '// What it is.\n')
        self.assert_refused(names.faults, 'store/blob.h: a header without #pragma once')
        for name in ('store/blob.cpp', 'web/src/main.ts', 'deploy/try.sh', 'tests/lint/try.py'):
            self.write(name, '#!/bin/sh\nx = 1\n' if name.endswith('.sh') else 'x = 1\n')
            self.assert_refused(names.faults, f'{name}: does not begin with a comment')

    def test_places_outside_the_repository(self):
        self.write('README.md', 'See ../' + 'shared/DESIGN.md.\n')
        self.assert_refused(names.faults, 'README.md:1: names a place outside')
        self.write('deploy/a.json', '\n{"a": "/' + 'work/main"}\n')
        self.assert_refused(names.faults, 'deploy/a.json:2: names a place outside')

    def test_good_files(self):
        self.write('dialects/text/number.h', GOOD)
        self.write('deploy/start.sh', '#!/bin/sh\n# Starts it.\n')
        self.write('server/app/processing_order.h', GOOD)
        self.write('build/utils.h', '')
        self.write('web/node_modules/x/util.js', '')
        self.assert_clean(names.faults)


if __name__ == '__main__':
    unittest.main()
