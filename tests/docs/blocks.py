# Every code block of README and docs is tried by something. This table names what; a block that it does not name is a fault, so that
# none is added unseen. Blocks that are no session are looked at here: commands and their options exist (commands.py runs those that can be run),
# a profile is read by `dripfeed check`, names of metrics and routes are those of the binary. And each section of figures names a program that
# gives them.
#   blocks.py DRIPFEED [ROOT]
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import pages

# What other tests run, by page and language: the test, which must name the page ("*": any page).
ELSEWHERE = {
    ('*', 'console'): 'tests/docs/sessions.py',
    ('diagnostics.md', 'nc'): 'tests/docs/examples.py',
    ('families.md', 'family'): 'tests/unit/dialects/compile/render/family_language_test.cpp',
    ('families.md', 'wrapped'): 'tests/unit/dialects/compile/wrapped_family_test.cpp',
    ('editor.md', 'json'): 'tests/docs/documents.py',
    ('editor.md', 'lua'): 'tests/e2e/neovim.py',
    ('integrating.md', 'js'): 'tests/docs/documents.py',
    ('integrating.md', 'json'): 'tests/docs/documents.py',
    ('integrating.md', 'python'): 'tests/api/receiver.py',
    ('operating.md', 'json'): 'tests/docs/documents.py',
    ('operating.md', 'nginx'): 'tests/e2e/tls.py',
}
# Blocks that no program runs, and what is done instead; a block of commands has its reason in commands.py.
NOT_RUN = {
    'ebnf': 'a grammar is not run: its words are compared with those of the reader',
    'js': 'its library is not installed for the tests: node reads it',
    'text': 'a drawing or a formula',
    'yaml': 'Prometheus is not installed for the tests: js-yaml reads it, and each series is looked for in the metrics of a server',
}
# Programs of others in blocks of commands.
OTHERS = {'cat', 'cmake', 'createdb', 'createuser', 'ctest', 'curl', 'ninja', 'npx', 'podman', 'systemctl'}


class Binary:
    """What the built program states of itself."""

    def __init__(self, path, root):
        self.path, self.root, self._help = path, root, {}
        self.routes = json.loads(self.run('openapi').stdout)['paths'].keys()
        self.metrics = set(re.findall(r'dripfeed_\w+', '\n'.join(p.read_text(encoding='utf-8') for p in sorted((root / 'server/http').glob('*.cpp')))))

    def run(self, *arguments, stdin=''):
        return subprocess.run([self.path, *arguments], input=stdin, capture_output=True, text=True, timeout=30)

    def help_of(self, words):
        if words not in self._help:
            done = self.run(*words, '--help')
            self._help[words] = done.stdout if done.returncode == 0 else ''
        return self._help[words]


def command_lines(block):
    """Without comments, continued lines joined, both sides of && and | apart."""
    joined = re.sub(r'\\\n\s*', ' ', block)
    for line in joined.splitlines():
        line = re.sub(r'(?:^|\s)#.*', '', line).strip()
        yield from (part.strip() for part in re.split(r'&&|\s\|\s', line) if part.strip())


def of_dripfeed(line, binary):
    words = line.split()[1:]
    named = tuple(word for word in words[:2] if re.fullmatch(r'[a-z]+', word))
    command = next((named[:n] for n in (2, 1) if len(named) >= n and binary.help_of(named[:n])), None)
    if command is None or f'dripfeed {command[0]}' not in binary.help_of(command[:1]):
        return [f'there is no command dripfeed {" ".join(named)}']
    text = binary.help_of(command)
    return [f'dripfeed {" ".join(command)} has no option {one}' for one in re.findall(r'(?<!\S)--[\w-]+', line) if not re.search(rf'{one}(?![\w-])', text)]


def of_script(line, root):
    script = root / line.split()[0]
    if not script.is_file():
        return [f'there is no {line.split()[0]}']
    text = script.read_text(encoding='utf-8')
    return [f'{line.split()[0]} has no option {one}' for one in re.findall(r'(?<!\S)--[\w-]+', line) if one not in text]


def is_route(path, routes):
    parts = path.split('?')[0].rstrip('/').split('/')
    return any(len(parts) == len(route.split('/')) and all(a == b or b.startswith('{') for a, b in zip(parts, route.split('/'))) for route in routes)


def of_commands(block, binary):
    for line in command_lines(block):
        first = line.split()[0]
        if first == 'dripfeed':
            yield from of_dripfeed(line, binary)
        elif first.startswith('./'):
            yield from of_script(line, binary.root)
        elif first not in OTHERS:
            yield f'{first} is no command that this test knows'
        preset = re.search(r'--preset (\w+)', line)
        if preset and f'"name": "{preset[1]}"' not in (binary.root / 'CMakePresets.json').read_text(encoding='utf-8'):
            yield f'there is no preset {preset[1]}'
        yield from (f'there is no route {path}' for path in re.findall(r'https?://[^/\s]+(/api[\w/.-]*)', line) if not is_route(path, binary.routes))


def of_profile(document, binary):
    with tempfile.TemporaryDirectory(prefix='dripfeed_blocks_') as folder:
        file = pathlib.Path(folder) / 'machine.json'
        file.write_text(json.dumps(document), encoding='utf-8')
        done = binary.run('check', '-', '--machine', str(file), stdin='%\nO1\nG21\nM30\n%\n')
    return [] if done.returncode != 2 else [f'is not a profile: {done.stderr.strip()}']


def of_json(name, block, binary):
    try:
        document = json.loads(block)
    except ValueError as error:
        return [f'is not JSON: {error}']
    return of_profile(document, binary) if name == 'profiles.md' else ['is JSON of which no test knows what it is']


def of_metrics(block, binary):
    """Its names are metrics, without what Prometheus adds to the name of a histogram."""
    for name in set(re.findall(r'\bdripfeed_\w+', block)):
        if re.sub(r'_(?:sum|count|bucket)$', '', name) not in binary.metrics:
            yield f'there is no metric {name}'


def of_excerpt(block, root):
    """Lines of one family of deploy/families, in their order; … leaves some out."""
    wanted = [line.strip() for line in block.splitlines() if line.strip() and line.strip() != '…']
    for path in sorted((root / 'deploy/families').glob('*.family')):
        lines = iter(re.sub(r'\s+#.*', '', line).strip() for line in path.read_text(encoding='utf-8').splitlines())
        if all(any(line == one for one in lines) for line in wanted):
            return []
    return ['no family of deploy/families has these lines']


def of_grammar(block, root):
    text = '\n'.join(p.read_text(encoding='utf-8') for p in sorted((root / 'dialects/family').glob('*.cpp')))
    known = set(re.findall(r'"([\w]+)"', text))
    return [f'the reader knows no word {word}' for word in sorted(set(re.findall(r'"([a-z_]{2,})"', block)) - known)]


def programs_of(root):
    """What gives figures: scripts of the tree, benches and tests by the name of their target or source, dripfeed itself."""
    sources = [p for top in ('deploy', 'tests') for p in (root / top).rglob('*') if p.is_file() and p.suffix in ('', '.cpp', '.mjs', '.py', '.sh')]
    return {'dripfeed'} | {p.name for p in sources} | {p.stem for p in sources} | {f'{p.parent.name}_{p.stem.removesuffix("_test")}' for p in sources}


def figures_without_command(name, page, known):
    """Sections of the page of measurements, and rows of the README's table of them, that name no program in backticks."""
    for section in re.split(r'^## ', page, flags=re.M)[1:] if name == 'measurements.md' else re.findall(r'^\| .*\d.*\|$', measured(page), re.M):
        named = {word.rsplit('/', 1)[-1] for code in re.findall(r'`([^`]+)`', section) for word in re.split(r'[\s=,]+', code)}
        if re.search(r'\d', section) and not named & known and not any(one.startswith('wire_') for one in named):
            yield f'{name}: no command gives the figures of: {section.splitlines()[0]}'


def measured(page):
    """The README's section of measurements."""
    return next((one for one in re.split(r'^## ', page, flags=re.M) if one.startswith('Measured')), '')


def indented(name, page):
    """Blocks by four blanks, which have no language and so no test."""
    before, in_list = '', False
    for number, line in enumerate(pages.without_blocks(page).splitlines(), 1):
        if line.startswith('    ') and not before.strip() and not in_list:
            yield f'{name}:{number}: a block by indentation: write it between fences, with its language'
        if line.strip():
            in_list = bool(re.match(r'\s*(?:[-*]|\d+\.) ', line)) or in_list and line.startswith(' ')
        before = line


def faults_of(path, binary):
    page = path.read_text(encoding='utf-8')
    yield from indented(path.name, page)
    for line, language, block in pages.blocks(page):
        if language in NOT_RUN:
            print(f'not run: {path.name}:{line}: {language}: {NOT_RUN[language]}')
        for fault in of_block(path.name, language, block, binary):
            yield f'{path.name}:{line}: {fault}'


def of_block(name, language, block, binary):
    test = ELSEWHERE.get((name, language)) or ELSEWHERE.get(('*', language))
    if test:
        text = (binary.root / test).read_text(encoding='utf-8')
        return [] if ('*', language) in ELSEWHERE or name in text else [f'{test} does not read this page']
    looks = {'sh': lambda: of_commands(block, binary), 'json': lambda: of_json(name, block, binary), 'yaml': lambda: of_metrics(block, binary),
             'family': lambda: of_excerpt(block, binary.root), 'ebnf': lambda: of_grammar(block, binary.root),
             'ts': lambda: [f'there is no route {route}' for route in re.findall(r'"(/api/[^"]*)"', block) if not is_route(route, binary.routes)],
             'text': lambda: []}  # a drawing or a formula
    return list(looks[language]()) if language in looks else [f'a block of "{language}" that no test looks at']


def main(arguments):
    root = pages.root_of(arguments, 2)
    binary = Binary(arguments[1], root)
    known = programs_of(root)
    found = [fault for path in pages.pages(root) for fault in faults_of(path, binary)]
    found += [fault for name in ('README.md', 'docs/measurements.md') for fault in
              figures_without_command(pathlib.Path(name).name, (root / name).read_text(encoding='utf-8'), known)]
    pages.finish('blocks', found)


if __name__ == '__main__':
    main(sys.argv)
