# What every lint shares: which files there are, C++ text without its comments or strings, and how a lint reports and ends.
import os
import re
import sys

TOPS = ('dialects', 'checks', 'protocol', 'store', 'server')
CODE = ('.cpp', '.h')
SKIPPED = re.compile(r'^(\.git|build.*|node_modules|dist|data|__pycache__|\.cache)$')

# A comment, a raw string, a string or a character: whatever starts first wins, so that a quote inside a comment is not a string.
# The look-behind keeps the digit separator of 1'000 from opening a character.
TOKEN = re.compile(
    r'(?P<comment>//[^\n]*|/\*.*?\*/)'
    r'|(?P<raw>R"(?P<fence>[^()\\\s]{0,16})\(.*?\)(?P=fence)")'
    r'|(?P<string>"(?:\\.|[^"\\\n])*")'
    r"|(?P<char>(?<![0-9A-Za-z_])'(?:\\.|[^'\\\n])+')", re.S)


def files(root, tops=None, endings=None):
    """Paths relative to root, sorted; of the folders `tops` (all when None) and with one of `endings` (any when None)."""
    found = []
    for top in tops or ('.',):
        for folder, folders, names in os.walk(os.path.join(root, top)):
            folders[:] = [f for f in folders if not SKIPPED.match(f)]
            for name in names:
                if endings is None or name.endswith(endings):
                    found.append(os.path.relpath(os.path.join(folder, name), root))
    return sorted(found)


def read(root, path):
    with open(os.path.join(root, path), encoding='utf-8', errors='replace') as file:
        return file.read()


def _blank(text):
    return re.sub(r'[^\n]', ' ', text)


def without_comments(text):
    """The same text, comments turned to blanks, so that line numbers stay."""
    return TOKEN.sub(lambda m: _blank(m[0]) if m['comment'] else m[0], text)


def code_only(text):
    """The same text with comments, and the insides of strings and characters, turned to blanks."""
    return TOKEN.sub(lambda m: _blank(m[0]) if m['comment'] else m[0][0] + _blank(m[0][1:-1]) + m[0][-1], text)


def strings(text):
    """Pairs (line, literal) of every string in it."""
    for match in TOKEN.finditer(text):
        if match['raw'] or match['string']:
            yield line_of(text, match.start()), match[0]


def line_of(text, offset):
    return text.count('\n', 0, offset) + 1


def includes(text):
    """Pairs (line, what stands after #include)."""
    bare = without_comments(text)
    for match in re.finditer(r'^[ \t]*#[ \t]*include\b[ \t]*([^\n]*)', bare, re.M):
        yield line_of(bare, match.start()), match[1].strip()


def finish(name, faults):
    """Prints the faults and ends the program: 1 when there are any."""
    for fault in faults:
        print(fault)
    print(f'{name}: {len(faults)} fault(s)')
    sys.exit(1 if faults else 0)


def root_of(arguments):
    """The tree to look at: the first argument, or the one this file lies in."""
    return arguments[1] if len(arguments) > 1 else os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..'))
