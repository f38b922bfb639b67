# SPDX-License-Identifier: BSD-3-Clause
"""A ball is touched with the mouse; a panel changes tool and material during the contact. The key ? shows all keys.

    ./run python Plugin/Python/examples/touch_window.py    (--demo: a script moves the tool and prints the force)
"""
import sys
import time
import palpate
import vtkmodules.all as vtk

ball = vtk.vtkSphereSource()
ball.SetRadius(50)                                          # mm
ball.SetThetaResolution(300)
ball.SetPhiResolution(300)
ball.Update()

setup = palpate.vtkContactSetup()                           # body, tools and material of the contact
setup.SetBody(ball.GetOutput())
setup.SetYoungsModulus(0.05)                                # MPa
for specification in ("sphere:6.35", "flat:1.6"):
    tool = palpate.vtkContactTool()
    tool.SetSpecification(specification)
    setup.AddTool(tool)
setup.Update()

session = palpate.vtkHapticSession()                        # the servo thread at 1 kHz
session.SetRealTime(True)
session.GetRecorder().SetRecording(False)
setup.ApplyTo(session)

view, strip = vtk.vtkRenderer(), vtk.vtkRenderer()          # the body, and the panel next to it
window = vtk.vtkRenderWindow()
for part, left, right in ((view, 0, 0.77), (strip, 0.77, 1)):
    part.SetViewport(left, 0, right, 1)
    window.AddRenderer(part)
window.SetSize(1100, 760)
window.SetMultiSamples(0)

scene = palpate.vtkContactScene()                           # body, tool and force in the view
scene.SetRenderer(view)
scene.SetLargestForce(setup.GetLargestForce())
setup.ShowIn(scene)
style = palpate.vtkInteractorStyleHaptic()                  # the mouse moves the tool
style.SetSession(session)
style.SetScene(scene)
mouse = vtk.vtkRenderWindowInteractor()
mouse.SetRenderWindow(window)
mouse.SetInteractorStyle(style)
mouse.Initialize()
clock = palpate.vtkFrameClock()                             # 30 pictures a second
clock.SetInteractor(mouse)
scene.Follow(clock, session)
panel = palpate.vtkContactPanel()
panel.SetRenderer(strip)
panel.SetSetup(setup)
panel.SetStyle(style)
panel.SetClock(clock)
panel.On()
style.HoverAt((30, 0, 40), (0.6, 0, 0.8))
session.Start()
clock.Start()
scene.LookAtBody((1, -0.5, 0.7), (0, 0, 1))


def press_and_print(modulus):
    setup.SetYoungsModulus(modulus)
    style.SteerTo((29.4, 0, 39.2))                          # 1 mm deep
    begin = time.time()
    while time.time() < begin + 1.5:
        clock.ShowFrame()
        begin = time.time() if setup.IsBusy() else begin    # a new modulus takes a second or two
    session.GetIdealForce(force := [0.0, 0.0, 0.0])
    print("%.4f mm deep: %.4f N" % (session.GetDeflection(), vtk.vtkMath.Norm(force)))

if "--demo" in sys.argv:
    press_and_print(0.05)
    press_and_print(0.1)
    session.Stop()
else:
    mouse.Start()
