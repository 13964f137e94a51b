# What the tests of README and docs share: which pages there are, their code blocks, their text without code.
import pathlib
import re
import sys

FENCE = re.compile(r'^```(\w*)[^\n]*\n(.*?)^```[ ]*$', re.M | re.S)


def root_of(arguments, at):
    """The tree to look at: the argument at that place, or the one this file lies in."""
    return pathlib.Path(arguments[at]) if len(arguments) > at else pathlib.Path(__file__).resolve().parents[2]


def pages(root):
    return [root / 'README.md', *sorted((root / 'docs').glob('*.md'))]


def line_of(text, offset):
    return text.count('\n', 0, offset) + 1


def blocks(text):
    """Triples (line of the first line inside, language, content) of the fenced blocks."""
    for match in FENCE.finditer(text):
        yield line_of(text, match.start(2)), match[1], match[2]


def without_blocks(text):
    """The same text, fenced blocks turned to empty lines, so that line numbers stay."""
    return FENCE.sub(lambda m: re.sub(r'[^\n]', '', m[0]), text)


def finish(name, faults):
    for fault in faults:
        print(fault)
    print(f'{name}: {len(faults)} fault(s)')
    sys.exit(1 if faults else 0)
