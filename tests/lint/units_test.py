# Shows that the lint of units counts through headers and refuses one file too many.
import unittest

import bad_tree
import units


class Units(bad_tree.BadTree):
    def test_beast_through_headers(self):
        self.write('server/http/stream.h', '#include <boost/beast/core.hpp>\n')
        self.write('server/http/session.h', '#include "server/http/stream.h"\n')
        for n in range(6):
            self.write(f'server/http/route{n}.cpp', '#include "server/http/session.h"\n')
        self.assert_clean(units.faults)
        self.write('server/http/route6.cpp', '#include "server/http/session.h"\n')
        self.assert_refused(units.faults, 'Beast is in 7 source files')

    def test_json_counts_without_its_forward_header(self):
        for n in range(30):
            self.write(f'server/json/light{n}.cpp', '#include <nlohmann/json_fwd.hpp>\n')
        self.assert_clean(units.faults)
        for n in range(30):
            self.write(f'server/json/heavy{n}.cpp', '#include <nlohmann/json_fwd.hpp>\n#include <nlohmann/json.hpp>\n')
        self.assert_clean(units.faults)
        self.write('tests/api/routes_test.cpp', '#include <nlohmann/json.hpp>\n')
        self.assert_refused(units.faults, 'JSON is in 31 source files')


if __name__ == '__main__':
    unittest.main()
