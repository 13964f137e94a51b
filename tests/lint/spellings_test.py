# Shows that the lint of spellings refuses names of cycles and system variables outside their dialect.
import unittest

import bad_tree
import spellings


class Spellings(bad_tree.BadTree):
    def test_a_name_in_its_own_folder(self):
        self.write('dialects/sinumerik/tables/more.cpp', 'auto name = "CYCLE81";\n')
        self.assert_clean(spellings.faults)

    def test_a_name_elsewhere(self):
        self.write('dialects/passes/more.cpp', 'bool drills = name == "CYCLE81";\n')
        self.assert_refused(spellings.faults, '"CYCLE81"')

    def test_a_system_variable(self):
        self.write('dialects/sinumerik/tables/more.cpp', 'auto name = "$P_UIFR";\n')
        self.write('dialects/passes/more.cpp', 'auto folder = "$PATH=";\n')
        self.assert_clean(spellings.faults)
        self.write('dialects/interpreter/more.cpp', 'bool is_frame = name == "$P_UIFR";\n')
        self.assert_refused(spellings.faults, '"$P_UIFR"')

    def test_a_name_of_a_dialect(self):
        self.write('dialects/mazak/more.cpp', 'auto name = "mazak";\n')
        self.write('dialects/compile/dialect/more.cpp', 'auto name = "mazak";\n')
        self.write('server/machine/more.cpp', 'auto name = "mazak";\n')
        self.assert_clean(spellings.faults)
        self.write('dialects/passes/more.cpp', 'bool is_it = control.dialect == "mazak";\n')
        self.assert_refused(spellings.faults, 'names a dialect: "mazak"')

    def test_a_comment_and_a_sentence(self):
        self.write('dialects/passes/more.cpp', '// as "CYCLE81"\nauto text = "a cycle";\n')
        self.assert_clean(spellings.faults)


if __name__ == '__main__':
    unittest.main()
