# SPDX-License-Identifier: BSD-3-Clause
"""Tips per second of palpate.probe on one core, compared with vtkImplicitPolyDataDistance in the same run.

    probe.py [FOLDER] [TIPS]        (default: no file, 1000000 tips; the head of mricron-data is needed)

The body is the demo's head (153 thousand points). The tips are scattered evenly over it, from 0.1 mm above the skin to
1 mm under it, in random order or along a curve. Everything runs on one thread. The time is the processor time of this
process, the best of Rounds alternating runs. It includes everything from the given numpy array to the returned arrays,
except building the search structure, which is reported separately. vtkImplicitPolyDataDistance gives a signed distance
and no force, for a tenth of the tips.
Writes FOLDER/probe.csv.
"""
import csv
import os
import sys
import time

import numpy as np
import palpate
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkSMPTools
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance
from vtkmodules.vtkIOImage import vtkNIFTIImageReader

SCAN = "/usr/share/mricron/templates/ch2.nii.gz"
ROUNDS = 5


def head():
    reader = vtkNIFTIImageReader()
    reader.SetFileName(SCAN)
    skin = palpate.vtkSkinSurface()
    skin.SetInputConnection(reader.GetOutputPort())
    return palpate.response(skin, "sphere:6.35", young=0.035, poisson=0.49)


def scattered(body, count):
    """Random tips near the triangles of a body, evenly distributed by area."""
    random = np.random.default_rng(1)
    points = vtk_to_numpy(body.GetPoints().GetData()).astype(float)
    corners = points[vtk_to_numpy(body.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(normals, axis=1)
    chosen = random.choice(len(area), count, p=area / area.sum())
    shares = random.dirichlet((1, 1, 1), count)
    depth = random.uniform(-0.1, 1.0, (count, 1))
    return np.einsum("nk,nkj->nj", shares, corners[chosen]) - depth * (normals / area[:, None])[chosen]


def along_a_curve(tips):
    """The same tips in Morton order of cells of 0.25 mm, so that each is near the previous one."""
    cells = ((tips - tips.min(axis=0)) / 0.25).astype(np.uint64)
    key = sum(((cells[:, axis] >> np.uint64(bit)) & np.uint64(1)) << np.uint64(3 * bit + axis)
              for bit in range(11) for axis in range(3))
    return np.ascontiguousarray(tips[np.argsort(key)])


def seconds(call):
    start = time.process_time()
    call()
    return time.process_time() - start


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else None
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 1000000
    vtkSMPTools.SetBackend("Sequential")
    body = head()
    random = scattered(body, count)
    orders = {"random": random, "coherent": along_a_curve(random)}
    build = seconds(lambda: palpate.probe(body, random[:1]))
    peer = vtkImplicitPolyDataDistance()
    peer.SetInput(body)
    best = {}
    for _ in range(ROUNDS):
        for order, tips in orders.items():
            few, distances = numpy_to_vtk(tips[:: 10].copy()), vtkDoubleArray()
            times = {"palpate.probe": seconds(lambda: palpate.probe(body, tips)) / count,
                     "vtkImplicitPolyDataDistance": seconds(lambda: peer.FunctionValue(few, distances)) / (count // 10)}
            for method, time_per_tip in times.items():
                best[method, order] = min(time_per_tip, best.get((method, order), np.inf))
    felt = palpate.probe(body, random)
    print("%d points, %d tips, %.0f %% of them in contact; search structure built in %.2f s" % (
        body.GetNumberOfPoints(), count, 100 * (felt.contact_cell >= 0).mean(), build))
    rows = [(method, order, 1e9 * each, 1e-6 / each, each / best["palpate.probe", order])
            for (method, order), each in best.items()]
    for row in rows:
        print("%-28s %-9s %8.0f ns per tip  %6.2f million per second  %6.1f times palpate.probe" % row)
    if folder:
        os.makedirs(folder, exist_ok=True)
        with open(os.path.join(folder, "probe.csv"), "w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(("method", "order", "ns_per_tip", "million_per_s", "ratio"))
            writer.writerows(rows)


main()
