# SPDX-License-Identifier: BSD-3-Clause
"""Computes the share of a surface on which the stated error of a tool's force is within a tolerance, and the largest part
of the error on the rest of the surface."""
import numpy as np
import palpate
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

TOOLS = ("sphere:6.35", "sphere:1.6", "flat:1.6", "cone:60")
LIMITS = ("storage", "strain", "curvature", "thickness", "opposite wall", "edge", "data", "elements")


def poly(points, triangles):
    """Returns a vtkPolyData with points (n, 3) in mm and triangles (m, 3)."""
    body, places, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points, np.float32), deep=True))
    body.SetPoints(places)
    offsets = np.arange(0, 3 * len(triangles) + 1, 3, dtype=np.int64)
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                  numpy_to_vtkIdTypeArray(np.ascontiguousarray(triangles, np.int64).ravel(), deep=True))
    body.SetPolys(cells)
    return body


def force_on_layer(tool, height, deflection, young, poisson):
    """Returns the exact force (N) of a tool on an infinite layer that is bonded to a rigid base."""
    points = np.array([[x, y, 0.0] for x in (-90, 0, 90) for y in (-90, 0, 90)])
    triangles = np.array([[a, a + 3, a + 4] for a in (0, 1, 3, 4)] + [[a, a + 4, a + 1] for a in (0, 1, 3, 4)])
    layer = palpate.response((points, triangles), tool, young=young, poisson=poisson, layer=height, curvature=False,
                             maximum_deflection=deflection, error_tolerance=0)
    force = layer.GetPointData().GetArray("ResponseForce")
    return force.GetComponent(4, force.GetNumberOfComponents() - 1)


def read_head(scan):
    """Returns the skin of a scan of a head, made as in the demo."""
    from vtkmodules.vtkIOImage import vtkNIFTIImageReader
    reader, skin = vtkNIFTIImageReader(), palpate.vtkSkinSurface()
    reader.SetFileName(str(scan))
    skin.SetInputConnection(reader.GetOutputPort())
    skin.Update()
    return skin.GetOutput()


def read_body(file, length=None):
    """Returns the surface of a file, scaled so that its longest side is `length` mm; None: not scaled."""
    surface = palpate.response(file, tool="sphere:1", maximum_deflection=0.001, compliance=None)
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    factor = length / np.ptp(points, axis=0).max() if length else 1.0
    return poly(factor * points, triangles)


def areas(body):
    """Returns the area of each point, mm²: a third of the area of the triangles around the point."""
    points = vtk_to_numpy(body.GetPoints().GetData()).astype(float)
    cells = vtk_to_numpy(body.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = (points[cells[:, k]] for k in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 6
    found = np.zeros(len(points))
    for k in range(3):
        np.add.at(found, cells[:, k], area)
    return found


def shares(made, name, area, tolerance):
    """Returns the share of the area in which the stated error at the range is within the tolerance, and the shares of the
    rest by the largest part of the error."""
    arrays = made.GetPointData()
    error = vtk_to_numpy(arrays.GetArray(name + "Error"))[:, -1]
    limit = vtk_to_numpy(arrays.GetArray(name + "Limit"))
    within = (error <= tolerance) & (area > 0)
    whole = area.sum()
    rest = {text: float(area[~within & (limit == code)].sum() / whole) for code, text in enumerate(LIMITS)}
    return float(area[within].sum() / whole), {text: share for text, share in rest.items() if share > 0}


def cover(body, tool, depth=1.0, tolerance=0.05, poisson=0.45):
    """Returns shares() of a response with curvature and Neo-Hooke, pressed to `depth` mm."""
    made = palpate.response(body, tool=tool, young=0.05, poisson=poisson, maximum_deflection=depth, curvature=True,
                            strain="neohooke", error_tolerance=tolerance)
    return shares(made, "Response", areas(made), tolerance)
