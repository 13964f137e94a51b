# Shows that the lint of sentences refuses a row that no code says, a row that is there twice, and a refusal without one.
import unittest

import bad_tree
import sentences

TABLE = '// Sentences.\nconstexpr std::array kRows = {\n    Row{"busy", "the line of {machine} is busy"},\n    Row{"long",\n        "a sentence that is "\n        "long"},\n};\n'
CODE = '// Lines.\nreturn fail(ErrorCode::refused, fmt::format("the line of {} is busy", name));\nreturn std::unexpected("a sentence "\n    "that is long");\n'


class Sentences(bad_tree.BadTree):
    def setUp(self):
        super().setUp()
        for name in sentences.WORDED:
            self.write(f'server/app/{name}', '// Nothing.\n')
        self.write('server/json/sentences.cpp', TABLE)
        self.write('server/app/lines/lines.cpp', CODE)

    def test_a_good_tree(self):
        self.assert_clean(sentences.faults)

    def test_a_row_that_no_code_says(self):
        self.write('server/json/sentences.cpp', TABLE.replace('is busy', 'is very busy'))
        self.assert_refused(sentences.faults, 'busy: no code says')

    def test_a_row_twice(self):
        self.write('server/json/sentences.cpp', TABLE.replace('"long"', '"busy"', 1))
        self.assert_refused(sentences.faults, 'busy has two rows')

    def test_a_refusal_without_a_row(self):
        self.write('server/app/jobs/jobs.cpp', '// Jobs.\nreturn fail(ErrorCode::refused, "the cat sits on the line");\n')
        self.assert_refused(sentences.faults, 'jobs/jobs.cpp: "the cat sits on the line" has no row')


if __name__ == '__main__':
    unittest.main()
