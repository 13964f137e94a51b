# The parts of docs/ that the binary writes: routes, members of a machine's profile, diagnostics. A test that they are current;
# UPDATE_DOCS=1 writes them again.
#   reference.py DRIPFEED [ROOT]
import json
import os
import pathlib
import re
import subprocess
import sys

SECTION = re.compile(r'(<!-- generated: (\w+) -->\n).*?(<!-- end -->)', re.S)


def route_table(api):
    rows = ['| route | role | does |', '|---|---|---|']
    for path, methods in api['paths'].items():
        for method, route in methods.items():
            rows.append(f"| `{method.upper()} {path}` | {_role(route)} | {_cell(route['summary'])} |")
    return rows


def _role(route):
    return 'none' if route.get('security') == [] else route['x-role']


def problem_table(api):
    described = api['components']['schemas']['Problem']['properties']['code']['x-enumDescriptions']
    rows = ['| code | status | means |', '|---|---|---|']
    for code, meaning in described.items():
        status, _, about = meaning.partition(': ')
        rows.append(f'| `{code}` | {status} | {_cell(about)} |')
    return rows


def profile_table(api):
    rows = ['| member | type | means |', '|---|---|---|']
    _members(api['components']['schemas'], api['components']['schemas']['Profile'], '', rows)
    return rows


def _members(schemas, schema, above, rows):
    required = schema.get('required', [])
    for name, member in schema.get('properties', {}).items():
        if '$ref' in member:
            member = schemas[member['$ref'].rsplit('/', 1)[1]]
        path = above + name
        shown = f'**`{path}`**' if name in required else f'`{path}`'
        rows.append(f"| {shown} | {_type(member)} | {_cell(member.get('description', ''))} |")
        inner = member.get('items', member)
        if 'properties' in inner:
            _members(schemas, inner, path + ('[].' if 'items' in member else '.'), rows)


def _type(member):
    if 'enum' in member:
        return ', '.join(str(value) for value in member['enum'] if value is not None)
    kinds = member.get('type', 'any')
    kinds = [kinds] if isinstance(kinds, str) else [kind for kind in kinds if kind != 'null']
    if kinds == ['array']:
        inner = member.get('items', {}).get('type', 'any')
        return f'list of {inner if isinstance(inner, str) else inner[0]}'
    text = ' or '.join(kinds)
    least, most = member.get('minimum'), member.get('maximum')
    return text if least is None or most is None else f'{text}, {least:g} to {most:g}'


def _cell(text):
    return ' '.join(text.split()).replace('|', '\\|')


def written(text, tables):
    """The text with each generated section written from its table."""
    return SECTION.sub(lambda m: m[1] + '\n'.join(['', *tables[m[2]](), '', '']) + m[3], text)


def _printed(dripfeed, *arguments):
    return subprocess.run([dripfeed, *arguments], check=True, capture_output=True, text=True).stdout


def pages(dripfeed, root):
    """Triples (path, text as it is, text as it should be)."""
    api = json.loads(_printed(dripfeed, 'openapi'))
    tables = {'routes': lambda: route_table(api), 'problems': lambda: problem_table(api), 'profile': lambda: profile_table(api)}
    whole = {'diagnostics.md': lambda: _printed(dripfeed, 'explain', '--all', '--markdown'), 'words.md': lambda: _printed(dripfeed, 'words', '--markdown')}
    for path in sorted((root / 'docs').glob('words-*.md')):
        whole[path.name] = lambda dialect=path.stem.removeprefix('words-'): _printed(dripfeed, 'words', '--markdown', '--dialect', dialect)
    for path in sorted((root / 'docs').glob('*.md')):
        text = path.read_text(encoding='utf-8')
        yield path, text, whole[path.name]() if path.name in whole else written(text, tables)


def main(arguments):
    root = pathlib.Path(arguments[2]) if len(arguments) > 2 else pathlib.Path(__file__).resolve().parents[2]
    old = 0
    for path, text, wanted in pages(arguments[1], root):
        if text == wanted:
            continue
        if os.environ.get('UPDATE_DOCS'):
            path.write_text(wanted, encoding='utf-8')
            print(f'{path.name}: written')
        else:
            old += 1
            print(f'{path.name}: not current; UPDATE_DOCS=1 writes it again')
    return 1 if old else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv))
