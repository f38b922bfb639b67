# SPDX-License-Identifier: BSD-3-Clause
"""Figure 5: three tools on rubber that deflects as a whole.

The paper states neither size nor support of its sample. Two samples are assumed: the plate on edges of the
CalculiX study and a longer, narrower strip, both 6 mm thick and supported along two end faces. The
compliance C_g comes from vtkElasticCompliance; it is in series with the half-space law of each tool.
"""
import collections
import pathlib

import numpy as np

import results
from body import add_array, curve, material, press, respond, square
from palpate import vtkContactRegime, vtkElasticCompliance
from setting import FLAT, LARGE, RUBBER, SMALL, SPEED, TOOLS, contact_tool, half_space_depth
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkPolyData, vtkUnstructuredGrid

CALCULIX = pathlib.Path(__file__).resolve().parents[3] / "Data" / "Studies" / "calculix"
POISSON, THICKNESS = 0.45, 6.0                      # as in the CalculiX study; mm
Body = collections.namedtuple("Body", "name length width")
PLATE, STRIP = Body("plate", 60.0, 40.0), Body("strip", 100.0, 30.0)
BODIES = (PLATE, STRIP)
DEPTH = 3.0                                         # mm, half the thickness
NEARLY_ONE = 0.05                                   # fraction of the mean force: the paper's "almost identical"


def hexahedra(body, spacing, layers):
    """Returns a plate about the origin below z = 0 whose two end faces are held along z."""
    counts = [2 * round(0.5 * body.length / spacing), 2 * round(0.5 * body.width / spacing), layers]
    x, y, z = (np.linspace(low, high, n + 1) for low, high, n in zip(
        (-0.5 * body.length, -0.5 * body.width, -THICKNESS), (0.5 * body.length, 0.5 * body.width, 0), counts))
    grid = np.stack(np.meshgrid(x, y, z, indexing="ij"), -1).reshape(-1, 3)
    ids = np.arange(len(grid)).reshape([n + 1 for n in counts])
    low, high = slice(None, -1), slice(1, None)
    corners = [ids[i, j, k] for k in (low, high)
               for i, j in ((low, low), (high, low), (high, high), (low, high))]
    fixed = np.where(np.abs(grid[:, 0]) > 0.5 * body.length - 1e-9, 4, 0)
    # The plate can slide and rotate freely. The fixed points are on the lines of symmetry, where no force acts on them.
    middle = ids[:, counts[1] // 2, 0]
    fixed[middle[counts[0] // 2]] |= 3
    fixed[middle[-1]] |= 2
    points = vtkPoints()
    points.SetData(numpy_to_vtk(grid, deep=1))
    mesh = vtkUnstructuredGrid()
    mesh.SetPoints(points)
    for cell in np.stack([c.ravel() for c in corners], -1):
        mesh.InsertNextCell(VTK_HEXAHEDRON, 8, cell.tolist())
    array = numpy_to_vtk(fixed.astype(np.uint8), deep=1)
    array.SetName("Fixed")
    mesh.GetPointData().AddArray(array)
    return mesh


def compliant_surface(body, quick):
    """Returns the surface of the rubber body with GlobalCompliance, and the point in the middle of its top."""
    elastic = vtkElasticCompliance()
    elastic.SetInputData(hexahedra(body, 2.0 if quick else 1.0, 3 if quick else 6))
    elastic.SetYoungsModulus(RUBBER * (1 - POISSON ** 2))
    elastic.SetPoissonRatio(POISSON)
    elastic.Update()
    surface = vtkPolyData()
    surface.ShallowCopy(elastic.GetOutput())
    middle = surface.FindPoint((0.0, 0.0, 0.0)) if surface.GetNumberOfPoints() else -1
    if middle < 0 or surface.GetPointData().GetArray("ComplianceStatus").GetTuple1(middle) != 0:
        raise RuntimeError("no compliance of the " + body.name)
    return surface, middle


def regime(responding, specification, depth):
    """Returns λ, sensitivity and verdict of each point."""
    judge = vtkContactRegime()
    judge.SetInputData(responding)
    judge.SetTool(contact_tool(specification))
    judge.SetDeflection(depth)
    material(judge, RUBBER, POISSON, compliance="GlobalCompliance")
    judge.Update()
    points = judge.GetOutput().GetPointData()
    return [vtk_to_numpy(points.GetArray(name)).copy()
            for name in ("RegimeIndex", "ToolSensitivity", "RegimeVerdict")]


def spread(forces):
    """Returns (largest - smallest) / mean of the three tools' forces at equal depth."""
    return np.ptp(forces, axis=0) / np.mean(forces, axis=0)


def make(folder, quick):
    depths = np.linspace(0.0, DEPTH, 13 if quick else 61)[1:]
    curves, moves = {"delta_mm": depths}, {}
    verdicts = {name: [] for name in ("body", "compliance_mm_per_N", "compliance_times_modulus_per_mm", "tool",
                                      "delta_mm", "F_N", "lambda", "sensitivity", "verdict", "spread")}
    for body in BODIES:
        surface, middle = compliant_surface(body, quick)
        compliance = surface.GetPointData().GetArray("GlobalCompliance").GetTuple1(middle)
        forces = {}
        for tool in TOOLS:
            responding = respond(surface, tool.specification, DEPTH, RUBBER, POISSON,
                                 compliance="GlobalCompliance", samples=32)
            forces[tool] = curves["F_%s_%s_N" % (body.name, tool.key)] = curve(responding, middle, depths)
            judged = [values[middle] for values in regime(responding, tool.specification, DEPTH)]
            for name, value in zip(verdicts, (body.name, compliance, compliance * RUBBER, tool.key, DEPTH,
                                              forces[tool][-1], *judged)):
                verdicts[name].append(value)
            print("  {}, {}: {:.5f} N at {:g} mm, lambda {:.4f}, sensitivity {:.4f}, verdict {:g}".format(
                body.name, tool.key, forces[tool][-1], DEPTH, *judged))
            if body is STRIP and tool is LARGE:
                # The tip remains above the middle surface, so that it does not come near the other side.
                moves[tool] = press(respond(surface, tool.specification, DEPTH, RUBBER, POISSON,
                                            compliance="GlobalCompliance"), 0.8 * DEPTH, 0.5)
        apart = curves["spread_%s" % body.name] = spread(list(forces.values()))
        verdicts["spread"] += [apart[-1]] * len(TOOLS)
        print("  {}: C_g = {:.4f} mm/N, C_g E* = {:.4f} /mm, forces {:.1f} % apart at {:g} mm".format(
            body.name, compliance, compliance * RUBBER, 100 * apart[-1], DEPTH))
    results.write_table(folder / "figure5_curves.csv", curves)
    results.write_table(folder / "figure5_regime.csv", verdicts)
    time, displacement, force = (column[::20] for column in moves[LARGE])
    results.write_table(folder / "figure5_trajectory.csv", {
        "time_s": time, "displacement_mm": displacement, "force_%s_N" % LARGE.key: force})
    swept = sweep(folder, quick)
    computed = {material_: from_calculix(material_) for material_ in ("linear", "neohooke")}
    write_comparison(folder, curves, computed)
    draw(folder, curves, verdicts, moves, swept, computed)


def sweep(folder, quick):
    """Computes the spread over λ at DEPTH on one body with a different compliance at each point."""
    side = 6 if quick else 11
    body = square(side)
    products = np.concatenate([[0.0], np.geomspace(0.05, 200.0, side * side - 1)])      # C_g E*, 1/mm
    add_array(body, "GlobalCompliance", products / RUBBER)
    table, forces = {"compliance_times_modulus_per_mm": products}, []
    for tool in TOOLS:
        responding = respond(body, tool.specification, DEPTH, RUBBER, POISSON, compliance="GlobalCompliance")
        forces.append(curve(responding, np.arange(len(products)), DEPTH))
        index, _, verdict = regime(responding, tool.specification, DEPTH)
        table["lambda_" + tool.key], table["verdict_" + tool.key] = index, verdict
    table["spread"] = spread(forces)
    results.write_table(folder / "figure5_spread.csv", table)
    apart = table["spread"]
    print("  forces within {:g} % of each other at {:g} mm from C_g E* = {:.3g} /mm, lambda = {}".format(
        100 * NEARLY_ONE, DEPTH, np.interp(-NEARLY_ONE, -apart, products),
        ", ".join("%.3f (%s)" % (np.interp(-NEARLY_ONE, -apart, table["lambda_" + tool.key]), tool.key)
                  for tool in TOOLS)))
    suffices = np.all([table["verdict_" + tool.key] == 2 for tool in TOOLS], axis=0)
    first = np.argmax(suffices)
    print("  a point force suffices for all three from C_g E* = {:.3g} /mm, forces {:.1f} % apart".format(
        products[first], 100 * apart[first]))
    table["point_force_suffices"] = suffices.astype(float)
    return table


def from_calculix(kind):
    """Returns depths, and forces of the plate on edges by tool, scaled from E = 0.1 MPa to the rubber's modulus."""
    forces = {}
    for tool, name in ((LARGE, "sphere6.35"), (FLAT, "flat1.6"), (SMALL, "sphere1.6")):
        table = results.read_table(CALCULIX / "plateedges-{}-{}.csv".format(name, kind))
        forces[tool] = table["force_N"] * RUBBER * (1 - POISSON ** 2) / 0.1
    return table["deflection_mm"], forces


def write_comparison(folder, curves, computed):
    columns = {"material": [], "tool": [], "delta_mm": [], "F_calculix_N": [], "F_series_N": [],
               "lambda_calculix": []}
    for kind, (depths, forces) in computed.items():
        for tool in TOOLS:
            kernel = contact_tool(tool.specification)
            series = np.interp(depths, curves["delta_mm"], curves["F_plate_%s_N" % tool.key])
            columns["material"] += [kind] * len(depths)
            columns["tool"] += [tool.key] * len(depths)
            columns["delta_mm"] += list(depths)
            columns["F_calculix_N"] += list(forces[tool])
            columns["F_series_N"] += list(series)
            columns["lambda_calculix"] += [1 - half_space_depth(kernel, f) / d
                                           for f, d in zip(forces[tool], depths)]
            print("  plate, {}: series over CalculiX's {} {:.4f} at {:g} mm".format(
                tool.key, kind, series[-1] / forces[tool][-1], depths[-1]))
        print("  CalculiX, {}: forces {:.1f} % apart at {:g} mm".format(
            kind, 100 * spread(list(forces.values()))[-1], depths[-1]))
    results.write_table(folder / "figure5_calculix.csv", columns)


def draw(folder, curves, verdicts, moves, swept, computed):
    figure, panels = results.picture(2, 10.0, rows=2)
    if figure is None:
        return
    time, displacement, _ = moves[LARGE]
    panels[0].plot(time, displacement, color="black")
    panels[0].axhline(0, color="black", linewidth=0.8)
    panels[0].set(xlabel="time, s", ylabel="displacement into the body, mm",
                  title="Trajectory at {:g} mm/s, 12.7 mm sphere on the strip".format(SPEED))
    for panel, body in ((panels[1], STRIP), (panels[2], PLATE)):
        for tool in TOOLS:
            panel.plot(curves["delta_mm"], curves["F_%s_%s_N" % (body.name, tool.key)], tool.dash,
                       color=tool.colour, label=tool.name)
        panel.set(xlabel="deflection $\\delta$, mm", ylabel="force F, N", xlim=(0, 3.1), ylim=(0, None),
                  title="Assumed: {} {:g} × {:g} × {:g} mm".format(body.name, body.length, body.width, THICKNESS))
    for kind, mark in (("linear", "o"), ("neohooke", "x")):
        depths, forces = computed[kind]
        for tool in TOOLS:
            panels[2].plot(depths, forces[tool], mark, color=tool.colour, fillstyle="none", markersize=5)
        panels[2].plot([], [], mark, color="0.3", fillstyle="none",
                       label="CalculiX, " + ("linear" if kind == "linear" else "Neo-Hooke"))
    least = "lambda_" + SMALL.key
    panels[3].plot(swept[least], 100 * swept["spread"], color="black", label="series model")
    panels[3].axhline(100 * NEARLY_ONE, color="0.4", linewidth=0.8, linestyle="--")
    panels[3].axvspan(swept[least][np.argmax(swept["point_force_suffices"])], 1, color="#F0E442", alpha=0.4,
                      label="verdict: a point force suffices")
    for body, mark, colour in ((PLATE, "s", "#CC79A7"), (STRIP, "D", "#0072B2")):
        row = verdicts["body"].index(body.name) + TOOLS.index(SMALL)
        panels[3].plot(verdicts["lambda"][row], 100 * verdicts["spread"][row], mark, color=colour,
                       label=body.name)
    kernel = contact_tool(SMALL.specification)
    for kind, mark in (("linear", "o"), ("neohooke", "x")):
        depths, forces = computed[kind]
        panels[3].plot(1 - half_space_depth(kernel, forces[SMALL][-1]) / depths[-1],
                       100 * spread(list(forces.values()))[-1], mark, color="black", fillstyle="none",
                       label="plate by CalculiX, " + ("linear" if kind == "linear" else "Neo-Hooke"))
    panels[3].set(xlabel="$\\lambda$ of the 3.2 mm sphere, the least of the three",
                  ylabel="largest minus smallest force, % of mean", xlim=(0.4, 1), ylim=(0, 40),
                  title="How far apart the tools are at 3 mm")
    panels[2].set_ylim(0, 1.65)
    for panel in panels[1:3]:
        panel.legend(loc="upper left")
    panels[3].legend(loc="upper right")
    results.save(figure, folder / "figure5_rubber_on_edges.png")
