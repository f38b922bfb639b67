# SPDX-License-Identifier: BSD-3-Clause
"""Figure 8: a sphere is dragged over rubber with friction. Does the normal force change?

In Palpate it does not change (section 3 of the paper); friction comes from the stored response or from one
stiffness. This is compared with frictional contact by CalculiX (Data/Studies/sliding): the case of the paper,
14 N on the 3.2 mm sphere, which is then deeper than the radius of its tip; a case in between; and a case
within small strain.
"""
import math
import pathlib

import numpy as np

import results
from body import curve, respond, square
from friction import MU, softness
from palpate import vtkToolContactProbe
from setting import RUBBER, contact_tool
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

CALCULIX = pathlib.Path(__file__).resolve().parents[3] / "Data" / "Studies" / "sliding"
POISSON = (0.3, 0.49)
# Radius and depth, mm, of the computed cases.
CASES = {"control": (6.35, 0.4), "mid": (1.6, 0.65), "deep": (1.6, 1.95885)}
COMPUTED = [("control", 0.3), ("control", 0.49), ("mid", 0.3), ("mid", 0.49), ("deep", 0.49)]
CENTRE = 4                                  # index of the point at the centre of the square


class Prediction:
    """Palpate's results for a tool at one depth: a normal force that friction does not change, and friction."""

    def __init__(self, radius, depth, poisson_ratio):
        self.specification, self.depth = "sphere:{:g}".format(radius), depth
        self.response = respond(square(), self.specification, depth, RUBBER, poisson_ratio)
        self.poisson_ratio = poisson_ratio
        self.normal = float(curve(self.response, CENTRE, depth))
        self.slides_after = MU * softness(poisson_ratio) * depth            # mm
        # Stiffness of the sticking contact: dF/dδ over c (Mindlin 1949).
        normal_stiffness = contact_tool(self.specification).GetStiffness(depth, RUBBER)
        self.stick_stiffness = normal_stiffness / softness(poisson_ratio)   # N/mm

    def shape_derived(self, places):
        return self.dragged(places, lambda probe: probe.SetFrictionModelToShapeDerived())

    def elasto_plastic(self, places):
        return self.dragged(places, lambda probe: probe.SetFrictionModelToElastoPlastic())

    def dragged(self, places, choose_model):
        """Returns the friction (N, on the body) along a path that begins at 0 under the pressed tool."""
        tips, way = vtkPolyData(), vtkCellArray()
        along = np.concatenate([[0.0], places])
        points = vtkPoints()
        points.SetDataTypeToDouble()
        way.InsertNextCell(len(along))
        for x in along:
            way.InsertCellPoint(points.InsertNextPoint(x, 0.0, -self.depth))
        tips.SetPoints(points)
        tips.SetLines(way)
        probe = vtkToolContactProbe()
        probe.SetInputData(self.response)
        probe.SetTipData(tips)
        probe.SetForceFormToNormalizedDirection()
        probe.SetContactSurfaceToFacets()
        probe.SetFrictionCoefficient(MU)
        probe.SetTangentialStiffness(self.stick_stiffness)
        probe.SetPoissonRatio(self.poisson_ratio)
        choose_model(probe)
        probe.Update()
        felt = vtk_to_numpy(probe.GetOutput().GetPointData().GetArray("FrictionForce"))
        return 0.0 - felt[1:, 0]


def legs(places):
    """Returns (number, start, stop) of the rows between the turns of a path that begins at 0."""
    bounds, direction = [0], 0.0
    for i, step in enumerate(np.sign(np.diff(places, prepend=0.0))):
        if step * direction < 0:
            bounds.append(i)
        direction = step or direction
    bounds.append(len(places))
    return [(i, a, b) for i, (a, b) in enumerate(zip(bounds[:-1], bounds[1:]))]


def computed(body, poisson_ratio):
    """Returns the columns of CalculiX from the end of the press on: leg, slide, normal force and friction; finite strain."""
    table = results.read_table(CALCULIX / "{}-nu{:g}-neohooke.csv".format(body, poisson_ratio))
    first = np.flatnonzero(table["leg"] == "press")[-1]
    return {name: column[first:] for name, column in table.items()}


def loop_loss(places, friction):
    """Returns the work of friction in a closed loop, N mm: twice the work from one turn to its mirror image, because the
    second half of the loop is symmetric to the first; NaN if the path ends earlier."""
    ways = legs(places)
    if len(ways) < 2 or not math.isclose(places[ways[1][2] - 1], -places[ways[1][1] - 1], rel_tol=1e-3):
        return math.nan
    part = slice(ways[1][1] - 1, ways[1][2])
    return float(2 * np.sum(0.5 * (friction[part][1:] + friction[part][:-1]) * np.diff(places[part])))


def compare(body, poisson_ratio, rows, summary):
    """Compares one computed case with the prediction: adds to both tables, prints, and returns the curves to draw."""
    found = computed(body, poisson_ratio)
    radius, depth = CASES[body]
    prediction = Prediction(radius, depth, poisson_ratio)
    places, normal, friction = found["slide_mm"], found["normal_N"], found["friction_N"]
    shape, plastic = prediction.shape_derived(places), prediction.elasto_plastic(places)
    change = normal / normal[0] - 1
    count = len(places)
    for name, values in (("case", [body] * count), ("nu", [poisson_ratio] * count),
                         ("leg", list(found["leg"])),
                         ("slide_mm", places), ("normal_calculix_N", normal), ("normal_change", change),
                         ("normal_palpate_N", [prediction.normal] * count), ("friction_calculix_N", friction),
                         ("friction_shape_derived_N", shape), ("friction_elasto_plastic_N", plastic)):
        rows.setdefault(name, []).extend(values)
    furthest = np.argmax(places)
    numbers = {
        "case": body, "nu": poisson_ratio, "radius_mm": radius, "depth_mm": depth,
        "depth_over_radius": depth / radius, "normal_palpate_N": prediction.normal, "normal_pressed_N": normal[0],
        "slid_to_mm": places[furthest], "slides_after_law_mm": prediction.slides_after,
        "friction_over_normal": friction[furthest] / normal[furthest], "change_there": change[furthest],
        "least_change": change.min(), "largest_change": change.max(),
        "friction_calculix_N": friction[furthest], "friction_shape_derived_N": shape[furthest],
        "friction_error_out": np.max(np.abs(friction - shape)[:furthest + 1]) / (MU * prediction.normal),
        "loop_calculix_Nmm": loop_loss(places, friction), "loop_shape_derived_Nmm": loop_loss(places, shape),
        "loop_elasto_plastic_Nmm": loop_loss(places, plastic)}
    for name, value in numbers.items():
        summary.setdefault(name, []).append(value)
    print("  {case}, nu = {nu}: depth {depth_over_radius:.2f} R, pressed {normal_pressed_N:.4f} N (Palpate "
          "{normal_palpate_N:.4f})\n    at {slid_to_mm:.3f} mm (law: slides after {slides_after_law_mm:.3f}) the "
          "normal force has changed by {change_there:+.2%} (all the way {least_change:+.2%} to "
          "{largest_change:+.2%})\n    friction is {friction_over_normal:.3f} of it, {friction_calculix_N:.3f} N "
          "(shape-derived {friction_shape_derived_N:.3f}, at worst {friction_error_out:.3f} of its limit "
          "off)".format(**numbers))
    if not math.isnan(numbers["loop_calculix_Nmm"]):
        print("    a loop takes {loop_calculix_Nmm:.4g} N mm (shape-derived {loop_shape_derived_Nmm:.4g}, "
              "elasto-plastic {loop_elasto_plastic_Nmm:.4g})".format(**numbers))
    return places, normal, friction


def make(folder, quick):
    rows, summary = {}, {}
    drawn = {case: compare(*case, rows, summary) for case in COMPUTED}
    results.write_table(folder / "figure8_sliding.csv", rows)
    results.write_table(folder / "figure8_summary.csv", summary)
    draw(folder, drawn)


TITLES = {"control": "12.7 mm sphere, 0.4 mm deep ($\\delta/R$ = 0.06)",
          "mid": "3.2 mm sphere, 0.65 mm deep ($\\delta/R$ = 0.41)",
          "deep": "the paper's: 3.2 mm sphere, 1.96 mm deep ($\\delta/R$ = 1.22)"}


def draw(folder, drawn):
    figure, panels = results.picture(3, 14.0, rows=2)
    if figure is None:
        return
    for column, (body, (radius, depth)) in enumerate(CASES.items()):
        loops, changes = panels[column], panels[3 + column]
        for nu, colour in zip(POISSON, ("#D55E00", "#0072B2")):
            prediction = Prediction(radius, depth, nu)
            end = 1.4 * prediction.slides_after     # the planned end of the CalculiX run
            way = np.concatenate([np.linspace(a, b, 100) for a, b in ((0, end), (end, -end), (-end, end))])
            loops.plot(way, prediction.shape_derived(way), "-", color=colour, linewidth=1.2,
                       label="Palpate, shape-derived, $\\nu$ = {}".format(nu))
            if nu == POISSON[-1]:
                loops.plot(way, prediction.elasto_plastic(way), ":", color="0.35", linewidth=1.2,
                           label="Palpate, elasto-plastic, $\\nu$ = {}".format(nu))
            if (body, nu) in drawn:
                places, normal, friction = drawn[body, nu]
                loops.plot(places, friction, "o", color=colour, fillstyle="none", markersize=4,
                           label="CalculiX, $\\nu$ = {}".format(nu))
                changes.plot(places, 100 * (normal / normal[0] - 1), "o-", color=colour, fillstyle="none",
                             markersize=4, linewidth=0.8, label="CalculiX, $\\nu$ = {}".format(nu))
        changes.axhline(0, color="black", linewidth=1.2, label="Palpate: unchanged")
        loops.set(xlabel="slide, mm", ylabel="friction, N", title=TITLES[body])
        changes.set(xlabel="slide, mm", ylabel="change of the normal force, %", xlim=loops.get_xlim())
        low, high = changes.get_ylim()
        changes.set_ylim(low, high + 0.5 * (high - low))
        changes.legend(loc="upper center", fontsize=7)
    # The legend is below the loop.
    panels[0].set_ylim(-3.7, None)
    panels[0].legend(loc="lower center", fontsize=7)
    results.save(figure, folder / "figure8_sliding.png")
