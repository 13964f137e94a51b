# What pages take for granted before one of their commands (a file, a server, a database), and how it shows that a command did what its page
# states. All have the computer of the page (computer.py); what is wrong is an AssertionError.
import json
import pathlib
import re
import shutil
import subprocess
import sys

import pages

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / 'tests/api'), str(ROOT / 'deploy')]
import shop  # noqa: E402

PROGRAM = '%\nO0042\nG21 G17 G90 G94 G40\nG00 X0. Y0.\nM30\n%\n'


def expect(condition, sentence):
    if not condition:
        raise AssertionError(sentence)


def token(computer):
    """Of the first administrator, where the pages have their server's data."""
    folders = (computer.root / one for one in ('home/user/data', 'var/lib/dripfeed/data'))
    return next(one / 'first-token' for one in folders if one.is_dir()).read_text(encoding='utf-8').strip()


def request(computer, method, path, body=None, bearer=None, as_text=False):
    """The answer of the server that was started last; fails where it is not a good one."""
    command = ['curl', '-sS', '--fail-with-body', '-X', method, '-H', f'Authorization: Bearer {bearer or token(computer)}', computer.server + path]
    given = [] if body is None else ['-H', 'Content-Type: application/json', '--data', json.dumps(body)]
    done = subprocess.run(command + given, capture_output=True, text=True, timeout=30)
    expect(done.returncode == 0, f'{method} {path}: {done.stdout}{done.stderr}')
    return done.stdout if as_text else json.loads(done.stdout or 'null')


def machine(computer, name):
    profile = shop.preset(name, url=f'pty:{computer.root}/tmp/lathe')
    return profile | {'name': name}


# --- getting-started.md


def write_machine(computer):
    (computer.home / 'machine.json').write_text(json.dumps(machine(computer, 'fanuc-0i-lathe')), encoding='utf-8')


def line_is_idle(computer):
    shop.wait_for('the line of the simulated control', lambda: request(computer, 'GET', '/api/v1/machines/fanuc-0i-lathe')['status']['line'] == 'idle')


# --- api.md


def start_server(computer):
    code, output = computer.run('dripfeed serve --data data')
    expect(code == 0, output)


def node_project(computer):
    """The packages of the page's example, as the web folder has them."""
    start_server(computer)
    modules = computer.folder('home/user/node_modules')
    (modules / '.bin').symlink_to(ROOT / 'web/schema/node_modules/.bin')
    (modules / 'openapi-fetch').symlink_to(ROOT / 'web/node_modules/openapi-fetch')


def client_is_compiled(computer):
    """The block of TypeScript, against the types that the command has made; … stands for what a client does."""
    page = (ROOT / 'docs/api.md').read_text(encoding='utf-8')
    block = next(block for _, language, block in pages.blocks(page) if language == 'ts')
    for text, wanted in ((block, 0), (block.replace('/api/v1/jobs', '/api/v1/no-jobs'), 1), (block.replace('release: 17', 'release: "17"'), 1)):
        (computer.home / 'client.ts').write_text('declare const token: string;\n' + text.replace('…', 'throw error;\nexport { data };'), encoding='utf-8')
        options = ['--noEmit', '--strict', '--target', 'es2022', '--lib', 'es2022,dom', '--module', 'esnext', '--moduleResolution', 'bundler', '--types', '']
        done = subprocess.run([ROOT / 'web/node_modules/.bin/tsc', *options, 'client.ts'], cwd=computer.home, capture_output=True, text=True, timeout=60)
        expect(bool(done.returncode) == bool(wanted), f'tsc of\n{text}ended with {done.returncode}: {done.stdout}{done.stderr}')


# --- integrating.md


def export_token(computer):
    start_server(computer)
    computer.environment['TOKEN'] = token(computer)


def webhook_is_there(computer):
    hook = request(computer, 'GET', '/api/v1/webhooks')['items'][0]
    expect((hook['url'], hook['types'], hook['description']) == ('https://mes.shop/dripfeed', ['job.*', 'alarm.raised'], 'the MES'), f'{hook}')


def mqtt_password(computer):
    (computer.folder('etc/dripfeed') / 'mqtt').write_text('secret\n', encoding='utf-8')


# --- operating.md


def packaged_options(computer):
    options = (ROOT / 'deploy/debian/dripfeed.json').read_text(encoding='utf-8')
    (computer.folder('etc/dripfeed') / 'dripfeed.json').write_text(computer.adapted(options), encoding='utf-8')
    computer.folder('usr/share/dripfeed/web')
    computer.folder('var/lib/dripfeed')


def start_unit(computer):
    """As systemctl would: the command of the unit."""
    unit = (ROOT / 'deploy/dripfeed.service').read_text(encoding='utf-8')
    command = next(line for line in unit.splitlines() if line.startswith('ExecStart=')).partition('/usr/bin/')[2]
    code, output = computer.run(command)
    expect(code == 0, output)


def rules_have_their_metrics(computer):
    """The token reads the metrics, and each series that the page's rules name is among them, with its labels."""
    from prometheus_client.parser import text_string_to_metric_families
    request(computer, 'POST', '/api/v1/machines', machine(computer, 'fanuc-0i-lathe'))
    bearer = (computer.root / 'etc/prometheus/dripfeed.token').read_text(encoding='utf-8').strip()
    wanted = selectors_of((ROOT / 'docs/operating.md').read_text(encoding='utf-8'))

    def missing():
        text = request(computer, 'GET', '/metrics', bearer=bearer, as_text=True)
        samples = [sample for family in text_string_to_metric_families(text) for sample in family.samples]
        return [(name, labels) for name, labels in wanted if not any(one.name == name and labels.items() <= one.labels.items() for one in samples)]

    shop.wait_for('the series of the rules', lambda: not missing(), seconds=5, seen=missing)


def selectors_of(page):
    """Each series in the expressions of the page's YAML, which js-yaml reads."""
    found = []
    for _, language, block in pages.blocks(page):
        if language == 'yaml':
            read = subprocess.run([ROOT / 'web/node_modules/.bin/js-yaml', '/dev/stdin'], input=block, capture_output=True, text=True, check=True, timeout=30)
            groups = json.loads(read.stdout).get('groups', [])
            rules = [rule['expr'] for group in groups for rule in group['rules']]
            found += [(m[1], dict(re.findall(r'(\w+)="([^"]*)"', m[2]))) for rule in rules for m in re.finditer(r'(dripfeed_\w+)\{([^}]*)\}', rule)]
    expect(found, 'the page has no rule with a series')
    return found


def olga_signs_in(computer):
    for body in ({'name': 'olga', 'password': 'a password of olga'}, {'name': 'olga', 'pin': '271828'}):
        request(computer, 'POST', '/api/v1/session', body)  # fails where it is refused


def start_database(computer):
    """Of another computer, whose folder has no store; the commands of PostgreSQL are those of its administrator."""
    from postgresql import Database
    computer.database_server = Database()
    computer.database = computer.database_server.folder
    computer.environment.update(PGHOST=str(computer.database), PGUSER='dnc')
    computer.first, computer.root = computer.root, computer.folder('hall-1')


def stop_all(computer):
    expect(not (faults := computer.stop()), f'{faults}')


def empty_database(computer):
    """For the shop of the first computer, whose server is stopped."""
    stop_all(computer)
    for command in ('dropdb dripfeed', 'createdb --owner dripfeed --encoding UTF8 dripfeed'):
        code, output = computer.run(command)
        expect(code == 0, output)
    computer.second, computer.root = computer.root, computer.first
    computer.folder('backup')


def second_computer(computer):
    """The shop has the tokens of the first one."""
    stop_all(computer)
    token = 'var/lib/dripfeed/data/first-token'
    shutil.copy(computer.first / token, computer.second / token)
    computer.root = computer.second


def node_is_listed(computer):
    nodes = request(computer, 'GET', '/api/v1/nodes')
    expect([one['name'] for one in nodes['items']] == ['hall-1'], f'{nodes}')


def first_computer(computer):
    """The shop's server with its store in a folder, running while it is backed up."""
    stop_all(computer)
    computer.root = computer.first
    computer.folder('backup')
    start_unit(computer)


def lose_the_store(computer):
    stop_all(computer)
    shutil.rmtree(computer.root / 'var/lib/dripfeed/data')


def olga_is_restored(computer):
    code, output = computer.run('dripfeed user list --data /var/lib/dripfeed/data')
    expect(code == 0 and 'olga' in output, output)


def programs_to_import(computer):
    (computer.folder('mnt/programs/rolls') / 'O0042.NC').write_text(PROGRAM, encoding='utf-8')


def export_has_the_program(computer):
    found = list((computer.root / 'backup').glob('shop-*/programs/rolls/*'))
    expect([one.read_text(encoding='utf-8') for one in found] == [PROGRAM], f'{found}')


def end(computer):
    """Ends what no command has started."""
    if database := getattr(computer, 'database_server', None):
        database.end()
