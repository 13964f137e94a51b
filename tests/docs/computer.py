# A computer on which the commands of a page are run: a folder that stands for its root, a line of bash at a time with the built dripfeed in the PATH.
# What a line starts and leaves running (a server, a simulated control) runs until the end of the page. Addresses that a shop would have lead to the
# server that was started last.
import os
import pathlib
import re
import signal
import subprocess
import time

SECONDS = 120  # for a computer that is busy: npx alone takes 2 s on a quiet one
STAYS = re.compile(r'dripfeed (?:serve(?!.* --check)|simulate) ')
PATHS = re.compile(r'(?<![\w./-])/(?=(?:backup|etc|mnt|tmp|usr/share/dripfeed|var/lib)\b)')
ADDRESS = re.compile(r'https://dnc\.shop:8443|http://127\.0\.0\.1:8840')
STORE = re.compile(r'postgresql://dripfeed@[\w.]+/dripfeed')


def first_of(log):
    """The first line that is none of the log's."""
    lines = log.read_text(encoding='utf-8').splitlines(keepends=True)
    return next((line for line in lines if line.endswith('\n') and not line.startswith('[')), '')


class Computer:
    def __init__(self, folder, binary):
        self.root, self.binary = pathlib.Path(folder), pathlib.Path(binary).resolve()
        self.running, self.server, self.database = [], None, None
        self.environment = dict(os.environ, PATH=f'{self.binary.parent}:{os.environ["PATH"]}', LC_ALL='C.UTF-8', DRIPFEED_LINES=str(self.root / 'lines'),
                                npm_config_offline='true', npm_config_update_notifier='false')
        self.home = self.folder('home/user')  # where commands are run

    def folder(self, path):
        made = self.root / path.lstrip('/')
        made.mkdir(parents=True, exist_ok=True)
        return made

    def adapted(self, text):
        """A command, or a file that it reads, with the places and addresses of this computer."""
        text = PATHS.sub(f'{self.root}/', text)
        text = ADDRESS.sub(self.server or 'http://no.server', text)
        return STORE.sub(f'postgresql://dripfeed@/dripfeed?host={self.database}', text)

    def run(self, line, given=''):
        """(exit code, output): of what stays, 0 and its first line."""
        line = self.adapted(line)
        if STAYS.match(line):
            return self._start(line)
        done = subprocess.run(['bash', '-euo', 'pipefail', '-c', line], cwd=self.home, env=self.environment, input=given.encode(), stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=SECONDS)
        return done.returncode, done.stdout.decode('utf-8', 'replace')

    def _start(self, line):
        if line.startswith('dripfeed serve'):
            line += ' --listen 127.0.0.1:0'
        log = self.root / f'log{len(self.running)}'
        with open(log, 'wb') as out:
            process = subprocess.Popen(['bash', '-c', f'exec {line}'], cwd=self.home, env=self.environment, stdout=out, stderr=subprocess.STDOUT)
        self.running.append((line, process))
        until = time.monotonic() + SECONDS
        while not (first := first_of(log)) and process.poll() is None and time.monotonic() < until:
            time.sleep(0.02)
        address = re.search(r'http://127\.0\.0\.1:\d+', first)
        self.server = address[0] if address else self.server
        return process.poll() or 0, first

    def stop(self):
        """Ends what runs, the last one first; what did not end well."""
        faults = []
        for line, process in reversed(self.running):
            process.send_signal(signal.SIGTERM)
            try:
                code = process.wait(SECONDS)
            except subprocess.TimeoutExpired:
                process.kill()
                code = process.wait()
            if code != 0 and ' simulate ' not in line:  # a control without a whole program ends with 1
                faults.append(f'{line} ended with {code}')
        self.running = []
        return faults
