# Has each document that the docs show (JSON, JavaScript) read by the program that it is for: options by `dripfeed serve --config`, an event
# by its schema in the API's description, the settings of an editor by `dripfeed lsp`, a script by node. blocks.py gives profiles to
# `dripfeed check`, tests/api/hook.py compares the question before an arming with a real one, command_scenes.py compiles the TypeScript
# and looks for the series of the rules.
#   documents.py DRIPFEED [ROOT]
import json
import pathlib
import subprocess
import sys
import tempfile

import pages

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / 'tests/api'), str(ROOT / 'tests/e2e')]
FAULTY = '%\nO0001\nG21 G17 G90 G94 G40\nG01 X10. Y10.\nM30\n%\n'  # it cuts without a feed


def options_faults(document, dripfeed):
    """The option `data` is left to the command line where the page leaves it out."""
    with tempfile.TemporaryDirectory(prefix='dripfeed_documents_') as folder:
        here = pathlib.Path(folder)
        for member in [name for name in document if name.endswith(('_cert', '_key', '_file'))] + ['data']:
            if member in document:
                document = document | {member: f'{here}/{pathlib.Path(document[member]).name}'}
        (here / 'oidc').write_text('secret\n', encoding='utf-8')
        if 'tls_cert' in document:
            subprocess.run(['openssl', 'req', '-x509', '-newkey', 'ec', '-pkeyopt', 'ec_paramgen_curve:prime256v1', '-nodes', '-subj', '/CN=dnc.shop',
                            '-keyout', document['tls_key'], '-out', document['tls_cert']], check=True, capture_output=True, timeout=30)
        (here / 'dripfeed.json').write_text(json.dumps(document), encoding='utf-8')
        done = subprocess.run([dripfeed, 'serve', '--config', here / 'dripfeed.json', '--check'], cwd=folder, capture_output=True, text=True, timeout=30)
        return [] if done.returncode == 0 else [f'dripfeed serve --config refuses it: {done.stderr.strip()}']


def event_faults(document, _):
    import contract
    described = contract.document()['webhooks'].get(document['type'])
    if not described:
        return [f'there is no event {document["type"]}']
    schema = described['post']['requestBody']['content']['application/cloudevents+json']['schema']['$ref']
    return [f'is not an event: {fault}' for fault in contract.faults(schema, document)]


def question_faults(document, _):
    return [] if document.get('type') == 'dripfeed.job.arming' else ['is not the question that tests/api/hook.py compares']


def editor_faults(document, dripfeed):
    """The language server, started as these settings have it, looks at a text for their machine."""
    import language_client
    settings = {name.removeprefix('glspc.server.'): value for name, value in document.items()}
    if settings['command'] != 'dripfeed' or settings['commandArguments'] != ['lsp']:
        return [f'starts {settings["command"]} {settings["commandArguments"]}']
    client = language_client.Client()
    client.start(settings['initializationOptions'])
    client.open('file:///O0001.nc', FAULTY)
    answer = client.wait(lambda message: message.get('method') == 'textDocument/publishDiagnostics')
    found = [one['code'] for one in answer['params']['diagnostics']]
    client.result('shutdown')
    client.notify('exit')
    ended = client.process.wait(30)
    return [] if 'no-feed' in found and ended == 0 else [f'dripfeed lsp ended with {ended} and found {found}']


def script_faults(block):
    with tempfile.NamedTemporaryFile('w', suffix='.mjs', encoding='utf-8') as file:
        file.write(block)
        file.flush()
        done = subprocess.run(['node', '--check', file.name], capture_output=True, text=True, timeout=30)
    return [] if done.returncode == 0 else [f'node refuses it: {done.stderr.strip()}']


# Of each page, by the order of its blocks.
JSON = {'operating.md': [options_faults, options_faults], 'integrating.md': [event_faults, question_faults], 'editor.md': [editor_faults]}


def faults_of(name, text, dripfeed, readers):
    left = list(readers)
    for line, language, block in pages.blocks(text):
        if language == 'js':
            yield from (f'{name}:{line}: {fault}' for fault in script_faults(block))
        if language != 'json':
            continue
        if not left:
            yield f'{name}:{line}: JSON of which documents.py does not know what it is'
            return
        try:
            found = left.pop(0)(json.loads(block), dripfeed)
        except (ValueError, KeyError) as error:
            found = [f'{type(error).__name__}: {error}']
        yield from (f'{name}:{line}: {fault}' for fault in found)
    if left:
        yield f'{name}: {len(left)} reader(s) without a block'


def main(arguments):
    root = pages.root_of(arguments, 2)
    found = []
    for path in pages.pages(root):
        if path.name != 'profiles.md':
            found += faults_of(path.name, path.read_text(encoding='utf-8'), str(pathlib.Path(arguments[1]).resolve()), JSON.get(path.name, []))
    pages.finish('documents', found)


if __name__ == '__main__':
    main(sys.argv)
