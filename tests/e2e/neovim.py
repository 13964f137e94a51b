"""Neovim against the language server, with the very lines that docs/editor.md gives for it."""

import os
import re
import subprocess

from rig import ROOT, binary, expect, in_folder

PROGRAM = "%\nO1\nN3 G21 G90 G17 G94\nN7 G01 X1. F100.\nIF[#1GT2]GOTO3\n(L\u00e4nge) \u041c03\nM30\n%\n"


def neovim(folder):
    config = folder / "config.lua"
    page = (ROOT / "docs/editor.md").read_text()
    config.write_text(re.search(r"```lua\n(.*?)```", page, re.S)[1])
    home = {name: str(folder / name.lower()) for name in ("HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME")}
    for encoding in ("utf-8", "latin-1"):
        program = folder / f"{encoding}.nc"
        text = PROGRAM if encoding == "utf-8" else PROGRAM.replace("\u041c", "M")
        program.write_bytes(text.encode(encoding))
        environment = {**os.environ, **home, "DRIPFEED": str(binary()), "PROGRAM": str(program), "CONFIG": str(config), "ENCODING": encoding}
        done = subprocess.run(["nvim", "--headless", "-u", "NONE", "-c", f"luafile {ROOT}/tests/e2e/neovim.lua"], capture_output=True, text=True, timeout=240,
                              env=environment, check=False)
        expect(done.returncode == 0, f"{done.stdout}{done.stderr}")
        written = program.read_bytes().decode(encoding)
        expect(written == "%\nO1\nN10 G21 G90 G17 G94\nN20 G01 X1. F100.\nIF[#1GT2]GOTO10\n(L\u00e4nge) M03\nM30\n%\n", written)


if __name__ == "__main__":
    in_folder(neovim)
