# SPDX-License-Identifier: BSD-3-Clause
"""Drags a sphere back and forth, 1 mm deep in a plate; prints its position, the friction and the state of the contact.

    ./run python Plugin/Python/examples/friction_loop.py
"""
import numpy as np
import palpate

points = [[-9, -9, 0], [9, -9, 0], [0, 9, 0]]               # mm
plate = np.array(points, dtype=float), np.array([[0, 1, 2]]) # one triangle around the origin, facing +z
body = palpate.response(plate, tool="sphere:5", young=0.1)

there = np.arange(8)
back = np.arange(8, -8, -1)
again = np.arange(-8, 9)
x = 0.05 * np.concatenate([there, back, again])             # from 0 to 0.4, to -0.4, to 0.4 mm
tips = np.stack([x, 0.1 + 0 * x, -1 + 0 * x], axis=1)
felt = palpate.probe(body, tips, path=True, friction=0.5, tangential_stiffness=0.8) # N/mm, while the contact sticks
STICKS = 1
for place, friction, state in zip(x, felt.friction[:, 0], felt.contact_state):
    print("x %5.2f mm  friction %7.4f N  %s" % (place, friction, "sticks" if state == STICKS else "slides"))
