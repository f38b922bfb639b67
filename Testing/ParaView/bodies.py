# SPDX-License-Identifier: BSD-3-Clause
"""A body in any form (strips, polygons, blocks, partitions, volumes) has the same responses as its plain triangles. The
plain triangles come from ParaView's own filters, and their responses from vtkToolContactResponse."""
import numpy as np
import palpate
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkPartitionedDataSet, vtkRectilinearGrid
from vtkmodules.vtkFiltersCore import vtkExtractCells

PLACES = 4                                                  # decimals of mm by which points are distinguished


def stiffened(source):
    """Adds a modulus that differs at every point, so that interchanged points are detected."""
    return simple.Calculator(Input=source, ResultArrayName="Stiff",
                             Function="0.05 + 0.001 * abs(coordsX + 0.37 * coordsY + 0.11 * coordsZ)")


def in_order(body):
    """Points and all point arrays of a polydata, in the order of the coordinates."""
    points = vtk_to_numpy(body.GetPoints().GetData()).astype(float)
    order = np.lexsort(np.round(points, PLACES).T)
    arrays = {"points": points[order]}
    for i in range(body.GetPointData().GetNumberOfArrays()):
        array = body.GetPointData().GetArray(i)
        arrays[array.GetName()] = vtk_to_numpy(array)[order]
    return arrays


def in_paraview(source):
    # Curvature and edges depend on the triangles, which each kind of data makes in its own way.
    response = simple.ToolContactResponse(Input=source, YoungsModulusArrayMPa=["POINTS", "Stiff"],
                                          CurvatureCorrection=0, ErrorTolerance=0)
    response.Tool.Shape = "Cone"
    made = servermanager.Fetch(response)
    assert made.IsA("vtkPolyData") and made.GetNumberOfCells() == made.GetNumberOfPolys(), made.GetClassName()
    assert made.GetPolys().IsHomogeneous() == 3
    return made


def of_plain(source):
    """Computes the response with the class itself, from triangles."""
    tool = palpate.vtkContactTool()
    tool.SetShapeToCone()
    response = palpate.vtkToolContactResponse()
    response.SetInputData(servermanager.Fetch(source))
    response.SetTool(tool)
    response.SetInputArrayToProcess(0, 0, 0, 0, "Stiff")
    response.CurvatureCorrectionOff()
    response.SetErrorTolerance(0)
    response.Update()
    return response.GetOutput()


def check(source, plain, name):
    found, expected = in_paraview(source), of_plain(plain)
    assert expected.GetNumberOfPoints() > 0 and found.GetNumberOfPoints() == expected.GetNumberOfPoints(), (
        name, found.GetNumberOfPoints(), expected.GetNumberOfPoints())
    assert found.GetNumberOfPolys() == expected.GetNumberOfPolys(), name
    found, expected = in_order(found), in_order(expected)
    assert found.keys() >= expected.keys(), (name, expected.keys() - found.keys())
    for key, values in expected.items():
        # The sums over the triangles of a point have another order: a few units of the last place
        # of a float.
        np.testing.assert_allclose(found[key], values, rtol=2e-6, atol=2e-6, err_msg=f"{name}: {key}")


def plain_surface(volume):
    """The outer triangles of a volume, made by ParaView's filters; each point occurs once."""
    return simple.Triangulate(Input=simple.Clean(Input=simple.ExtractSurface(Input=volume)))


def given(data):
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    return producer


def halves(source):
    """A data set in two partitions. The cells alternate between the partitions; each partition has its own points."""
    data = servermanager.Fetch(source)
    parts = vtkPartitionedDataSet()
    for part in range(2):
        ids = vtkIdList()
        for cell in range(part, data.GetNumberOfCells(), 2):
            ids.InsertNextId(cell)
        some = vtkExtractCells()
        some.SetInputData(data)
        some.SetCellList(ids)
        some.Update()
        parts.SetPartition(part, some.GetOutput())
    return given(parts)


ball = stiffened(simple.Sphere(Radius=50, ThetaResolution=40, PhiResolution=40))
check(ball, ball, "triangles")
assert "Normals" in in_order(in_paraview(ball))             # the arrays of the body are kept
check(simple.TriangleStrips(Input=ball), ball, "strips")

quads = stiffened(simple.Plane(Origin=(-20, -20, 0), Point1=(20, -20, 0), Point2=(-20, 20, 0),
                               XResolution=8, YResolution=5))
check(quads, simple.Triangulate(Input=quads), "polygons")

other = stiffened(simple.Sphere(Radius=20, Center=(100, 0, 0)))
check(simple.GroupDatasets(Input=[ball, other]), simple.AppendGeometry(Input=[ball, other]), "blocks")

image = stiffened(simple.Wavelet(WholeExtent=(-4, 4, -5, 5, -6, 6)))
surface = plain_surface(image)
check(image, surface, "image")
check(simple.ImageDatatoPointSet(Input=image), surface, "structured grid")
check(simple.AppendDatasets(Input=[image]), surface, "unstructured grid of voxels")
tetrahedra = simple.Tetrahedralize(Input=image)
check(tetrahedra, plain_surface(tetrahedra), "tetrahedra")
grid = vtkRectilinearGrid()
voxels = servermanager.Fetch(image)
grid.SetDimensions(voxels.GetDimensions())
for half, set_ticks in zip((4, 5, 6), (grid.SetXCoordinates, grid.SetYCoordinates, grid.SetZCoordinates)):
    set_ticks(numpy_to_vtk(np.arange(-half, half + 1.0), deep=True))
grid.GetPointData().ShallowCopy(voxels.GetPointData())
check(given(grid), surface, "rectilinear grid")

# Partitions form one body: no inner wall where volumes meet, and no duplicate points.
check(halves(image), surface, "image in partitions")
check(halves(tetrahedra), plain_surface(tetrahedra), "tetrahedra in partitions")
bare = stiffened(simple.Triangulate(Input=simple.Clean(Input=simple.Cylinder(Radius=20, Height=30, Capping=1))))
check(halves(bare), bare, "surface in partitions")
