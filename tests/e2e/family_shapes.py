"""What the shipped families cut, from their traces, against shapes that are computed here in another manner: by distance and by bisection, not by the
families' formulas. `tests/e2e/family_shapes.py BINARY`."""

import math
import pathlib
import random
import tempfile
from math import comb, cos, dist, hypot, pi, radians, sin, tan

from families import EXPLICIT_MM, MACRO_MM, ROOT, ask, expect, moves


def trace(name, machine, mode, folder, *values):
    program = folder / "program.nc"
    words = [word for value in values for word in ("--set", value)]
    done = ask("render", ROOT / f"deploy/families/{name}.family", "--machine", machine, "--mode", mode, "--output", program, *words)
    expect(done.returncode == 0, f"{name}: {done.stderr}")
    return moves(ask("run", program, "--machine", machine).stdout)


def lowest(function, start, steps):
    """A local minimum of a function of two values, by halving steps."""
    best, size = (function(*start), *start), 1.0
    while size > 1e-6:
        _, a, b = best
        tried = min((function(a + size * i * steps[0], b + size * j * steps[1]), a + size * i * steps[0], b + size * j * steps[1])
                    for i in (-1, 0, 1) for j in (-1, 0, 1))
        if tried[0] < best[0] - 1e-14:
            best = tried
        else:
            size /= 2
    return best[0]


def ring_radius(z, c, radius=31, cone=radians(15), tilt=radians(4), depth=5):
    """Of the tilted cone at z and c: by bisection along the ray."""
    low, high = 0.0, 500.0
    while high - low > 1e-10:
        r = (low + high) / 2
        x, y, along = r * cos(c), r * sin(c), z + depth
        outside = hypot(x * cos(tilt) - along * sin(tilt), y) > radius - (x * sin(tilt) + along * cos(tilt)) * tan(cone)
        low, high = (low, r) if outside else (r, high)
    return low


def ring(folder):
    """The nose touches the section at each point."""
    for sections, worst_mm in (("exact", 0.0), ("table", 0.004)):
        for mode, print_mm in (("macro", MACRO_MM), ("explicit", EXPLICIT_MM)):
            cuts = [m for kind, m in trace("seal-ring", "mazak-qtn", mode, folder, f"sections={sections}") if kind == "linear"]
            expect(len(cuts) == 14 * 72 + 1 and abs(cuts[-1]["C"] - 14 * 360) < 1e-6, "14 turns")
            worst = 0.0
            for move in random.Random(1).sample(cuts, 60):
                z, r, c = move["Z"] + 0.4, move["X"] / 2 + 0.4, radians(move["C"])
                low, high = z - 1, z + 1
                while high - low > 1e-7:
                    a, b = (2 * low + high) / 3, (low + 2 * high) / 3
                    low, high = (low, b) if hypot(a - z, ring_radius(a, c) - r) < hypot(b - z, ring_radius(b, c) - r) else (a, high)
                worst = max(worst, abs(hypot(low - z, ring_radius(low, c) - r) - 0.4))
            expect(worst_mm / 2 < worst + (worst_mm == 0) and worst <= worst_mm + print_mm, f"ring, {sections}, {mode}: {worst}")
            print(f"seal-ring, {sections}, {mode}: the nose is {worst:.6f} mm off the cone at most")


HEIGHTS = [-2, -6, -6, -2, -8, -14, -2, -8, -3, -2, -12, -8, -4, -6, -8, -2]


def height(x, y, length=80.0, width=60.0):
    u, w = x / length, y / width
    return sum(comb(3, i) * u**i * (1 - u) ** (3 - i) * comb(3, j) * w**j * (1 - w) ** (3 - j) * HEIGHTS[4 * i + j] for i in range(4) for j in range(4))


def surface(folder, ball=3.0):
    """The ball touches the surface and cuts nowhere into it."""
    for mode, print_mm in (("macro", MACRO_MM), ("explicit", EXPLICIT_MM)):
        last = [m for kind, m in trace("bezier-surface", "fanuc-0i-mill", mode, folder) if kind == "linear"][-2000:]
        worst = 0.0
        for move in random.Random(1).sample(last, 150):
            center = (move["X"], move["Y"], move["Z"] + ball)
            off = lambda x, y: dist(center, (x, y, height(x, y)))
            near = min((off(move["X"] + i, move["Y"] + j), move["X"] + i, move["Y"] + j) for i in range(-3, 4) for j in range(-3, 4))
            worst = max(worst, abs(lowest(off, near[1:], (0.5, 0.5)) - ball))
        expect(worst <= print_mm, f"surface, {mode}: {worst}")
        print(f"bezier-surface, {mode}: the ball is {worst:.6f} mm off the surface at most")


def basis(t, knots, n, order):
    """Cox and de Boor, as the definition has it."""
    if order == 1:
        last = t >= knots[-1] and knots[n] < knots[n + 1] == knots[-1]
        return 1.0 if knots[n] <= t < knots[n + 1] or last else 0.0
    left, right = knots[n + order - 1] - knots[n], knots[n + order] - knots[n + 1]
    return (((t - knots[n]) / left * basis(t, knots, n, order - 1) if left else 0.0)
            + ((knots[n + order] - t) / right * basis(t, knots, n + 1, order - 1) if right else 0.0))


def nurbs_point(u, v, points, weights, row, knots_u, knots_v):
    bu = [basis(u, knots_u, i, 4) for i in range(len(knots_u) - 4)]
    bv = [basis(v, knots_v, j, 4) for j in range(row)]
    parts = [(bu[i] * bv[j] * weights[i * row + j], points[i * row + j]) for i in range(len(bu)) for j in range(row) if bu[i] * bv[j]]
    whole = sum(part for part, _ in parts)
    return tuple(sum(part * p[axis] for part, p in parts) / whole for axis in range(3))


SURFACES = {
    "default": ([(0, 0, -4), (0, 20, -6), (0, 40, -6), (0, 60, -3), (25, 0, -8), (27, 20, -13), (27, 40, -3), (25, 60, -8), (55, 0, -4), (53, 20, -3),
                 (53, 40, -11), (55, 60, -8), (80, 0, -5), (80, 20, -6), (80, 40, -8), (80, 60, -3)], [1] * 5 + [1.2] + [1] * 10, 4, [0] * 4 + [1] * 4,
                [0] * 4 + [1] * 4),
    "5 x 6": ([(20 * i, 12 * j, -6 - 3 * ((i + j) % 2) - 0.5 * i) for i in range(5) for j in range(6)], [1 + 0.1 * ((i * j) % 3) for i in range(5) for j in range(6)],
              6, [0] * 4 + [1] + [2] * 4, [0] * 4 + [1, 1.5] + [3] * 4)}


def nurbs_surface(folder, ball=3.0):
    """The ball touches the surface at each point of the last passes, and these leave no more than the scallop."""
    for name, (points, weights, row, knots_u, knots_v) in SURFACES.items():
        values = ["point=" + ", ".join(f"({x} mm, {y} mm, {z} mm)" for x, y, z in points), "weight=" + ", ".join(map(str, weights)), f"row={row}",
                  "knot_u=" + ", ".join(map(str, knots_u)), "knot_v=" + ", ".join(map(str, knots_v)), "block_width=60 mm", "points=30"]
        at = lambda u, v: nurbs_point(min(max(u, knots_u[0]), knots_u[-1]), min(max(v, knots_v[0]), knots_v[-1]), points, weights, row, knots_u, knots_v)
        for mode, print_mm in (("macro", MACRO_MM), ("explicit", EXPLICIT_MM)):
            cuts = [m for kind, m in trace("nurbs-surface", "fanuc-0i-mill", mode, folder, *values) if kind == "linear"]
            last = cuts[-31 * 20:]
            worst = 0.0
            for move in random.Random(1).sample(last, 40):
                center = (move["X"], move["Y"], move["Z"] + ball)
                off = lambda u, v: dist(center, at(u, v))
                du, dv = (knots_u[-1] - knots_u[0]) / 16, (knots_v[-1] - knots_v[0]) / 16
                near = min((off(i * du, j * dv), i * du, j * dv) for i in range(17) for j in range(17))
                worst = max(worst, abs(lowest(off, near[1:], (du, dv)) - ball))
            expect(worst <= print_mm, f"nurbs-surface {name}, {mode}: {worst}")
            # Neighbors of two passes are no further apart than a ball that leaves the scallop on a plane.
            passes = [last[i:i + 31] for i in range(0, len(last), 31)]
            width = 2 * (2 * ball * 0.05 - 0.05**2) ** 0.5
            apart = max(dist((a["X"], a["Y"], a["Z"]), (b["X"], b["Y"], b["Z"])) for one, other in zip(passes[-4:], passes[-3:]) for a, b in zip(one, reversed(other)))
            expect(apart <= width * 1.35, f"nurbs-surface {name}, {mode}: passes are {apart} apart, on a plane {width}")
            print(f"nurbs-surface {name}, {mode}: the ball is {worst:.6f} mm off the surface at most, {len(cuts)} cuts")


def worm_by_points(folder):
    """Each pass keeps the place that is given for it, on both layouts of axes."""
    places = [(-1.2, 22.5), (0.0, 21.0), (1.5, 20.5)]
    for family, machine, along, up, turn in (("worm", "mazak-vcn", "X", "Z", "A"), ("worm-turned", "mazak-qtn", "Z", "X", "C"), ("worm-turned", "mazak-integrex", "Z", "X", "C")):
        order = lambda x, r: f"({r} mm, {x} mm)" if up == "X" else f"({x} mm, {r} mm)"
        for mode, print_mm in (("macro", MACRO_MM), ("explicit", EXPLICIT_MM)):
            value = "place=" + ", ".join(order(*one) for one in places)
            cuts = [m for kind, m in trace(family, machine, mode, folder, "flanks=points", value) if kind == "linear"]
            scale = 2 if up == "X" else 1
            found = []
            for move in cuts:
                section = move[along] - 4 * pi * move[turn] / 360
                found.append((round(section, 2), round(move[up] / scale + 1.5, 2)))
            expect(sorted(set(found)) == sorted((round(x, 2), round(r, 2)) for x, r in places), f"{family} on {machine}, {mode}: {sorted(set(found))}")
            ends = [b[turn] - a[turn] for a, b in zip(cuts, cuts[1:]) if b[along] > a[along] + 1e-6]
            expect(max(ends) <= 90 + print_mm, f"{family}: a block turns by {max(ends)}")
        print(f"{family} on {machine}: every pass at its place")


def flank_distance(center, side, turn, lead, hand, pitch_radius=20.0, module=4.0):
    """From a point to a flank of the groove next to it, in the part's own space; `turn` is where the tool stands around x."""
    def flank(r, t):
        x = side * (pi * module / 4 + (r - pitch_radius) * tan(radians(20))) + hand * lead * t / (2 * pi)
        return (x, -r * sin(t), r * cos(t))
    off = lambda r, t: dist(center, flank(r, t))
    near = min((off(14 + 0.5 * i, turn + 0.03 * j), 14 + 0.5 * i, turn + 0.03 * j) for i in range(22) for j in range(-8, 9))
    return lowest(off, near[1:], (0.25, 0.015))


def worm(folder):
    """Roughing stays clear of both flanks, each of the last passes touches one."""
    for mode, print_mm, starts, hand, ball in (("macro", MACRO_MM, 1, "right", 1.5), ("explicit", EXPLICIT_MM, 1, "right", 1.5), ("macro", MACRO_MM, 3, "left", 1)):
        cuts = [m for kind, m in trace("worm", "mazak-vcn", mode, folder, f"starts={starts}", f"hand={hand}", f"ball_diameter={2 * ball} mm")
                if kind == "linear"]
        lead, sign = 4 * pi * starts, 1 if hand == "right" else -1
        expect(abs(min(m["Z"] for m in cuts) - 15.2) < 1e-3, "the root")
        # A pass begins where A is turned back; the last twenty of each start follow the flanks.
        begins = [i for i in range(1, len(cuts)) if cuts[i]["A"] * sign < cuts[i - 1]["A"] * sign]
        first_of_last = begins[-20 * starts]
        finishing = []
        for chosen in random.Random(1).sample(range(len(cuts)), 120):
            m = cuts[chosen]
            turn = radians(m["A"])
            center = (m["X"], -(m["Z"] + ball) * sin(turn), (m["Z"] + ball) * cos(turn))
            # The groove that the tool is in: of several starts the nearest.
            shift = round((m["X"] - sign * lead * turn / (2 * pi)) / (4 * pi)) * 4 * pi
            here = (center[0] - shift, *center[1:])
            gap = min(flank_distance(here, side, turn, lead, sign) for side in (-1, 1)) - ball
            expect(gap >= -print_mm, f"worm, {mode}: {gap} into a flank")
            if chosen >= first_of_last:
                finishing.append(abs(gap))
        expect(len(finishing) > 20 and max(finishing) <= print_mm, f"worm, {mode}, {starts} starts: {max(finishing)}")
        print(f"worm, {mode}, {starts} starts: the last passes are {max(finishing):.6f} mm off a flank at most")


def path_of(trace_moves):
    """Places along all cuts, a tenth of a millimeter apart."""
    at, places = None, []
    for kind, m in trace_moves:
        end = (m["X"], m["Y"], m["Z"])
        if at and kind == "linear":
            n = max(1, int(dist(at, end) / 0.1))
            places += [tuple(a + (b - a) * i / n for a, b in zip(at, end)) for i in range(n + 1)]
        elif at and kind == "arc-ccw":
            x, y = at[0] + m["I"], at[1] + m["J"]
            r, first, last = hypot(m["I"], m["J"]), math.atan2(-m["J"], -m["I"]), math.atan2(end[1] - y, end[0] - x)
            expect(abs(hypot(end[0] - x, end[1] - y) - r) < 2e-3, "an arc ends on its circle")
            sweep = (last - first) % (2 * pi) or 2 * pi
            sweep = 2 * pi if sweep < 1e-6 or sweep > 2 * pi - 1e-6 else sweep
            n = max(1, int(r * sweep / 0.1))
            places += [(x + r * cos(first + sweep * i / n), y + r * sin(first + sweep * i / n), at[2] + (end[2] - at[2]) * i / n) for i in range(n + 1)]
        at = end
    return places


def pocket(folder):
    """Nothing is cut beyond the wall, all of the floor is cut, and the wall is reached all around."""
    for length, width, corner, cutter, values in ((80, 50, 8, 12, ()), (80, 50, 25, 12, ()), (80, 50, 6, 12, ("entry=ramp", "overlap=0.8")),
                                                  (40, 90, 6, 10, ("entry=ramp",)), (50, 50, 7, 10, ("overlap=0.8",))):
        size = (f"pocket_length={length} mm", f"pocket_width={width} mm", f"corner_radius={corner} mm", f"cutter_diameter={cutter} mm")

        def outside(x, y):
            a, b = abs(x) - length / 2 + corner, abs(y) - width / 2 + corner
            return hypot(max(a, 0), max(b, 0)) + min(max(a, b), 0) - corner

        for mode, print_mm in (("macro", MACRO_MM), ("explicit", EXPLICIT_MM)):
            places = path_of(trace("rectangular-pocket", "haas-vf2", mode, folder, *size, *values))
            r = cutter / 2
            over = max(outside(x, y) + r for x, y, _ in places)
            expect(abs(over) <= print_mm and abs(min(z for *_, z in places) + 12) < 1e-9, f"pocket {size}, {mode}: {over} beyond the wall")
            wall = [(length / 2, 0.5 * i * (width / 2 - corner)) for i in (-2, -1, 0, 1, 2)]
            wall += [(0.5 * i * (length / 2 - corner), width / 2) for i in (-2, -1, 0, 1, 2)]
            wall += [(length / 2 - corner + corner * cos(0.2 * i), width / 2 - corner + corner * sin(0.2 * i)) for i in range(1, 8)]
            for x, y in [(sign * x, sign * y) for x, y in wall for sign in (-1, 1)]:
                gap = min(dist((x, y), place[:2]) for place in places if place[2] < -12 + 1e-6) - r
                expect(gap <= print_mm + 0.0015, f"pocket {size}, {mode}: {gap} left on the wall at {x} {y}")
            cells = {}
            for x, y, z in places:
                if z < -12 + 1e-6:
                    cells.setdefault((x // r, y // r), []).append((x, y))
            left = [(x, y) for x in (0.77 * i for i in range(-60, 61)) for y in (0.77 * i for i in range(-60, 61)) if outside(x, y) < -0.02
                    and not any(dist((x, y), p) <= r + 0.02 for i in (-1, 0, 1) for j in (-1, 0, 1) for p in cells.get((x // r + i, y // r + j), ()))]
            expect(not left, f"pocket {size}, {mode}: the floor is left at {left[:5]}")
        print(f"rectangular-pocket, {length} x {width}, corners of {corner} mm: no more and no less")


def main():
    with tempfile.TemporaryDirectory() as name:
        for shape in (ring, surface, nurbs_surface, worm, worm_by_points, pocket):
            shape(pathlib.Path(name))


if __name__ == "__main__":
    main()
