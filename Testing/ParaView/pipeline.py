# SPDX-License-Identifier: BSD-3-Clause
"""Builds one pipeline with every filter of the plugin, for the tests of state and trace, and reads its numbers.

Not a test: state.py and trace.py use it.
"""
import os
from contextlib import nullcontext

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

TIME = 0.55                                                 # s, between two steps of the trajectory


def write_files(folder):
    """A trajectory and curves, for the readers."""
    way, curves = os.path.join(folder, "way.csv"), os.path.join(folder, "curves.csv")
    with open(way, "w", encoding="utf-8") as csv:
        csv.write("time_s,tip_x_mm,tip_y_mm,tip_z_mm\n")
        csv.writelines(f"{i / 100!r},{52 - 5 * i / 100!r},0.25,5\n" for i in range(101))
    with open(curves, "w", encoding="utf-8") as csv:
        csv.write("site,x_mm,y_mm,z_mm,deflection_mm,force_N\n")
        csv.writelines(f"A,0,0,0,{i / 40!r},{4 / 3 * 0.05 * 6.35**0.5 * max(i / 40, 0)**1.5!r}\n"
                       for i in range(-10, 61))
    return way, curves


def set_tool(proxy, shape, changing, **sizes):
    with changing(proxy):
        proxy.Tool.Shape = shape
        for name, value in sizes.items():
            setattr(proxy.Tool, name, value)


def build(folder, changing=lambda proxy: nullcontext()):
    """Returns the names of the sources whose numbers are compared. `changing(proxy)` is a context in which its
    properties change."""
    way, measured = write_files(folder)
    made = []

    def add(create, name, **properties):
        made.append(name)
        return create(registrationName=name, **properties)

    ball = simple.Sphere(Radius=50, ThetaResolution=60, PhiResolution=60)
    body = simple.Calculator(Input=ball, ResultArrayName="Stiff", Function="0.05 + 0.001 * abs(coordsX)")
    body.UpdatePipeline()
    response = add(simple.ToolContactResponse, "response", Input=body, YoungsModulusArrayMPa=["POINTS", "Stiff"],
                   MaximumDeflectionmm=3, ResponseName="Cone")
    set_tool(response, "Cone", changing, HalfAngledegrees=45)
    both = add(simple.ToolContactResponse, "both", Input=response, ResponseName="Flat")
    set_tool(both, "Flat", changing, Radiusmm=4)
    both.UpdatePipeline()
    regime = add(simple.ContactRegime, "regime", Input=both, ResponseName="Cone", Deflectionmm=0.5)
    set_tool(regime, "Cone", changing)
    tips = add(simple.PalpateTrajectoryReader, "trajectory", FileName=way, FrameRate1s=10)
    probe = add(simple.ToolContactProbe, "probe", Body=both, Tips=tips, ResponseName="Cone", Indentationmm=0.25)
    add(simple.ContactDeflection, "dent", Body=both, Tips=probe, ResponseName="Cone", TipIndex=-1)
    add(simple.ContactHistory, "history", Tips=probe, Abscissa="Deflection (mm)")
    add(simple.ResponseCurves, "given", Input=both, ResponseName="Cone", MoreResponseNames=["Flat"],
        PointIds=[3, 7])
    selection = simple.IDSelectionSource(FieldType="POINT", IDs=[-1, 11, -1, 12])
    add(simple.ResponseCurves, "selected", Input=both, ResponseName="Flat", Selection=selection)
    add(simple.Touch, "touch", Input=both, ResponseName="Flat", TipPositionmm=[0, 60, 0], Indentationmm=0.7)
    plate = simple.Plane(Origin=(-10, -10, 0), Point1=(10, -10, 0), Point2=(-10, 10, 0), XResolution=10,
                         YResolution=10)
    table = simple.CSVReader(FileName=[measured])
    found = add(simple.MeasuredContactResponse, "measured", Input=simple.Triangulate(Input=plate), CurveTable=table,
                MeasuringTool="paraboloid:6.35", Reachmm=15)
    set_tool(found, "Sphere", changing, Radiusmm=2)
    found.UpdatePipeline()
    add(simple.MeasuredCurves, "readings", Readings=servermanager.OutputPort(found, 2))
    return made


def numbers(names):
    """Every number in the outputs of the sources at TIME, by source, port and array."""
    out = {}
    for name in names:
        source = simple.FindSource(name)
        assert source is not None, name + " did not come back"
        source.UpdatePipeline(TIME)
        for port in range(source.SMProxy.GetNumberOfOutputPorts()):
            data = servermanager.Fetch(source, idx=port)
            arrays = data.GetRowData() if data.IsA("vtkTable") else data.GetPointData()
            for i in range(arrays.GetNumberOfArrays()):
                if arrays.GetArray(i):
                    key = "%s %d %s" % (name, port, arrays.GetArrayName(i))
                    out[key] = np.array(vtk_to_numpy(arrays.GetArray(i)))
    return out


def check_same(found, expected):
    assert found.keys() == expected.keys(), found.keys() ^ expected.keys()
    for key, values in expected.items():
        np.testing.assert_array_equal(found[key], values, key)
