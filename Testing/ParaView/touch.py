# SPDX-License-Identifier: BSD-3-Clause
"""Touch: the force has the closed form of the tool at any position of the tip; animated, saved and loaded. Usage:
touch.py FOLDER"""
import sys
import numpy as np
import palpate
from paraview import servermanager, simple, smtrace
from vtkmodules.util.numpy_support import vtk_to_numpy

YOUNG, POISSON, RANGE = 0.05, 0.4, 3.0                      # MPa, -, mm
FLOAT = 1e-6                                                # relative error of stored floats


def tool():
    made = palpate.vtkContactTool()
    made.SetShapeToParaboloid()                             # the samples store the law of this shape exactly
    made.SetRadius(6.35)
    return made


def force_at(depth):
    return tool().GetForce(depth, YOUNG / (1 - POISSON**2))


def field(touch, name):
    touch.UpdatePipeline()
    array = servermanager.Fetch(touch, idx=2).GetFieldData().GetArray(name)
    value = array.GetTuple(0)
    return value[0] if len(value) == 1 else np.array(value)


def text(touch):
    return servermanager.Fetch(touch, idx=3).GetValue(0, 0).ToString()


def block():
    """A body with flat faces, on which a press has the force of a half-space."""
    plate = simple.Plane(Origin=(-40, -30, 5), Point1=(40, -30, 5), Point2=(-40, 30, 5), XResolution=80,
                         YResolution=60)
    triangles = simple.Triangulate(Input=plate)
    response = simple.ToolContactResponse(Input=triangles)
    response.Tool.Shape = "Paraboloid"
    response.Tool.Radiusmm = 6.35
    response.YoungsModulusMPa = YOUNG
    response.PoissonsRatio = POISSON
    response.MaximumDeflectionmm = RANGE
    response.UpdatePipeline()
    return response


def ball_with_tail(name="Response"):
    """A ball of 30 mm with a thin tail, 60 mm long. The tail ends in the corner of the bounds that faces the first
    view."""
    ball = simple.Sphere(Radius=30, ThetaResolution=120, PhiResolution=120)
    pulled = simple.Calculator(Input=ball, CoordinateResults=1,
                               Function="coords * (1 + 2 * exp(((coordsX + coordsY + coordsZ) / (30 * sqrt(3)) - 1) / 0.01))")
    return simple.ToolContactResponse(Input=pulled, ResponseName=name, WholeBody=0)


def check_start(folder):
    """The initial position is on the ball, on the side that faces the active view; without a view, on the upper
    side."""
    def check(touch, towards):
        start, towards = np.array(touch.TipPositionmm), np.array(towards) / np.linalg.norm(towards)
        np.testing.assert_allclose(np.linalg.norm(start), 30, atol=0.1)      # the facets' sag is 0.05 mm
        way = start / np.linalg.norm(start)
        assert way @ towards > 0.5 and way @ np.ones(3) / np.sqrt(3) < np.cos(0.4), (start, towards)
        np.testing.assert_allclose(field(touch, "ContactPoint"), start, atol=0.05)
        assert "invalid" not in text(touch)

    response = ball_with_tail()
    first = simple.Touch(Input=response)
    check(first, (0, 0, 1))
    check(simple.Touch(Input=ball_with_tail("Soft")), (0, 0, 1))
    assert list(simple.Touch(Input=response, TipPositionmm=(1, 2, 3)).TipPositionmm) == [1, 2, 3]
    view = simple.CreateView("RenderView")
    view.CameraFocalPoint, view.CameraViewUp = (0, 0, 0), (0, 0, 1)
    smtrace.start_trace()
    for place in ((-200, 20, 10), (30, -180, 60), (0, 0, -250)):
        view.CameraPosition = place
        view.CameraViewUp = (0, 1, 0) if place[2] < -200 else (0, 0, 1)
        last = simple.Touch(Input=response)
        check(last, place)
    trace = smtrace.stop_trace()
    assert trace.count(".TipPositionmm = [") == 3, trace    # the script must not depend on the current view
    kept = list(last.TipPositionmm)
    simple.RenameSource("begun", last)
    view.CameraPosition = (200, 0, 0)                       # the state must not set the camera of the view again
    simple.SaveState(folder + "/touch_start.pvsm")
    simple.ResetSession()
    simple.LoadState(folder + "/touch_start.pvsm")
    assert list(simple.FindSource("begun").TipPositionmm) == kept
    simple.ResetSession()


def check_positions(response):
    """The default position is in the middle, at a depth of half of Range. Then the tip is moved to other positions."""
    touch = simple.Touch(Input=response)
    np.testing.assert_allclose(touch.TipPositionmm, (0, 0, 5), atol=1e-9)
    assert touch.SnapToSurface == 1 and touch.Indentationmm == 0 and touch.ResponseName == "Response"
    for tip in ((0.2, 0.1, 5), (-17.3, 12.9, 80), (3, -4, -20)):
        touch.TipPositionmm = tip
        np.testing.assert_allclose(field(touch, "NormalForce"), force_at(RANGE / 2), rtol=FLOAT)
        np.testing.assert_allclose(field(touch, "TipPosition"), (tip[0], tip[1], 5 - RANGE / 2), atol=1e-5)
        np.testing.assert_allclose(field(touch, "Force"), (0, 0, force_at(RANGE / 2)), atol=1e-6)
    touch.Indentationmm = 0.7
    np.testing.assert_allclose(field(touch, "NormalForce"), force_at(0.7), rtol=FLOAT)
    touch.SnapToSurface = 0
    touch.Indentationmm = 0
    for height in (4.5, 3.1):
        touch.TipPositionmm = (1, 2, height)
        np.testing.assert_allclose(field(touch, "NormalForce"), force_at(5 - height), rtol=FLOAT)
        assert f"Force {force_at(5 - height):#.3g} N" in text(touch), text(touch)
    touch.TipPositionmm = (1, 2, 7.5)
    assert field(touch, "NormalForce") == 0 and "2.50 mm off the surface" in text(touch), text(touch)
    return touch


def check_dent(touch):
    touch.SnapToSurface = 1
    touch.Indentationmm = 0
    touch.TipPositionmm = (0, 0, 5)
    touch.UpdatePipeline()
    body = servermanager.Fetch(touch, idx=0)
    heights = vtk_to_numpy(body.GetPoints().GetData())[:, 2]
    dent = vtk_to_numpy(body.GetPointData().GetArray("Dent (mm)"))
    np.testing.assert_allclose(dent.max(), RANGE / 2, rtol=FLOAT)   # a vertex is right under the tip
    np.testing.assert_allclose(5 - heights, dent, atol=1e-6)        # floats of 5 mm
    assert body.GetPointData().HasArray("ResponseForce")


def check_second_tip(response):
    """Two handles: each tool alone, and both coupled, with the forces of the probe. The second handle begins next to
    the first."""
    touch = simple.Touch(Input=response, SecondTip=1)
    first, second = np.array(touch.TipPositionmm), np.array(touch.SecondTipPositionmm)
    assert 5 < np.linalg.norm(second - first) < 30, (first, second)
    touch.TipPositionmm, touch.SecondTipPositionmm = (0.2, 0.1, 5), (9.2, 0.1, 40)
    alone = [force_at(RANGE / 2)] * 2
    np.testing.assert_allclose(forces(touch), alone, rtol=FLOAT)
    assert "do not interact" in text(touch), text(touch)
    response.Coupling = 1
    tips = np.array([[0.2, 0.1, 5 - RANGE / 2], [9.2, 0.1, 5 - RANGE / 2]])
    response.UpdatePipeline()
    felt = palpate.probe(servermanager.Fetch(response), tips, coupled=True)
    np.testing.assert_array_equal(forces(touch), felt.normal_force)
    assert (forces(touch) < 0.97 * np.array(alone)).all() and "less by the other tip" in text(touch), text(touch)
    dent = vtk_to_numpy(servermanager.Fetch(touch, idx=0).GetPointData().GetArray("Dent (mm)"))
    places = vtk_to_numpy(servermanager.Fetch(response).GetPoints().GetData())
    for tip in tips:                                        # the surface touches both tools
        under = np.linalg.norm((places - tip)[:, :2], axis=1).argmin()
        np.testing.assert_allclose(dent[under], RANGE / 2, rtol=0.02)    # C is from a point law, a tenth of a mm away
    tools = servermanager.Fetch(touch, idx=1).GetBounds()
    assert tools[0] < 0 and tools[1] > 9.2, tools
    response.Coupling = 0
    touch.SecondTip = 0
    touch.UpdatePipeline()
    assert len(forces(touch)) == 1


def forces(touch):
    touch.UpdatePipeline()
    return vtk_to_numpy(servermanager.Fetch(touch, idx=2).GetFieldData().GetArray("NormalForce"))


def check_animation(touch):
    """An animation cue moves the tip along a line. The force follows at each frame."""
    touch.SnapToSurface = 0
    scene = simple.GetAnimationScene()
    scene.PlayMode = "Sequence"
    scene.StartTime, scene.EndTime, scene.NumberOfFrames = 0, 1, 5
    cue = simple.GetAnimationTrack("TipPosition", index=2, proxy=touch)
    start, end = simple.CompositeKeyFrame(), simple.CompositeKeyFrame()
    start.KeyTime, start.KeyValues = 0, [5]
    end.KeyTime, end.KeyValues = 1, [3]
    cue.KeyFrames = [start, end]
    for frame in range(1, 5):
        scene.AnimationTime = frame / 4
        np.testing.assert_allclose(field(touch, "NormalForce"), force_at(frame / 2), rtol=FLOAT)
    scene.AnimationTime = 0


def check_state(touch, file):
    """A saved and loaded state has the same numbers, and its ports have the same appearance."""
    touch.TipPositionmm = (7, 8, 3.6)
    simple.RenameSource("touch", touch)
    view = simple.CreateView("RenderView")
    shown = [simple.Show(servermanager.OutputPort(touch, port), view) for port in range(4)]
    simple.Render(view)
    assert shown[1].Opacity == 0.4 and tuple(shown[2].DiffuseColor) == (1, 0.4, 0)
    assert shown[0].ColorArrayName[1] == "Dent (mm)"
    assert shown[3].Justification == "Left"
    shown[1].Opacity = 0.7
    before = field(touch, "NormalForce"), text(touch)
    simple.SaveState(file)
    simple.ResetSession()
    simple.LoadState(file)
    touch = simple.FindSource("touch")
    assert (field(touch, "NormalForce"), text(touch)) == before
    view = simple.GetActiveViewOrCreate("RenderView")
    again = [simple.GetDisplayProperties(servermanager.OutputPort(touch, port), view) for port in range(4)]
    assert again[1].Opacity == 0.7 and tuple(again[2].DiffuseColor) == (1, 0.4, 0)


def check_defaults():
    """Labels, defaults equal to those of the class, and a help text for each property."""
    proxy = servermanager.ProxyManager().NewProxy("filters", "ToolTouch")
    made = proxy.GetClientSideObject()
    assert type(made) is palpate.vtkToolTouch
    expected = {"Input": None, "Tip Position (mm)": [0, 0, 0], "Second Tip": [0],
                "Second Tip Position (mm)": [0, 0, 0], "Snap To Surface": [1], "Indentation (mm)": [0],
                "Response Name": ["Response"], "Force Scale (mm/N)": [0], "Tool Length (mm)": [0],
                "Poisson's Ratio": [0.45], "Extent Of Dent (contact radii)": [20]}
    found = {}
    keys = proxy.NewPropertyIterator()
    keys.Begin()
    while not keys.IsAtEnd():
        item = keys.GetProperty()
        assert item.GetDocumentation().GetDescription(), item.GetXMLLabel()
        value = None
        if not item.IsA("vtkSMProxyProperty"):
            value = [item.GetElement(i) for i in range(item.GetNumberOfElements())]
            given = getattr(made, "Get" + keys.GetKey())()
            assert list(given if isinstance(given, tuple) else [given]) == value, (keys.GetKey(), given, value)
        found[item.GetXMLLabel()] = value
        keys.Next()
    assert found == expected, found


check_defaults()
check_start(sys.argv[1])
plate = block()
check_second_tip(plate)
pressed = check_positions(plate)
check_dent(pressed)
check_animation(pressed)
check_state(pressed, sys.argv[1] + "/touch.pvsm")
