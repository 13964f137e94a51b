"""A control that fetches its programs by FTP: the server drops a released program into a folder, vsftpd serves the folder, and an FTP client (Python's,
in the place of the control's) lists and fetches it. Another program of that name is never replaced."""

import ftplib
import io
import json
import os
import subprocess

import rig

TEXT = "%\nO0042\nG21 G17 G90 G94 G40\nG54\nT01 M06\nS1000 M03\nG00 X0. Y0.\nG43 H01 Z50.\n" + "".join(
    f"G01 X{i % 9}.5 Y{i % 7}.25 F500.\n" for i in range(200)) + "G00 Z50.\nM05\nM30\n%\n"


class Ftp:
    """vsftpd, anonymous and read-only, on a folder that its user cannot write to."""

    def __init__(self, folder, root):
        self.port = rig.shop.free_port()
        empty = folder / "empty"
        empty.mkdir()
        config = folder / "vsftpd.conf"
        config.write_text("\n".join([
            "listen=YES", "listen_address=127.0.0.1", f"listen_port={self.port}", "background=NO", "anonymous_enable=YES",
            "no_anon_password=YES", f"anon_root={root}", "local_enable=NO", "write_enable=NO", f"secure_chroot_dir={empty}",
            "seccomp_sandbox=NO", "pasv_address=127.0.0.1", "xferlog_enable=NO",
            "ftp_username=ftp" if os.geteuid() == 0 else "run_as_launching_user=YES", ""]))
        self.process = subprocess.Popen(["/usr/sbin/vsftpd", str(config)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        rig.shop.wait_for("vsftpd", lambda: rig.shop.listens(self.port) or self.process.poll() is not None)
        rig.expect(self.process.poll() is None, f"vsftpd ended: {self.process.stdout.read() if self.process.poll() is not None else ''}")

    def stop(self):
        self.process.terminate()
        self.process.wait(10)


def dropped_and_fetched(folder):
    share = folder / "share"
    drop = share / "vf2"
    drop.mkdir(parents=True)
    folder.chmod(0o755)
    profile = rig.shop.preset("fanuc-0i-mill", url=f"dir:{drop}?eob=cr-lf")
    profile["name"] = "vf2"
    server = rig.shop.Server(rig.binary(), folder / "data")
    server.start()
    ftp = None
    try:
        server.add_machine(profile)
        program = server.post("/programs", {"name": "O0042", "dialect": "fanuc", "text": TEXT})
        check = server.post("/checks", {"program": program["id"], "machine": "vf2", "delivery": "memory"})
        rig.expect(check["verdict"] in ("pass", "warn"), f"verdict {check['verdict']}: {json.dumps(check)[:2000]}")
        release = server.release(program["id"], "vf2", delivery="memory")
        job = server.post("/jobs", {"release": release["id"]})["id"]
        rig.expect(not list(drop.iterdir()), "nothing lies there before a person armed it")
        server.post(f"/jobs/{job}/arm", {})
        done = server.wait_job(job, "done", "failed")
        rig.expect(done["state"] == "done", f"{done}")

        ftp = Ftp(folder, share)
        with ftplib.FTP() as control:
            control.connect("127.0.0.1", ftp.port, 10)
            control.login()
            control.cwd("vf2")
            rig.expect(control.nlst() == ["O0042"], f"{control.nlst()}")
            fetched = io.BytesIO()
            control.retrbinary("RETR O0042", fetched.write)
        rig.expect(fetched.getvalue() == TEXT.replace("\n", "\r\n").encode(), "the control has another text")

        (drop / "O0042").write_text("the shop's own")
        again = server.post("/jobs", {"release": release["id"]})["id"]
        server.post(f"/jobs/{again}/arm", {})
        failed = server.wait_job(again, "done", "failed")
        rig.expect(failed["state"] == "failed" and "another program lies there" in failed["reason"], f"{failed}")
        rig.expect((drop / "O0042").read_text() == "the shop's own", "and it stays")
    finally:
        if ftp:
            ftp.stop()
        server.stop()


def a_sinumerik_gets_a_plain_file(folder):
    """`send` into a folder takes the head of the archive off: name and place are the folder's."""
    drop = folder / "drop"
    drop.mkdir()
    (folder / "ROLL.MPF").write_text("%_N_ROLL_MPF\n;$PATH=/_N_MPF_DIR\nG0 X1\nM30\n%\n")
    done = subprocess.run([str(rig.binary()), "send", str(folder / "ROLL.MPF"), "--link", f"dir:{drop}", "--machine", "sinumerik-840d-mill",
                           "--unreleased", "--json"], capture_output=True, text=True, timeout=60)
    rig.expect(done.returncode == 0, f"{done}")
    rig.expect((drop / "ROLL.MPF").read_bytes().replace(b"\r\n", b"\n") == b"G0 X1\nM30\n", f"{(drop / 'ROLL.MPF').read_bytes()}")


if __name__ == "__main__":
    rig.in_folder(a_sinumerik_gets_a_plain_file)
    rig.in_folder(dropped_and_fetched)
