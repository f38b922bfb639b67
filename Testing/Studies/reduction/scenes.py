# SPDX-License-Identifier: BSD-3-Clause
"""Bodies that need more or fewer numbers: the material of each body, and the path of a tip over it."""
import pathlib

import numpy as np
from palpate import vtkContactTool, vtkLayerThickness, vtkSkinSurface, vtkToolContactResponse
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkReverseSense
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkFiltersSources import vtkPlatonicSolidSource
from vtkmodules.vtkIOImage import vtkNIFTIImageReader

SCAN = pathlib.Path("/usr/share/mricron/templates/ch2.nii.gz")  # Debian's mricron-data: Colin 27
RADIUS = 60.0                                                   # radius of the ball, mm
YOUNG, POISSON = 0.035, 0.45                                    # MPa, -
DEPTH = 2.0                                                     # depth of the curves, mm
YOUNG_INDEX, THICKNESS_INDEX, COMPLIANCE_INDEX = 0, 1, 2


def ball(level):
    solid, finer, turned = vtkPlatonicSolidSource(), vtkLinearSubdivisionFilter(), vtkReverseSense()
    solid.SetSolidTypeToIcosahedron()  # VTK's icosahedron is inside out
    finer.SetInputConnection(solid.GetOutputPort())
    finer.SetNumberOfSubdivisions(level)
    turned.SetInputConnection(finer.GetOutputPort())
    turned.Update()
    body = vtkPolyData()
    body.ShallowCopy(turned.GetOutput())
    directions = vtk_to_numpy(body.GetPoints().GetData()).astype(float)
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(RADIUS * directions, deep=True))
    body.SetPoints(points)
    return body, directions


def add(body, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values, float), deep=True)
    array.SetName(name)
    body.GetPointData().AddArray(array)


def waves(directions):
    """Returns values between 0 and 1 that vary smoothly over the ball."""
    x, y, z = directions.T
    return 0.5 + 0.5 * np.sin(5 * x + 1) * np.cos(4 * y) * np.cos(3 * z)


def homogeneous(level):
    return ball(level)[0], {}


def stiffness_map(level):
    """A ball with a Young's modulus from 10 to 60 kPa and 10 % of noise."""
    body, directions = ball(level)
    noise = np.random.default_rng(1).uniform(0.95, 1.05, len(directions))
    add(body, "Stiffness", (0.01 + 0.05 * waves(directions)) * noise)
    return body, {YOUNG_INDEX: "Stiffness"}


def layer_map(level):
    """A ball with a layer of 6 to 20 mm on a rigid base. A sixth of the ball has no base."""
    body, directions = ball(level)
    thickness = 6 + 14 * waves(directions)
    add(body, "Thickness", np.where(directions[:, 2] < -2 / 3, 0.0, thickness))
    return body, {THICKNESS_INDEX: "Thickness"}


def gives_way(level):
    """A ball with a global compliance of 0 to 20 mm/N in series."""
    body, directions = ball(level)
    add(body, "Compliance", 20 * waves(directions))
    return body, {COMPLIANCE_INDEX: "Compliance"}


def head(level):
    """The scalp over the skull of a scan; the finest level has the resolution of the scan."""
    reader, skin, layer = vtkNIFTIImageReader(), vtkSkinSurface(), vtkLayerThickness()
    reader.SetFileName(str(SCAN))
    skin.SetInputConnection(reader.GetOutputPort())
    skin.SetResolution(0.0 if level > 5 else 4.0)
    layer.SetInputConnection(0, skin.GetOutputPort())
    layer.SetInputConnection(1, reader.GetOutputPort())
    layer.Update()
    body = vtkPolyData()
    body.ShallowCopy(layer.GetOutput())
    return body, {THICKNESS_INDEX: "LayerThickness"}


SCENES = {"homogeneous": homogeneous, "stiffness map": stiffness_map, "layer map": layer_map,
          "gives way": gives_way, "head": head}


def respond(body, arrays, specification):
    tool, response = vtkContactTool(), vtkToolContactResponse()
    tool.SetSpecification(specification)
    response.SetInputData(body)
    response.SetTool(tool)
    response.SetYoungsModulus(YOUNG)
    response.SetPoissonRatio(POISSON)
    response.SetMaximumDeflection(DEPTH)
    response.CurvatureCorrectionOff()  # so that bodies differ only in their material
    response.SetErrorTolerance(0)
    for index, name in arrays.items():
        response.SetInputArrayToProcess(index, 0, 0, 0, name)
    response.Update()
    output = vtkPolyData()
    output.ShallowCopy(response.GetOutput())
    return output


def path(body, response, count):
    """Returns a polyline of tips from triangle to triangle of the body, 0.05 to 1.9 mm deep."""
    data = body.GetPointData()
    points = vtk_to_numpy(body.GetPoints().GetData()).astype(float)
    normals = vtk_to_numpy(data.GetArray(response + "Normal")).astype(float)
    usable = vtk_to_numpy(data.GetArray(response + "Status")) == 0
    triangles = vtk_to_numpy(body.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    random = np.random.default_rng(2)
    # The next triangle shares two corners with the present one and is not the preceding one.
    neighbours = {}
    for triangle, corners in enumerate(triangles):
        for k in range(3):
            edge = tuple(sorted((corners[k], corners[(k + 1) % 3])))
            neighbours.setdefault(edge, []).append(triangle)
    tips, here, last = [], int(random.integers(len(triangles))), -1
    while len(tips) < count:
        corners = triangles[here]
        if usable[corners].all():
            weights = random.dirichlet((2, 2, 2))
            place, normal = weights @ points[corners], weights @ normals[corners]
            depth = 0.05 + 1.85 * (0.5 + 0.5 * np.sin(len(tips) / 40))
            tips.append(place - depth * normal / np.linalg.norm(normal))
        edges = [tuple(sorted((corners[k], corners[(k + 1) % 3]))) for k in range(3)]
        ways = [t for edge in edges for t in neighbours[edge] if t not in (here, last)]
        last, here = here, int(random.choice(ways)) if ways else int(random.integers(len(triangles)))
    line, cells, places = vtkPolyData(), vtkCellArray(), vtkPoints()
    places.SetDataTypeToDouble()
    places.SetData(numpy_to_vtk(np.array(tips), deep=True))
    cells.InsertNextCell(count)
    for i in range(count):
        cells.InsertCellPoint(i)
    line.SetPoints(places)
    line.SetLines(cells)
    return line
