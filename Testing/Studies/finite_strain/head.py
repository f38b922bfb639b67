#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the cost of finite strain on a layered head: solved, and from the cache.

    ./run python Testing/Studies/finite_strain/head.py [RESOLUTION [TOOL]]     mm, default 2; default sphere:6.35

The bodies are the skin of Colin 27 with its soft tissue over the bone (Debian's mricron-data): one layer of 0.035 MPa and
nu 0.49 (a half-space where there is no bone); and skin over fat, 1.5 mm of 0.035 MPa over 0.002 MPa in the rest of the
thickness. Prints for each material: seconds of a response at small strain, of a response whose correction is solved (with
a separate cache, empty at first), and of the same response again; in parentheses processor seconds, which a busy machine
does not change much. Then prints the difference between c of the stack at thicknesses between its nodes and c solved at
these thicknesses.
"""
import os
import sys
import tempfile
import time

import numpy as np

SCAN = "/usr/share/mricron/templates/ch2.nii.gz"
SKIN, DEEPEST = 1.5, 20.0  # mm: thickness of the skin, and of the tissue where no bone is found


def head(resolution):
    from palpate import vtkLayerThickness, vtkSkinSurface
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkNIFTIImageReader
    reader, skin, layer = vtkNIFTIImageReader(), vtkSkinSurface(), vtkLayerThickness()
    reader.SetFileName(SCAN)
    skin.SetInputConnection(reader.GetOutputPort())
    skin.SetResolution(resolution)
    layer.SetInputConnection(0, skin.GetOutputPort())
    layer.SetInputConnection(1, reader.GetOutputPort())
    layer.Update()
    body = layer.GetOutput()
    return body, vtk_to_numpy(body.GetPointData().GetArray("LayerThickness")).astype(float)


def plate(n):
    """Returns a body of n separate triangles."""
    corners = np.array([[0, 0, 0], [10, 0, 0], [0, 10, 0]], float)
    points = np.concatenate([corners + [100 * i, 0, 0] for i in range(n)])
    return points, np.arange(3 * n).reshape(-1, 3)


def main():
    import palpate
    resolution = float(sys.argv[1]) if len(sys.argv) > 1 else 2.0
    tool = sys.argv[2] if len(sys.argv) > 2 else "sphere:6.35"
    body, tissue = head(resolution)
    whole = np.where(tissue > 0, tissue, DEEPEST)
    print("%d points, tissue %.1f to %.1f mm, %s, to 2 mm" % (len(tissue), whole.min(), whole.max(), tool))

    def response(stack, strain):
        begin, work = time.perf_counter(), time.process_time()
        given = ({"young": 0.035, "poisson": 0.48, "layer": SKIN, "layers": [(whole - SKIN, 0.002, 0.49)]} if stack else
                 {"young": 0.035, "poisson": 0.49, "layer": tissue})
        palpate.response(body, tool, strain=strain, **given)
        return time.perf_counter() - begin, time.process_time() - work

    print("%-16s %-12s %17s %17s %17s" % ("body", "material", "small (cpu)", "once (cpu)", "again (cpu)"))
    for stack in (False, True):
        small = response(stack, "small")
        for strain in ("neohooke", ("ogden", 9.0), ("ogden", -5.0), ("demiray", 2.0)):
            with tempfile.TemporaryDirectory() as folder:
                os.environ["PALPATE_CACHE"] = folder
                once, again = response(stack, strain), response(stack, strain)
            print("%-16s %-12s %7.1f (%6.1f) s %7.1f (%6.1f) s %7.1f (%6.1f) s" % (
                "skin over fat" if stack else "one layer", strain if isinstance(strain, str) else "%s %g" % strain,
                *small, *once, *again), flush=True)

    # Three thicknesses between the nodes of the table: in one body together, and each in a separate body.
    between = np.array([2.6, 6.0, 13.0])
    os.environ["PALPATE_CACHE"] = ""
    for strain in ("neohooke", ("ogden", 9.0)):
        def forces(thicknesses):
            fat = np.repeat(thicknesses, 3)
            made = palpate.response(plate(len(thicknesses)), tool, young=0.035, poisson=0.48, layer=SKIN,
                                    layers=[(fat, 0.002, 0.49)], strain=strain)
            return np.array(palpate.curves(made, 3 * np.arange(len(thicknesses))).force)[:, 1:]  # without first contact
        table = forces(np.concatenate([between, [whole.min() - SKIN, whole.max() - SKIN]]))[:3]
        alone = np.concatenate([forces(between[i:i + 1]) for i in range(3)])
        print("between nodes, %s: force off by %.4f at most" % (strain, np.abs(table / alone - 1).max()))


if __name__ == "__main__":
    main()
