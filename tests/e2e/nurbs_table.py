"""The NURBS profile on the CVM-800 as chords and as macro, against table 2 of "NURBS by macro against CAM": blocks, bytes, time and error, and what
the paper's points say again. `tests/e2e/nurbs_table.py BINARY` prints it. The paper does not print its control points: ours are a curve in the same
box, 10 mm flat mill and 3 mm depth aside, so the times are compared with each other, not made equal."""

import csv
import io
import json
import pathlib
import subprocess
import sys
import tempfile

BINARY = sys.argv[1]
MACHINE = ["--machine", "mitsubishi-m80-cvm800"]
CUT = ["--set", "depth=3 mm", "--set", "profile_tolerance=1 mm", "--set", "speed_rpm=3000 rpm", "--set", "mill_feed=300 mm/min"]
PAPER_S = {"CAM": 165, "macro": 150}
# Table 1 of the paper: Y as theory, as milled by CAM's program, as milled by the macro.
TABLE_1 = [(50.000, 50.036, 50.037), (44.342, 44.422, 44.412), (40.888, 40.949, 40.970), (39.289, 39.354, 39.395), (55.638, 55.796, 55.706),
           (87.125, 87.369, 87.301), (119.045, 119.178, 119.102), (126.823, 126.850, 126.739), (114.152, 114.314, 114.185), (71.739, 71.957, 71.848),
           (52.474, 52.545, 52.532), (59.605, 59.720, 59.706), (150.000, 150.186, 150.095)]


def ask(*arguments):
    done = subprocess.run([BINARY, *map(str, arguments), "--json"], capture_output=True, text=True, timeout=60)
    if done.returncode != 0:
        raise AssertionError(f"{arguments}: {done.stderr}")
    return json.loads(done.stdout)


def row(folder, mode, steps, *more):
    family = ["nurbs-profile", *MACHINE, *CUT, "--set", f"steps={steps}", *more, "--mode", mode]
    rendered = ask("render", *family)
    program = folder / f"{mode}{steps}.nc"
    program.write_text(rendered["text"])
    return rendered | {"time": ask("time", program, *MACHINE), "accuracy": ask("accuracy", *family)}


def line(name, one):
    time, off = one["time"], one["accuracy"]
    print(f"{name:<28}{one['blocks']:>7}{one['bytes']:>8}{one['variables']:>6}{time['cycle_s']:>9.2f}{time['compute_s']:>9.2f}"
          f"{off['max_mm']:>9.4f}{off['rmse_mm']:>9.4f}{off['chord_bound_mm']:>9.4f}")


def measured_again(folder, column):
    table = io.StringIO()
    csv.writer(table).writerows([("nominal", "measured")] + [(one[0], one[column]) for one in TABLE_1])
    path = folder / "points.csv"
    path.write_text(table.getvalue())
    return ask("accuracy", "nurbs-profile", *MACHINE, "--mode", "explicit", "--cmm", path)["cmm"]


def expect(condition, text):
    if not condition:
        raise AssertionError(text)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        print(f"{'':<28}{'blocks':>7}{'bytes':>8}{'vars':>6}{'cycle s':>9}{'compute':>9}{'max mm':>9}{'rmse':>9}{'bound':>9}")
        print(f"{'paper, CAM':<28}{144:>7}{'':>8}{'':>6}{PAPER_S['CAM']:>9}")
        print(f"{'paper, macro of 50 points':<28}{135:>7}{'':>8}{527:>6}{PAPER_S['macro']:>9}")
        rows = {(mode, steps): row(folder, mode, steps) for mode, steps in
                [("explicit", 120), ("explicit", 130), ("macro", 50), ("explicit", 50), ("macro", 130), ("macro", 245), ("macro", 500)]}
        for (mode, steps), one in rows.items():
            line(f"{'chords' if mode == 'explicit' else 'macro'}, {steps} points", one)
        chords, macro = rows["explicit", 50], rows["macro", 50]
        for steps in (50, 130):
            a, b = rows["explicit", steps]["time"]["cycle_s"], rows["macro", steps]["time"]["cycle_s"]
            print(f"{steps} points: macro less chords {b - a:+.3f} s of {a:.2f} s; a point is computed in "
                  f"{1000 * rows['macro', steps]['time']['compute_s'] / steps:.1f} ms and lasts {1000 * a / steps:.0f} ms at 300 mm/min")
            expect(abs(b - a) < 0.01 * a, "the macro takes longer than its chords: the control would starve")
        # To 0.01 mm by steps as long as the chord error lets them be, proved before each is cut, against as many equal steps as that takes.
        adaptive = {mode: row(folder, mode, 4, "--set", "stepping=adaptive", "--set", "chord_error=0.01 mm") for mode in ("macro", "explicit")}
        for mode, one in adaptive.items():
            line(f"adaptive, {mode}", one)
            expect(one["accuracy"]["max_mm"] <= 0.01 + 1e-3 * (mode == "explicit"), f"adaptive, {mode}: {one['accuracy']}")
        count = adaptive["explicit"]["blocks"] - (rows["explicit", 50]["blocks"] - 51)
        even = next(n for n in range(200, 300, 5) if row(folder, "explicit", n)["accuracy"]["max_mm"] <= 0.01)
        print(f"to 0.01 mm: {count} adaptive steps, {even} equal ones; bound {adaptive['macro']['accuracy']['chord_bound_mm']:.6f}, measured "
              f"{adaptive['macro']['accuracy']['max_mm']:.6f} mm; a point is computed in {1000 * adaptive['macro']['time']['compute_s'] / count:.1f} ms")
        expect(count < 0.65 * even, "adaptive steps save nothing")
        saved, feed = PAPER_S["CAM"] - PAPER_S["macro"], 300 / 60
        print(f"the paper's {saved} s are {saved * feed:.0f} mm of path at 300 mm/min: the ramps, approaches and retracts that it names, not the "
              f"{144 - 135} blocks, which take {9 * 60 / 33.7:.0f} ms to read")
        for what, seconds in PAPER_S.items():
            print(f"{what}: {seconds} s are {seconds / chords['time']['cycle_s']:.2f} times one pass of our curve ({chords['time']['path_mm']:.0f} mm "
                  f"with its approach)")
        # The text does not grow with the points, the error falls with their square.
        expect(macro["blocks"] == rows["macro", 500]["blocks"] <= 80 and macro["variables"] <= 60, "the macro grows")
        expect(rows["explicit", 120]["blocks"] == 144, "as many blocks as CAM's")
        ratio = macro["accuracy"]["max_mm"] / rows["macro", 500]["accuracy"]["max_mm"]
        expect(70 < ratio < 130, f"ten times the points, {ratio:.0f} times the accuracy")
        for one in rows.values():
            off = one["accuracy"]
            expect(off["max_mm"] <= off["chord_bound_mm"] <= 1.05 * off["max_mm"], f"bound {off['chord_bound_mm']}, found {off['max_mm']}")
        print(f"\n{'points of table 1 (13 of 50)':<30}{'min':>8}{'max':>8}{'mean':>8}{'rmse':>8}   paper's 50: mean, rmse")
        for name, column, paper, known in (("CAM", 1, "0.135, 0.154", (0.120, 0.137)), ("macro", 2, "0.097, 0.111", (0.070, 0.090))):
            found = measured_again(folder, column)
            print(f"{name:<30}{found['min_mm']:>8.3f}{found['max_mm']:>8.3f}{found['mean_mm']:>8.3f}{found['rmse_mm']:>8.3f}   {paper}")
            expect(abs(found["mean_mm"] - known[0]) < 6e-4 and abs(found["rmse_mm"] - known[1]) < 6e-4, f"{found}")


if __name__ == "__main__":
    main()
