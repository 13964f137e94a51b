# Shows that the lint of conversions refuses every conversion outside of dialects/text/number, takes an exception only with its reason, and
# leaves whole numbers alone.
import unittest

import bad_tree
import conversions


class Conversions(bad_tree.BadTree):
    def refuse(self, code, wanted, path='server/app/bad.cpp'):
        self.write(path, code)
        self.assert_refused(conversions.faults, wanted)

    def accept(self, code, path='server/app/good.cpp'):
        self.write(path, code)
        self.assert_clean(conversions.faults)

    def test_functions_of_the_c_library(self):
        for code in ('double d = std::strtod(s, &e);', 'd = stof(s);', 'd = std::stod(s);', 'd = atof(s);'):
            self.refuse(code, 'strtod')
        for code in ('std::printf("%f", d);', 'snprintf(b, n, "%g", d);', 'std::sscanf(s, "%lf", &d);'):
            self.refuse(code, 'printf')

    def test_locales(self):
        for code in ('setlocale(LC_ALL, "");', 'std::locale l;', 'out.imbue(l);', '#include <clocale>\n'):
            self.refuse(code, 'locale')

    def test_streams(self):
        self.refuse('out << std::setprecision(3);', 'stream format')
        self.refuse('out << std::fixed;', 'stream format')
        self.refuse('void f(double feed) { out << feed; }', 'streamed')
        self.refuse('struct S { double feed_mm_min = 0; }; void f(S s) { out << s.feed_mm_min << 1; }', 'streamed')
        self.refuse('void f() { double x; in >> x; }', 'streamed')
        self.refuse('out << 1.5;', 'streamed')

    def test_to_string(self):
        self.refuse('auto s = std::to_string(1.5);', 'to_string')
        self.refuse('void f(double x) { std::to_string(x); }', 'to_string')
        self.refuse('struct S { double x, y = 0; }; void f(S s) { std::to_string(s.y); }', 'to_string')
        self.refuse('void f(int n) { std::to_string(static_cast<double>(n)); }', 'to_string')

    def test_chars(self):
        self.refuse('void f() { double d; std::from_chars(a, b, d); }', 'from_chars')
        self.refuse('void f(float d) { std::to_chars(a, b, d); }', 'from_chars')
        self.refuse('std::to_chars(a, b, d, std::chars_format::fixed);', 'chars_format')

    def test_floating_formats_of_fmt(self):
        for text in ('{:.3f}', '{:g}', 'a {0:+.{}e} b', '{:>8.2f}', '{:.4}', '{name:.1F}', '{:L}'):
            self.refuse(f'fmt::format("{text}", d);', 'format')

    def test_whole_numbers_and_words_pass(self):
        self.accept('void f(int n, double x) { std::to_string(n); fmt::format("{:>8} {:04x} {:.3s}", n, n, s); out << n; }')
        self.accept('void f() { unsigned u; std::from_chars(a, b, u); std::to_chars(a, b, u, 16); auto v = u << 3; }')
        self.accept('void f(double x) { std::to_string(std::lround(x)); std::to_string(static_cast<int>(x)); }')
        self.accept('// printf("%f") and std::locale\nconst char* s = "strtod setlocale";')
        self.accept('std::vector<std::vector<double>> feeds; out << feeds.size();')
        self.accept('void f(double x) {}\nvoid g(int x) { std::to_string(x); }')

    def test_an_exception_wants_a_reason(self):
        self.write('server/cli/table.cpp', 'fmt::print("{:.1f}", d);')
        self.assert_refused(conversions.faults, 'format')
        self.write('tests/lint/conversions.txt', 'server/cli/table.cpp : format : read by people alone\n')
        self.assert_clean(conversions.faults)
        self.refuse('d = atof(s);', 'strtod', 'server/cli/table.cpp')
        self.write('tests/lint/conversions.txt', 'server/cli/table.cpp : format :\n')
        with self.assertRaises(ValueError):
            self.faults(conversions.faults)

    def test_the_place_where_it_belongs(self):
        self.copy_table('conversions.txt')
        self.accept('void f() { double d; std::from_chars(a, b, d); }', 'dialects/text/number.cpp')


if __name__ == '__main__':
    unittest.main()
