# Every figure has its command: each row of the README's table under "Measured", and each section of docs/measurements.md, names in
# backticks a script or program of tests/bench that exists, a test, or a command of dripfeed.
import os
import re
import sys

CODE = re.compile(r'`([^`]+)`')
TESTS = re.compile(r'^(?:unit|numeric|wire|store|api|e2e|modbus|docs|fuzz)_\w+')


def faults(root):
    readme = _read(root, 'README.md')
    rows = [line for line in _section(readme, 'Measured').splitlines() if line.startswith('|')][2:]
    found = [] if rows else ['README.md: no table under "Measured"']
    found += [f'README.md: no command for: {row.split("|")[1].strip()}' for row in rows if not _has_command(root, row.split('|')[-2])]
    for title, text in _sections(_read(root, 'docs/measurements.md')):
        if re.search(r'\d', text) and not _has_command(root, text):
            found.append(f'docs/measurements.md: no command for the figures of: {title}')
    return found


def _read(root, name):
    with open(os.path.join(root, name), encoding='utf-8') as file:
        return file.read()


def _sections(markdown):
    parts = re.split(r'^## +(.+)$', markdown, flags=re.M)
    return list(zip(parts[1::2], parts[2::2]))


def _section(markdown, title):
    return dict(_sections(markdown)).get(title, '')


def _has_command(root, text):
    codes = CODE.findall(text) + re.findall(r'^```\w*\n(?:.|\n)*?^```', text, re.M)
    return any(_is_command(root, code) for code in codes)


def _is_command(root, code):
    return any(_names_command(root, word) for word in code.replace('```', ' ').split())


def _names_command(root, word):
    is_script = re.match(r'(?:\./)?(?:tests|deploy|web)/', word) and os.path.isfile(os.path.join(root, word))
    is_measure = re.fullmatch(r'\w+', word) and os.path.isfile(os.path.join(root, 'tests', 'bench', f'{word}.cpp'))
    return bool(TESTS.match(word) or os.path.basename(word) == 'dripfeed' or is_script or is_measure)


if __name__ == '__main__':
    FOUND = faults(sys.argv[-1])
    print(*FOUND, f'figures: {len(FOUND)} fault(s)', sep='\n')
    sys.exit(bool(FOUND))
