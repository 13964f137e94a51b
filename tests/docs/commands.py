# Runs the commands that README and docs show without their output (blocks marked `sh`), line by line as they stand, all of a page on one
# computer (computer.py): each must end with 0 and print what its row has. A line that cannot be run here has a row with the reason, which is
# printed. A line without a row is a fault, and a row without a line. blocks.py looks at the options of all of them.
#   commands.py DRIPFEED [ROOT]
import dataclasses
import re
import sys
import tempfile
import typing

import blocks
import command_scenes as scenes
import pages
from computer import Computer


@dataclasses.dataclass
class Run:
    begins: str  # the command line
    shows: str = ''  # all of its output; the first line of what goes on running
    given: str = ''  # to its standard input
    before: typing.Callable = None  # (computer): what the page takes for granted
    after: typing.Callable = None  # (computer): whether it did what the page states
    replaced: tuple = ()  # (what the page leaves out, what stands there)


@dataclasses.dataclass
class NotRun:
    begins: str
    why: str


CONTAINER = 'needs podman and a registry; tests/bench/container.sh makes the container with buildah and runs it'
BUILDS = 'installs packages as root and builds; tests/e2e/smoke.py feeds what --smoke feeds, and ./deploy/test runs this test itself'
OPTIONS = r'the options are valid: data in (?:\S+/)?data, listening at 127\.0\.0\.1:\d+\n'
SERVES = r'dripfeed is at http://127\.0\.0\.1:\d+/.*\n'

ROWS = {
    'README.md': [NotRun('./deploy/run', BUILDS), NotRun('./deploy/test', BUILDS)],
    'contributing.md': [NotRun('./deploy/test', BUILDS), NotRun('cmake --preset dev', 'builds the tree that this test is run in'),
                        NotRun('ninja -C build/dev', 'builds the tree that this test is run in'),
                        NotRun('ctest --test-dir build/dev -L lint', 'runs the lints, which are tests of their own')],
    'getting-started.md': [
        NotRun('./deploy/run', BUILDS), NotRun('./deploy/run --smoke', BUILDS), NotRun('./deploy/test', BUILDS),
        Run('dripfeed serve --data data', SERVES),
        Run('cat data/first-token', r'\S{20,}\n'),
        Run('dripfeed simulate --link pty:/tmp/lathe --machine fanuc-0i-lathe', r'.*/tmp/lathe.*\n', before=lambda computer: computer.folder('tmp')),
        Run('curl -H "Authorization: Bearer $(cat data/first-token)" --data @machine.json', r'(?s).*"name": ?"fanuc-0i-lathe".*', before=scenes.write_machine,
            after=scenes.line_is_idle),
    ],
    'api.md': [Run('npx openapi-typescript', r'(?s).*/api/openapi\.json → dripfeed\.d\.ts.*', before=scenes.node_project, after=scenes.client_is_compiled)],
    'integrating.md': [
        Run('curl -H "Authorization: Bearer $TOKEN"', r'(?s).*"secret": ?"whsec_.*', before=scenes.export_token, after=scenes.webhook_is_there),
        Run('dripfeed serve … --mqtt mqtts://broker.shop:8883', OPTIONS, before=scenes.mqtt_password, replaced=('…', '--check --data data')),
        Run('dripfeed serve … --mqtt mqtts://broker.shop:8883 --sparkplug-group hall-2', OPTIONS, replaced=('…', '--check --data data')),
    ],
    'operating.md': [
        Run('dripfeed serve --config /etc/dripfeed/dripfeed.json --check', OPTIONS, before=scenes.packaged_options),
        NotRun('systemctl enable --now dripfeed', "needs root and a running systemd; the unit's command is run in its place, tests/e2e/service.py has the unit"),
        Run('cat /var/lib/dripfeed/data/first-token', r'\S{20,}\n', before=scenes.start_unit),
        NotRun('./deploy/package', BUILDS), NotRun('podman build', CONTAINER), NotRun('podman run', CONTAINER),
        Run('dripfeed token add prometheus', r'token \d+ of prometheus as viewer.*\n', before=lambda computer: computer.folder('etc/prometheus'), after=scenes.rules_have_their_metrics),
        Run('dripfeed user add olga', r'olga is added as operator; .*\n'),
        Run('dripfeed user password olga', given='a password of olga\n'),
        Run('dripfeed user pin olga', given='271828\n', after=scenes.olga_signs_in),
        Run('createuser dripfeed', before=scenes.start_database),
        Run('createdb --owner dripfeed'),
        Run('dripfeed serve --data /var/lib/dripfeed/data --store postgresql://dripfeed@db.shop/dripfeed', SERVES),
        Run('dripfeed backup', r'(?s)\S+\.backup is a whole backup of .*', before=scenes.empty_database),
        Run('dripfeed restore', r'(?s)the database has the store of \S+\.backup\n.*'),
        Run('dripfeed serve --data /var/lib/dripfeed/shop --store postgresql://dripfeed@db.shop/dripfeed', SERVES),
        Run('dripfeed serve --data /var/lib/dripfeed/data --store postgresql://dripfeed@db.company/dripfeed --node hall-1', SERVES, before=scenes.second_computer,
            after=scenes.node_is_listed),
        Run('dripfeed backup', r'(?s)\S+\.backup is a whole backup of .*\n1 machines, .*', before=scenes.first_computer),
        Run('dripfeed restore', r'(?s)\S+ has the store of \S+\.backup\n.*\n1 machines, .*', before=scenes.lose_the_store, after=scenes.olga_is_restored),
        Run('dripfeed import /mnt/programs --data /var/lib/dripfeed/data --dry-run', r'added .*\nnothing was stored; .* 1 added, .*\n', before=scenes.programs_to_import),
        Run('dripfeed import /mnt/programs', r'added .*\n1 added, .*\n'),
        Run('dripfeed export', r'\S+: 1 programs, .*\n', after=scenes.export_has_the_program),
    ],
}


def lines_of(text):
    """Pairs (line of the block, command line) of the blocks of commands, in their order."""
    return [(line, command) for line, language, block in pages.blocks(text) if language == 'sh' for command in blocks.command_lines(block)]


def fault_of(row, command, computer):
    if row.before:
        row.before(computer)
    code, output = computer.run(command.replace(*row.replaced) if row.replaced else command, row.given)
    if code != 0 or not re.fullmatch(row.shows, output):
        return f'{command} ended with {code} and printed:\n{output}--- but not: {row.shows}'
    if row.after:
        row.after(computer)
    return None


def faults_of(name, text, rows, computer, report=print):
    shown = lines_of(text)
    if len(shown) != len(rows):
        yield f'{name}: {len(shown)} command lines and {len(rows)} rows in commands.py'
    for (line, command), row in zip(shown, rows):
        if not command.startswith(row.begins):
            yield f'{name}:{line}: {command} is not what the row has: {row.begins}'
            return
        if isinstance(row, NotRun):
            report(f'not run: {name}:{line}: {command}: {row.why}')
            continue
        try:
            fault = fault_of(row, command, computer)
        except Exception as error:  # of what is around a command: the rest of the page counts on it
            fault = f'{command}: {type(error).__name__}: {error}'
        if fault:
            yield f'{name}:{line}: {fault}'
            return


def main(arguments):
    root = pages.root_of(arguments, 2)
    found = []
    for path in pages.pages(root):
        with tempfile.TemporaryDirectory(prefix='dripfeed_commands_', ignore_cleanup_errors=True) as folder:
            computer = Computer(folder, arguments[1])
            try:
                found += faults_of(path.name, path.read_text(encoding='utf-8'), ROWS.get(path.name, []), computer)
            finally:
                found += [f'{path.name}: {fault}' for fault in computer.stop()]
                scenes.end(computer)
    pages.finish('commands', found)


if __name__ == '__main__':
    main(sys.argv)
