# Relative links of README and docs lead to a file, anchors to a heading, and what stands in backticks like a path of the repository is
# one. And the README's limits: it must be read in one sitting.
#   links.py [ROOT]
import re
import sys

import pages

LINES = 150
CHARACTERS = 160
LINK = re.compile(r'\[[^\]\n]*(?:\][^(\[][^\]\n]*)*\]\(([^)\s]+)\)')
CODE = re.compile(r'`([^`\n]+)`')
TOPS = '(?:checks|cmake|deploy|dialects|docs|protocol|server|store|tests|web)'
PATH = re.compile(r'^(?:\./)?(' + TOPS + r'(?:/[\w.-]+)*/?|[\w.-]+/[\w./-]+\.(?:cpp|h|md|py|json|family|sh|tsx?|mjs|txt))$')
# Paths that are made or that stand at another place than the repository.
MADE = re.compile(r'^(?:build|data|DATA|store)(?:/|$)')


def slug(heading):
    """The anchor that GitHub and the page of these docs give a heading."""
    text = re.sub(r'\[([^\]]*)\]\([^)]*\)', r'\1', heading).strip().lower()
    return re.sub(r'[^\w\- ]', '', text).replace(' ', '-')


def anchors(text):
    found, seen = set(), {}
    for heading in re.findall(r'^#{1,6} +(.+?) *#*$', pages.without_blocks(text), re.M):
        name = slug(heading)
        seen[name] = seen.get(name, -1) + 1
        found.add(name if not seen[name] else f'{name}-{seen[name]}')
    return found


def link_faults(path, text):
    bare = pages.without_blocks(text)
    for match in LINK.finditer(CODE.sub(lambda m: ' ' * len(m[0]), bare)):
        target, _, anchor = match[1].partition('#')
        where = f'{path.name}:{pages.line_of(bare, match.start())}'
        if re.match(r'\w+:', target):
            continue
        file = (path.parent / target).resolve() if target else path
        if not file.exists():
            yield f'{where}: there is no {match[1]}'
        elif anchor and anchor not in anchors(file.read_text(encoding='utf-8')):
            yield f'{where}: {target or path.name} has no heading #{anchor}'


def path_faults(path, text, root):
    bare = pages.without_blocks(text)
    for match in CODE.finditer(bare):
        first = match[1].split()[0]
        named = PATH.match(first)
        if named and '/' in first and not MADE.match(named[1]) and not (root / named[1]).exists():
            yield f'{path.name}:{pages.line_of(bare, match.start())}: there is no file {first}'


def readme_faults(text):
    lines = text.splitlines()
    if len(lines) > LINES:
        yield f'README.md: {len(lines)} lines, at most {LINES}: move what is more to docs/'
    for number, line in enumerate(lines, 1):
        if len(line) > CHARACTERS:
            yield f'README.md:{number}: {len(line)} characters, at most {CHARACTERS}'


def unlinked(root):
    """Pages that the README does not name."""
    text = (root / 'README.md').read_text(encoding='utf-8')
    for path in pages.pages(root)[1:]:
        if f'(docs/{path.name})' not in text:
            yield f'README.md: no link to docs/{path.name}'


def faults(root):
    found = list(unlinked(root))
    for path in pages.pages(root):
        text = path.read_text(encoding='utf-8')
        if path.name == 'README.md':
            found += readme_faults(text)
        found += link_faults(path, text)
        found += path_faults(path, text, root)
    return found


if __name__ == '__main__':
    pages.finish('links', faults(pages.root_of(sys.argv, 1)))
