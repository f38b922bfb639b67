# SPDX-License-Identifier: BSD-3-Clause
"""The proxy of vtkMeasuredContactResponse: properties, defaults, its three outputs, and curves from a CSV reader."""
import os
import sys

import numpy as np
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
    body = simple.Triangulate(Input=simple.Plane(  # centred at 0
        Origin=(-10, -10, 0), Point1=(10, -10, 0), Point2=(-10, 10, 0), XResolution=10, YResolution=10))
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
    check_table(body, proxy, os.path.join(folder, "measured.csv"))


def check_table(body, from_file, file):
    """ParaView's CSV reader does not accept comments, so the tool is given as a property. All bits are the same as with
    the file."""
    with open(file, encoding="utf-8") as curves:
        rows = [line for line in curves if not line.startswith("#")]
    with open(file + ".plain.csv", "w", encoding="utf-8") as plain:
        plain.writelines(rows)
    table = simple.CSVReader(FileName=[file + ".plain.csv"])
    from_table = simple.MeasuredContactResponse(Input=body, CurveTable=table, MeasuringTool=f"paraboloid:{RADIUS}")
    from_table.Tool.Shape = "Flat"
    from_table.Tool.Radiusmm = 1.6
    one, other = servermanager.Fetch(from_table, idx=0), servermanager.Fetch(from_file, idx=0)
    arrays = [other.GetPointData().GetArrayName(i) for i in range(other.GetPointData().GetNumberOfArrays())]
    assert "IdentifiedModulus" in arrays and one.GetPointData().GetNumberOfArrays() == len(arrays)
    for name in arrays:
        np.testing.assert_array_equal(vtk_to_numpy(one.GetPointData().GetArray(name)),
                                      vtk_to_numpy(other.GetPointData().GetArray(name)), name)
    assert servermanager.Fetch(from_table, idx=2).GetNumberOfRows() == 71

    # The same test with every column as text, and with the output of a filter on the table.
    table.DetectNumericColumns = 0
    text = servermanager.Fetch(from_table, idx=0)
    np.testing.assert_array_equal(vtk_to_numpy(text.GetPointData().GetArray("ResponseForce")),
                                  vtk_to_numpy(other.GetPointData().GetArray("ResponseForce")))


main(sys.argv[1])
