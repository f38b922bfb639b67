# SPDX-License-Identifier: BSD-3-Clause
"""A ball under the mouse, with a panel that changes tool and material under the hand; ? shows the keys.
    ./run python Plugin/Python/examples/touch_window.py    (--demo: a script is the hand; prints what is felt)
"""
import sys, time, palpate, vtkmodules.all as vtk

def make(vtk_class, **properties):
    made = vtk_class()
    [getattr(made, "Set" + n)(*v if isinstance(v, tuple) else (v,)) for n, v in properties.items()]
    return made

ball = make(vtk.vtkSphereSource, Radius=50, ThetaResolution=300, PhiResolution=300)         # mm
ball.Update()
setup = make(palpate.vtkContactSetup, Body=ball.GetOutput(), YoungsModulus=0.05)            # MPa
[setup.AddTool(make(palpate.vtkContactTool, Specification=tool)) for tool in ("sphere:6.35", "flat:1.6")]
view, strip = make(vtk.vtkRenderer, Viewport=(0, 0, .77, 1)), make(vtk.vtkRenderer, Viewport=(.77, 0, 1, 1))
window = make(vtk.vtkRenderWindow, Size=(1100, 760), MultiSamples=0)
setup.Update(), window.AddRenderer(view), window.AddRenderer(strip)
session = make(palpate.vtkHapticSession, RealTime=True, Recording=False, HistorySeconds=2)
scene = make(palpate.vtkContactScene, Renderer=view, LargestForce=setup.GetLargestForce())
style = make(palpate.vtkInteractorStyleHaptic, Session=session, Scene=scene)
mouse = make(vtk.vtkRenderWindowInteractor, RenderWindow=window, InteractorStyle=style)
panel = make(palpate.vtkContactPanel, Renderer=strip, Setup=setup, Style=style)
setup.ApplyTo(session), setup.ShowIn(scene), mouse.Initialize(), panel.On()
style.HoverAt((30, 0, 40), (.6, 0, .8)), style.StartSession(), scene.LookAtBody((1, -.5, .7), (0, 0, 1))
for modulus in (0.05, 0.1) if "--demo" in sys.argv else ():
    setup.SetYoungsModulus(modulus), style.SteerTo((29.4, 0, 39.2))                         # 1 mm deep
    [(time.sleep(0.05), style.ShowFrame()) for frame in range(30)], session.GetIdealForce(force := [0, 0, 0])
    print("%.4f mm deep: %.4f N" % (session.GetDeflection(), vtk.vtkMath.Norm(force)))
mouse.Start() if "--demo" not in sys.argv else style.StopSession()
