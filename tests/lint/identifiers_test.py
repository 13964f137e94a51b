# Shows that the lint of identifiers refuses each of its words as a part of a name, and no other word.
import unittest

import bad_tree
import identifiers


class Identifiers(bad_tree.BadTree):
    def test_words(self):
        for word in identifiers.WORDS:
            for name in (word, f'{word}_', f'is_{word}_by_table', f'k{word.title()}', f'Ends{word.title()}Early'):
                self.write('dialects/text/number.h', f'// A number.\n\nint {name} = 0;\n')
                self.assert_refused(identifiers.faults, f'dialects/text/number.h:3: {name}: the word "{word}"')

    def test_words_of_python(self):
        for word in identifiers.PYTHON:
            self.write('tests/api/a.py', f'# What it is.\n\ndef is_{word}_by_table():\n    pass\n')
            self.assert_refused(identifiers.faults, f'tests/api/a.py:3: is_{word}_by_table: the word "{word}"')

    def test_idioms(self):
        self.write('protocol/packet/state.h', '// States.\nint give_way = 0;\nbool gives_way = false;\nint away = 0, always = 1, midway = 2;\n')
        self.write('tests/api/a.py', "# On its way.\nalways = 'a way'\n")
        self.assert_clean(identifiers.faults)
        self.write('protocol/packet/state.h', '// States.\nint gives_way_to = 0;\n')
        self.assert_refused(identifiers.faults, 'state.h:2: gives_way_to')

    def test_other_words(self):
        self.write('dialects/text/number.h', '// It is told beside.\nint besides = 0;\nauto text = "nobody said";\nint intellect = 0;\n')
        self.write('web/src/said.ts', 'const said = 0;\n')
        self.assert_clean(identifiers.faults)


if __name__ == '__main__':
    unittest.main()
