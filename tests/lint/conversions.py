# Refuses every conversion between floating point and text but dialects/text/number, and everything that depends on a locale: a decimal
# comma in a feed is a crash. Types are guessed from declarations, as far as text shows. Exceptions, with reasons: conversions.txt.
import os
import re
import sys

import tree

# Refused wherever it stands in code.
BANNED = {
    'strtod': r'\b(?:strto(?:d|f|ld)|sto(?:d|f|ld)|atof|wcsto(?:d|f|ld))\b',
    'printf': r'\b(?:v?(?:f|s|sn|d|as)?w?printf|v?[fs]?w?scanf)\s*\(',
    'stream format': r'\b(?:setprecision|std\s*::\s*(?:fixed|scientific|hexfloat|defaultfloat)|showpoint|put_money)\b',
    'locale': r'\b(?:setlocale|uselocale|newlocale|localeconv|std\s*::\s*locale|imbue)\b|#\s*include\s*<(?:c?locale|locale\.h)>',
    'chars_format': r'\bchars_format\b',
}
# Refused when the argument is floating point; the last group is the argument's end.
CALLS = {
    'to_string': re.compile(r'\bto_string\s*\('),
    'from_chars': re.compile(r'\b(?:from|to)_chars\s*\('),
}
# A floating format of fmt, and any format with a precision or with L and no other type: {:.3f} {:g} {:.{}} {:L}.
FORMAT = re.compile(r'\{\w*:(?:[^{}]?[<>^])?[-+ ]?#?0?(?:\d+|\{\w*\})?'
                    r'(?:(?:\.(?:\d+|\{\w*\}))?L?[aAeEfFgG]|\.(?:\d+|\{\w*\})L?|L\w?)\}')
DECLARED = re.compile(r'\b(?:double|float)\b\s*&?\s*((?:[A-Za-z_]\w*\s*(?:(?:=|\{)[^,;()]*)?,\s*)*[A-Za-z_]\w*)')
INTEGER = re.compile(r'\b(?:int|unsigned|long|short|size_t|bool|char|auto|u?int\d+_t)\b\s*&?\s*([A-Za-z_]\w*)')
# The blank before it distinguishes a shift from the end of a template; clang-format sees to it.
STREAMED = re.compile(r'(?<=\s)(?:<<|>>)\s*(?:(\d+\.\d*)|((?:[A-Za-z_]\w*(?:\.|->|::))*[A-Za-z_]\w*)(?!\s*[\w(.\[]|->|::|\s*<(?!<)))')


def faults(root):
    allowed = _exceptions(root)
    texts = {path: tree.read(root, path) for path in tree.files(root, tree.TOPS + ('tests',), tree.CODE)}
    codes = {path: tree.code_only(text) for path, text in texts.items()}
    declared = {path: _declarations(code) for path, code in codes.items()}
    members = _members(declared.values())
    found = []
    for path, text in texts.items():
        for line, rule, what in _of_file(path, text, codes[path], declared[path], members):
            if not any(path.startswith(prefix) and name in ('*', rule) for prefix, name in allowed):
                found.append(f'{path}:{line}: {rule}: {what}')
    return found


def _exceptions(root):
    path = 'tests/lint/conversions.txt'
    lines = tree.read(root, path).splitlines() if os.path.exists(os.path.join(root, path)) else []
    rows = [[part.strip() for part in line.split(':')] for line in lines if line.strip() and not line.startswith('#')]
    for row in rows:
        if len(row) != 3 or not all(row):
            raise ValueError(f'{path}: a row without path, rule and reason: {row}')
    return [(prefix, rule) for prefix, rule, _ in rows]


def _declarations(code):
    """Name -> [(offset, whether it is floating point)], in the order of the text."""
    found = {}
    for pattern, floating in ((DECLARED, True), (INTEGER, False)):
        for match in pattern.finditer(code):
            for name in re.findall(r'[A-Za-z_]\w*', re.sub(r'(?:=|\{)[^,]*', '', match[1])):
                found.setdefault(name, []).append((match.start(), floating))
    return {name: sorted(places) for name, places in found.items()}


def _members(files):
    """Names that are floating point wherever the tree declares them."""
    kinds = {}
    for declared in files:
        for name, places in declared.items():
            kinds.setdefault(name, set()).update(floating for _, floating in places)
    return {name for name, seen in kinds.items() if seen == {True}}


def _of_file(path, text, code, declared, members):
    for rule, pattern in BANNED.items():
        for match in re.finditer(pattern, code):
            yield tree.line_of(code, match.start()), rule, match[0].strip()
    for rule, pattern in CALLS.items():
        for match in pattern.finditer(code):
            argument = _argument(code, match.end(), 0 if rule == 'to_string' else 2)
            if _is_floating(argument, match.start(), declared, members):
                yield tree.line_of(code, match.start()), rule, argument.strip()
    for line, literal in tree.strings(text):
        for match in FORMAT.finditer(literal):
            yield line, 'format', match[0]
    if not path.startswith('tests/'):  # what a failing test says is for people
        for match in STREAMED.finditer(code):
            if match[1] or _is_floating(match[2], match.start(), declared, members):
                yield tree.line_of(code, match.start()), 'streamed', match[0].strip()


def _argument(code, start, index):
    """The text of the index-th argument of a call whose opening parenthesis ends at start."""
    depth, parts, begin = 0, [], start
    for at in range(start, len(code)):
        letter = code[at]
        if letter in '([{':
            depth += 1
        elif letter in ')]}':
            if depth == 0:
                parts.append(code[begin:at])
                break
            depth -= 1
        elif letter == ',' and depth == 0:
            parts.append(code[begin:at])
            begin = at + 1
    return parts[index] if index < len(parts) else ''


def _is_floating(argument, at, declared, members):
    """Whether an expression looks like floating point: by its literals and casts, else by how its last name was declared, in this
    file for a variable (the last declaration before `at`), in the whole tree for a member."""
    cast = re.search(r'\b(?:static_cast<\s*([^<>]*)>|l?lround)\s*\(', argument)
    if cast:
        return bool(cast[1]) and bool(re.search(r'\b(?:double|float)\b', cast[1]))
    if re.search(r'\b\d+\.\d*|\b\d+e[-+]?\d|\b(?:double|float)\b', argument):
        return True
    match = re.search(r'(\.|->)?\s*([A-Za-z_]\w*)\s*(?:\(\s*\))?\s*$', argument)
    if not match:
        return False
    if match[1]:
        return match[2] in members
    before = [floating for offset, floating in declared.get(match[2], ()) if offset < at]
    return before[-1] if before else match[2] in members


if __name__ == '__main__':
    tree.finish('conversions', faults(tree.root_of(sys.argv)))
