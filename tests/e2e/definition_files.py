"""Definition files (GUD, macros) and called programs of a SINUMERIK: found next to the program, by --path, and in the control's own directories,
whatever the case of their names; check and run see the same."""

import subprocess

from rig import binary, expect, in_folder

PROGRAM = "G17 G710 G90 G94\nR1=GAUGE[1]+WIDTH\nOPEN_ALL\nHELPER(R1)\nM30\n"
MACROS = "DEFINE COUNT AS 10\nDEFINE OPEN_ALL AS M80 M8\nM30\n"
DATA = "DEF NCK REAL GAUGE[COUNT]=REP(2.5)\nDEF CHAN REAL WIDTH=1\nM30\n"
HELPER = "PROC HELPER(REAL A)\nR2=A\nM17\n"


def command(*arguments):
    done = subprocess.run([str(binary()), *map(str, arguments), "--dialect", "sinumerik-840d"], capture_output=True, text=True, timeout=60)
    return done.returncode, done.stderr


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def expect_known(what, *arguments):
    for name in ("check", "run"):
        code, errors = command(name, *arguments)
        expect(code == 0, f"{what}: {name} ends with {code}: {errors}")
        expect("not defined" not in errors and "not found" not in errors, f"{what}: {name} says: {errors}")


def definition_files(folder):
    alone = folder / "alone" / "part.mpf"
    write(alone, PROGRAM)
    code, errors = command("check", alone)
    expect(code == 0, f"what is not there is no error: {errors}")
    expect(errors.count("the name GAUGE is not defined") == 1, errors)
    expect("verdict unknown" in errors, errors)

    nearby = folder / "nearby"
    write(nearby / "part.mpf", PROGRAM)
    write(nearby / "Mgud.Def", DATA)
    write(nearby / "UMAC.DEF", MACROS)
    write(nearby / "_N_HELPER_SPF", HELPER)
    expect_known("next to the program", nearby / "part.mpf")
    expect_known("by --path", alone, "--path", nearby)

    control = folder / "control"
    write(control / "WKS.DIR" / "PART.WPD" / "PART.MPF", PROGRAM)
    write(control / "MPF.DIR" / "PART.MPF", PROGRAM)
    write(control / "DEF.DIR" / "_N_MGUD_DEF", DATA)
    write(control / "DEF.DIR" / "smac.def", MACROS)
    write(control / "CMA.DIR" / "helper.cyc", HELPER)
    expect_known("in the control's directories", control / "MPF.DIR" / "PART.MPF")
    expect_known("from a workpiece", control / "WKS.DIR" / "PART.WPD" / "PART.MPF")


if __name__ == "__main__":
    in_folder(definition_files)
