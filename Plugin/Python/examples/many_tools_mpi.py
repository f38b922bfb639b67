# SPDX-License-Identifier: BSD-3-Clause
"""Several tools on one body that is distributed over processes; prints the force of each tool and saves the body.

    mpiexec -np 4 pvbatch Plugin/Python/examples/many_tools_mpi.py [BODY] [OUTPUT.pvtp]

PV_PLUGIN_PATH must name the folder of the plugin. Each process makes the responses of its own piece. All processes
take part in a contact, so that the results do not depend on the number of processes. Without mpiexec: ./run pvpython.
"""
import sys
from paraview import servermanager, simple

TOOLS = {"Sphere": {"Shape": "Sphere", "Radiusmm": 6.35},
         "Flat": {"Shape": "Flat", "Radiusmm": 3},
         "Cone": {"Shape": "Cone", "HalfAngledegrees": 60}}

if len(sys.argv) > 1:
    body = simple.OpenDataFile(sys.argv[1])
else:
    body = simple.Sphere(Radius=50, ThetaResolution=200, PhiResolution=200)
felt = simple.RedistributeDataSet(Input=body) # pieces of equal size
for name, shape in TOOLS.items():
    # The deflection of the whole body needs the body on one process.
    felt = simple.ToolContactResponse(Input=felt, ResponseName=name, YoungsModulusMPa=0.05, WholeBody=0)
    for key, value in shape.items():
        setattr(felt.Tool, key, value)

felt.UpdatePipeline()
x0, x1, y0, y1, _, top = felt.GetDataInformation().GetBounds()
x = (x0 + x1) / 2 + 0.1
y = (y0 + y1) / 2 + 0.2
press = simple.Line(Point1=(x, y, top + 1), Point2=(x, y, top - 2), Resolution=6)
for name in TOOLS:
    probe = simple.ToolContactProbe(Body=felt, Tips=press, ResponseName=name)
    felt_force = servermanager.Fetch(probe).GetPointData().GetArray("NormalForce")
    print(name, " ".join("%.4f" % felt_force.GetValue(i) for i in range(7)), "N")
if len(sys.argv) > 2:
    simple.SaveData(sys.argv[2], felt, DataMode="Binary")
