#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A rigid sphere that is pressed into rubber and dragged over it with friction, by CalculiX: makes Data/Studies/sliding.

  slide.py [--case NAME ...] [--output DIR] [--keep DIR] [--list]

Without --case all cases are solved, one after the other, some minutes each. Each case writes
DIR/NAME.csv. If CalculiX stops before the end of a case, the results so far are written, with a message.
Exit code 77 without `ccx` on the PATH, 1 if a case was not finished.

The sphere moves down to its depth, stays at this depth, and is dragged along x: to +u and, in one case, back to
-u and again to +u; u = 1.4 times the distance after which it slides in theory (μ c δ).
The models are half models, because the problem is symmetric about the plane y = 0.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass

import numpy as np

import deck
import mesh
import slide_mesh
import theory
from run import version

REDUCED_MODULUS = 3.45  # MPa: the rubber of Mahvash and Hayward 2002
FAR = 100.0             # mm: radius and height of the body, which is held at its side and base
LEGS = {"out": (0, 1), "back": (1, -1), "forth": (-1, 1)}  # x of the tool over u at start and end


@dataclass(frozen=True)
class Slide:
    body: str
    radius: float             # mm
    depth: float              # mm
    poisson_ratio: float
    legs: int = 2             # number of legs of the tool's path after the press
    friction: float = 0.5
    press_friction: float = 0.5
    first: float = 0.025      # first increment after a turn, as a fraction of u
    suffix: str = ""

    @property
    def name(self):
        return "{}-nu{:g}-neohooke{}".format(self.body, self.poisson_ratio, self.suffix)

    @property
    def contact_radius(self):
        return theory.half_space_contact_radius("sphere", self.radius, self.depth)

    @property
    def force(self):
        return theory.half_space_force("sphere", self.radius, REDUCED_MODULUS, self.depth)

    @property
    def reach(self):
        """The largest displacement u, mm."""
        c = (2 - self.poisson_ratio) / (2 - 2 * self.poisson_ratio)
        return 1.4 * self.friction * c * self.depth

    @property
    def contact_stiffness(self):
        """Contact stiffness, N/mm^3: the tool penetrates the surface by a thousandth of the depth."""
        return 1000 * self.force / (np.pi * self.contact_radius ** 2) / self.depth

    @property
    def stick_slope(self):
        """Stick slope, N/mm^3: it adds less than 1 % to the compliance of a sticking contact."""
        return 0.15 * self.contact_stiffness


# Radius and depth, mm. control: within small strain, a/R = 0.25; mid: beyond small strain, a/R = 0.62; deep: the case of the
# paper, 14 N on the half-space, deeper than R.
BODIES = {"control": (6.35, 0.4), "mid": (1.6, 0.65), "deep": (1.6, 1.95885)}
CONTROL = BODIES["control"]
CASES = {case.name: case for case in [
    Slide("control", *CONTROL, 0.3, legs=1), Slide("control", *CONTROL, 0.49, legs=3),
    # With the full friction during the press these cases hardly converge. The sphere starts to move with tiny increments.
    Slide("mid", *BODIES["mid"], 0.3, legs=1, press_friction=0.01, first=0.0005),
    Slide("mid", *BODIES["mid"], 0.49, legs=1, press_friction=0.01, first=0.002),
    Slide("deep", *BODIES["deep"], 0.3, legs=1, press_friction=0.01, first=0.0004),
    Slide("deep", *BODIES["deep"], 0.49, legs=1, press_friction=0.01),
    # The press without friction shows the error of mesh and support.
    Slide("control", *CONTROL, 0.3, legs=0, friction=0.0, press_friction=0.0, suffix="-frictionless"),
    Slide("control", *CONTROL, 0.49, legs=0, friction=0.0, press_friction=0.0, suffix="-frictionless")]}


def body_mesh(case):
    """Returns a mesh of the body, finest under the path of the contact; the contact surface is the part that the tool can
    reach."""
    a = case.contact_radius
    step = 0.24 * a
    rings = 0.35 * a + mesh.graded(step, 0.95 * a, FAR - 0.35 * a, 3)
    heights = mesh.graded(step, 2 * step, FAR, 3)
    body = slide_mesh.half_body(2, rings, -heights[::-1])
    radius = np.hypot(*body.points[:, :2].T)
    body.contact = [(e, face) for e, face in body.contact if np.min(radius[body.elements[e]]) < 1.313 * a]
    return body


def tool_mesh(case):
    """Returns a mesh of the tool: a cap twice as wide as the contact, or the lower half of the sphere and the shaft."""
    if case.radius > 2:
        return slide_mesh.half_tool(case.radius, 2.2 * np.arcsin(case.contact_radius / case.radius), 2, 2,
                                    0.1 * case.radius)
    return slide_mesh.half_tool(case.radius, 2.4, 2, 4, 0.1 * case.radius)


def write(case):
    """Returns the text of the deck and the number of nodes of the body."""
    body, tool = body_mesh(case), tool_mesh(case)
    points, radius = body.points, np.hypot(*body.points[:, :2].T)
    young = REDUCED_MODULUS * (1 - case.poisson_ratio ** 2)
    text = deck.nodes_and_elements(body, "C3D20R", "BODY", 1, 1)
    text += deck.material("BODY", "neohooke", young, case.poisson_ratio)
    text += "*SOLID SECTION, ELSET=EBODY, MATERIAL=BODY\n"
    text += deck.nodes_and_elements(tool, "C3D20R", "TOOL", len(points) + 1, len(body.elements) + 1)
    # Every node of the tool is prescribed, so its stiffness does not matter.
    text += "*NSET, NSET=TOOL\nNTOOL\n" + deck.material("TOOL", "linear", 100, 0.3)
    text += "*SOLID SECTION, ELSET=ETOOL, MATERIAL=TOOL\n"
    text += "*SURFACE INTERACTION, NAME=RUBBING\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{:g}\n".format(
        case.contact_stiffness)
    if case.friction > 0:
        text += rubbing(case, case.press_friction)
    text += "*CONTACT PAIR, INTERACTION=RUBBING, TYPE=SURFACE TO SURFACE\nSBODY, STOOL\n"
    fixed = np.isclose(points[:, 2], -FAR) | np.isclose(radius, FAR)
    text += deck.node_set("SUPPORT", fixed) + deck.node_set("YPLANE", np.isclose(points[:, 1], 0) & ~fixed)
    text += "*BOUNDARY\nSUPPORT, 1, 3\nYPLANE, 2, 2\nTOOL, 1, 2\n"
    # An increment of the press is at most a tenth of the radius.
    press = min(1 / 4, 0.1 * case.radius / case.depth)
    text += step(case, press, press, 3, -case.depth)
    change = "*CHANGE FRICTION, INTERACTION=RUBBING\n" + rubbing(case, case.friction)
    # The first increment after a turn of the tool converges only if it is small.
    for start, end in list(LEGS.values())[:case.legs]:
        text += step(case, case.first / abs(end - start), 1 / 8 / abs(end - start), 1, end * case.reach,
                     change if start == 0 and case.press_friction != case.friction else "")
    return text, len(points)


def rubbing(case, coefficient):
    return "*FRICTION\n{:g}, {:g}\n".format(coefficient, case.stick_slope)


def step(case, first, largest, direction, displacement, change=""):
    return ("*STEP, INC=400, NLGEOM\n{}*STATIC\n{:g}, 1, 1e-4, {:g}\n".format(change, first, largest) +
            # Residuals of 0.1 % of the force. The default compares with a mean over the many
            # unloaded nodes.
            "*CONTROLS, PARAMETERS=FIELD\n0.005, 0.01, {0:g}, {0:g}, 0.02, 1e-5, 1e-3, 1e-8\n".format(
                0.2 * case.force) +
            "*BOUNDARY\nTOOL, {0}, {0}, {1:g}\n".format(direction, displacement) +
            "*NODE PRINT, NSET=TOOL, TOTALS=ONLY\nRF\n*NODE PRINT, NSET=SUPPORT, TOTALS=ONLY\nRF\n*END STEP\n")


def read(text, case):
    """Returns rows (leg, depth mm, slide mm, normal force N, friction N) from the tables that CalculiX prints: the forces of
    the tool on the whole body, from the reactions of the support."""
    totals = {"TOOL": [], "SUPPORT": []}
    for name, *numbers in re.findall(
            r"total force \(fx,fy,fz\) for set (\w+) and time" + 4 * r"\s+(\S+)", text):
        totals[name].append([float(number) for number in numbers])
    rows, legs = [("press", 0.0, 0.0, 0.0, 0.0)], list(LEGS.items())
    for tool, held in zip(totals["TOOL"], totals["SUPPORT"]):
        moment, drag, _, normal = held * np.array([1, -2, 2, 2])
        # Some residual is allowed, but the unbalanced force must be small compared with the force.
        apart = 2 * max(abs(tool[1] + held[1]), abs(tool[3] + held[3]))
        if apart > 0.01 * case.force:
            raise ValueError("{}: tool and support differ by {:.2g} N".format(case.name, apart))
        if moment <= 1 + 1e-9:
            row = ("press", moment * case.depth, 0.0, normal, drag)
        else:
            number = min(int(np.ceil(moment - 1 - 1e-6)), len(legs)) - 1
            leg, (start, end) = legs[number]
            row = (leg, case.depth, case.reach * (start + (moment - 1 - number) * (end - start)), normal, drag)
        # CalculiX may end a step with an increment of almost zero length.
        if rows[-1][0] == row[0] and np.allclose(rows[-1][1:3], row[1:3], atol=1e-5 * case.depth):
            rows.pop()
        rows.append(row)
    return rows


def finished(case, rows):
    """Whether the last row is at the end of the tool's path."""
    last, (_, end) = [("press", (0, 0)), *LEGS.items()][case.legs]
    return rows[-1][0] == last and np.allclose(rows[-1][1:3], (case.depth, end * case.reach), rtol=1e-4)


def solve(case, folder):
    """Returns the rows of read(), number of nodes of the body, computing time in s, and the last output of CalculiX."""
    text, nodes = write(case)
    job = folder / case.name
    pathlib.Path(str(job) + ".inp").write_text(text)
    start = time.monotonic()
    answer = subprocess.run(["ccx", "-i", job.name], cwd=folder, capture_output=True, text=True)
    pathlib.Path(str(job) + ".log").write_text(answer.stdout + answer.stderr)
    table = pathlib.Path(str(job) + ".dat")
    rows = read(table.read_text() if table.exists() else "", case)
    return rows, nodes, time.monotonic() - start, " ".join(answer.stdout.strip().split("\n")[-3:])


def write_curve(path, case, rows, nodes):
    head = [
        "origin: CalculiX {}, finite elements, made by Testing/Studies/calculix/slide.py".format(version()),
        "tool: sphere:{:g}, rigid".format(case.radius),
        "body: half-space (cylinder, radius and height {:g} mm, held at side and base)".format(FAR),
        "material: compressible Neo-Hooke, finite strain, E* = {:g} MPa, nu = {:g}".format(
            REDUCED_MODULUS, case.poisson_ratio),
        "friction: Coulomb, {:g}, {:g} during the press; contact stiffness {:.4g} N/mm^3, stick slope {:.4g} "
        "N/mm^3".format(case.friction, case.press_friction, case.contact_stiffness, case.stick_slope),
        "mesh: C3D20R, half model, {} nodes".format(nodes),
        "end: " + ("of the way" if finished(case, rows) else "CalculiX was stopped or gave up here")]
    with open(path, "w", encoding="utf-8") as out:
        out.writelines("# {}\n".format(line) for line in head)
        out.write("leg,depth_mm,slide_mm,normal_N,friction_N\n")
        # Without friction, and until the tool moves sideways, the sideways force is round-off.
        out.writelines("{},{:.6g},{:.6g},{:.6g},{:.6g}\n".format(
            *row[:4], row[4] if abs(row[4]) > 1e-6 * case.force else 0.0) for row in rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--case", nargs="+", metavar="NAME", choices=list(CASES), default=list(CASES))
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("."))
    parser.add_argument("--keep", type=pathlib.Path, help="folder for decks and CalculiX's files")
    parser.add_argument("--list", action="store_true")
    arguments = parser.parse_args()
    if arguments.list:
        print("\n".join(CASES))
        return 0
    if shutil.which("ccx") is None:
        print("slide.py: no ccx on the PATH (Debian: calculix-ccx)", file=sys.stderr)
        return 77
    arguments.output.mkdir(parents=True, exist_ok=True)
    failed = 0
    with tempfile.TemporaryDirectory() as scratch:
        folder = arguments.keep or pathlib.Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        for name in arguments.case:
            case = CASES[name]
            try:
                rows, nodes, seconds, words = solve(case, folder)
            except (OSError, ValueError) as reason:
                print("slide.py: error:", reason, file=sys.stderr, flush=True)
                failed += 1
                continue
            write_curve(arguments.output / (name + ".csv"), case, rows, nodes)
            print("{}: {} nodes, {:.0f} s, {} rows".format(name, nodes, seconds, len(rows)), flush=True)
            if not finished(case, rows):
                print("slide.py: error: {}: ended at {:.4g} mm of depth, {:.4g} mm of slide ({}): {}".format(
                    name, rows[-1][1], rows[-1][2], rows[-1][0], words), file=sys.stderr, flush=True)
                failed += 1
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
