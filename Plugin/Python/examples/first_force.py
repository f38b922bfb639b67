# SPDX-License-Identifier: BSD-3-Clause
"""The first force: a sphere is pressed on a ball of soft tissue; prints its depth and its force.

    ./run python Plugin/Python/examples/first_force.py
"""
import numpy as np
import palpate
from vtkmodules.vtkFiltersSources import vtkSphereSource

ball = vtkSphereSource()                                    # or arrays (points, triangles), or "liver.stl"
ball.SetRadius(50)                                          # mm
ball.SetThetaResolution(200)
ball.SetPhiResolution(200)
material = {"young": 0.05, "poisson": 0.45}                 # MPa, -
body = palpate.response(ball, tool="sphere:6.35", compliance=None, **material)  # as on a half-space

direction = np.array([0.6, 0.0, 0.8])
tips = np.linspace(50.5, 48, 6)[:, None] * direction        # from outside to 2 mm deep
forces, deflection, *rest = palpate.probe(body, tips)
for depth, force in zip(deflection, forces):
    print("%.2f mm deep: %.4f N" % (depth, force @ direction))
