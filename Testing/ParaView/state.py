# SPDX-License-Identifier: BSD-3-Clause
"""A pipeline of every filter is saved as a state, XML or Python, and has the same numbers when it is loaded:
state.py FOLDER

The charts are restored as well, if there is an X server.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from pipeline import build, check_same, numbers             # noqa: E402
from paraview import simple                                 # noqa: E402

CHARTS = bool(os.environ.get("DISPLAY"))
FOLDER = os.path.join(sys.argv[1], "state")                 # a separate folder: tests run in parallel


def show_charts():
    if CHARTS:
        view = simple.CreateView("XYChartView")
        for name in ("given", "history"):
            simple.Show(simple.FindSource(name), view)
        shown = simple.GetRepresentation(simple.FindSource("history"), view)
        shown.XArrayName = "Time (s)"
        simple.Render(view)


def check_properties():
    """Checks the properties that do not affect the numbers."""
    response = simple.FindSource("response")
    assert response.Tool.Shape == "Cone" and response.Tool.HalfAngledegrees == 45
    assert list(response.GlobalComplianceArraymmN)[1] in ("None", "")
    given, selected = simple.FindSource("given"), simple.FindSource("selected")
    assert given.ResponseName == "Cone" and list(given.MoreResponseNames) == ["Flat"]
    assert list(given.PointIds) == [3, 7] and not given.Selection
    assert list(selected.Selection.IDs) == [-1, 11, -1, 12], list(selected.Selection.IDs)
    measured = simple.FindSource("measured")
    assert measured.MeasuringTool == "paraboloid:6.35" and measured.CurveTable is not None
    times = list(simple.GetTimeKeeper().TimestepValues)
    assert len(times) == 11 and abs(times[3] - 0.3) < 1e-9, times
    if CHARTS:
        views = [view for view in simple.GetViews() if view.SMProxy.GetXMLName() == "XYChartView"]
        assert len(views) == 1, views
        simple.Render(views[0])
        chart = views[0].SMProxy.GetClientSideObject().GetContextItem()
        assert chart.GetAxis(0).GetTitle() == "Force (N)", chart.GetAxis(0).GetTitle()
        shown = {name: simple.GetRepresentation(simple.FindSource(name), views[0]) for name in ("given", "history")}
        assert all(r.SMProxy.GetXMLName() == "ForceChartRepresentation" for r in shown.values())
        assert shown["given"].XArrayName == "First column" and shown["history"].XArrayName == "Time (s)"
        assert set(shown["history"].SeriesVisibility) == {"Normal Force (N)", "Friction Force (N)", "Force (N)"}


os.makedirs(FOLDER, exist_ok=True)
sources = build(FOLDER)
show_charts()
before = numbers(sources)
assert before["probe 0 NormalForce"][-1] > 0 and abs(before["dent 0 ContactDisplacement"]).max() > 0.05
assert before["selected 0 Flat at point 11 (N)"][-1] > 0 and before["measured 0 ResponseForce"].max() > 0
check_properties()
for suffix in (".pvsm", ".py"):
    file = FOLDER + "/pipeline" + suffix
    simple.SaveState(file)
    simple.ResetSession()
    assert not simple.GetSources()
    simple.LoadState(file)
    check_same(numbers(sources), before)
    check_properties()
