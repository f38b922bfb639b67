# SPDX-License-Identifier: BSD-3-Clause
"""Charts that open automatically: curves of selected points, of several responses, forces along a path, and measured
readings. The horizontal axis of each chart is its first column. A chart shows only forces, and its axes have titles:
charts.py FOLDER

Needs an X server for the pictures.
"""
import os
import sys

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

FOLDER = sys.argv[1]
FLOAT = 5e-7                                                # relative error of a stored float
YOUNG, POISSON = 0.05, 0.45                                 # MPa, -
REDUCED = YOUNG / (1 - POISSON**2)
if not os.environ.get("DISPLAY"):
    print("no DISPLAY: nothing was drawn")
    sys.exit(77)


def rows(proxy):
    return servermanager.Fetch(proxy).GetRowData()


def column(proxy, name):
    return vtk_to_numpy(rows(proxy).GetArray(name))


def names(proxy):
    return [rows(proxy).GetArrayName(i) for i in range(rows(proxy).GetNumberOfArrays())]


def opened(proxy):
    """Shows the proxy in the view that ParaView chooses, which must be a line chart. Returns the view and the
    representation."""
    proxy.UpdatePipeline()
    controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
    made = controller.ShowInPreferredView(proxy.SMProxy, 0, None)
    assert made.GetXMLName() == "XYChartView", made.GetXMLName()
    view = servermanager._getPyProxy(made)
    view.ViewSize = [600, 400]
    shown = simple.GetRepresentation(proxy, view)
    assert shown.SMProxy.GetXMLName() == "ForceChartRepresentation", shown.SMProxy.GetXMLName()
    return view, shown


def chart_of(view):
    simple.Render(view)
    return view.SMProxy.GetClientSideObject().GetContextItem()


def visible(shown):
    """The names of the series that are drawn."""
    return set(shown.SeriesVisibility)


def check_axes(view, bottom, left="Force (N)"):
    chart = chart_of(view)
    assert chart.GetAxis(1).GetTitle() == bottom, chart.GetAxis(1).GetTitle()
    assert chart.GetAxis(0).GetTitle() == left, chart.GetAxis(0).GetTitle()


def check_span(view, bottom, top):
    """Checks the ranges of both axes, except for rounding at their ends."""
    chart = chart_of(view)
    for axis, (low, high) in ((1, bottom), (0, top)):
        found = [chart.GetAxis(axis).GetMinimum(), chart.GetAxis(axis).GetMaximum()]
        slack = 0.25 * (high - low)                          # round numbers at the ends
        assert abs(found[0] - low) < slack and abs(found[1] - high) < slack, (found, low, high)


def picture(view, name):
    """Saves a picture and checks that it has other colours than those of the axes, which are black, and of the
    background."""
    file = os.path.join(FOLDER, name)
    simple.SaveScreenshot(file, view)
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)
    coloured = (pixels.max(axis=1) - pixels.min(axis=1) > 60).sum()
    assert coloured > 200, (name, coloured)


def hertz(depth, modulus=REDUCED, radius=6.35):
    return 4 / 3 * modulus * radius**0.5 * np.maximum(depth, 0) ** 1.5


def body_with_responses():
    ball = simple.Sphere(Radius=50, ThetaResolution=60, PhiResolution=60)
    plain = {"CurvatureCorrection": 0, "ErrorTolerance": 0, "WholeBody": 0}    # closed forms, without error bands
    first = simple.ToolContactResponse(Input=ball, YoungsModulusMPa=YOUNG, PoissonsRatio=POISSON, **plain)
    first.Tool.Shape, first.Tool.Radiusmm = "Paraboloid", 6.35
    both = simple.ToolContactResponse(Input=first, YoungsModulusMPa=YOUNG, PoissonsRatio=POISSON, ResponseName="Flat",
                                      MaximumDeflectionmm=3, **plain)
    both.Tool.Shape, both.Tool.Radiusmm = "Flat", 2
    both.UpdatePipeline()
    return both


def check_selected(body):
    """The filter starts with the selected points of the body. Other kinds of selection come from other sources."""
    body.SMProxy.SetSelectionInput(0, simple.IDSelectionSource(
        FieldType="POINT", IDs=[-1, 7, -1, 3]).SMProxy, 0)
    curves = simple.ResponseCurves(Input=body)
    assert curves.Selection is not None, "the selection was not taken over"
    assert names(curves) == ["Deflection (mm)", "Response at point 3 (N)", "Response at point 7 (N)"], names(curves)
    depth = column(curves, "Deflection (mm)")
    np.testing.assert_allclose(column(curves, "Response at point 7 (N)"), hertz(depth), rtol=2 * FLOAT, atol=1e-9)

    view, shown = opened(curves)
    assert visible(shown) == {"Response at point 3 (N)", "Response at point 7 (N)"}, visible(shown)
    check_axes(view, "Deflection (mm)")
    check_span(view, (0, 2), (0, hertz(2.0)))
    picture(view, "chart_selected.png")

    points = vtk_to_numpy(servermanager.Fetch(body).GetPoints().GetData())
    high = np.flatnonzero(points[:, 2] > 49.9)
    for selection in (simple.SelectionQuerySource(QueryString="Height > 49.9", ElementType=0),
                      simple.ThresholdSelectionSource(FieldType="POINT", ArrayName="Height", Thresholds=[49.9, 51]),
                      simple.FrustumSelectionSource(FieldType="POINT", Frustum=[
                          c for x in (-60, 60) for y in (-60, 60) for z in (60, 49.9) for c in (x, y, z, 1)])):
        lifted = simple.Calculator(Input=body, ResultArrayName="Height", Function="coordsZ")
        other = simple.ResponseCurves(Input=lifted, Selection=selection, MaximumNumberOfPoints=100)
        found = names(other)
        assert found[1:] == ["Response at point %d (N)" % i for i in high], (selection, found, high)
    body.SMProxy.SetSelectionInput(0, None, 0)
    assert simple.ResponseCurves(Input=body).Selection is None
    return curves, view


def check_several(body, curves, view):
    """Several responses on one chart. Their columns are shown automatically; a title set by the user is kept."""
    curves.Selection = None
    curves.PointIds = [5]
    curves.MoreResponseNames = ["Flat"]
    simple.Render(view)
    assert names(curves) == ["Deflection (mm)", "Response at point 5 (N)", "Flat at point 5 (N)"], names(curves)
    depth, flat = column(curves, "Deflection (mm)"), column(curves, "Flat at point 5 (N)")
    np.testing.assert_allclose(flat, 2 * 2 * REDUCED * depth, rtol=2 * FLOAT, atol=1e-9)
    assert depth[-1] == 3 and np.isnan(column(curves, "Response at point 5 (N)")[-1])
    shown = simple.GetRepresentation(curves, view)
    assert {"Response at point 5 (N)", "Flat at point 5 (N)"} <= visible(shown), visible(shown)
    assert "Deflection (mm)" not in visible(shown)
    view.BottomAxisTitle = "Indentation (mm)"
    check_axes(view, "Indentation (mm)")
    view.BottomAxisTitle = ""
    check_axes(view, "Deflection (mm)")
    picture(view, "chart_several.png")
    curves.ResponseName, curves.MoreResponseNames = "Flat", []
    assert names(curves)[1:] == ["Flat at point 5 (N)"]


def check_band():
    """The error of a force is shown by two thin lines in the colour of the force, without entries in the legend."""
    body = simple.ToolContactResponse(Input=simple.Sphere(Radius=50, ThetaResolution=60, PhiResolution=60), WholeBody=0)
    curves = simple.ResponseCurves(Input=body, PointIds=[70])
    force = "Response at point 70"
    band = [force + ", least (N)", force + ", most (N)"]
    assert names(curves) == ["Deflection (mm)", force + " (N)", *band], names(curves)
    middle, least, most = (column(curves, name) for name in (force + " (N)", *band))
    assert (least[1:] < middle[1:]).all() and (middle[1:] < most[1:]).all()
    view, shown = opened(curves)
    assert visible(shown) == {force + " (N)", *band}, visible(shown)
    chart = chart_of(view)
    plots = [chart.GetPlot(i) for i in range(chart.GetNumberOfPlots())
             if chart.GetPlot(i).GetLabel().startswith(force)]
    colours = set()
    for plot in plots:
        colour = [0.0, 0.0, 0.0]
        plot.GetPen().GetColorF(colour)
        colours.add(tuple(colour))
    assert len(plots) == 3 and len(colours) == 1, ([plot.GetLabel() for plot in plots], colours)
    assert sorted(plot.GetLegendVisibility() for plot in plots) == [False, False, True]
    picture(view, "chart_band.png")
    curves.ErrorBand = 0
    assert len(names(curves)) == 2


def check_history(body):
    """Along a line into the ball: the horizontal axis is the deflection if there are no times, otherwise the time."""
    way = simple.Line(Point1=(53, 0, 5), Point2=(48, 0, 5), Resolution=50)
    probe = simple.ToolContactProbe(Body=body, Tips=way)
    history = simple.ContactHistory(Tips=probe)
    felt = servermanager.Fetch(probe).GetPointData()
    assert names(history) == ["Deflection (mm)", "Normal Force (N)", "Friction Force (N)", "Force (N)"], names(history)
    np.testing.assert_array_equal(column(history, "Normal Force (N)"), vtk_to_numpy(felt.GetArray("NormalForce")))
    view, shown = opened(history)
    check_axes(view, "Deflection (mm)")
    assert visible(shown) == {"Normal Force (N)", "Friction Force (N)", "Force (N)"}, visible(shown)
    # If there are times, the same chart switches to time by itself, and back.
    timed = simple.Calculator(Input=way, ResultArrayName="Time", Function="(53 - coordsX) / 5")
    probe.Tips = timed
    simple.Render(view)
    assert names(history)[:2] == ["Time (s)", "Deflection (mm)"], names(history)
    check_axes(view, "Time (s)")
    check_span(view, (0, 1), (0, column(history, "Force (N)").max()))
    assert "Time (s)" not in visible(shown) and "Deflection (mm)" not in visible(shown)
    picture(view, "chart_time.png")
    history.Abscissa = "Deflection (mm)"
    check_axes(view, "Deflection (mm)")
    picture(view, "chart_deflection.png")
    shown.XArrayName = "Time (s)"                            # chosen in the chart itself
    check_axes(view, "Time (s)")


def check_loop():
    """A slab of liver pressed at 1 mm/s and probed at these times: force loop over deflection, memory over time."""
    slab = simple.Triangulate(Input=simple.Plane(Origin=(-20, -20, 0), Point1=(20, -20, 0), Point2=(-20, 20, 0)))
    response = simple.ToolContactResponse(Input=slab, YoungsModulusMPa=0.01, PoissonsRatio=0.5, LayerThicknessmm=10,
                                          MaximumDeflectionmm=5, NumberOfSamples=16, Relaxations=[0.5, 0.5, 0.5, 10])
    response.Tool.Shape, response.Tool.Radiusmm = "Paraboloid", 6.35
    way = simple.Line(Point1=(0.3, 0.2, 0), Point2=(10.3, 0.2, 0), Resolution=2000) # x - 0.3 is the time
    time = simple.Calculator(Input=way, ResultArrayName="Time", Function="coordsX - 0.3")
    tips = simple.Calculator(Input=time, CoordinateResults=1, ResultArrayName="tips",
                             Function="0.3*iHat + 0.2*jHat + (abs(Time - 5) - 5)*kHat")
    probe = simple.ToolContactProbe(Body=response, Tips=tips)
    history = simple.ContactHistory(Tips=probe)
    view, shown = opened(history)
    check_axes(view, "Time (s)")
    assert {"Normal Force (N)", "Slow Force (N)", "Memory Force (N)"} <= visible(shown), visible(shown)
    picture(view, "chart_memory.png")
    history.Abscissa = "Deflection (mm)"
    check_axes(view, "Deflection (mm)")
    picture(view, "chart_loop.png")
    deflection, felt, slow = (column(history, name) for name in ("Deflection (mm)", "Normal Force (N)", "Slow Force (N)"))
    np.testing.assert_allclose(felt - slow, column(history, "Memory Force (N)"), atol=1e-12)
    touches = np.flatnonzero(felt)
    way = np.diff(deflection[touches[0]:touches[-1] + 1])
    work = way * (felt[touches[0]:touches[-1]] + felt[touches[0] + 1:touches[-1] + 1]) / 2
    # Data/Reference/rate/loops_paper.csv
    assert abs(work.sum() / work[way > 0].sum() - 0.2434) < 0.01, work.sum() / work[way > 0].sum()
    assert abs(felt.max() / slow.max() - 1.514) < 0.01, felt.max() / slow.max()
    assert abs(deflection[touches[-1]] / 5 - 0.1417) < 0.005, deflection[touches[-1]]


def check_measured():
    """Readings are shown as points, the curves of the identified bodies as lines."""
    file = os.path.join(FOLDER, "charted.csv")
    rng = np.random.default_rng(1)
    with open(file, "w", encoding="utf-8") as csv:
        csv.write("# tool: paraboloid:6.35\nsite,x_mm,y_mm,z_mm,deflection_mm,force_N\n")
        for site, x, modulus in (("A", -3, 0.05), ("B", 3, 0.1)):
            csv.writelines(f"{site},{x},0,0,{i / 40!r},{float(hertz(i / 40, modulus) + 2e-3 * rng.normal())!r}\n"
                           for i in range(-10, 61))
    flat = simple.Triangulate(Input=simple.Plane(
        Origin=(-10, -10, 0), Point1=(10, -10, 0), Point2=(-10, 10, 0), XResolution=10, YResolution=10))
    measured = simple.MeasuredContactResponse(Input=flat, Curves=[file])
    curves = simple.MeasuredCurves(Readings=servermanager.OutputPort(measured, 2))
    series = {"%s %s (N)" % (site, what) for site in "AB" for what in ("measured", "model")}
    assert set(names(curves)) == {"Deflection (mm)"} | series, names(curves)
    view, shown = opened(curves)
    check_axes(view, "Deflection (mm)")
    assert visible(shown) == series
    for prop, measured_value, model_value in ((shown.SeriesLineStyle, "0", "1"), (shown.SeriesMarkerStyle, "4", "0")):
        pairs = dict(zip(list(prop)[::2], list(prop)[1::2]))
        assert pairs["A measured (N)"] == measured_value and pairs["A model (N)"] == model_value, pairs
    picture(view, "chart_measured.png")


body = body_with_responses()
curves, view = check_selected(body)
check_several(body, curves, view)
check_band()
check_history(body)
check_loop()
check_measured()
