# SPDX-License-Identifier: BSD-3-Clause
"""Uses Palpate in ParaView through its proxies: a ball, its responses, a probe, the dent; prints the force.

    ./run pvpython Plugin/Python/examples/in_paraview.py [STATE.pvsm]

ParaView makes the names of the properties from their labels, including the units. With STATE.pvsm the pipeline
is saved for ./run paraview STATE.pvsm.
"""
import sys
from paraview import simple

ball = simple.Sphere(Radius=50, ThetaResolution=200, PhiResolution=200)
response = simple.ToolContactResponse(Input=ball, YoungsModulusMPa=0.05, MaximumDeflectionmm=4,
                                      WholeBody=0)          # the ball is not held: only the local dent
response.Tool.Shape = "Sphere"
response.Tool.Radiusmm = 6.35
press = simple.Line(Point1=(0, 55, 0), Point2=(0, 47, 0), Resolution=8)
probe = simple.ToolContactProbe(Body=response, Tips=press)
dent = simple.ContactDeflection(Body=response, Tips=probe)
warp = simple.WarpByVector(Input=dent, Vectors=["POINTS", "ContactDisplacement"])
simple.Show(warp)

tips = simple.servermanager.Fetch(probe).GetPointData()
deflection, force = tips.GetArray("Deflection"), tips.GetArray("NormalForce")
for i in range(9):
    print("%.3f mm  %.4f N" % (deflection.GetValue(i), force.GetValue(i)))
if len(sys.argv) > 1:
    simple.SaveState(sys.argv[1])
