# Shows that the lint of layers refuses each thing it is there to refuse, and nothing of a tree that keeps the rules.
import unittest

import bad_tree
import layers
import table


class Layers(bad_tree.BadTree):
    def setUp(self):
        super().setUp()
        self.copy_table('layers.txt')
        self.write('dialects/text/span.h', '#include <vector>\n#include <fmt/core.h>\n')
        self.write('dialects/ir/program.h', '#include "dialects/text/span.h"\n')
        self.write('dialects/fanuc/lexer.h', '#include "dialects/ir/program.h"\n')
        self.write('dialects/sinumerik/lexer.h', '')
        self.write('dialects/passes/fold.h', '')
        self.write('checks/machine.h', '#include "dialects/ir/program.h"\n')
        self.write('checks/timing/plan.h', '#include <thread>\n#include "checks/machine.h"\n')
        self.write('protocol/feed/feed.h', '#include <chrono>\n')
        self.write('server/app/jobs/job.h', '#include <mutex>\n#include "dialects/compile/dialect/dialect.h"\n')
        self.write('server/app/ports/link.h', '')
        self.write('server/io/serial.cpp', '#include <boost/asio.hpp>\n#include "server/app/ports/link.h"\n')
        self.write('dialects/compile/dialect/dialect.h', '#include "dialects/fanuc/lexer.h"\n')

    def refuse(self, path, text, wanted):
        self.write(path, text)
        self.assert_refused(layers.faults, wanted)

    def test_a_tree_that_keeps_the_rules_is_clean(self):
        self.assert_clean(layers.faults)

    def test_an_edge_that_is_not_listed(self):
        self.refuse('dialects/text/bad.h', '#include "dialects/ir/program.h"\n', 'dialects/text may not name dialects/ir')
        self.refuse('protocol/feed/bad.cpp', '#include "dialects/text/span.h"\n', 'protocol/feed may not name dialects/text')

    def test_a_part_of_a_folder_is_not_the_folder(self):
        self.refuse('server/io/bad.cpp', '#include "server/app/jobs/job.h"\n', 'server/io may not name server/app/jobs ')

    def test_a_file_with_a_row_of_its_own(self):
        self.refuse('checks/machine.h', '#include "checks/timing/plan.h"\n', 'checks/machine.h may not name checks/timing')

    def test_one_dialect_names_another(self):
        self.refuse('dialects/fanuc/bad.cpp', '#include "dialects/sinumerik/lexer.h"\n', 'may not name dialects/sinumerik')

    def test_what_is_closed_outside_dialects(self):
        self.refuse('server/app/bad.cpp', '#include "dialects/passes/fold.h"\n', 'server/app may not name dialects/passes')

    def test_a_cycle(self):
        self.refuse('dialects/text/bad.h', '#include "dialects/ir/program.h"\n', 'cycle between folders: dialects/ir dialects/text')

    def test_a_relative_include(self):
        for name in ('span.h', './span.h', '../ir/program.h', 'dialects/text/../ir/program.h', 'dialects/text/none.h'):
            self.refuse('dialects/text/bad.cpp', f'#include "{name}"\n', 'is no full path from the root')

    def test_an_own_header_in_angles(self):
        self.refuse('dialects/ir/bad.cpp', '#include <dialects/text/span.h>\n', 'write it in quotes')

    def test_an_include_by_macro(self):
        self.refuse('dialects/ir/bad.cpp', '#include HEADER\n', 'an include that is not a name')

    def test_third_party_headers(self):
        for path, header, group in (('dialects/ir/bad.cpp', 'nlohmann/json.hpp', 'json'), ('server/app/bad.cpp', 'boost/asio.hpp', 'asio'),
                                    ('server/json/bad.cpp', 'boost/beast/core.hpp', 'beast'), ('server/app/bad.cpp', 'sqlite3.h', 'sqlite'), ('store/sql/bad.cpp', 'libpq-fe.h', 'postgresql'),
                                    ('protocol/modbus/bad.cpp', 'modbus/modbus.h', 'modbus'), ('protocol/feed/bad.cpp', 'fmt/core.h', 'fmt'),
                                    ('server/app/bad.cpp', 'openssl/sha.h', 'openssl'), ('server/json/bad.cpp', 'CLI/CLI.hpp', 'cli11'),
                                    ('store/sqlite/bad.cpp', 'spdlog/spdlog.h', 'spdlog'), ('dialects/text/bad.cpp', 'unistd.h', 'posix')):
            self.refuse(path, f'#include <{header}>\n', f'may not use {group} ')

    def test_a_third_party_header_without_a_group(self):
        self.refuse('server/app/bad.cpp', '#include <libxml/tree.h>\n', 'is in no group')

    def test_a_folder_without_a_row(self):
        self.refuse('server/extra/bad.cpp', '', 'no row of layers.txt')
        self.refuse('dialects/bad.h', '', 'no row of layers.txt')

    def test_fenced_standard_headers(self):
        for header, kind in (('thread', 'thread'), ('mutex', 'thread'), ('fstream', 'file'), ('filesystem', 'file'), ('ctime', 'clock')):
            self.refuse('dialects/ir/bad.cpp', f'#include <{header}>\n', f'gives a {kind}')
            self.refuse('protocol/feed/bad.cpp', f'#include <{header}>\n', f'gives a {kind}')
        self.refuse('checks/timing/bad.cpp', '#include <fstream>\n', 'gives a file')

    def test_a_clock_in_a_template_of_a_header(self):
        self.refuse('protocol/feed/bad.h', 'auto now() { return std::chrono::steady_clock::now(); }\n', 'reads a clock')

    def test_a_unit_test_beyond_its_row(self):
        self.write('tests/unit/dialects/ir/program_test.cpp', '#include "dialects/text/span.h"\n#include "dialects/ir/program.h"\n')
        self.assert_clean(layers.faults)
        self.refuse('tests/unit/dialects/ir/bad_test.cpp', '#include "dialects/passes/fold.h"\n', 'may not name dialects/passes')

    def test_a_comment_is_no_include(self):
        self.write('dialects/text/fine.h', '// #include <thread>\n/*\n#include <mutex>\n*/\n')
        self.assert_clean(layers.faults)


class Rows(unittest.TestCase):
    def refuse(self, text, wanted):
        found = table.Table(text).faults()
        self.assertTrue(any(wanted in fault for fault in found), f'{wanted!r} is not among {found}')

    def test_a_table_that_allows_what_it_must_not(self):
        self.refuse('row a : b :\nrow b : a :\n', 'a cycle of rows: a b')
        self.refuse('row a : b :\n', 'names b, which has no row')
        self.refuse('row a : : none\n', 'the unknown group none')
        self.refuse('dialect x y\nrow x : y :\nrow y : :\n', 'the dialect x names the dialect y')
        self.refuse('open dialects/ir\nrow s : dialects/p :\nrow dialects/p : :\n', 'is not open outside dialects')

    def test_a_line_it_does_not_know(self):
        with self.assertRaises(ValueError):
            table.Table('rows a : b :\n')


if __name__ == '__main__':
    unittest.main()
