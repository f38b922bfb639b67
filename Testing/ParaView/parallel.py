# SPDX-License-Identifier: BSD-3-Clause
"""A body in pieces on several processes gives the same results as on one process: parallel.py FOLDER, under mpiexec.

The serial result comes from the same filters without a controller, on process 0, for any number of processes.
Triangles, and results that depend only on data of the point itself, are bitwise equal (ranks.py). All other results are
bitwise equal away from seams, and everywhere if normals are given. At a seam the normals of triangles are summed in another
order. There the arrays of the response agree to a unit in the last place of a float (2e-7 of their largest value);
forces and displacements follow from these arrays.
"""
import os
import sys
import numpy as np
import ranks
import raw_xml
from paraview import servermanager, simple
from palpate import (vtkContactDeflection, vtkContactRegime, vtkContactTool, vtkToolContactProbe,
                     vtkToolContactResponse)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataObject, vtkPolyData
from vtkmodules.vtkFiltersParallel import vtkIntegrateAttributes
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
from vtkmodules.vtkParallelCore import vtkMultiProcessController

FOLDER = sys.argv[1]
PROCESSES = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
ULP = 2e-7
if PROCESSES > 1:
    raw_xml.need_raw_xml()


def bumpy_ball(columns=72, rows=48):
    """A closed surface around the origin, 18 to 22 mm, not convex; arrays E (MPa) and Layer (mm)."""
    phi = np.pi * np.arange(1, rows) / rows
    theta = 2 * np.pi * np.arange(columns) / columns
    t, p = np.meshgrid(theta, phi)
    r = 20 + 2 * np.sin(3 * t) * np.sin(p) ** 3 * np.cos(2 * p)
    ring = np.stack([r * np.sin(p) * np.cos(t), r * np.sin(p) * np.sin(t), r * np.cos(p)], -1).reshape(-1, 3)
    points = np.vstack([ring, [[0, 0, 20], [0, 0, -20]]])
    top, bottom = len(ring), len(ring) + 1
    cells = []
    for j in range(columns):
        k = (j + 1) % columns
        cells += [(top, j, k), (bottom, (rows - 2) * columns + k, (rows - 2) * columns + j)]
        for i in range(rows - 2):
            a, b, c, d = i * columns + j, (i + 1) * columns + j, (i + 1) * columns + k, i * columns + k
            cells += [(a, b, c), (a, c, d)]
    return surface(points, cells)


def slab(cells=32):
    """The two faces, 40 x 40 mm in squares of 1.25 mm, of a block 16 mm thick; without its sides."""
    x = np.linspace(-20, 20, cells + 1)
    points = [(u, v, z) for z in (8.0, -8.0) for u in x for v in x]
    triangles = []
    for i in range(cells):
        for j in range(cells):
            a = i * (cells + 1) + j
            b, c, d = a + cells + 1, a + cells + 2, a + 1
            triangles += [(a, b, c), (a, c, d)]
            triangles += [tuple(k + (cells + 1) ** 2 for k in t[::-1]) for t in triangles[-2:]]
    return surface(np.array(points), triangles)


def surface(points, triangles):
    body, coordinates, polys = vtkPolyData(), vtkPoints(), vtkCellArray()
    coordinates.SetDataTypeToDouble()
    for p in points:
        coordinates.InsertNextPoint(p)
    for triangle in triangles:
        polys.InsertNextCell(3, triangle)
    body.SetPoints(coordinates)
    body.SetPolys(polys)
    for name, values in (("E", 0.05 + 0.001 * np.abs(points[:, 0])), ("Layer", 6 + 0.1 * points[:, 2])):
        array = numpy_to_vtk(values, deep=1)
        array.SetName(name)
        body.GetPointData().AddArray(array)
    return body


def write(body, name):
    file = os.path.join(FOLDER, "parallel_%s_%d.vtp" % (name, PROCESSES))
    writer = vtkXMLPolyDataWriter()
    writer.SetDataModeToBinary()
    writer.SetInputData(body)
    writer.SetFileName(file)
    writer.Write()
    return file


def in_pieces(body, name):
    """The body from a file, spread over all processes."""
    pieces = simple.RedistributeDataSet(Input=simple.XMLPolyDataReader(FileName=[write(body, name)]))
    pieces.UpdatePipeline()
    return pieces


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def arrays_of(data):
    arrays = data.GetPointData()
    return {arrays.GetArrayName(i): vtk_to_numpy(arrays.GetArray(i)) for i in range(arrays.GetNumberOfArrays())}


def check_same(pieces, serial, names, tolerance=ULP):
    """The values of the serial body at each point of the pieces; points on seams occur several times."""
    assert pieces.GetNumberOfCells() == serial.GetNumberOfCells(), (
        pieces.GetNumberOfCells(), serial.GetNumberOfCells())
    where = {tuple(p): i for i, p in enumerate(np.round(points_of(serial), 5) + 0.0)}
    ids = np.array([where[tuple(p)] for p in np.round(points_of(pieces), 5) + 0.0])
    assert set(ids) == set(range(serial.GetNumberOfPoints()))
    assert PROCESSES == 1 or len(ids) > serial.GetNumberOfPoints(), "the body has no seam"
    found, expected = arrays_of(pieces), arrays_of(serial)
    for name in names:
        size = np.nanmax(np.abs(expected[name].astype(float)))
        difference = np.abs(found[name].astype(float) - expected[name][ids].astype(float))
        difference[np.isnan(found[name].astype(float)) & np.isnan(expected[name][ids].astype(float))] = 0
        worst = np.unravel_index(difference.argmax(), difference.shape)[0]
        assert difference.max() <= tolerance * size, "%s is off by %g of %g at %s" % (
            name, difference.max(), size, points_of(pieces)[worst])


def integrals(source):
    data = servermanager.Fetch(simple.IntegrateVariables(Input=source))
    return arrays_of(data)


def check_integrals(source, serial, names):
    whole = vtkIntegrateAttributes()
    whole.SetController(None)
    whole.SetInputData(serial)
    whole.Update()
    expected, found = arrays_of(whole.GetOutput()), integrals(source)
    for name in names:
        size = np.abs(expected[name]).max()
        assert np.abs(found[name] - expected[name]).max() <= 1e-6 * size, (name, found[name], expected[name])


def serial_response(body, **arrays):
    tool = vtkContactTool()
    tool.SetShapeToSphere()
    tool.SetRadius(5)
    response = vtkToolContactResponse()
    response.SetController(None)
    response.SetInputData(body)
    response.SetTool(tool)
    response.SetYoungsModulus(0.05)
    for index, name in arrays.items():
        response.SetInputArrayToProcess(int(index[1:]), 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, name)
    response.Update()
    return response.GetOutput()


def serial_probe(body, tips, **settings):
    probe = vtkToolContactProbe()
    probe.SetController(None)
    probe.SetInputData(0, body)
    probe.SetInputData(1, tips)
    for name, value in settings.items():
        getattr(probe, "Set" + name)(value)
    probe.Update()
    return probe.GetOutput()


def serial_dent(body, tips, distance=0.0, index=-1):
    dent = vtkContactDeflection()
    dent.SetController(None)
    dent.SetInputData(0, body)
    dent.SetInputData(1, tips)
    dent.SetMaximumDistance(distance)
    dent.SetTipIndex(index)
    dent.Update()
    return dent.GetOutput()


def tips_from(points, line):
    tips, coordinates = vtkPolyData(), vtkPoints()
    coordinates.SetDataTypeToDouble()
    for p in points:
        coordinates.InsertNextPoint(p)
    tips.SetPoints(coordinates)
    cells = vtkCellArray()
    if line:
        cells.InsertNextCell(len(points), range(len(points)))
        tips.SetLines(cells)
    else:
        for i in range(len(points)):
            cells.InsertNextCell(1, [i])
        tips.SetVerts(cells)
    return tips


def check_probe(response, serial, tips, name, settings=None, tolerance=1e-6):
    """Compares forces at tips, in the order of the tips, to a millionth of the largest force, because normals are
    floats."""
    settings = settings or {}
    probe = simple.ToolContactProbe(Body=response, Tips=simple.XMLPolyDataReader(FileName=[write(tips, name)]),
                                    **settings)
    found = servermanager.Fetch(probe)
    expected = arrays_of(serial_probe(serial, tips, **{k.replace("mm", ""): v for k, v in settings.items()}))
    assert found.GetNumberOfPoints() == tips.GetNumberOfPoints()
    arrays = arrays_of(found)
    assert np.array_equal(arrays["ContactState"], expected["ContactState"])
    for array in ("Force", "NormalForce", "FrictionForce", "Deflection", "Normal", "ContactPoint"):
        size = max(np.abs(expected[array]).max(), 1e-9)
        off = np.abs(arrays[array] - expected[array]).max()
        assert off <= tolerance * size, "%s %s is off by %g of %g" % (name, array, off, size)
    assert np.array_equal(arrays["ContactCell"] < 0, expected["ContactCell"] < 0)
    assert ("ContactRank" in arrays) == (PROCESSES > 1)
    if PROCESSES > 1:
        ranks = arrays["ContactRank"]
        assert np.array_equal(ranks < 0, expected["ContactCell"] < 0) and ranks.max() < PROCESSES
    return probe, arrays, expected


def around(depth, count=400, tilt=0.4):
    """A path around the ball, `depth` below its radius of 20 mm; it crosses all pieces of any division."""
    t = np.linspace(0, 2.2 * np.pi, count)
    r = 20 - depth * np.minimum(1, t)
    return np.stack([r * np.cos(t), r * np.sin(t) * np.cos(tilt), r * np.sin(t) * np.sin(tilt)], -1)


RESPONSE = ("ResponseForce", "ResponseStiffness", "ResponseNormal", "ResponseRange", "ResponseStatus",
            "ResponseValidity", "ResponseLimit")
OF_POINTS = ("ResponseForce", "ResponseStiffness", "ResponseRange", "ResponseStatus", "E", "Layer")
OF_NORMALS = ("ResponseNormal", "ResponseValidity", "ResponseLimit")

# A body with constant material: response, forces along a path with friction, the dent.
ball = bumpy_ball()
pieces = in_pieces(ball, "ball")
response = simple.ToolContactResponse(Input=pieces, YoungsModulusMPa=0.05, WholeBody=0)
serial = serial_response(ball)
fetched = servermanager.Fetch(response)
check_same(fetched, serial, RESPONSE)
ranks.check_bits(fetched, serial, OF_POINTS, OF_NORMALS)
check_integrals(response, serial, ("ResponseForce", "ResponseStiffness", "ResponseValidity"))

path = tips_from(around(2.5), True)
probe, arrays, expected = check_probe(response, serial, path, "path", {"FrictionCoefficient": 0.3})
assert (expected["ContactState"] > 0).sum() > 200 and np.abs(expected["FrictionForce"]).max() > 0.01
assert PROCESSES == 1 or len(set(arrays["ContactRank"][arrays["ContactRank"] >= 0])) > 1, "no seam was crossed"
check_probe(response, serial, path, "smooth", {"ContactSurface": 1})
random = np.random.default_rng(3).uniform(-26, 26, (300, 3))
check_probe(response, serial, tips_from(random, False), "loose")
check_probe(response, serial, tips_from(random[:40], False), "pressed", {"Indentationmm": 1.5})
far = tips_from([(90, 0, 0), (0, -300, 0), (0, 0, float("nan")), (1e7, 0, 0)], False)
_, arrays, _ = check_probe(response, serial, far, "far")
assert list(arrays["ContactState"]) == [0, 0, 5, 0]

pressed = serial_probe(serial, path, FrictionCoefficient=0.3)
for index, distance in ((200, 0.0), (60, 9.0), (-1, 0.0)):
    dent = simple.ContactDeflection(Body=response, Tips=probe, TipIndex=index, MaximumDistancemm=distance)
    whole = serial_dent(serial, pressed, distance, index)
    check_same(servermanager.Fetch(dent), whole, ("ContactDisplacement",), 1e-6)
    check_integrals(dent, whole, ("ContactDisplacement",))

# Material from arrays: the tables of layers, the exponent and the regime are computed for the whole
# body.
response = simple.ToolContactResponse(Input=pieces, YoungsModulusArrayMPa=["POINTS", "E"],
                                      LayerThicknessArraymm=["POINTS", "Layer"])
serial = serial_response(ball, i0="E", i1="Layer")
fetched = servermanager.Fetch(response)
check_same(fetched, serial, RESPONSE + ("ResponseLayerThickness",))
ranks.check_bits(fetched, serial, OF_POINTS + ("ResponseLayerThickness",), OF_NORMALS)
ranks.check_sums(fetched, serial)
for field in ("ResponseExponent", "ResponseSamples", "ResponseLayerBase"):
    assert (fetched.GetFieldData().GetArray(field).GetTuple1(0) ==
            serial.GetFieldData().GetArray(field).GetTuple1(0)), field
regime = simple.ContactRegime(Input=response, YoungsModulusArrayMPa=["POINTS", "E"],
                              LayerThicknessArraymm=["POINTS", "Layer"])
alone = vtkContactRegime()
alone.SetController(None)
alone.SetInputData(serial)
for index, name in ((0, "E"), (1, "Layer")):
    alone.SetInputArrayToProcess(index, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, name)
alone.Update()
check_same(servermanager.Fetch(regime), alone.GetOutput(), ("RegimeIndex", "ToolSensitivity", "RegimeVerdict"))
probe, _, _ = check_probe(response, serial, path, "layers", {"FrictionCoefficient": 0.2})
dent = simple.ContactDeflection(Body=response, Tips=probe)
check_same(servermanager.Fetch(dent), serial_dent(serial, serial_probe(serial, path, FrictionCoefficient=0.2)),
           ("ContactDisplacement",), 1e-6)

# Input normals that differ from those of the triangles are not used.
with_normals = bumpy_ball()
normals = numpy_to_vtk((points_of(ball) / np.linalg.norm(points_of(ball), axis=1)[:, None]).astype(np.float32), deep=1)
normals.SetName("Outward")
with_normals.GetPointData().SetNormals(normals)
response = simple.ToolContactResponse(Input=in_pieces(with_normals, "normals"), YoungsModulusArrayMPa=["POINTS", "E"],
                                      LayerThicknessArraymm=["POINTS", "Layer"])
fetched, serial = servermanager.Fetch(response), serial_response(with_normals, i0="E", i1="Layer")
ranks.check_bits(fetched, serial, OF_POINTS, OF_NORMALS)
ranks.check_sums(fetched, serial)

# Through a block: the contact stays on the face through which the tip entered, even if the other
# face is nearer. Therefore more points must be gathered than the points around the tip.
plate = slab()
response = simple.ToolContactResponse(Input=in_pieces(plate, "slab"), YoungsModulusMPa=0.05, WholeBody=0)
serial = serial_response(plate)
check_same(servermanager.Fetch(response), serial, RESPONSE)
down = [(-14.7 + 0.02 * i, 0.2, 8.5 - 0.25 * i) for i in range(65)]
along = [(down[-1][0] + 0.25 * i, 0.2, down[-1][2]) for i in range(1, 110)]
_, arrays, expected = check_probe(response, serial, tips_from(down + along, True), "through")
assert expected["Deflection"][-1] == 15.5 and arrays["ContactPoint"][-1][2] == 8, "the contact let go"

# Composite data: one body of two balls, each in pieces.
moved = simple.Transform(Input=pieces)
moved.Transform.Translate = [60.0, 0.0, 0.0]
group = simple.GroupDatasets(Input=[pieces, moved])
response = simple.ToolContactResponse(Input=group, YoungsModulusMPa=0.05, WholeBody=0)
fetched = servermanager.Fetch(response)
assert fetched.IsA("vtkPolyData") and fetched.GetNumberOfCells() == 2 * ball.GetNumberOfCells()
one, two = integrals(simple.ToolContactResponse(Input=pieces, YoungsModulusMPa=0.05, WholeBody=0)), integrals(response)
assert np.abs(two["ResponseForce"] - 2 * one["ResponseForce"]).max() <= 1e-5 * one["ResponseForce"].max()
first = serial_response(ball)
for name, tips in (("first", around(2.5, 60)), ("second", around(2.5, 60) + [60, 0, 0])):
    on_one = arrays_of(serial_probe(first, tips_from(around(2.5, 60), True)))
    probe = simple.ToolContactProbe(
        Body=response, Tips=simple.XMLPolyDataReader(FileName=[write(tips_from(tips, True), name)]))
    forces = arrays_of(servermanager.Fetch(probe))["Force"]
    # The second ball is moved in float coordinates of 80 mm, which gives an error of 4e-6 mm at a
    # depth of 2.5 mm.
    assert np.abs(forces - on_one["Force"]).max() <= 1e-5 * np.abs(on_one["Force"]).max(), name
print("done", PROCESSES)
