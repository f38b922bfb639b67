# SPDX-License-Identifier: BSD-3-Clause
"""Makes a body for the walk-through: smooth, closed, of the size of an organ, in mm. Usage: organ.py FILE.vtp"""
import sys
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkFiltersSources import vtkPlatonicSolidSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

SEMI_AXES = np.array([45.0, 32.0, 24.0])                    # mm


def swelling(way):
    """Relative increase of the radius by the swellings, in the directions `way`, which are unit vectors."""
    return sum(height * np.exp((way @ np.array(to) / np.linalg.norm(to) - 1) / width)
               for height, width, to in ((0.18, 0.15, (1, 0.6, 0.4)), (0.12, 0.1, (-1, -0.5, 0.6))))


def curvatures(place):
    """The principal curvatures (1/mm) of the surface near a place, positive where it is convex."""
    def level(x):
        q = x / SEMI_AXES
        return np.linalg.norm(q) / (1 + swelling(q / np.linalg.norm(q))) - 1

    def gradient(x, h=1e-3):
        return np.array([(level(x + h * e) - level(x - h * e)) / (2 * h) for e in np.eye(3)])

    x = np.array(place, float)
    for _ in range(20):
        x -= level(x) * gradient(x) / (gradient(x) @ gradient(x))
    slope = gradient(x)
    steepness = np.linalg.norm(slope)
    along = np.eye(3) - np.outer(slope, slope) / steepness**2
    bend = np.array([(gradient(x + 1e-2 * e) - gradient(x - 1e-2 * e)) / 2e-2 for e in np.eye(3)])
    found = np.linalg.eigvalsh(along @ (0.5 * (bend + bend.T)) @ along / steepness)
    return np.delete(found, np.argmin(np.abs(found)))        # removes the zero curvature along the normal


def organ(level=6, size=1.0):
    """10 · 4^level + 2 points of an ellipsoid with two broad swellings. The semi-axes are `size` times SEMI_AXES; the
    normals are outward."""
    solid = vtkPlatonicSolidSource()
    solid.SetSolidTypeToIcosahedron()
    finer = vtkLinearSubdivisionFilter()
    finer.SetInputConnection(solid.GetOutputPort())
    finer.SetNumberOfSubdivisions(level)
    finer.Update()
    ball = finer.GetOutput()
    way = vtk_to_numpy(ball.GetPoints().GetData()).astype(float)
    way /= np.linalg.norm(way, axis=1)[:, None]
    points = vtkPoints()
    points.SetData(numpy_to_vtk(size * way * SEMI_AXES * (1 + swelling(way))[:, None], deep=True))
    body = vtkPolyData()
    body.SetPoints(points)
    body.SetPolys(ball.GetPolys())
    normals = vtkPolyDataNormals()
    normals.SetInputData(body)
    normals.SplittingOff()
    normals.ConsistencyOn()
    normals.AutoOrientNormalsOn()
    normals.Update()
    return normals.GetOutput()


def write(file, size=1.0):
    writer = vtkXMLPolyDataWriter()
    writer.SetDataModeToBinary()
    writer.SetInputData(organ(size=size))
    writer.SetFileName(file)
    assert writer.Write(), file


if __name__ == "__main__":
    write(sys.argv[1])
