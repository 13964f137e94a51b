# Names source files over 400 lines and functions over 60. These are warnings: the lint prints them and passes.
import re
import sys

import tree

FILE_LINES = 400
FUNCTION_LINES = 60
SCOPE = re.compile(r'\b(?:namespace|class|struct|union|enum)\b|\bextern\s*"')


def warnings(root):
    found = []
    for path in tree.files(root, tree.TOPS + ('tests',), tree.CODE):
        text = tree.read(root, path)
        lines = text.count('\n')
        if lines > FILE_LINES:
            found.append(f'{path}: {lines} lines')
        found += [f'{path}:{line}: {name} has {length} lines' for line, name, length in functions(text)
                  if length > FUNCTION_LINES]
    return found


def functions(text):
    """(line, name, lines) of every function that stands in a namespace or a class; lambdas count to the function around them."""
    code = re.sub(r'^[ \t]*#[^\n]*', lambda m: ' ' * len(m[0]), tree.code_only(text), flags=re.M)
    open_scopes, head = [], 0
    for match in re.finditer(r'[{};]', code):
        at = match.start()
        if match[0] == '{':
            before = code[head:at]
            inside = any(kind != 'scope' for kind, _, _ in open_scopes)
            name = re.search(r'([\w~:]+)\s*\(', before)
            if not inside and SCOPE.search(before) and not re.search(r'\)\s*(?:const|noexcept|override|->[^{}]*)?\s*$', before):
                kind = 'scope'
            else:
                kind = 'function' if not inside and name and not re.search(r'=\s*$', before) else 'other'
            open_scopes.append((kind, tree.line_of(code, at), name[1] if name else ''))
        elif match[0] == '}' and open_scopes:
            kind, line, name = open_scopes.pop()
            if kind == 'function':
                yield line, name, tree.line_of(code, at) - line + 1
        head = at + 1


if __name__ == '__main__':
    for warning in warnings(tree.root_of(sys.argv)):
        print(f'warning: {warning}')
