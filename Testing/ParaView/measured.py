# SPDX-License-Identifier: BSD-3-Clause
"""The proxy of vtkMeasuredContactResponse: properties, defaults, and its three outputs."""
import os
import sys

import palpate
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

MODULUS, RADIUS = 0.05, 6.35                                # E* in MPa, mm


def hertz(depth):
    return 4 / 3 * MODULUS * RADIUS ** 0.5 * max(depth, 0.0) ** 1.5


def write_curves(path):
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"# tool: paraboloid:{RADIUS}\n# synthetic: Hertz\n")
        file.write("site,x_mm,y_mm,z_mm,deflection_mm,force_N\n")
        for i in range(-10, 61):
            file.write(f"A,0,0,0,{0.2 + i / 40:.17g},{hertz(i / 40):.17g}\n")
    return path


def check_defaults(proxy):
    made = proxy.GetClientSideObject()
    assert type(made) is palpate.vtkMeasuredContactResponse
    keys = proxy.SMProxy.NewPropertyIterator()
    keys.Begin()
    while not keys.IsAtEnd():
        item, name = keys.GetProperty(), keys.GetKey()
        assert item.GetDocumentation() and item.GetDocumentation().GetDescription(), name
        getter = getattr(made, "Get" + name, None)
        if getter and not item.IsA("vtkSMProxyProperty") and not item.IsA("vtkSMInputProperty"):
            assert getter() == item.GetElement(0), (name, getter(), item.GetElement(0))
        keys.Next()


def main(folder):
    body = simple.Triangulate(Input=simple.Plane(XResolution=10, YResolution=10))  # 1 mm, its middle at 0
    proxy = simple.MeasuredContactResponse(Input=body)
    check_defaults(proxy)
    proxy.Curves = [write_curves(os.path.join(folder, "measured.csv"))]
    proxy.Tool.Shape = "Flat"
    proxy.Tool.Radiusmm = 1.6
    proxy.UpdatePipeline()
    force = vtk_to_numpy(servermanager.Fetch(proxy, idx=0).GetPointData().GetArray("ResponseForce"))
    flat = 2 * 1.6 * MODULUS * 2.0                          # N at 2 mm
    assert force.shape == (121, 8) and abs(force[60, 7] / flat - 1) < 1e-6, force[60, 7]
    sites = servermanager.Fetch(proxy, idx=1)
    assert sites.GetColumnByName("Verdict").GetValue(0) == "identified"
    assert abs(sites.GetColumnByName("ContactOffset (mm)").GetValue(0) - 0.2) < 1e-6
    assert servermanager.Fetch(proxy, idx=2).GetNumberOfRows() == 71


main(sys.argv[1])
