# SPDX-License-Identifier: BSD-3-Clause
"""A recorded trajectory is played, scrubbed and exported, followed by a probe, a dent and a chart: time.py FOLDER

A session presses and drags a sphere on a plate; its recording is opened as a Palpate Trajectory. At every time the
probe has the force of the session at that time, and the force from the whole path at once. Needs an X server.
"""
import csv
import glob
import os
import sys

import numpy as np
import palpate
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIOImage import vtkPNGReader

FOLDER = sys.argv[1]
FRICTION = 0.3
COLUMNS = ("time_s,tip_x_mm,tip_y_mm,tip_z_mm,contact_x_mm,contact_y_mm,contact_z_mm,deflection_mm,normal_force_N,"
           "friction_x_N,friction_y_N,friction_z_N,ideal_force_N,state")
if not os.environ.get("DISPLAY"):
    print("no DISPLAY: nothing was drawn")
    sys.exit(77)


def array(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def press_and_drag():
    """The path: down to a depth of 1 mm in 0.4 s, then 3 mm sideways until 1 s."""
    points, times, cells = vtkPoints(), vtkDoubleArray(), vtkCellArray()
    points.SetDataTypeToDouble()
    times.SetName("Time")
    cells.InsertNextCell(3)
    for i, (time, *tip) in enumerate(((0, 0.25, 0.5, 0.6), (0.4, 0.25, 0.5, -1), (1, 3.25, 0.5, -1))):
        points.InsertNextPoint(tip)
        times.InsertNextValue(time)
        cells.InsertCellPoint(i)
    path = vtkPolyData()
    path.SetPoints(points)
    path.SetLines(cells)
    path.GetPointData().AddArray(times)
    return path


def record(body, file):
    """The recording of a session with the simulated device, as a file and in memory."""
    session = palpate.vtkHapticSession()
    session.SetBody(body)
    session.GetDevice().SetPath(press_and_drag())
    session.GetSettings().SetFrictionCoefficient(FRICTION)
    assert session.Start()
    session.Step(1.0)
    session.Stop()
    felt = vtkPolyData()
    session.GetRecorder().GetRecording(felt)
    parts = [array(felt, "Time"), vtk_to_numpy(felt.GetPoints().GetData())]
    parts += [array(felt, name) for name in ("ContactPoint", "Deflection", "NormalForce", "FrictionForce")]
    total = array(felt, "NormalForce")[:, None] * array(felt, "Normal") if felt.GetPointData().HasArray("Normal") \
        else np.zeros((felt.GetNumberOfPoints(), 3))
    parts += [np.linalg.norm(total + array(felt, "FrictionForce"), axis=1), array(felt, "ContactState")]
    with open(file, "w", encoding="utf-8") as out:
        out.write(COLUMNS + "\n")
        for row in zip(*parts):
            numbers = [repr(float(x)) for part in row[:-1] for x in np.atleast_1d(part)]
            out.write(",".join([*numbers, str(int(row[-1]))]) + "\n")
    return felt


flat = simple.Triangulate(Input=simple.Plane(
    Origin=(-10, -10, 0), Point1=(10, -10, 0), Point2=(-10, 10, 0), XResolution=40, YResolution=40))
response = simple.ToolContactResponse(Input=flat)
response.Tool.Shape, response.Tool.Radiusmm = "Sphere", 5
felt = record(servermanager.Fetch(response), FOLDER + "/session.csv")
times = array(felt, "Time")

trajectory = simple.PalpateTrajectoryReader(FileName=FOLDER + "/session.csv", FrameRate1s=10)
probe = simple.ToolContactProbe(Body=response, Tips=trajectory, FrictionCoefficient=FRICTION)
dent = simple.ContactDeflection(Body=response, Tips=probe)
history = simple.ContactHistory(Tips=probe)
warp = simple.WarpByVector(Input=dent, Vectors=["POINTS", "ContactDisplacement"])
whole = simple.ToolContactProbe(
    Body=response, FrictionCoefficient=FRICTION,
    Tips=simple.PalpateTrajectoryReader(FileName=FOLDER + "/session.csv", WholePath=1))
all_at_once = servermanager.Fetch(whole)

# The probe on the whole path reproduces the session: the same kernel, the same tips.
for name in ("Deflection", "NormalForce", "FrictionForce"):
    np.testing.assert_allclose(array(all_at_once, name), array(felt, name), rtol=1e-12, atol=1e-13, err_msg=name)
assert abs(array(felt, "FrictionForce")).max() > 0.5 * FRICTION * array(felt, "NormalForce").max()

scene = simple.GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
keeper = simple.GetTimeKeeper()
steps = np.arange(11) / 10
steps[-1] = times[-1]                                       # the last tick ends the recording
for proxy in (probe, dent, history, warp):                  # times are passed on
    proxy.UpdatePipelineInformation()
    passed = proxy.GetClientSideObject().GetOutputInformation(0)
    assert passed.Length(vtkStreamingDemandDrivenPipeline.TIME_STEPS()) == len(trajectory.TimestepValues), proxy
np.testing.assert_allclose(keeper.TimestepValues, steps, atol=1e-9)
assert scene.PlayMode == "Snap To TimeSteps", scene.PlayMode

view = simple.CreateView("RenderView", ViewSize=[400, 300])
shown = simple.Show(warp, view)
simple.ColorBy(shown, ("POINTS", "ContactDisplacement", "Magnitude"))
colours = simple.GetColorTransferFunction("ContactDisplacement")
colours.RescaleTransferFunction(0, 1)
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0, -25, 20], [0, 0, 0], [0, 0, 1]
chart = simple.CreateView("XYChartView", ViewSize=[400, 300])
simple.Show(history, chart)


def check_now(time):
    """At this time the present tip is the last tip, and its data equal those of the whole path."""
    last = np.searchsorted(times, time + 1e-9, side="right")
    for view_at in (view, chart):
        simple.Render(view_at)
    now = probe.GetClientSideObject().GetOutput()           # the output for the time that the views have requested
    assert now.GetNumberOfPoints() == last, (time, now.GetNumberOfPoints(), last)
    for name in ("Deflection", "NormalForce", "FrictionForce", "Force"):
        np.testing.assert_array_equal(array(now, name), array(all_at_once, name)[:last], err_msg=name)
    deep = array(now, "Deflection")[-1]
    moved = array(dent.GetClientSideObject().GetOutput(), "ContactDisplacement")
    # The grid point nearest to the contact is at most 0.36 mm from the contact. There the sphere's
    # surface is 0.36^2/(2*5) mm higher, and the rim of the dent is not steeper.
    assert deep - 0.05 <= -moved[:, 2].min() + 1e-6 and -moved[:, 2].min() <= deep + 1e-6, (time, deep, moved.min())
    assert history.GetClientSideObject().GetOutput().GetNumberOfRows() == last
    return deep


scene.GoToFirst()
played, depths = [view.ViewTime], [check_now(view.ViewTime)]
for step in steps[1:]:
    scene.GoToNext()
    assert view.ViewTime == chart.ViewTime == keeper.Time
    played.append(view.ViewTime)
    depths.append(check_now(view.ViewTime))
np.testing.assert_allclose(played, steps, atol=1e-9)
# Tolerance: the motion in one tick, 4 mm/s for 1 ms
np.testing.assert_allclose(depths, np.clip(4 * steps - 0.6, 0, 1), atol=6e-3)
for time in (0.7, 0.2, 0.55, 0.0):                          # scrubbed, also between the steps
    scene.AnimationTime = time
    check_now(time)
scene.Play()
assert abs(view.ViewTime - steps[-1]) < 1e-9, view.ViewTime
check_now(view.ViewTime)

for old in glob.glob(FOLDER + "/played*") + glob.glob(FOLDER + "/exported*"):
    if os.path.isfile(old):
        os.remove(old)
for name, what in (("played", view), ("played_chart", chart)):
    simple.SaveAnimation("%s/%s.png" % (FOLDER, name), what, ImageResolution=[400, 300], FrameWindow=[0, 10])
    frames = []
    for file in sorted(glob.glob("%s/%s.0*.png" % (FOLDER, name))):
        reader = vtkPNGReader()
        reader.SetFileName(file)
        reader.Update()
        frames.append(vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int))
    assert len(frames) == 11, (name, len(frames))
    assert abs(frames[0] - frames[4]).max() > 100 and abs(frames[4] - frames[9]).max() > 100, name

simple.SaveData(FOLDER + "/exported.csv", proxy=history, WriteTimeSteps=1, WriteTimeStepsSeparately=1)
assert len(glob.glob(FOLDER + "/exported_*.csv")) == 11
for frame, time in enumerate(steps):
    file = "%s/exported_%d.csv" % (FOLDER, frame)
    with open(file, encoding="utf-8") as table:
        last = list(csv.DictReader(table))[-1]
    index = np.searchsorted(times, time + 1e-9, side="right") - 1
    found = [float(last[name]) for name in ("Time (s)", "Deflection (mm)", "Normal Force (N)")]
    expected = [times[index], array(all_at_once, "Deflection")[index], array(all_at_once, "NormalForce")[index]]
    np.testing.assert_allclose(found, expected, rtol=1e-4, atol=1e-6) # five digits are written
simple.SaveData(FOLDER + "/exported.pvd", proxy=dent, WriteTimeSteps=1, DataMode="Binary")
again = simple.PVDReader(FileName=FOLDER + "/exported.pvd")
np.testing.assert_allclose(again.TimestepValues, steps, atol=1e-6)
again.UpdatePipeline(again.TimestepValues[7])
scene.AnimationTime = steps[7]
dent.UpdatePipeline(steps[7])
np.testing.assert_array_equal(array(servermanager.Fetch(again), "ContactDisplacement"),
                              array(servermanager.Fetch(dent), "ContactDisplacement"))
