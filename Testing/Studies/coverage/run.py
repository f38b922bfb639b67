#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures how often the stated error of a force covers the true error, for each family of contacts.

Contacts are random: row of a reference table, size and stiffness of the body, rotation and position, place under the
tool, kind of mesh defect. The true force is that of the table (Data/Reference: closed forms, integral equations,
boundary elements, finite elements of other codes). Palpate receives the body as a mesh through its Python package, and
returns force and stated error. A case is covered if the true error is at most the sum of the stated error, the error of
the table and 1e-6 (rounding of floats).

    run.py [--count N] [--seed S] [--output DIR] [--family NAME]

Writes cases.csv (one row per contact) and coverage.md (one row per family: cases, covered share, median stated and true
error, their ratio). Exit code 1 if a family is covered in less than 95 % of its cases.
"""
import argparse
import csv
import math
import sys
import warnings
from pathlib import Path

import numpy as np

import palpate

ROOT = Path(__file__).resolve().parents[3]
REFERENCE = ROOT / "Data" / "Reference"
ROUNDING = 1e-6
GOAL = 0.95
RATIO = 3.0                      # largest allowed ratio of the median stated error to the median true error


def rows(name):
    with open(REFERENCE / name, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def matrix(name):
    """Returns (row values, column values, numbers) of a table whose first row contains the column values."""
    with open(REFERENCE / name, newline="", encoding="utf-8") as file:
        table = list(csv.reader(file))
    return ([float(row[0]) for row in table[1:]], [float(value) for value in table[0][1:]],
            np.array([[float(value) for value in row[1:]] for row in table[1:]]))


# Bodies, each as points and triangles. The place of the press is the origin; its outward normal is +z.

def plate(half):
    """A square about the origin with sides of 2 `half`, finer towards the origin; it represents an infinite plane."""
    steps = np.linspace(-1, 1, 41)
    x = half * np.sign(steps) * np.abs(steps) ** 1.5
    points = np.array([[a, b, 0.0] for b in x for a in x])
    n = len(x)
    first = np.array([i + n * j for j in range(n - 1) for i in range(n - 1)])
    return points, np.vstack([np.column_stack([first, first + 1, first + n + 1]),
                              np.column_stack([first, first + n + 1, first + n])])


def block(side):
    """A cube with its upper face in z = 0; the edge x = 0 bounds this face."""
    grid = np.linspace(0, 1, 9)
    points, triangles, number = [], [], {}

    def corner(place):
        key = tuple(np.round(place, 9))
        if key not in number:
            number[key] = len(points)
            points.append(place)
        return number[key]

    for axis in range(3):
        for end in (0, 1):
            for i in range(8):
                for j in range(8):
                    quad = []
                    for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                        place = np.zeros(3)
                        place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3] = end, grid[a], grid[b]
                        quad.append(corner(place))
                    quad = quad if end else quad[::-1]
                    triangles += [[quad[0], quad[1], quad[2]], [quad[0], quad[2], quad[3]]]
    return (np.array(points) - [1.0, 0.5, 1.0]) * side, np.array(triangles)


def ball(radius):
    """A sphere whose top is at the origin: an icosahedron, refined five times and rotated so that a point is at the top."""
    golden = (1 + 5 ** 0.5) / 2
    corners = [[-1, golden, 0], [1, golden, 0], [-1, -golden, 0], [1, -golden, 0], [0, -1, golden], [0, 1, golden],
               [0, -1, -golden], [0, 1, -golden], [golden, 0, -1], [golden, 0, 1], [-golden, 0, -1], [-golden, 0, 1]]
    faces = [[0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4], [11, 10, 2], [10, 7, 6],
             [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10],
             [8, 6, 7], [9, 8, 1]]
    points = [np.array(c) / np.linalg.norm(c) for c in corners]
    for _ in range(5):
        middle, finer = {}, []

        def between(a, b):
            key = (min(a, b), max(a, b))
            if key not in middle:
                middle[key] = len(points)
                half = points[a] + points[b]
                points.append(half / np.linalg.norm(half))
            return middle[key]

        for a, b, c in faces:
            ab, bc, ca = between(a, b), between(b, c), between(c, a)
            finer += [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
        faces = finer
    pole = points[0]
    side = np.cross(pole, [1.0, 0, 0])
    side /= np.linalg.norm(side)
    turn = np.array([side, np.cross(pole, side), pole])
    points = radius * (np.array(points) @ turn.T) - [0, 0, radius]
    return points, np.array(faces)


def cavity(radius):
    """A spherical hole in a ball with forty times the radius; the origin is the lowest point of the hole."""
    hole, faces = ball(radius)
    outside, more = ball(40 * radius)
    return (np.vstack([-hole, outside + [0, 0, 41 * radius]]), np.vstack([faces, more + len(hole)]))


# Defects of a mesh that do not change the shape.

def damaged(points, triangles, kind, random):
    if kind == "seam":                       # some triangles have separate points
        strip = random.random(len(triangles)) < 0.2
        extra = triangles[strip].ravel()
        triangles = triangles.copy()
        triangles[strip] = len(points) + np.arange(len(extra)).reshape(-1, 3)
        points = np.vstack([points, points[extra]])
    elif kind == "flipped":
        triangles = triangles.copy()
        flipped = random.random(len(triangles)) < 0.1
        triangles[flipped] = triangles[flipped][:, ::-1]
    elif kind == "repeated":
        again = random.random(len(triangles)) < 0.05
        triangles = np.vstack([triangles, triangles[again]])
    elif kind == "shuffled":
        order = random.permutation(len(points))
        place = np.empty_like(order)
        place[order] = np.arange(len(order))
        points, triangles = points[order], place[triangles][random.permutation(len(triangles))]
    return points, triangles


DEFECTS = ("sound", "seam", "flipped", "repeated", "shuffled")


def turned(random):
    q, r = np.linalg.qr(random.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else q[:, ::-1]


class Case:
    """One contact: a body in its own frame, the tool that is pressed into it, and the true force."""

    def __init__(self, body, tool, depth, true, *, site=(0.0, 0.0, 0.0), own=0.0, axis=None, second=None, way=None,
                 deepest=0.0, **response):
        self.body, self.tool, self.depth, self.true = body, tool, depth, true
        self.site, self.own, self.axis, self.second, self.way = np.array(site), own, axis, second, way
        self.deepest = max(depth, deepest)   # depth of the tool's deepest point below the surface
        self.response = response

    def felt(self, random, defect):
        """Returns force and stated error for the body after a rotation, a translation and a mesh defect."""
        points, triangles = damaged(*self.body, defect, random)
        turn, shift = turned(random), random.uniform(-200, 200, 3)

        def placed(place):
            return np.asarray(place, float) @ turn.T + shift

        with warnings.catch_warnings():
            warnings.simplefilter("ignore", RuntimeWarning)
            body = palpate.response((placed(points), triangles), self.tool, maximum_deflection=1.05 * self.deepest,
                                    coupling=self.second is not None, **self.response)
            down = np.array([0, 0, -self.depth])
            axis = None if self.axis is None else np.asarray(self.axis) @ turn.T
            if self.second is not None:
                probe = palpate.probe(body, placed([self.site + down, self.second]), coupled=True)
                return float(probe.normal_force[0]), float(probe.error[0])
            if self.way is not None:
                probe = palpate.probe(body, placed(self.way), path=True)
                return float(probe.normal_force[-1]), float(probe.error[-1])
            probe = palpate.probe(body, placed([self.site + down]), axis=axis)
        force = float(np.linalg.norm(probe.forces[0])) if axis is None else float(probe.normal_force[0])
        return force, float(probe.error[0])


def scales(random):
    """Returns a random length (mm) and Young's modulus (MPa), the scales of a case."""
    return 10 ** random.uniform(-0.3, 0.7), 10 ** random.uniform(-2.5, 0.5)


def reduced(young, poisson):
    return young / (1 - poisson ** 2)


# Families. Each function returns a random Case.

def half_space(random):
    """Tools on a half-space in closed form: Hertz, Sneddon, Galin."""
    length, young = scales(random)
    poisson = random.uniform(0.2, 0.5)
    star = reduced(young, poisson)
    kind = random.choice(["paraboloid", "flat", "cone", "power"])
    # The presses are shallow, because errors of small strain are tested by another family.
    if kind == "paraboloid":
        depth = length * 10 ** random.uniform(-4, -2.3)
        true = 4 / 3 * star * math.sqrt(length) * depth ** 1.5
        tool = f"paraboloid:{length!r}"
    elif kind == "flat":
        depth = length * 10 ** random.uniform(-4, -2)
        true, tool = 2 * star * length * depth, f"flat:{length!r}"
    elif kind == "cone":
        angle = random.uniform(75, 85)
        depth = 0.1 * length * random.uniform(0.1, 1)
        true = 2 / math.pi * star * math.tan(math.radians(angle)) * depth ** 2
        tool = f"cone:{angle!r}"
    else:
        depth = length * random.uniform(0.05, 0.15)
        exponent = random.uniform(2, 4)
        coefficient = 0.3 * length / length ** exponent
        factor = coefficient * exponent * math.sqrt(math.pi) / 2 * math.gamma(exponent / 2) / math.gamma((exponent + 1) / 2)
        a = (depth / factor) ** (1 / exponent)
        true = 2 * star * depth * a * exponent / (exponent + 1)
        tool = f"power:{exponent!r},{coefficient!r}"
    return Case(plate(60 * length), tool, depth, true, young=young, poisson=poisson)


def layer(random):
    """Bonded and slipping layers: integral equation of another code."""
    length, young = scales(random)
    kind = random.choice(["flat", "paraboloid", "cone"])
    bonded = random.random() < 0.7
    if bonded:
        ratios, columns, table = matrix({"flat": "layer_bonded_flat_kappa.csv", "paraboloid": "layer_bonded_sphere_ratio.csv",
                                         "cone": "layer_bonded_cone_ratio.csv"}[kind])
        i = random.integers(len(ratios))
        j = random.integers(max(1, sum(c <= 1.0 for c in columns)))
        poisson, x, factor = ratios[i], columns[j], table[i, j]
    else:
        poisson = random.uniform(0.1, 0.5)
        if kind == "flat":
            columns, table = slip_flat()
            j = random.integers(sum(c <= 1.0 for c in columns))
            x, factor = columns[j], table[j]
        else:
            found = [r for r in rows("layer_slip_sphere_cone_ratio.csv") if float(r["chi_or_eta"]) <= 1.0]
            row = found[random.integers(len(found))]
            x, factor = float(row["chi_or_eta"]), float(row["sphere" if kind == "paraboloid" else "cone"])
    star = reduced(young, poisson)
    if kind == "flat":
        thickness = length / x
        depth = 0.01 * min(length, thickness)
        true, tool = factor * 2 * star * length * depth, f"flat:{length!r}"
    elif kind == "paraboloid":
        thickness = length
        radius = random.uniform(30, 300) * length * max(1.0, x)
        depth = (x * thickness) ** 2 / radius
        true, tool = factor * 4 / 3 * star * math.sqrt(radius) * depth ** 1.5, f"paraboloid:{radius!r}"
    else:
        thickness, angle = length, random.uniform(80, 88)
        depth = x * thickness / math.tan(math.radians(angle))
        true = factor * 2 / math.pi * star * math.tan(math.radians(angle)) * depth ** 2
        tool = f"cone:{angle!r}"
    return Case(plate(60 * max(length, thickness)), tool, depth, true, young=young, poisson=poisson, layer=thickness,
                base="bonded" if bonded else "slip")


def slip_flat():
    with open(REFERENCE / "layer_slip_flat_kappa.csv", newline="", encoding="utf-8") as file:
        table = list(csv.reader(file))
    return [float(x) for x in table[0][1:]], [float(x) for x in table[1][1:]]


def stack(random):
    """Two and three layers, on a rigid base or a half-space, bonded or slipping: integral equation of another code."""
    length, young = scales(random)
    found = [r for r in rows("deep/stack_force_ratio.csv") if r["tool"] != "cone 60"]
    row = found[random.integers(len(found))]
    definition = next(r for r in rows("deep/stack_definitions.csv") if r["stack"] == row["stack"])
    layers = [words.split() for words in definition["layers (h E nu [slip interface above])"].split("|")]
    first, *deeper = [(float(h) * length, float(e) * young, float(nu), *(True for _ in slip)) for h, e, nu, *slip in layers]
    base = definition["base"]
    if base != "rigid":
        modulus, ratio = base.strip("()").split(",")
        base = ("elastic", float(modulus) * young, float(ratio))
    thickness, modulus, poisson = first[:3]
    star, value = reduced(modulus, poisson), float(row["value"])
    if row["tool"] == "flat":
        radius = value * thickness
        depth, tool = 0.01 * min(radius, thickness), f"flat:{radius!r}"
        alone = 2 * star * radius * depth
    else:
        radius, depth = float(row["tool"].split("=")[1]) * thickness, value * thickness
        tool = f"paraboloid:{radius!r}"
        alone = 4 / 3 * star * math.sqrt(radius) * depth ** 1.5
    return Case(plate(60 * max(radius, thickness)), tool, depth, float(row["F_over_F_halfspace_of_top_layer"]) * alone,
                own=1e-4, young=modulus, poisson=poisson, layer=thickness, layers=deeper,
                base="bonded" if base == "rigid" else base)


def finite_strain(random):
    """Neo-Hookean half-spaces and bonded layers under a sphere: finite elements of another code, 0.5 %."""
    length, young = scales(random)
    if random.random() < 0.5:
        found = [r for r in rows("deep/finite_sphere_halfspace.csv") if float(r["nu"]) >= 0.3]
        row = found[random.integers(len(found))]
        poisson, depth, thickness = float(row["nu"]), float(row["delta_over_R"]) * length, None
    else:
        found = [r for r in rows("deep/finite_layer_sphere.csv") if float(r["delta_over_h"]) <= 0.3]
        row = found[random.integers(len(found))]
        poisson, thickness = float(row["nu"]), float(row["h_over_R"]) * length
        depth = float(row["delta_over_h"]) * thickness
    true = float(row["F_over_EstarR2"]) * reduced(young, poisson) * length ** 2
    return Case(plate(60 * length), f"sphere:{length!r}", depth, true, own=0.005, young=young, poisson=poisson,
                layer=thickness, strain=random.choice(["neohooke", "small"]))


def curvature(random):
    """A sphere on a ball and in a cavity: finite elements, 0.5 %."""
    length, young = scales(random)
    found = [r for r in rows("deep/curvature_sphere_on_ball.csv") if abs(float(r["Rb_over_R(negative: cavity)"])) >= 1.5]
    row = found[random.integers(len(found))]
    over, poisson = float(row["Rb_over_R(negative: cavity)"]), float(row["nu"])
    depth = float(row["delta_over_R"]) * length
    return Case((ball if over > 0 else cavity)(abs(over) * length), f"sphere:{length!r}", depth, float(row["F_fe_over_E"]) * young * length ** 2,
                own=0.005, young=young, poisson=poisson, curvature=bool(random.random() < 0.7))


TILTED = {"cone45": "cone:45", "cone60": "cone:60", "cone70": "cone:70", "flat": "flat:{0!r}", "blunt45": "blunted:{0!r},45",
          "blunt60": "blunted:{0!r},60", "trunc45": "truncated:{0!r},45", "trunc60": "truncated:{0!r},60",
          "round0_25": "rounded:{0!r},{1!r}"}


def tilt(random):
    """Tilted tools on a half-space and on bonded layers: boundary elements."""
    length, young = scales(random)
    upright = rows("tilt/tilt_bem.csv")
    lowest = {(row["tool"], float(row["theta_deg"])): float(row["z_deepest"]) for row in upright}
    is_layer = random.random() < 0.4
    found = [row for row in (rows("tilt/tilt_layer_nu0.45.csv") if is_layer else upright)
             if row["tool"] in TILTED and float(row["theta_deg"]) > 0 and (row["tool"], float(row["theta_deg"])) in lowest]
    row = found[random.integers(len(found))]
    name, degrees, poisson = row["tool"], float(row["theta_deg"]), 0.45 if is_layer else random.uniform(0.3, 0.5)
    angle, deepest = math.radians(degrees), float(row["D"]) * length
    # The table has the depth of the tool's deepest point; the probe has the depth of the tip, which is on the axis.
    depth = deepest + lowest[name, degrees] * length
    shallow = float(row["D"]) < 0.05             # for flat ends at smaller depths the error of the table is 1.8 %
    own = 4e-4 if name.startswith(("cone", "blunt")) else 0.018 if shallow else 0.004
    return Case(plate(60 * length), TILTED[name].format(length, 0.25 * length), depth,
                float(row["F_over_Estar"]) * reduced(young, poisson) * length ** 2, own=own,
                axis=(math.sin(angle), 0.0, math.cos(angle)), young=young, poisson=poisson,
                layer=float(row["h"]) * length if is_layer else None, tilt=degrees + 1.0, deepest=deepest)


def edge(random):
    """Tools near the straight edge of a block, reached along a path: Hetenyi's quarter spaces."""
    length, young = scales(random)
    found = [r for r in rows("edges/edge_law.csv") if float(r["m"]) in (1.0, 1.5) and float(r["u=d/a0"]) >= 0.0
             and float(r["u=d/a0"]) <= 4.0]
    row = found[random.integers(len(found))]
    poisson, m = float(row["nu"]), float(row["m"])
    star = reduced(young, poisson)
    if m == 1.0:
        tool, radius, depth = f"flat:{length!r}", length, 0.01 * length
        whole = 2 * star * length * depth
    else:
        depth = 0.002 * length
        tool, radius = f"paraboloid:{length!r}", math.sqrt(length * depth)
        whole = 4 / 3 * star * math.sqrt(length) * depth ** 1.5
    x = -float(row["u=d/a0"]) * radius
    start = -8.0 * radius
    way = [[start, 0, 0.1 * depth]] + [[start, 0, -depth * k / 10] for k in range(1, 11)]
    way += [[start + (x - start) * k / 400, 0, -depth] for k in range(1, 401)]
    return Case(block(200.0 * radius), tool, depth, float(row["Phi=F/F0"]) * whole, own=0.005, way=way,
                young=young, poisson=poisson, edges=True, curvature=bool(random.random() < 0.5))


def two_tools(random):
    """Two tools on one half-space: boundary elements, 0.2 %."""
    length, young = scales(random)
    found = [r for r in rows("tilt/two_contacts_halfspace.csv") if r["quantity"] in ("F/F0", "F1/F01", "F2/F02")
             and not (r["case"].startswith("flat") and float(r["r_over_a"]) < 2.0)]
    row = found[random.integers(len(found))]
    poisson = random.uniform(0.3, 0.5)
    star = reduced(young, poisson)
    over = float(row["r_over_a"])
    if row["case"].startswith("flat"):
        tool, radius, depths = f"flat:{length!r}", length, (0.01 * length, 0.01 * length)
        alone = 2 * star * length * depths[0]
    else:
        deep = 0.002 * length
        depths = (deep, deep if row["case"] == "sphere_d2=1" else 0.5 * deep)
        tool, radius = f"paraboloid:{length!r}", math.sqrt(length * deep)
        depths = depths if row["quantity"] != "F2/F02" else depths[::-1]
        alone = 4 / 3 * star * math.sqrt(length) * depths[0] ** 1.5
    return Case(plate(60 * length), tool, depths[0], float(row["BEM"]) * alone, own=0.002,
                second=(over * radius, 0.0, -depths[1]), deepest=max(depths), young=young, poisson=poisson)


FAMILIES = {"half-space": half_space, "layer": layer, "stack": stack, "finite strain": finite_strain, "curvature": curvature, "tilt": tilt,
            "edge": edge, "two tools": two_tools}


def draw(name, count, seed):
    random = np.random.default_rng([seed, sum(map(ord, name))])
    found = []
    while len(found) < count:
        case = FAMILIES[name](random)
        defect = DEFECTS[random.integers(len(DEFECTS))]
        try:
            force, stated = case.felt(random, defect)
        except ValueError:                       # refused with a reason, such as a tilt with a cone's flank on the body
            continue
        error = abs(force / case.true - 1.0)
        found.append({"family": name, "tool": case.tool, "defect": defect, "depth_mm": case.depth,
                      "poisson": case.response.get("poisson"), "true_N": case.true, "force_N": force,
                      "true_error": error, "stated_error": stated,
                      "covered": int(error <= stated + case.own + ROUNDING)})
    return found


def summary(cases):
    lines = ["| family | cases | covered | median stated | median true | stated over true |", "|---|---|---|---|---|---|"]
    for name in dict.fromkeys(case["family"] for case in cases):
        own = [case for case in cases if case["family"] == name]
        stated = float(np.median([case["stated_error"] for case in own]))
        true = float(np.median([case["true_error"] for case in own]))
        share = sum(case["covered"] for case in own) / len(own)
        lines.append(f"| {name} | {len(own)} | {100 * share:.1f} % | {100 * stated:.3g} % | {100 * true:.3g} % | "
                     f"{stated / true if true > 0 else math.inf:.2g} |")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=100, help="contacts of each family (default 100)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--output", type=Path, default=ROOT / "build" / "studies" / "coverage")
    parser.add_argument("--family", choices=sorted(FAMILIES), action="append", help="only this one; may be repeated")
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    cases = [case for name in arguments.family or FAMILIES for case in draw(name, arguments.count, arguments.seed)]
    with open(arguments.output / "cases.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, cases[0].keys())
        writer.writeheader()
        writer.writerows({key: f"{value:.6g}" if isinstance(value, float) else value for key, value in case.items()}
                         for case in cases)
    lines = summary(cases)
    (arguments.output / "coverage.md").write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(*lines, sep="\n")
    shares = {}
    for case in cases:
        shares.setdefault(case["family"], []).append(case["covered"])
    return 0 if all(np.mean(share) >= GOAL for share in shares.values()) else 1


if __name__ == "__main__":
    sys.exit(main())
