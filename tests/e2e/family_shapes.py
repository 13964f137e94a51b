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


# Radius, angle of the cone and tilt in degrees, depth where the axes meet; how far the tabulated ring may be off.
RINGS = ((31, 15, 4, 5, 0.004), (125, 45, 15, -100, 0.002), (125, 0, 20, 100, 0.025), (9, 40, 20, -4, 0.048), (5, 0, 0, 0, 0.0))


def ring(folder):
    """The nose touches the section at each point, also at corners of the ranges."""
    for radius, cone, tilt, depth, off_mm in RINGS:
        values = (f"cone_diameter={2 * radius} mm", f"cone_angle={cone} deg", f"tilt={tilt} deg", f"meeting_depth={depth} mm")
        section = lambda z, c: ring_radius(z, c, radius, radians(cone), radians(tilt), depth)
        for sections, worst_mm in (("exact", 0.0), ("table", off_mm)):
            for mode, print_mm in (("macro", MACRO_MM), ("explicit", EXPLICIT_MM)):
                cuts = [m for kind, m in trace("seal-ring", "mazak-qtn", mode, folder, f"sections={sections}", *values) if kind == "linear"]
                expect(len(cuts) == 14 * 72 + 1 and abs(cuts[-1]["C"] - 14 * 360) < 1e-6, "14 turns")
                worst = 0.0
                for move in random.Random(1).sample(cuts, 60):
                    z, r, c = move["Z"] + 0.4, move["X"] / 2 + 0.4, radians(move["C"])
                    low, high = z - 1, z + 1
                    while high - low > 1e-7:
                        a, b = (2 * low + high) / 3, (low + 2 * high) / 3
                        low, high = (low, b) if hypot(a - z, section(a, c) - r) < hypot(b - z, section(b, c) - r) else (a, high)
                    worst = max(worst, abs(hypot(low - z, section(low, c) - r) - 0.4))
                expect(worst_mm / 2 < worst + (worst_mm == 0) and worst <= worst_mm + print_mm, f"ring {values}, {sections}, {mode}: {worst}")
                print(f"seal-ring {' '.join(values)}, {sections}, {mode}: the nose is {worst:.6f} mm off the cone at most")


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


def flank_distance(center, side, turn, lead, hand, pitch_radius, module, angle):
    """From a point to a flank of the groove next to it, in the part's own space; `turn` is where the tool stands around x."""
    def flank(r, t):
        x = side * (pi * module / 4 + (r - pitch_radius) * tan(radians(angle))) + hand * lead * t / (2 * pi)
        return (x, -r * sin(t), r * cos(t))
    off = lambda r, t: dist(center, flank(r, t))
    low, high = pitch_radius - 1.5 * module, pitch_radius + 1.125 * module
    step = (high - low) / 21
    near = min((off(low + step * i, turn + 0.03 * j), low + step * i, turn + 0.03 * j) for i in range(22) for j in range(-8, 9))
    return lowest(off, near[1:], (step / 2, 0.015))


# Mode, starts, hand, radius of the ball, module, pitch diameter, flank angle, and what must be changed with them: usual values, and corners.
WORMS = (("macro", 1, "right", 1.5, 4, 40, 20, ()), ("explicit", 1, "right", 1.5, 4, 40, 20, ()), ("macro", 3, "left", 1, 4, 40, 20, ()),
         ("macro", 1, "left", 10, 20, 300, 5, ("run_out=60 mm", "layer_depth=10 mm", "rough_width=10 mm")),
         ("macro", 8, "right", 2, 20, 300, 25, ("run_out=60 mm", "layer_depth=10 mm", "rough_width=10 mm", "thread_length=2 mm", "finish=0 mm")),
         ("explicit", 1, "right", 0.2, 0.5, 4, 5, ("run_out=0.8 mm", "finish=0.05 mm", "thread_length=2 mm")))


def worm(folder):
    """Roughing stays clear of both flanks, each of the last passes touches one."""
    for mode, starts, hand, ball, module, pitch_diameter, angle, more in WORMS:
        print_mm = MACRO_MM if mode == "macro" else EXPLICIT_MM
        values = (f"starts={starts}", f"hand={hand}", f"ball_diameter={2 * ball} mm", f"module={module} mm", f"pitch_diameter={pitch_diameter} mm",
                  f"flank_angle={angle} deg", *more)
        cuts = [m for kind, m in trace("worm", "mazak-vcn", mode, folder, *values) if kind == "linear"]
        lead, sign = module * pi * starts, 1 if hand == "right" else -1
        expect(abs(min(m["Z"] for m in cuts) - (pitch_diameter / 2 - 1.2 * module)) < 1e-3, "the root")
        # A pass begins where A is turned back; the last twenty of each start follow the flanks.
        begins = [i for i in range(1, len(cuts)) if cuts[i]["A"] * sign < cuts[i - 1]["A"] * sign]
        first_of_last = begins[-20 * starts]
        finishing = []
        for chosen in random.Random(1).sample(range(len(cuts)), 120):
            m = cuts[chosen]
            turn = radians(m["A"])
            center = (m["X"], -(m["Z"] + ball) * sin(turn), (m["Z"] + ball) * cos(turn))
            # The groove that the tool is in: of several starts the nearest.
            shift = round((m["X"] - sign * lead * turn / (2 * pi)) / (module * pi)) * module * pi
            here = (center[0] - shift, *center[1:])
            gap = min(flank_distance(here, side, turn, lead, sign, pitch_diameter / 2, module, angle) for side in (-1, 1)) - ball
            expect(gap >= -print_mm, f"worm, {mode}, {values}: {gap} into a flank")
            if chosen >= first_of_last:
                finishing.append(abs(gap))
        expect(len(finishing) > 20 and max(finishing) <= print_mm, f"worm, {mode}, {values}: {max(finishing)} of {len(finishing)}")
        print(f"worm, {mode}, {' '.join(values)}: the last passes are {max(finishing):.6f} mm off a flank at most")


def path_of(trace_moves):
    """Places along all cuts, a tenth of a millimeter apart."""
    at, places = None, []
    for kind, m in trace_moves:
        end = (m["X"], m["Y"], m["Z"])
        if at and kind == "linear":
            n = max(1, int(dist(at, end) / 0.1))
            places += [tuple(a + (b - a) * i / n for a, b in zip(at, end)) for i in range(n + 1)]
        elif at and kind in ("arc-ccw", "arc-cw"):
            turn = 1 if kind == "arc-ccw" else -1
            x, y = at[0] + m["I"], at[1] + m["J"]
            r, first, last = hypot(m["I"], m["J"]), math.atan2(-m["J"], -m["I"]), math.atan2(end[1] - y, end[0] - x)
            expect(abs(hypot(end[0] - x, end[1] - y) - r) < 2e-3, "an arc ends on its circle")
            sweep = turn * (last - first) % (2 * pi)
            sweep = turn * (2 * pi if sweep < 1e-6 or sweep > 2 * pi - 1e-6 else sweep)
            n = max(1, int(r * abs(sweep) / 0.1))
            places += [(x + r * cos(first + sweep * i / n), y + r * sin(first + sweep * i / n), at[2] + (end[2] - at[2]) * i / n) for i in range(n + 1)]
        at = end
    return places


def left_of_floor(places, r, half, outside):
    """Where no place of the cutter's center is near enough: of a grid over the half sizes, inside by 0.02 mm."""
    cells = {}
    for x, y in places:
        cells.setdefault((x // r, y // r), []).append((x, y))
    step = max(half) / 60
    grid = [(step * i, step * j) for i in range(-60, 61) for j in range(-60, 61)]
    return [(x, y) for x, y in grid if outside(x, y) < -0.02
            and not any(dist((x, y), p) <= r + 0.02 for i in (-1, 0, 1) for j in (-1, 0, 1) for p in cells.get((x // r + i, y // r + j), ()))]


def floors(folder):
    """All of the floor is cut and nothing beyond the wall, also where the cutter is much smaller than what it clears."""
    rounded = lambda length, width, corner: lambda x, y: (
        hypot(max(abs(x) - length / 2 + corner, 0), max(abs(y) - width / 2 + corner, 0)) + min(max(abs(x) - length / 2, abs(y) - width / 2) + corner, 0) - corner)
    slot = lambda length, width: lambda x, y: hypot(max(abs(x) - length / 2, 0), y) - width / 2
    circle = lambda diameter: lambda x, y: hypot(x, y) - diameter / 2
    around = lambda outer, island: lambda x, y: max(outer(x, y), -island(x, y))
    cases = (("slot", 6, (35, 5), slot(60, 10), 8, ()),
             ("slot", 6, (55, 25), slot(60, 50), 3, ("slot_width=50 mm", "cutter_diameter=3 mm", "overlap=0.8")),
             ("slot", 6, (26, 25), slot(2, 50), 8, ("slot_length=2 mm", "slot_width=50 mm", "overlap=0.1")),
             ("round-pocket", 12, (30, 30), circle(60), 16, ()),
             ("round-pocket", 12, (30, 30), circle(60), 3, ("cutter_diameter=3 mm", "overlap=0.9")),
             ("round-pocket", 12, (30, 30), circle(60), 59.9, ("cutter_diameter=59.9 mm",)),
             ("island-pocket", 10, (50, 35), around(rounded(100, 70, 12), rounded(40, 20, 4)), 12, ()),
             ("island-pocket", 10, (50, 35), around(rounded(100, 70, 12), rounded(40, 20, 4)), 3, ("cutter_diameter=3 mm", "overlap=0.8")))
    for family, depth, half, outside, cutter, values in cases:
        for mode, print_mm in (("macro", MACRO_MM), ("explicit", EXPLICIT_MM)):
            places = path_of(trace(family, "haas-vf2", mode, folder, *values))
            r = cutter / 2
            over = max(outside(x, y) + r for x, y, z in places if z < -1e-6)
            expect(abs(over) <= print_mm, f"{family} {values}, {mode}: {over} beyond the wall")
            left = left_of_floor([place[:2] for place in places if place[2] < -depth + 1e-6], r, half, outside)
            expect(not left, f"{family} {values}, {mode}: the floor is left at {left[:5]}")
        print(f"{family} {' '.join(values)}: no more and no less")


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
            left = left_of_floor([place[:2] for place in places if place[2] < -12 + 1e-6], r, (length / 2, width / 2), outside)
            expect(not left, f"pocket {size}, {mode}: the floor is left at {left[:5]}")
        print(f"rectangular-pocket, {length} x {width}, corners of {corner} mm: no more and no less")


def main():
    with tempfile.TemporaryDirectory() as name:
        for shape in (ring, surface, nurbs_surface, worm, worm_by_points, pocket, floors):
            shape(pathlib.Path(name))


if __name__ == "__main__":
    main()
