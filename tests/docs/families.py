# The pictures of docs/families.md: what each shipped family cuts with its defaults, drawn from the trace of its plain blocks. A test
# that they are current and that the page shows each; UPDATE_DOCS=1 writes them.
#   families.py DRIPFEED [ROOT]
import concurrent.futures
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import pages

MACHINES = ('fanuc-0i-mill', 'mazak-vcn', 'mazak-qtn', 'sinumerik-840d-lathe')  # the first that renders it
WIDTH, HEIGHT, MARGIN = 480, 300, 16
MOST_POINTS = 1200  # of all lines of a picture


def trace_of(dripfeed, family, folder):
    """Lists (kind, numbers by letter) of its moves, and the machine's kind."""
    for machine in MACHINES:
        program = folder / f'{family.stem}.nc'
        made = subprocess.run([dripfeed, 'render', family, '--machine', machine, '--mode', 'auto' if family.stem == 'turning-cycle' else 'explicit',
                               '--output', program], capture_output=True, text=True, timeout=60)
        if made.returncode == 0:
            ran = subprocess.run([dripfeed, 'run', program, '--machine', machine, '--trace', 'motions'], capture_output=True, text=True, timeout=60)
            moves = []
            for line in ran.stdout.splitlines():
                _, kind, *words = line.split()
                if kind in ('rapid', 'linear', 'thread', 'arc-cw', 'arc-ccw'):
                    moves.append((kind, {word[0]: float(word[1:].split('/')[0]) for word in words if re.fullmatch(r'[A-Z]-?[0-9.]+(/\w+)?', word)}))
            return moves
    raise ValueError(f'{family.name} is rendered for none of {MACHINES}: {made.stderr}')


def arc_places(kind, at, end, numbers):
    """Of an arc of the x-y plane, its end last."""
    cx, cy = at[0] + numbers['I'], at[1] + numbers.get('J', 0.0)
    first, last = math.atan2(at[1] - cy, at[0] - cx), math.atan2(end[1] - cy, end[0] - cx)
    sweep = (last - first) % (2 * math.pi) or 2 * math.pi
    sweep = sweep if kind == 'arc-ccw' else sweep - 2 * math.pi
    radius = math.hypot(numbers['I'], numbers.get('J', 0.0))
    return [(cx + radius * math.cos(first + sweep * i / 24), cy + radius * math.sin(first + sweep * i / 24), at[2] + (end[2] - at[2]) * i / 24, end[3])
            for i in range(1, 25)]


def chords(moves):
    """Pieces (is_cut, [places]), places as x y z and the turn of the rotary axis; arcs and turns in short pieces."""
    pieces, at = [], None
    for kind, numbers in moves:
        end = (*(numbers.get(axis, 0.0) for axis in 'XYZ'), numbers.get('A', 0.0) + numbers.get('C', 0.0))
        if at is None:
            at = end
        if kind.startswith('arc') and 'I' in numbers:
            places = arc_places(kind, at, end, numbers)
        else:
            count = max(1, math.ceil(abs(end[3] - at[3]) / 15)) if kind != 'rapid' else 1
            places = [tuple(a + (b - a) * i / count for a, b in zip(at, end)) for i in range(1, count + 1)]
        is_cut = kind != 'rapid'
        if not pieces or pieces[-1][0] != is_cut:
            pieces.append((is_cut, [at]))
        pieces[-1][1].extend(places)
        at = end
    return pieces


def projected(place, is_lathe, turns):
    """On paper: a lathe's z and radius; else x, y and z from aside, around the axis where a part turns."""
    x, y, z, turn = place
    if is_lathe and not turns:
        return z, -x / 2
    if turns:
        along, radius = (z, x / 2) if is_lathe else (x, z)
        x, y, z = along, -radius * math.sin(math.radians(turn)), radius * math.cos(math.radians(turn))
    return x + 0.45 * y, -0.45 * y - z


def drawing(name, title, pieces, is_lathe):
    count = sum(len(places) for _, places in pieces)
    by = max(1, count // MOST_POINTS)
    turns = any(place[3] for _, places in pieces for place in places)
    if turns:  # where the tool comes from does not turn with the part
        pieces = [(is_cut, places) for is_cut, places in pieces if is_cut][-6:]
        by = 1
    lines = []
    for is_cut, places in pieces:
        kept = places[::by] + (places[-1:] if (len(places) - 1) % by else [])
        lines.append((is_cut, [projected(place, is_lathe, turns) for place in kept]))
    flat = [point for is_cut, line in lines if is_cut for point in line]
    low = [min(point[axis] for point in flat) for axis in (0, 1)]
    high = [max(point[axis] for point in flat) for axis in (0, 1)]
    scale = min((WIDTH - 2 * MARGIN) / max(high[0] - low[0], 1e-9), (HEIGHT - 2 * MARGIN) / max(high[1] - low[1], 1e-9))
    shift = [(size - scale * (high[axis] + low[axis])) / 2 for axis, size in ((0, WIDTH), (1, HEIGHT))]

    def path(line):
        points = [f'{min(max(x * scale + shift[0], 0), WIDTH):.0f} {min(max(y * scale + shift[1], 0), HEIGHT):.0f}' for x, y in line]
        return 'M' + 'L'.join(point for i, point in enumerate(points) if i == 0 or point != points[i - 1])

    rapids = ''.join(path(line) for is_cut, line in lines if not is_cut and line)
    cuts = ''.join(path(line) for is_cut, line in lines if is_cut and line)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" role="img">\n<title>{name}: {title}</title>\n'
            f'<rect width="{WIDTH}" height="{HEIGHT}" rx="8" fill="#f7f9fb"/>\n'
            f'<path d="{rapids}" fill="none" stroke="#b6c2cf" stroke-width="0.7" stroke-dasharray="4 3"/>\n'
            f'<path d="{cuts}" fill="none" stroke="#3b6ea5" stroke-width="1" stroke-linejoin="round"/>\n</svg>\n')


def picture_of(dripfeed, family, folder):
    text = family.read_text(encoding='utf-8')
    name, title = re.search(r'^family (\S+) "([^"]*)"', text, re.M).groups()
    is_lathe = re.search(r'^machine lathe', text, re.M) is not None
    return name, drawing(name, title, chords(trace_of(dripfeed, family, folder)), is_lathe)


def faults(dripfeed, root):
    out = []
    page = (root / 'docs/families.md').read_text(encoding='utf-8')
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        families = sorted((root / 'deploy/families').glob('*.family'))
        for name, made in pool.map(lambda one: picture_of(dripfeed, one, pathlib.Path(folder)), families):
            path = root / f'docs/pictures/family-{name}.svg'
            if os.environ.get('UPDATE_DOCS'):
                path.write_text(made, encoding='utf-8')
            if not path.exists() or path.read_text(encoding='utf-8') != made:
                out.append(f'{path} is not current: UPDATE_DOCS=1 writes it')
            if f'(pictures/family-{name}.svg)' not in page:
                out.append(f'docs/families.md does not show {name}')
    return out


if __name__ == '__main__':
    pages.finish('families', faults(sys.argv[1], pathlib.Path(pages.root_of(sys.argv, 2))))
