# Shows that the lint of build files refuses a library or a unit test that links more than its row lists.
import unittest

import bad_tree
import build_files


class BuildFiles(bad_tree.BadTree):
    def setUp(self):
        super().setUp()
        self.copy_table('layers.txt')

    def test_what_its_row_lists(self):
        self.write('dialects/ir/CMakeLists.txt', 'dripfeed_library(ir DEPENDS text SYSTEM Threads::Threads)\n')
        self.write('checks/CMakeLists.txt', 'target_link_libraries(dripfeed_checks INTERFACE dripfeed_flags dripfeed_ir)\n')
        self.write('checks/timing/CMakeLists.txt', 'dripfeed_library(timing\n  DEPENDS text ir checks)\n')
        self.write('server/io/CMakeLists.txt', '# a note (feed)\ndripfeed_library(io DEPENDS app machine feed)\n')
        self.write('tests/CMakeLists.txt', 'dripfeed_unit_test(dialects/ir LINKS ir text)\n')
        self.assert_clean(build_files.faults)

    def test_more_than_its_row_lists(self):
        self.write('dialects/ir/CMakeLists.txt', 'dripfeed_library(ir DEPENDS text passes)\n')
        self.assert_refused(build_files.faults, 'dialects/ir links passes')

    def test_more_by_the_plain_command(self):
        self.write('protocol/feed/CMakeLists.txt', 'target_link_libraries(dripfeed_feed PUBLIC dripfeed_text)\n')
        self.assert_refused(build_files.faults, 'protocol/feed links text')

    def test_another_name(self):
        self.write('dialects/ir/CMakeLists.txt', 'dripfeed_library(model DEPENDS text)\n')
        self.assert_refused(build_files.faults, 'is not called as its folder')

    def test_a_folder_without_a_row(self):
        self.write('dialects/extra/CMakeLists.txt', 'dripfeed_library(extra DEPENDS text)\n')
        self.assert_refused(build_files.faults, 'has no row')

    def test_a_script_that_never_runs(self):
        self.write('tests/api/CMakeLists.txt', 'foreach(name calls link_test)\n')
        for name in ('calls', 'calls_test', 'link_test'):
            self.write(f'tests/api/{name}.py', 'if __name__ == "__main__":\n    main()\n')
        self.write('tests/api/client.py', 'def call():\n    pass\n')
        self.assert_clean(build_files.faults)
        self.write('tests/api/floor.py', "if __name__ == '__main__':\n    main()\n")
        self.assert_refused(build_files.faults, 'tests/api/floor.py: its CMakeLists.txt does not name it')

    def test_a_unit_test_that_links_more(self):
        self.write('tests/CMakeLists.txt', 'dripfeed_unit_test(dialects/ir LINKS ir text curves LABELS x)\n')
        self.assert_refused(build_files.faults, 'dialects/ir links curves')


if __name__ == '__main__':
    unittest.main()
