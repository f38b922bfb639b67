# SPDX-License-Identifier: BSD-3-Clause
"""Presses three tools on a strip that bends and on a block that dents; prints the difference of the tools' forces.

    ./run python Plugin/Python/examples/compare_global_local.py
"""
import palpate
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource

YOUNG, POISSON = 1.0, 0.45                                  # MPa, -


def surface_with_compliance(size, held):
    box = vtkCubeSource()
    box.SetXLength(size[0])                                 # mm
    box.SetYLength(size[1])
    box.SetZLength(size[2])
    surface = vtkTriangleFilter()
    surface.SetInputConnection(box.GetOutputPort())
    solid = palpate.vtkVoxelBody()                          # hexahedra of 1 mm, held at the given faces
    solid.SetInputConnection(surface.GetOutputPort())
    solid.SetSpacing(1)
    solid.SetFixedFaces(held)
    body = palpate.vtkElasticCompliance()                   # global compliance of the body
    body.SetInputConnection(solid.GetOutputPort())
    body.SetYoungsModulus(YOUNG)
    body.SetPoissonRatio(POISSON)
    body.Update()
    return body.GetOutput()


for name, size, held in (("strip", (48, 12, 4), "x- x+"), ("block", (24, 24, 12), "z-")):
    body = surface_with_compliance(size, held)
    middle = body.FindPoint((0, 0, size[2] / 2))
    print(name, "C %.5f mm/N" % body.GetPointData().GetArray("GlobalCompliance").GetValue(middle), end="  ")
    forces = []
    for tool in ("flat:1", "sphere:6.35", "cone:80"):       # mm and degrees
        felt = palpate.response(body, tool, YOUNG, POISSON, compliance="GlobalCompliance", maximum_deflection=1)
        forces.append(palpate.curves(felt, middle, deflection=1).force[0])
        print(tool, "%.5f N" % forces[-1], end="  ")
    print("apart %.1f %%" % (100 * (max(forces) / min(forces) - 1)))
