# A state machine as a still picture: a box a state with everything that leads out of it as text, and an arrow where nothing stands
# between two boxes. SVG without styles or scripts, so that a page with a strict policy may hold it.
from xml.sax.saxutils import escape

# Three columns fit a page of the documentation on a desk of 1280 pixels.
WIDTH, LINE_HEIGHT, PADDING, GAP_X, GAP_Y, MARGIN = 268, 15, 10, 44, 48, 10
CHARACTERS = 37
APART = 7  # between an arrow and the one that leads back


def wrapped(text, characters=CHARACTERS):
    lines = ['']
    for word in text.split(' '):
        if lines[-1] and len(lines[-1]) + 1 + len(word) > characters:
            lines.append('  ' + word)
        else:
            lines[-1] = f'{lines[-1]} {word}' if lines[-1] else word
    return lines


def shown_labels(labels):
    """"eot, broken (in_block)": what has the same condition stands together; a label is an input, or an input and a condition."""
    groups = {}
    for label in labels:
        given, _, condition = label.partition(' if ')
        groups.setdefault(condition, []).append(given)
    return ', '.join(', '.join(given) + (f' ({condition})' if condition else '') for condition, given in groups.items())


def texts_of(machine, state):
    lines = []
    for target, labels in machine.of(state):
        shown = shown_labels(labels)
        lines += wrapped(f'→ {target}: {shown}' if shown else f'→ {target}')
    return lines


class Box:
    def __init__(self, x, y, height):
        self.x, self.y, self.height = x, y, height
        self.middle = (x + WIDTH / 2, y + height / 2)

    def edge_towards(self, point):
        """Where the line from the middle to the point leaves the box."""
        dx, dy = point[0] - self.middle[0], point[1] - self.middle[1]
        scale = min((WIDTH / 2) / abs(dx) if dx else 1e9, (self.height / 2) / abs(dy) if dy else 1e9)
        return self.middle[0] + dx * scale, self.middle[1] + dy * scale

    def is_crossed_by(self, a, b, slack=6):
        """Whether the line from a to b passes through the box or close to it."""
        steps = 200
        for i in range(steps + 1):
            x, y = a[0] + (b[0] - a[0]) * i / steps, a[1] + (b[1] - a[1]) * i / steps
            if self.x - slack < x < self.x + WIDTH + slack and self.y - slack < y < self.y + self.height + slack:
                return True
        return False


def boxes_of(machine, grid):
    placed = [state for row in grid for state in row]
    if sorted(placed) != sorted(machine.states):
        raise ValueError(f'the grid has {sorted(set(placed) ^ set(machine.states))} too many or not at all')
    boxes, y = {}, MARGIN
    for row in grid:
        height = max(2 * PADDING + LINE_HEIGHT * (1 + len(texts_of(machine, state))) for state in row)
        for column, state in enumerate(row):
            boxes[state] = Box(MARGIN + column * (WIDTH + GAP_X), y, height)
        y += height + GAP_Y
    return boxes


def arrow(boxes, source, target, has_reverse, tip):
    a, b = boxes[source], boxes[target]
    dx, dy = b.middle[0] - a.middle[0], b.middle[1] - a.middle[1]
    length = (dx * dx + dy * dy) ** 0.5
    aside = APART if has_reverse else 0
    shift = (-dy / length * aside, dx / length * aside)
    start, end = a.edge_towards(b.middle), b.edge_towards(a.middle)
    start, end = (start[0] + shift[0], start[1] + shift[1]), (end[0] + shift[0], end[1] + shift[1])
    if any(box.is_crossed_by(start, end) for state, box in boxes.items() if state not in (source, target)):
        return ''
    return (f'<line x1="{start[0]:.1f}" y1="{start[1]:.1f}" x2="{end[0]:.1f}" y2="{end[1]:.1f}" stroke="#3b6ea5" stroke-width="1.5" '
            f'marker-end="url(#{tip})"/>\n')


def box_of(machine, state, box):
    is_end = not machine.of(state)
    out = (f'<rect x="{box.x}" y="{box.y}" width="{WIDTH}" height="{box.height}" rx="6" fill="{"#eef1f4" if is_end else "#ffffff"}" '
           'stroke="#3b4754"/>\n')
    y = box.y + PADDING + LINE_HEIGHT - 4
    out += f'<text x="{box.x + PADDING}" y="{y}" font-weight="bold" fill="#14202b">{escape(state)}</text>\n'
    for line in texts_of(machine, state):
        y += LINE_HEIGHT
        out += f'<text x="{box.x + PADDING}" y="{y}" fill="#3b4754" xml:space="preserve">{escape(line)}</text>\n'
    return out


def drawing(title, machine, grid):
    tip = title.lower().replace(' ', '-') + '-tip'  # several drawings may be in one page
    boxes = boxes_of(machine, grid)
    width = MARGIN + max(box.x for box in boxes.values()) + WIDTH
    height = MARGIN + max(box.y + box.height for box in boxes.values())
    out = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img" '
           f'font-family="ui-monospace, monospace" font-size="11">\n<title>{escape(title)}</title>\n'
           f'<defs><marker id="{tip}" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="8" markerHeight="8" orient="auto">'
           '<path d="M0 0L8 4L0 8z" fill="#3b6ea5"/></marker></defs>\n'
           f'<rect width="{width}" height="{height}" rx="8" fill="#f7f9fb"/>\n')
    for source, target in machine.moves:
        if source != target:
            out += arrow(boxes, source, target, (target, source) in machine.moves, tip)
    for state in machine.states:
        out += box_of(machine, state, boxes[state])
    return out + '</svg>\n'
