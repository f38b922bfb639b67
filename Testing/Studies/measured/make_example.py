#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes Data/Examples/cylinder_sphere_curves.csv: curves similar to those of an instrument on the cylinder of
`palpate --scene cylinder`.

    make_example.py > FILE

The curves are synthetic, from closed forms: an exact sphere of 6.35 mm on a half-space of E* = 3.45 MPa (Sneddon
1965), in series with a global compliance that grows along the cylinder. They contain loading at 0.5 mm/s, a hold,
and unloading with a loss of 5 % of the energy. The noise is 0.05 N. First contact is at a different reading at each
site.
"""
import math
import random

RADIUS, MODULUS = 6.35, 3.45                                        # mm, MPa
SITES = {"left": (-12.0, 0.03), "top": (0.0, 0.04), "right": (12.0, 0.05)}  # x (mm), C_g (mm/N)
CYLINDER = 50.0                                                     # mm
DEPTH, STEPS, SPEED, LOSS, NOISE = 1.5, 60, 0.5, 0.05, 0.05


def indentation(a):
    """Returns (depth, force) of an exact sphere at contact radius a."""
    log = math.log((RADIUS + a) / (RADIUS - a))
    return 0.5 * a * log, MODULUS * (0.5 * (a * a + RADIUS * RADIUS) * log - a * RADIUS)


def force_at(depth, compliance):
    """Returns the force of the sphere in series with the compliance, by bisection over the contact radius."""
    low, high = 0.0, 0.999 * RADIUS
    for _ in range(100):
        a = 0.5 * (low + high)
        local, force = indentation(a)
        low, high = (a, high) if local + compliance * force < depth else (low, a)
    return indentation(0.5 * (low + high))[1]


def main():
    random.seed(2002)
    print("# tool: sphere:6.35")
    print("# synthetic: exact sphere on a half-space of E* = 3.45 MPa in series with 0.03 to 0.05 mm/N")
    print("# made by Testing/Studies/measured/make_example.py")
    print("site,x_mm,y_mm,z_mm,deflection_mm,force_N,time_s,phase")
    for site, (x, compliance) in SITES.items():
        offset = random.uniform(-0.1, 0.3)
        loading = [(DEPTH * i / STEPS, "loading") for i in range(-6, STEPS + 1)]
        hold = [(DEPTH, "hold")] * 10
        unloading = [(DEPTH * i / STEPS, "unloading") for i in range(STEPS, -7, -2)]
        time, before = 0.0, loading[0][0]
        for depth, phase in loading + hold + unloading:
            time += abs(depth - before) / SPEED if depth != before else 0.05
            before = depth
            force = force_at(depth, compliance) if depth > 0 else 0.0
            if phase != "loading":
                force *= 1.0 - LOSS
            force += random.gauss(0.0, NOISE)
            print(f"{site},{x:g},0,{CYLINDER:g},{offset + depth:.4f},{force:.3f},{time:.3f},{phase}")


if __name__ == "__main__":
    main()
