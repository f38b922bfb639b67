# SPDX-License-Identifier: BSD-3-Clause
"""Bodies with responses, and a tool pressed into them by a session in virtual time."""
import numpy as np

from palpate import contract, vtkHapticSession, vtkPressPath, vtkToolContactResponse
from setting import SPEED, contact_tool
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource


def square(points_per_side=3):
    """Returns a plane square of 60 mm about the origin with the normal +z."""
    plane, triangles = vtkPlaneSource(), vtkTriangleFilter()
    plane.SetOrigin(-30, -30, 0)
    plane.SetPoint1(30, -30, 0)
    plane.SetPoint2(-30, 30, 0)
    plane.SetResolution(points_per_side - 1, points_per_side - 1)
    triangles.SetInputConnection(plane.GetOutputPort())
    triangles.Update()
    return triangles.GetOutput()


def add_array(body, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values, dtype=float), deep=1)
    array.SetName(name)
    body.GetPointData().AddArray(array)


def material(filters, modulus, poisson_ratio, layer=0.0, compliance=None):
    """Sets E* (MPa) and the other material values of a response or regime filter; `compliance` names a point array."""
    filters.SetYoungsModulus(modulus * (1 - poisson_ratio ** 2))
    filters.SetPoissonRatio(poisson_ratio)
    filters.SetLayerThickness(layer)
    if compliance:
        filters.SetInputArrayToProcess(2, 0, 0, 0, compliance)


def respond(body, specification, depth, modulus, poisson_ratio, layer=0.0, compliance=None, samples=8, strain="small",
            relaxations=()):
    """Returns the body with the response of a tool to `depth` mm. `strain`: "small" or "neohooke"; `relaxations`: pairs of
    strength and seconds."""
    response = vtkToolContactResponse()
    response.SetInputData(body)
    response.SetTool(contact_tool(specification))
    response.SetMaximumDeflection(depth)
    response.SetNumberOfSamples(samples)
    response.CurvatureCorrectionOff()  # the paper's law is that of a flat surface
    response.SetErrorTolerance(0)      # Validity by the contact radius, as usual for small strain
    response.SetStrainModel(response.NeoHooke if strain == "neohooke" else response.SmallStrain)
    material(response, modulus, poisson_ratio, layer, compliance)
    for strength, seconds in relaxations:
        response.AddRelaxation(strength, seconds)
    response.Update()
    output = vtkPolyData()
    output.ShallowCopy(response.GetOutput())
    if output.GetNumberOfPoints() == 0:
        raise RuntimeError("no response for " + specification)
    return output


def curve(responding, point, depths):
    """Returns the force (N) at a point of a body with responses."""
    return contract.evaluate(contract.load(responding), point, depths)[0]


def validity(responding, point):
    return responding.GetPointData().GetArray("ResponseValidity").GetTuple1(point)


def press(responding, depth, approach):
    """Presses a tool down along the z axis at the paper's speed, holds it for half a second and lifts it, at 1 kHz.

    Returns time (s), displacement of the tip (mm, > 0 into the body) and normal force (N) of each tick.
    """
    top = responding.GetBounds()[5]
    path = vtkPressPath()
    path.SetInputData(responding)
    path.SetCenter(0, 0, top - 0.5)
    path.AddDirection(0, 0, 1)
    path.SetDepth(depth)
    path.SetApproach(approach)
    path.SetPressSpeed(SPEED)
    path.Update()
    return follow(responding, path.GetOutput())


def press_and_lift(responding, depth, approach, speed):
    """As press(), without the hold and at a given speed (mm/s)."""
    top = responding.GetBounds()[5]
    path, points, lines = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for height in (approach, -depth, approach):
        points.InsertNextPoint(0, 0, top + height)
    lines.InsertNextCell(3, (0, 1, 2))
    path.SetPoints(points)
    path.SetLines(lines)
    once = (approach + depth) / speed
    add_array(path, "Time", [0, once, 2 * once])
    add_array(path, "Inward", [(0, 0, -1)] * 3)
    return follow(responding, path, elements=32)


def follow(responding, path, elements=16):
    """As press(), along a path like that of vtkPressPath; `elements`: number of elements of a body that relaxes."""
    top = responding.GetBounds()[5]
    session = vtkHapticSession()
    session.SetBody(responding)
    session.GetSettings().SetRelaxationElements(elements)
    session.GetDevice().Open("simulated")
    session.GetDevice().SetPath(path)
    if not session.Start():
        raise RuntimeError("the session does not start")
    session.Step(session.GetDevice().GetPathDuration())
    session.Stop()
    recording = vtkPolyData()
    session.GetRecorder().GetRecording(recording)
    arrays = recording.GetPointData()
    tips = vtk_to_numpy(recording.GetPoints().GetData())
    return (vtk_to_numpy(arrays.GetArray("Time")).copy(), top - tips[:, 2],
            vtk_to_numpy(arrays.GetArray("NormalForce")).copy())
