"""A folder whose file system stops answering on command, as a hung NFS or SMB server does: a flat FUSE file system in memory, spoken to the kernel over
/dev/fuse without a library. freeze() stops the process that answers (SIGSTOP), thaw() lets it go on. Needs root and /dev/fuse; why_not() says what is missing."""

import ctypes
import errno
import os
import signal
import stat
import struct
import subprocess
import sys
import time

ROOT = 1
IN_HEADER = struct.Struct("<IIQQIIIHH")
OUT_HEADER = struct.Struct("<IiQ")
ATTR = struct.Struct("<QQQQQQIIIIIIIIII")
ENTRY = struct.Struct("<QQQQII")
OPEN = struct.Struct("<QII")
MNT_DETACH = 2
LIBC = ctypes.CDLL(None, use_errno=True)


class Refused(Exception):
    """An errno for the caller."""


class Inode:
    def __init__(self, mode):
        self.mode = mode
        self.data = bytearray()
        self.mtime = time.time()
        self.links = 1


class FlatFiles:
    """One folder of files. Each method answers one request of the kernel; the table below names them."""

    def __init__(self):
        self.inodes = {ROOT: Inode(stat.S_IFDIR | 0o777)}
        self.names = {}
        self.next = 2

    def attr(self, number):
        inode = self.inodes.get(number)
        if inode is None:
            raise Refused(errno.ESTALE)
        seconds = int(inode.mtime)
        return ATTR.pack(number, len(inode.data), len(inode.data) // 512 + 1, seconds, seconds, seconds, 0, 0, 0, inode.mode, inode.links, os.geteuid(),
                         os.getegid(), 0, 4096, 0)

    def entry(self, number):
        return ENTRY.pack(number, 0, 0, 0, 0, 0) + self.attr(number)

    def named(self, body):
        name = body.split(b"\0", 1)[0]
        if name not in self.names:
            raise Refused(errno.ENOENT)
        return name, self.names[name]

    def init(self, node, body):
        major, minor, readahead, _ = struct.unpack_from("<IIII", body)
        return struct.pack("<IIIIHHIIHHI28x", 7, min(minor, 31), readahead, 0, 16, 12, 131072, 1, 32, 0, 0)

    def lookup(self, node, body):
        return self.entry(self.named(body)[1])

    def getattr(self, node, body):
        return struct.pack("<QII", 0, 0, 0) + self.attr(node)

    def setattr(self, node, body):
        valid, _, _, size = struct.unpack_from("<IIQQ", body)
        if valid & 8:
            data = self.inodes[node].data
            del data[size:]
            data.extend(bytes(size - len(data)))
        return self.getattr(node, body)

    def open(self, node, body):
        return OPEN.pack(0, 1, 0)  # direct I/O: each read and write comes here

    def create(self, node, body):
        name = body[16:].split(b"\0", 1)[0]
        if name in self.names:
            raise Refused(errno.EEXIST)
        number, self.next = self.next, self.next + 1
        self.inodes[number] = Inode(stat.S_IFREG | 0o644)
        self.names[name] = number
        return self.entry(number) + self.open(number, body)

    def read(self, node, body):
        _, offset, size = struct.unpack_from("<QQI", body)
        return bytes(self.inodes[node].data[offset:offset + size])

    def write(self, node, body):
        _, offset, size = struct.unpack_from("<QQI", body)
        data = self.inodes[node].data
        data[offset:offset + size] = body[40:40 + size]
        self.inodes[node].mtime = time.time()
        return struct.pack("<II", size, 0)

    def readdir(self, node, body):
        _, offset, size = struct.unpack_from("<QQI", body)
        out = b""
        for at, (name, number) in list(enumerate(self.names.items(), 1))[offset:]:
            one = struct.pack("<QQII", number, at, len(name), 8) + name
            one += bytes(-len(one) % 8)
            if len(out) + len(one) > size:
                break
            out += one
        return out

    def link(self, node, body):
        name = body[8:].split(b"\0", 1)[0]
        if name in self.names:
            raise Refused(errno.EEXIST)
        number = struct.unpack_from("<Q", body)[0]
        self.names[name] = number
        self.inodes[number].links += 1
        return self.entry(number)

    def unlink(self, node, body):
        name, number = self.named(body)
        del self.names[name]
        self.inodes[number].links -= 1
        return b""

    def rename(self, node, body):
        old, new = body[8:].split(b"\0")[:2]
        self.names[new] = self.names.pop(old)
        return b""

    def rename2(self, node, body):
        return self.rename(node, body[8:])

    def nothing(self, node, body):
        return b""

    def statfs(self, node, body):
        return struct.pack("<QQQQQIII28x", 1 << 20, 1 << 19, 1 << 19, 1 << 20, 1 << 19, 4096, 255, 4096)


REQUESTS = {1: "lookup", 3: "getattr", 4: "setattr", 9: "write", 10: "unlink", 12: "rename", 13: "link", 14: "open", 15: "read", 16: "write", 17: "statfs",
            18: "nothing", 20: "nothing", 25: "nothing", 26: "init", 27: "open", 28: "readdir", 29: "nothing", 30: "nothing", 34: "nothing", 35: "create",
            45: "rename2"}
NO_ANSWER = {2, 36, 42}  # forget, interrupt, batch forget


def serve(mount):
    device = os.open("/dev/fuse", os.O_RDWR)
    options = f"fd={device},rootmode=40000,user_id={os.geteuid()},group_id={os.getegid()},allow_other"
    if LIBC.mount(b"freezing", mount.encode(), b"fuse", 6, options.encode()) != 0:
        sys.exit(f"mount: {os.strerror(ctypes.get_errno())}")
    print("mounted", flush=True)
    files = FlatFiles()
    while True:
        try:
            request = os.read(device, 1 << 18)
        except OSError as error:
            if error.errno in (errno.EINTR, errno.EAGAIN, errno.ENOENT):
                continue
            return  # unmounted
        _, code, unique, node = IN_HEADER.unpack_from(request)[:4]
        if code in NO_ANSWER:
            continue
        failed, answer = 0, b""
        try:
            answer = getattr(files, REQUESTS[code])(node, request[IN_HEADER.size:]) if code in REQUESTS else b""
            failed = 0 if code in REQUESTS else errno.ENOSYS
        except Refused as refused:
            failed = refused.args[0]
        try:
            os.write(device, OUT_HEADER.pack(OUT_HEADER.size + len(answer), -failed, unique) + answer)
        except OSError as error:
            if error.errno != errno.ENOENT:  # who asked is gone
                raise


def why_not():
    """What keeps this machine from mounting one, or an empty text."""
    if os.geteuid() != 0:
        return "mounting a file system needs root"
    try:
        os.close(os.open("/dev/fuse", os.O_RDWR))
    except OSError as error:
        return f"/dev/fuse: {error.strerror}"
    return ""


class FreezingFolder:
    """Mounted at `path` (an empty folder) until close(), which ends whatever waits for it with an error."""

    def __init__(self, path):
        self.path = path
        os.makedirs(path, exist_ok=True)
        self.process = subprocess.Popen([sys.executable, __file__, str(path)], stdout=subprocess.PIPE, text=True)
        if self.process.stdout.readline() != "mounted\n":
            self.process.wait(5)
            raise RuntimeError(f"{path} was not mounted")

    def freeze(self):
        self.process.send_signal(signal.SIGSTOP)

    def thaw(self):
        self.process.send_signal(signal.SIGCONT)

    def close(self):
        LIBC.umount2(str(self.path).encode(), MNT_DETACH)
        self.process.kill()
        self.process.wait(5)


if __name__ == "__main__":
    serve(sys.argv[1])
