"""Controls of the tests' own at the other end of a line, which count bytes themselves: DC1 and DC3 over a TCP socket or a pseudo-terminal. One thread serves
them all. Arrivals on TCP carry the kernel's own time, so that a delay is the server's and not this process's. What a byte may mean is left to the judge that a
control is given: it is asked for each piece that arrives."""

import errno
import fcntl
import os
import pty
import selectors
import socket
import struct
import termios
import threading
import time
import tty

DC1, DC2, DC3, DC4 = b"\x11", b"\x12", b"\x93", b"\x14"
SO_TIMESTAMPNS = 35
ABRUPT = struct.pack("ii", 1, 0)


def even(text):
    """The characters with even parity, as 7E2 has them."""
    return bytes(c | 0x80 if bin(c).count("1") % 2 else c for c in text.encode())


def plain(wire):
    """The text of wire bytes, without parity."""
    return bytes(byte & 0x7F for byte in wire).decode("latin-1")


class ControlLoop:
    """The thread that reads all controls."""

    def __init__(self):
        self.selector = selectors.DefaultSelector()
        self.lock = threading.RLock()  # of the selector and of every control
        self.over = False
        self.thread = threading.Thread(target=self._run, daemon=True)
        self.thread.start()

    def watch(self, file, call):
        with self.lock:
            self.selector.register(file, selectors.EVENT_READ, call)

    def forget(self, file):
        with self.lock:
            try:
                self.selector.unregister(file)
            except (KeyError, ValueError):
                pass

    def _run(self):
        while not self.over:
            for key, _ in self.selector.select(0.05):
                with self.lock:
                    key.data()

    def close(self):
        self.over = True
        self.thread.join()


class Control:
    """What both kinds share. `judge(control, data)` is called for every piece that arrives, under the loop's lock."""

    def __init__(self, loop, char_s, judge=None):
        self.loop = loop
        self.char_s = char_s
        self.judge = judge or (lambda control, data: None)
        self.wire = bytearray()  # of this transfer
        self.arrived_at = 0.0
        self.expected_since = None  # the time from which the next byte is due; none while it is not waited for
        self.delays = []  # seconds beyond what pacing explains, one an arrival
        self.hold_at = None

    def begin(self):
        with self.loop.lock:
            self.poll()
            self.wire.clear()
            self.expected_since = None
            self.hold_at = None

    def start(self):
        """The operator's cycle start: the control asks for the program."""
        self.expect_bytes()
        self.send(DC1)

    def expect_bytes(self):
        with self.loop.lock:
            self.expected_since = time.time()

    def expect_nothing(self):
        with self.loop.lock:
            self.expected_since = None

    def hold(self):
        self.expect_nothing()
        self.send(DC3)

    def punch(self, text):
        self.send(DC2 + even(text) + DC4)

    def poll(self):
        """Takes what is there, in case that the loop is late."""
        with self.loop.lock:
            if self.up():
                self._read()

    def count(self):
        with self.loop.lock:
            self.poll()
            return len(self.wire)

    def text(self):
        with self.loop.lock:
            self.poll()
            return plain(self.wire)

    def took(self, data, at):
        self.judge(self, data)
        self.wire += data
        if self.expected_since is not None:
            self.delays.append(max(0.0, at - self.expected_since - len(data) * self.char_s))
            self.expected_since = at
        self.arrived_at = at
        if self.hold_at is not None and len(self.wire) >= self.hold_at:
            self.hold_at = None
            self.hold()

    def inside_block(self):
        """Whether what came so far breaks off inside a block."""
        text = self.text()
        if not text.strip("\0"):
            return False
        return not text.rstrip("\0").endswith(("\n", "\r")) and not (text.count("%") > 1 and text.rstrip("\0\r\n").endswith("%"))


class TcpControl(Control):
    """Listens; the server connects. cut() resets the connection, unplug() also takes the port away until plug()."""

    timed = True

    def __init__(self, loop, char_s, judge=None):
        super().__init__(loop, char_s, judge)
        self.port = 0
        self.listener = None
        self.peer = None
        self.plug()

    def url(self):
        return f"tcp://127.0.0.1:{self.port}"

    def plug(self):
        with self.loop.lock:
            self.listener = socket.create_server(("127.0.0.1", self.port))
            self.port = self.listener.getsockname()[1]
            self.loop.watch(self.listener, self._accept)

    def _accept(self):
        peer, _ = self.listener.accept()
        if self.peer:
            self._drop()
        peer.setsockopt(socket.SOL_SOCKET, SO_TIMESTAMPNS, 1)
        peer.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        peer.setblocking(False)
        self.peer = peer
        self.loop.watch(peer, self._read)

    def _read(self):
        while self.peer:
            try:
                data, notes, _, _ = self.peer.recvmsg(4096, 64)
            except BlockingIOError:
                return
            except OSError:
                data, notes = b"", []
            if not data:
                return self._drop()
            at = time.time()
            for level, kind, value in notes:
                if level == socket.SOL_SOCKET and kind == SO_TIMESTAMPNS:
                    seconds, nanoseconds = struct.unpack("qq", value)
                    at = seconds + nanoseconds * 1e-9
            self.took(data, at)

    def _drop(self):
        peer, self.peer = self.peer, None
        self.expected_since = None
        self.loop.forget(peer)
        peer.close()

    def up(self):
        return self.peer is not None

    def send(self, data):
        with self.loop.lock:
            try:
                return self.peer.send(data) if self.peer else 0
            except OSError:
                return 0

    def cut(self):
        """What has arrived is read; what the server sends from now on gets a reset."""
        with self.loop.lock:
            if self.peer:
                self._read()
            if self.peer:
                self.peer.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, ABRUPT)
                self._drop()

    def unplug(self):
        with self.loop.lock:
            self.cut()
            if self.listener:
                self.loop.forget(self.listener)
                self.listener.close()
                self.listener = None

    def close(self):
        self.unplug()


class PtyControl(Control):
    """A pseudo-terminal with a link to it; cut() hangs it up until plug() makes another one under the same name."""

    timed = False

    def __init__(self, loop, char_s, path, judge=None):
        super().__init__(loop, char_s, judge)
        self.path = str(path)
        self.master = None
        self.slave = None
        self.plug()

    def url(self):
        return f"pty:{self.path}"

    def plug(self):
        with self.loop.lock:
            self.master, self.slave = pty.openpty()
            tty.setraw(self.slave, termios.TCSANOW)
            os.set_blocking(self.master, False)
            if os.path.islink(self.path):
                os.unlink(self.path)
            os.symlink(os.ttyname(self.slave), self.path)
            self.loop.watch(self.master, self._read)

    def _read(self):
        while self.master is not None:
            try:
                data = os.read(self.master, 4096)
            except BlockingIOError:
                return
            except OSError as error:
                if error.errno != errno.EIO:
                    raise
                return
            if not data:
                return
            self.took(data, time.time())

    def up(self):
        return self.master is not None

    def free(self):
        """The server that had the line is gone; its claim (TIOCEXCL) stays with the terminal as long as we hold it open."""
        with self.loop.lock:
            if self.slave is not None:
                fcntl.ioctl(self.slave, termios.TIOCNXCL)

    def send(self, data):
        with self.loop.lock:
            try:
                return os.write(self.master, data) if self.master is not None else 0
            except OSError:
                return 0

    def cut(self):
        with self.loop.lock:
            if self.master is None:
                return
            self.expected_since = None
            self._read()
            os.unlink(self.path)  # before the number can be another's
            self.loop.forget(self.master)
            os.close(self.master)
            os.close(self.slave)
            self.master = self.slave = None

    unplug = cut
    close = cut
