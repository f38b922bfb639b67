# SPDX-License-Identifier: BSD-3-Clause
"""Bodies of every kind in pieces on several processes have the surface of the whole body, without walls at the seams.
Runs under mpiexec. The expected values are known: areas, numbers of triangles, and the force of one law times the
area."""
import numpy as np
import palpate
import raw_xml
from paraview import servermanager, simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController

CONTROLLER = vtkMultiProcessController.GetGlobalController()
if CONTROLLER.GetNumberOfProcesses() > 1:
    raw_xml.need_raw_xml()
FIRST = CONTROLLER.GetLocalProcessId() == 0
SPHERE = dict(ThetaResolution=40, PhiResolution=40)
SPHERE_TRIANGLES = 2 * 40 * (40 - 2)


def sphere_area(radius):
    """Area of the sphere's facets: the sum over the bands between neighbouring rings of polygons (40 rings)."""
    polar = np.pi * np.arange(40) / 39
    z, r = radius * np.cos(polar), radius * np.sin(polar)
    half = np.pi / 40
    slant = np.hypot(np.diff(z), np.diff(r) * np.cos(half))
    return np.sum(40 * np.sin(half) * (r[1:] + r[:-1]) * slant)


def check(name, source, area, triangles, **settings):
    response = simple.ToolContactResponse(Input=source, CurvatureCorrection=0, WholeBody=0, **settings)
    response.Tool.Shape = "Cone"
    response.UpdatePipeline()
    outward = simple.Calculator(Input=response, ResultArrayName="Length", Function="mag(ResponseNormal)")
    sums = servermanager.Fetch(simple.IntegrateVariables(Input=outward))
    found = response.GetDataInformation().GetNumberOfCells()
    tool = palpate.vtkContactTool()
    tool.SetShapeToCone()
    force = tool.GetForce(2.0, 0.1 / (1 - 0.45**2))
    if FIRST:
        assert found == triangles, (name, found, triangles)
        total = sums.GetCellData().GetArray("Area").GetTuple1(0)
        np.testing.assert_allclose(total, area, rtol=1e-6, err_msg=name)    # coordinates are floats
        whole = sums.GetPointData().GetArray("ResponseForce").GetTuple(0)[-1]
        # The same force at every point; float rounding.
        np.testing.assert_allclose(whole, force * area, rtol=2e-6, err_msg=name)
    return response


check("sphere", simple.Sphere(Radius=50, **SPHERE), sphere_area(50), SPHERE_TRIANGLES)
check("in cm", simple.Sphere(Radius=5, **SPHERE), sphere_area(50), SPHERE_TRIANGLES, LengthUnit="cm")
image = simple.Wavelet()                                    # 20 voxels of 1 mm along each side
check("image", image, 6 * 20**2, 2 * 6 * 20**2)
check("tetrahedra", simple.Tetrahedralize(Input=image), 6 * 20**2, 2 * 6 * 20**2)
check("without ghosts", simple.RedistributeDataSet(Input=image), 6 * 20**2, 2 * 6 * 20**2)
check("blocks", simple.GroupDatasets(Input=[simple.Sphere(Radius=20, Center=(60, 0, 0), **SPHERE), image]),
      sphere_area(20) + 6 * 20**2, SPHERE_TRIANGLES + 2 * 6 * 20**2)

# Mirrored and without normals: the whole body is inside out, which no single piece can detect.
mirror = simple.Transform(Input=simple.PassArrays(Input=simple.Sphere(Radius=50, **SPHERE)), Transform="Transform")
mirror.Transform.Scale = [-1, 1, 1]
mirror.UpdatePipeline()
assert "Normals" not in mirror.PointData.keys()
turned = check("inside out", mirror, sphere_area(50), SPHERE_TRIANGLES)
side = simple.Calculator(Input=turned, ResultArrayName="Side", Function="dot(ResponseNormal, coords)")
side.UpdatePipeline()
low, high = side.GetDataInformation().GetPointDataInformation().GetArrayInformation("Side").GetComponentRange(0)
if FIRST:
    assert 0 < low < high < 50.01, (low, high)
    print("done", CONTROLLER.GetNumberOfProcesses())
