# Shows, on small objects that the project's compiler makes, that each kind of symbol is refused where it is fenced off.
import os
import subprocess
import unittest

import bad_tree
import symbols

CLEAN = '#include <vector>\n#include <memory>\n#include <charconv>\nint f(int n) { auto p = std::make_shared<int>(n); ' \
        'std::vector<int> v(9, *p); char b[9]; std::to_chars(b, b + 9, n); return v[8] + b[0]; }\n'
REACHES = {
    'clock': ('#include <chrono>\nauto f() { return std::chrono::steady_clock::now(); }\n',
              '#include <ctime>\nauto f() { return time(nullptr); }\n'),
    'socket': ('#include <sys/socket.h>\nint f() { return socket(1, 2, 3); }\n',),
    'file': ('#include <fstream>\nvoid f(int n) { std::ofstream("a") << n; }\n',
             '#include <fcntl.h>\nint f() { return open("a", 0); }\n',
             '#include <iostream>\nvoid f() { std::cerr << 1; }\n',
             '#include <cstdio>\nvoid f(int n) { std::printf("%d", n); }\n',
             '#include <fmt/core.h>\nvoid f(int n) { fmt::print("{}", n); }\n',
             '#include <filesystem>\nbool f() { return std::filesystem::exists("a"); }\n'),
    'thread': ('#include <thread>\nvoid g();\nvoid f() { std::thread(g).join(); }\n',
               '#include <mutex>\nstd::mutex m;\nvoid f() { std::scoped_lock l(m); }\n'),
}


class Symbols(bad_tree.BadTree):
    def setUp(self):
        super().setUp()
        self.copy_table('layers.txt')
        self.copy_table('symbols.txt')

    def object_of(self, code):
        self.write('x.cpp', code)
        out = os.path.join(self.root, 'x.o')
        subprocess.run([os.environ.get('CXX', 'g++'), '-std=c++20', '-O1', '-c', os.path.join(self.root, 'x.cpp'), '-o', out], check=True)
        return out

    def test_each_kind_is_refused(self):
        for kind, codes in REACHES.items():
            for code in codes:
                made = self.object_of(code)
                self.assert_refused(symbols.faults, f'x.o reaches a {kind}', 'protocol', [made])
                self.assert_refused(symbols.faults, f'x.o reaches a {kind}', 'dialects', [made])

    def test_checks_may_have_threads(self):
        self.assert_clean(symbols.faults, 'checks', [self.object_of(REACHES['thread'][0])])

    def test_plain_code_is_clean(self):
        self.assert_clean(symbols.faults, 'protocol', [self.object_of(CLEAN)])

    def test_an_archive_that_is_not_built(self):
        self.assert_refused(symbols.faults, 'is not built', 'protocol', ['none.a'])


if __name__ == '__main__':
    unittest.main()
