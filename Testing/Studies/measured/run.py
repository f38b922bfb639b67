#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Error of the force that is predicted for one tool from measurements with another tool.

    run.py CURVES_DIR OUTPUT.csv        (./run python Testing/Studies/measured/run.py ...)

CURVES_DIR contains curves BODY-TOOL-MATERIAL.csv of a finite-element code (Data/Studies/calculix). For each
body and material, vtkMeasuredContactResponse identifies the body from the curves of one or two tools. The force
of every other tool is predicted and compared with its curve by finite elements. This is done twice: with the
exact curves, counted from first contact, and with curves like those of an instrument, with noise of 1 % of the
largest force (fixed seed) and first contact at 0.15 mm, which must be found. 120 readings are taken from
each curve between its computed points; with noise, 20 readings before contact are added.

Each prediction has a row with the Validity of the predicted response (mm; 0 if the predicted tool is wider than
the measured contacts), the relative error of the force at that depth and at the full depth of the tool's curve,
where an error beyond Validity is expected, and the stated error at the full depth. Each refusal has a row with
its reason.
"""
import csv
import itertools
import math
import pathlib
import sys
import tempfile

import numpy
from palpate import contract, vtkContactTool, vtkMeasuredContactResponse
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource

TOOLS = ("sphere6.35", "sphere1.6", "flat1.6")
MEASURED_WITH = (("sphere6.35",), ("sphere1.6",), ("flat1.6",), ("sphere6.35", "flat1.6"))
POISSON = {"block": 0.45, "layer10": 0.45, "plateclamped": 0.3, "plateedges": 0.45}
E_STAR = {body: 0.1 / (1.0 - nu * nu) for body, nu in POISSON.items()}  # MPa, for E = 0.1
NOISE, OFFSET, READINGS, BEFORE = 0.01, 0.15, 120, 20
COLUMNS = ("body,material,measured_with,noise,verdict,model,reduced_modulus_MPa,from,to,true_MPa,compliance_mm_per_N,"
           "thickness_mm,misfit_share,tool,depth_mm,force_N,validity_mm,error_at_validity,error_at_depth,"
           "stated_error_at_depth").split(",")


def read(path):
    """Returns (deflection, force) of a file with one site."""
    lines = [line for line in path.read_text().splitlines() if not line.startswith("#")]
    rows = list(csv.DictReader(lines))
    return (numpy.array([float(row["deflection_mm"]) for row in rows]),
            numpy.array([float(row["force_N"]) for row in rows]))


def force_at(curve, depth):
    """Returns the force between the computed points: F/d^1.5 is interpolated over sqrt(d), nearly linear for these tools."""
    d, f = curve
    inside = numpy.maximum(depth, 1e-9)
    shape = numpy.interp(numpy.sqrt(inside), numpy.sqrt(d), f / d ** 1.5)
    first = f[0] * (inside / d[0]) ** (math.log(f[1] / f[0]) / math.log(d[1] / d[0]))
    return numpy.where(depth <= 0.0, 0.0, numpy.where(depth < d[0], first, shape * inside ** 1.5))


def write(path, tool, depth, force):
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"# tool: {specification(tool)}\n# synthetic: CalculiX\n")
        file.write("site,x_mm,y_mm,z_mm,deflection_mm,force_N\n")
        for d, f in zip(depth, force):
            file.write(f"centre,0,0,0,{d:.17g},{f:.17g}\n")


def specification(tool):
    name = tool.rstrip("0123456789.")
    return f"{name}:{tool[len(name):]}"


def plane():
    source = vtkPlaneSource()
    source.SetOrigin(-50, -50, 0)
    source.SetPoint1(50, -50, 0)
    source.SetPoint2(-50, 50, 0)
    source.SetResolution(40, 40)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    return triangles


class Identification:
    """A body identified from the curves of some tools, with predictions for other tools."""

    def __init__(self, files, poisson, find_contact):
        self.body = plane()
        self.filter = vtkMeasuredContactResponse()
        self.filter.SetInputConnection(self.body.GetOutputPort())
        for file in files:
            self.filter.AddFileName(str(file))
        self.filter.SetPoissonRatio(poisson)
        self.filter.SetFindContact(find_contact)
        self.refusal = ""
        self.filter.AddObserver("ErrorEvent", self.keep)
        self.filter.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)

    def keep(self, _, event, text="", *more):
        self.refusal = text.split("'centre': ", 1)[-1].strip().rstrip(".") or event

    keep.CallDataType = "string0"

    def feel(self, tool, depth):
        """Returns (response, its validity, its stated error at the end) of a tool to a depth; None after an error."""
        kernel = vtkContactTool()
        kernel.SetSpecification(specification(tool))
        self.filter.SetTool(kernel)
        self.filter.SetMaximumDeflection(depth)
        self.filter.Update()
        output = self.filter.GetOutput()
        if self.refusal or output.GetNumberOfPoints() == 0:
            return None
        middle = output.FindPoint(0.0, 0.0, 0.0)
        response = contract.load(output)
        validity = output.GetPointData().GetArray("ResponseValidity").GetTuple1(middle)
        stated = output.GetPointData().GetArray("ResponseError").GetTuple(middle)[-1]
        return lambda d: contract.evaluate(response, middle, d)[0], validity, stated

    def site(self, column):
        table = self.filter.GetOutputDataObject(1)
        values = table.GetColumnByName(column)
        return values.GetValue(0) if values else ""


def number(value, digits=4):
    return "" if value == "" or (isinstance(value, float) and math.isnan(value)) else f"{value:.{digits}g}"


def predict(curves, names, case, noise, folder):
    """Returns the rows of one identification."""
    body, material = case
    files = []
    for k, name in enumerate(names):
        depth = numpy.linspace(0.0, curves[name][0][-1], READINGS + 1)
        if noise:
            depth = numpy.concatenate([depth[1] * numpy.arange(-BEFORE, 0), depth])
        force = force_at(curves[name], depth)
        if noise:
            random = numpy.random.default_rng([2002, k])
            force = force + NOISE * force.max() * random.standard_normal(len(force))
            depth = depth + OFFSET
        files.append(folder / f"{name}.csv")
        write(files[-1], name, depth, force)
    found = Identification(files, POISSON[body], bool(noise))
    for tool in curves:
        if tool in names:
            continue
        depth, force = curves[tool]
        felt = found.feel(tool, depth[-1])
        row = dict.fromkeys(COLUMNS, "")
        row.update(body=body, material=material, measured_with=" ".join(names), noise=noise,
                   verdict="identified", tool=tool, depth_mm=number(depth[-1]), force_N=number(force[-1]),
                   true_MPa=number(E_STAR[body]))
        if felt is None:
            row["verdict"] = found.refusal
            yield row
            return
        at, validity, stated = felt
        row.update(model=found.site("Model"),
                   reduced_modulus_MPa=number(found.site("ReducedModulus (MPa)")),
                   to=number(found.site("ReducedModulus to (MPa)")),
                   compliance_mm_per_N=number(found.site("Compliance (mm/N)")),
                   thickness_mm=number(found.site("Thickness (mm)")),
                   misfit_share=number(found.site("Misfit (N)") / found.site("LargestForce (N)"), 2),
                   validity_mm=number(validity, 3),
                   error_at_depth=f"{at(depth[-1]) / force[-1] - 1:+.3f}",
                   stated_error_at_depth=f"{stated:.3f}")
        if validity > 0.0:
            row["error_at_validity"] = f"{at(validity) / force_at(curves[tool], validity) - 1:+.3f}"
        row["from"] = number(found.site("ReducedModulus from (MPa)"))
        yield row


def main(source, target):
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for case in itertools.product(POISSON, ("linear", "neohooke")):
            paths = {tool: pathlib.Path(source) / f"{case[0]}-{tool}-{case[1]}.csv" for tool in TOOLS}
            curves = {tool: read(path) for tool, path in paths.items() if path.is_file()}
            for names, noise in itertools.product(MEASURED_WITH, (0, NOISE)):
                if all(name in curves for name in names):
                    rows += predict(curves, names, case, noise, pathlib.Path(folder))
    with open(target, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    print(f"{len(rows)} predictions in {target}")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
