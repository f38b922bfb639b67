# SPDX-License-Identifier: BSD-3-Clause
"""A strip that bends beside a block that dents, under the same three tools; prints how far their forces lie apart.

    ./run python Plugin/Python/examples/compare_global_local.py
"""
from palpate import vtkContactTool, vtkElasticCompliance, vtkToolContactResponse, vtkVoxelBody
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource

YOUNG, POISSON, TOOLS = 1.0, 0.45, ("flat:1", "sphere:6.35", "cone:80")   # MPa, -, mm and degrees

for name, size, held in (("strip", (48, 12, 4), "x- x+"), ("block", (24, 24, 12), "z-")):
    box = vtkCubeSource()
    box.SetXLength(size[0]), box.SetYLength(size[1]), box.SetZLength(size[2])               # mm
    surface, solid, body = vtkTriangleFilter(), vtkVoxelBody(), vtkElasticCompliance()
    surface.SetInputConnection(box.GetOutputPort())
    solid.SetInputConnection(surface.GetOutputPort())       # hexahedra of 1 mm, held where it says
    solid.SetSpacing(1), solid.SetFixedFaces(held)
    body.SetInputConnection(solid.GetOutputPort())          # and how it gives way as a whole
    body.SetYoungsModulus(YOUNG), body.SetPoissonRatio(POISSON), body.Update()
    middle = body.GetOutput().FindPoint(0, 0, size[2] / 2)
    forces = []
    for specification in TOOLS:
        tool, response = vtkContactTool(), vtkToolContactResponse()
        tool.SetSpecification(specification)
        response.SetInputConnection(body.GetOutputPort()), response.SetTool(tool)
        response.SetYoungsModulus(YOUNG), response.SetPoissonRatio(POISSON), response.SetMaximumDeflection(1)
        response.SetInputArrayToProcess(2, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "GlobalCompliance")
        response.Update()
        forces.append(response.GetOutput().GetPointData().GetArray("ResponseForce").GetComponent(middle, 7))
    compliance = body.GetOutput().GetPointData().GetArray("GlobalCompliance").GetValue(middle)
    apart = 100 * (max(forces) / min(forces) - 1)
    print(name, "C %.5f mm/N " % compliance, *("%s %.5f N " % pair for pair in zip(TOOLS, forces)), "apart %.1f %%" % apart)
