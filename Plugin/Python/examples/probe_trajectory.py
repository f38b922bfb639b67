# SPDX-License-Identifier: BSD-3-Clause
"""A sphere presses 1 mm into a ball and slides along; prints its position, depth and force.

    ./run python Plugin/Python/examples/probe_trajectory.py
"""
import numpy as np
import palpate
from vtkmodules.vtkFiltersSources import vtkSphereSource

ball = vtkSphereSource()
ball.SetRadius(50)                                          # mm
ball.SetThetaResolution(200)
ball.SetPhiResolution(200)
body = palpate.response(ball, tool="sphere:6.35", young=0.1, compliance=None)

angle = np.linspace(0, np.pi / 2, 7)
start, end = np.array([49, 0, 0]), np.array([0, 34.65, 34.65])
tips = np.cos(angle)[:, None] * start + np.sin(angle)[:, None] * end
felt = palpate.probe(body, tips, path=True)                 # one movement; the forces act on the tool
for tip, depth, force in zip(tips, felt.deflection, felt.forces):
    print("tip (%6.2f %6.2f %6.2f) mm" % tuple(tip), end="  ")
    print("%.3f mm deep" % depth, end="  ")
    print("(%6.3f %6.3f %6.3f) N" % tuple(force))
