# Phrases that must not return to what people read: README, docs, the page's English, the messages of the program (its string
# literals), and all comments: C++, Python with its docstrings, TypeScript, the names of dialogs and what goldens show. docs/style.md has
# what to write instead.
import io
import json
import re
import sys
import tokenize

import tree

# Everywhere. What stands for two things, or for none, in the English of the trade.
EVERYWHERE = (
    r'ways?', r'(?:is|are|was|were) (?:told|said)', r'figures? of holes', r'does not go', r'nobody', r'somebody', r'anybody',
    r'anew', r'wak(?:es?|ing) up', r'places? of the machine', r'the length of the tool',
)
# In messages also words that docs use for places: a file beside another, a server behind a proxy.
IN_MESSAGES = (r'behind', r'beside', r'as it is', r'as it was', r'goes', r'tells?', r'says nothing', r'no more (?:armed|in)', r'(?:held|holds?) against',
               r'beyond all places', r'what no run shows', r'one of both', r'otherwise than', r'(?:counts?|ends?|named) otherwise')

# In comments also words that stand for "after", "in the same block as" and "reports".
IN_COMMENTS = (r'behind', r'beside', r'tells?', r'told', r'(?:held|holds?) against')
# The page has places: a text beside a picture.
IN_PAGE_COMMENTS = tuple(one for one in IN_COMMENTS if one != 'beside')
PAGE = ('.ts', '.tsx', '.mjs')
# What these words are right for: a port that a device server stands before, two things that are alike.
RIGHT = re.compile(r'behind\s+(?:an?|the|one|this|that)?\s*(?:device|proxy|telnet|RFC 2217|gateway|address|others|real nginx)|told\s+apart|look-behind', re.I)
# Test names, by the words that they are made of.
IN_TEST_NAMES = re.compile(r'(?:Nobody|Somebody|Anybody|Anew|Behind|Beside|Tells?|Told|Ways?|(?:Is|Are|And)Said)(?![a-z])')
TEST_NAME = re.compile(r'\bTEST(?:_F|_P)?\(\w+,\s*(\w+)\)')

# A dialog's comment and the name of a scene; what a golden is there to show.
OF_TESTS = re.compile(r'(?:#|==) |.*\boracle:', re.I)

# Literals that are names; a schema that is in use.
LITERAL = re.compile(r'"(?:anybody|[a-z]+(?:-[a-z]+)+)"')  # a role, the name of a diagnostic
FILES = re.compile(r'^store/sqlite/schema')
COMMENTS_LATER = re.compile(r'^store/sqlite/schema')
NOT_SWEPT = {'docs/style.md'}  # it names them
NAMES_THEM = {'tests/lint/phrases.py', 'tests/lint/phrases_test.py'}


def pattern(phrases):
    return re.compile(r'\b(?:' + '|'.join(phrases).replace(' ', r'\s+') + r')\b', re.I)


def faults(root):
    docs, messages = pattern(EVERYWHERE), pattern(EVERYWHERE + IN_MESSAGES)
    found = []
    for path in tree.files(root, ('docs',), ('.md',)) + ['README.md']:
        if path not in NOT_SWEPT:
            found += _in_text(path, tree.read(root, path), docs)
    for path in tree.files(root, tree.TOPS, tree.CODE):
        if not FILES.match(path):
            found += _in_literals(path, tree.read(root, path), messages)
    comments = pattern(EVERYWHERE + IN_COMMENTS)
    for path in tree.files(root, tree.TOPS + ('tests',), tree.CODE):
        if not COMMENTS_LATER.match(path):
            found += _in_comments(path, tree.read(root, path), comments)
            found += _in_test_names(path, tree.read(root, path))
    for path in tree.files(root, ('tests', 'deploy'), ('.py',)):
        if path not in NAMES_THEM:
            found += _in_python(path, tree.read(root, path), comments)
    for path in tree.files(root, ('tests/wire', 'tests/golden')):
        lines = ((n, line) for n, line in enumerate(tree.read(root, path).splitlines(), 1) if OF_TESTS.match(line))
        found += [f'{path}:{n}: {m[0]} in a comment' for n, line in lines for m in comments.finditer(RIGHT.sub(' ', line))]
    for path in tree.files(root, ('web', 'tests'), PAGE):
        found += _in_comments(path, tree.read(root, path), pattern(EVERYWHERE + IN_PAGE_COMMENTS))
    for key, value in json.loads(tree.read(root, 'web/src/i18n/en.json')).items():
        found += [f'web/src/i18n/en.json: {key}: {m[0]}' for m in messages.finditer(value)]
    return found


def _in_text(path, text, wanted):
    text = re.sub(r'`[^`\n]*`', lambda m: ' ' * len(m[0]), text)
    return [f'{path}:{tree.line_of(text, m.start())}: {m[0]}' for m in wanted.finditer(text)]


def _in_comments(path, text, wanted):
    """A comment is what without_comments() takes out; a phrase may go on in the next line."""
    code = tree.without_comments(text)
    comments = ''.join(a if a == '\n' or a != b else ' ' for a, b in zip(text, code)).replace('//', '  ')
    comments = re.sub(r'`[^`\n]*`', lambda m: ' ' * len(m[0]), comments)
    comments = RIGHT.sub(lambda m: re.sub(r'\S', ' ', m[0]), comments)
    return [f'{path}:{tree.line_of(text, m.start())}: {" ".join(m[0].split())} in a comment' for m in wanted.finditer(comments)]


def _in_python(path, text, wanted):
    found = []
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT or token.type == tokenize.STRING and token.string.startswith('"""'):
            words = re.sub(r'`[^`\n]*`', ' ', RIGHT.sub(' ', token.string))
            found += [f'{path}:{token.start[0]}: {" ".join(m[0].split())} in a comment' for m in wanted.finditer(words)]
    return found


def _in_test_names(path, text):
    return [f'{path}:{tree.line_of(text, m.start())}: {word[0]} in {m[1]}' for m in TEST_NAME.finditer(text) for word in IN_TEST_NAMES.finditer(m[1])]


def _in_literals(path, text, wanted):
    found = []
    for line, literal in tree.strings(tree.without_comments(text)):
        if not LITERAL.fullmatch(literal) and not literal.endswith('.h"'):
            found += [f'{path}:{line}: {m[0]} in {literal[:100]}' for m in wanted.finditer(literal)]
    return found


if __name__ == '__main__':
    tree.finish('phrases', faults(tree.root_of(sys.argv)))
