# The drawings of docs/architecture.md: the states of a feed, of its line, of jobs, releases and orders, drawn from the tables in the
# source that decide them. A test that they are current; UPDATE_DOCS=1 writes them again.
#   states.py [ROOT]
import os
import re
import sys

import pages
from state_drawing import drawing


def enumerators(text, name):
    body = re.search(r'enum class ' + name + r' : [\w:]+ \{(.*?)\};', text, re.S)[1]
    return re.findall(r'\w+', re.sub(r'//[^\n]*', '', body))


def array(text, name):
    """The rows of a constexpr array, each as the list of what stands in it."""
    body = re.search(r'\b' + name + r'\{+(.*?)\n\}+;', text, re.S)[1]
    rows = re.findall(r'\{([^{}]*)\}', re.sub(r'//[^\n]*', '', body))
    return [[part.strip().rsplit('::', 1)[-1] for part in row.split(',')] for row in rows]


class Machine:
    """States in their order, and what leads from one to another: {(from, to): [labels]}."""

    def __init__(self, states):
        self.states = states
        self.moves = {}

    def add(self, source, target, label):
        if source not in self.states or target not in self.states:
            raise ValueError(f'{source} or {target} is no state')
        labels = self.moves.setdefault((source, target), [])
        if source != target and label not in labels:
            labels.append(label)

    def of(self, state):
        """Pairs (target, labels), targets in the order of the states."""
        return [(target, self.moves[state, target]) for target in self.states if target != state and (state, target) in self.moves]


def feed(root):
    text = (root / 'protocol/feed/state.cpp').read_text(encoding='utf-8')
    machine = Machine(enumerators((root / 'protocol/feed/state.h').read_text(encoding='utf-8'), 'State'))
    rows = array(text, 'kReactions')
    stated = int(re.search(r'array<Reaction, (\d+)>', text)[1])
    if len(rows) != stated:
        raise ValueError(f'{len(rows)} rows of {stated} were read')
    for source, given, guard, _, target in ([part.removeprefix(part[:3]) if part[1:3] == '::' else part for part in row] for row in rows):
        machine.add(source, target, given if guard == 'always' else f'{given} if {guard}')
    for source, condition, _, target in array(text, 'kProgress'):
        machine.add(source, target, condition)
    return machine


def line(root):
    """What the feed's table makes of the state that people see, and the states that are not a feed's."""
    rows = array((root / 'server/app/lines/feed_line_states.h').read_text(encoding='utf-8'), 'kFeedStateRows = ')
    shown = {state: shown_as for state, shown_as, _ in rows}
    machine = Machine(enumerators((root / 'server/app/lines/line.h').read_text(encoding='utf-8'), 'LineState'))
    for (source, target), labels in feed(root).moves.items():
        for label in labels:
            machine.add(shown[source], shown[target], label.partition(' if ')[0])
    return machine


def stored(root, path, enum, row):
    """A table of the store: {from, to, …}, or {.from = …, .to = …, .needs = true}."""
    header, source = (root / f'store/{path}.{ending}' for ending in ('h', 'cpp'))
    machine = Machine(enumerators(header.read_text(encoding='utf-8'), enum))
    table = re.search(r'kTransitions\{(.*?\})\s*,?\s*\};', source.read_text(encoding='utf-8'), re.S)[1]
    for body in re.findall(row + r'\{([^{}]*)\}', table):
        parts = [part.strip() for part in body.split(',')]
        names = [part.split('=')[-1].strip() for part in parts[:2]]
        needs = [part.split('=')[0].strip(' .').removeprefix('needs_').replace('_', ' ') for part in parts[2:] if part.startswith('.needs')]
        machine.add(*names, ', '.join(needs))
    return machine


# Columns and rows of the boxes.
FEED = [['idle', 'armed', 'disarmed'], ['next_round', 'held', 'sending'], ['stopping_held', 'stopping', 'stopped'], ['cancelling_held', 'torn', 'stopped_held'],
        ['cancelled', 'cancelling', 'trailer'], ['reset_suspected', 'failed', 'trailer_held'], ['wait_end', 'draining', 'ending'], ['done']]
LINE = [['idle', 'armed', 'disconnected'], ['torn', 'feeding', 'receiving'], ['held', 'draining', 'answering']]
JOB = [['queued', 'armed', 'failed'], ['cancelled', 'feeding', 'held'], ['interrupted', 'draining', 'done']]
RELEASE = [['draft', 'in_review'], ['obsolete', 'proving'], ['approved']]
ORDER = [['open', 'held'], ['done', 'cancelled']]


def drawings(root):
    yield 'states-feed.svg', drawing('States of a feed', feed(root), FEED)
    yield 'states-line.svg', drawing('States of a line', line(root), LINE)
    yield 'states-job.svg', drawing('States of a job', stored(root, 'jobs', 'JobState', 'JobTransition'), JOB)
    yield 'states-release.svg', drawing('States of a release', stored(root, 'releases', 'ReleaseState', 'ReleaseTransition'), RELEASE)
    yield 'states-order.svg', drawing('States of an order', stored(root, 'orders', 'OrderState', 'OrderTransition'), ORDER)


def main(arguments):
    root = pages.root_of(arguments, 1)
    faults = []
    for name, wanted in drawings(root):
        path = root / 'docs/pictures' / name
        if path.exists() and path.read_text(encoding='utf-8') == wanted:
            continue
        if os.environ.get('UPDATE_DOCS'):
            path.write_text(wanted, encoding='utf-8')
            print(f'{name}: written')
        else:
            faults.append(f'{name}: older than its table; UPDATE_DOCS=1 writes it again')
    pages.finish('states', faults)


if __name__ == '__main__':
    main(sys.argv)
