#!/usr/bin/env python3
"""Called programs are found by the number or name inside the files of a folder, a fault of one is placed in its file, and a lathe's program whose lines name
two G-code systems is not translated without g_system."""
import json
import pathlib
import subprocess
import sys
import tempfile

BINARY = sys.argv[1]
DUMP = "%\nO9001(FIRST)\nG00 X1.\nM99\nO9700(SECOND)\nG00 X0. Y0.\nG02 X10. Y0. I1. J0. F100.\nM99\n<PROBE>\nG00 X2.\nM99\n%\n"
HEAD = "%\nO7000\nG21 G17 G90 G94 G40 G54\n"


def run(*arguments):
    return subprocess.run([BINARY, *map(str, arguments)], capture_output=True, text=True, timeout=60)


def diagnostics(folder, call):
    main = folder / "main.nc"
    main.write_text(f"{HEAD}{call}\nM30\n%\n")
    return json.loads(run("check", "--dialect", "fanuc", "--json", main).stdout)["files"][0]["diagnostics"]


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "ALL-FLDR.TXT").write_text(DUMP)
        fault = diagnostics(folder, "M98 P9700")
        assert [(d["id"], d["file"], d["line"]) for d in fault] == [("arc-radius-mismatch", str(folder / "ALL-FLDR.TXT"), 7)], fault
        assert diagnostics(folder, "M98 P9001") == []
        assert diagnostics(folder, "M98 <PROBE>") == []
        assert [d["id"] for d in diagnostics(folder, "M98 P9002")] == ["call-target-missing"]
        (folder / "copy.nc").write_text(DUMP)  # which of the two the control holds is not known
        assert [d["id"] for d in diagnostics(folder, "M98 P9001")] == ["call-target-missing"]

        lathe = folder / "lathe.nc"
        lathe.write_text("%\nO1\nG21 G91 G40\nG50 S2000\nT0101\nG00 X50. Z2.\nM30\n%\n")
        refused = run("convert", "--from", "fanuc", "--to", "sinumerik-840d", lathe)
        assert refused.returncode == 2 and "line 3 has G91 and line 4 has G50 S" in refused.stderr, refused.stderr
        # A G90 in the first line of a program of system A turns nothing: G50 S decides.
        lathe.write_text(lathe.read_text().replace("G91", "G90"))
        for more in ([], ["--control", "kind=lathe,g_system=A"]):
            done = run("convert", "--from", "fanuc", "--to", "sinumerik-840d", *more, lathe)
            assert done.returncode == 0, done.stderr

        for option, other in (("--from", ["--to", "fanuc"]), ("--to", ["--from", "fanuc"])):
            wrong = run("convert", option, "fanuc-0i", *other, lathe)
            assert wrong.returncode == 2 and f'{option} "fanuc-0i" is not known' in wrong.stderr, wrong.stderr


if __name__ == "__main__":
    sys.exit(main())
