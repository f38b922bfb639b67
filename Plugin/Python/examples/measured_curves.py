# SPDX-License-Identifier: BSD-3-Clause
"""Identifies a body from curves measured with a sphere: prints the body at each site, and the force of a flat punch.

    ./run python Plugin/Python/examples/measured_curves.py [CURVES.csv]
"""
import sys
from pathlib import Path
import palpate
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource

curves = Path(__file__).parents[3] / "Data/Examples/cylinder_sphere_curves.csv"
plate = vtkPlaneSource()                                    # through the sites, facing +z
plate.SetOrigin(-30, -15, 50)                               # mm
plate.SetPoint1(30, -15, 50)
plate.SetPoint2(-30, 15, 50)
plate.SetResolution(60, 30)
body = vtkTriangleFilter()
body.SetInputConnection(plate.GetOutputPort())

punch = palpate.vtkContactTool()
punch.SetSpecification("flat:1.6")
response = palpate.vtkMeasuredContactResponse()
response.SetInputConnection(body.GetOutputPort())
response.AddFileName(sys.argv[1] if len(sys.argv) > 1 else str(curves))
response.SetTool(punch)
response.Update()

felt = response.GetOutput()
sites = response.GetOutputDataObject(1)                     # a table of the bodies found at the sites
for row in range(sites.GetNumberOfRows()):
    name = sites.GetValueByName(row, "Site").ToString()
    modulus = sites.GetValueByName(row, "ReducedModulus (MPa)").ToDouble()
    compliance = sites.GetValueByName(row, "Compliance (mm/N)").ToDouble()
    place = [sites.GetValueByName(row, axis + " (mm)").ToDouble() for axis in "XYZ"]
    force = palpate.curves(felt, felt.FindPoint(place), deflection=0.5).force[0]
    print("%5s  E* %.3f MPa  C %.4f mm/N  0.5 mm deep: %.4f N" % (name, modulus, compliance, force))
