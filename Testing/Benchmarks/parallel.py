# SPDX-License-Identifier: BSD-3-Clause
"""Compares response and probe of one body on one process and on several: time and memory of each process.

    parallel.py MPIEXEC PVBATCH PLUGINS FOLDER [POINTS] [RANKS...]

The body is a ball of POINTS points (default 2 million) in equal pieces. Each process makes its own piece, without
normals, so that the computation of normals at the seams uses triangles of several pieces. Each process is bound to
its own core, so that one process represents one machine. Runs of one process and of several alternate, Rounds times.
The best time of each is taken, and its ratio to the time of one process is printed. Writes FOLDER/parallel.csv.
"""
import csv
import os
import resource
import subprocess
import sys
import time

ROUNDS = 3
COLUMNS = ("ranks", "rank", "points", "response_s", "probe_s", "probe_again_s", "memory_MiB", "force_N")


def piece(points, rank, ranks):
    """The rows of a ball that belong to a rank. Neighbouring ranks share the points on their border."""
    import numpy as np
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    rows = int((points / 2) ** 0.5)
    columns = 2 * rows
    first, last = rows * rank // ranks, rows * (rank + 1) // ranks
    phi = np.pi * (np.arange(first, last + 1) + 0.5) / (rows + 1) # open at the poles
    theta = 2 * np.pi * np.arange(columns) / columns
    p, t = np.meshgrid(phi, theta, indexing="ij")
    xyz = 100 * np.stack([np.sin(p) * np.cos(t), np.sin(p) * np.sin(t), np.cos(p)], -1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(last - first), np.arange(columns), indexing="ij")
    a, b = i * columns + j, i * columns + (j + 1) % columns
    c, d = a + columns, b + columns
    triangles = np.stack([a, c, d, a, d, b], -1).reshape(-1, 3).astype(np.int64)
    body, coordinates, polys = vtkPolyData(), vtkPoints(), vtkCellArray()
    coordinates.SetData(numpy_to_vtk(xyz, deep=1))
    polys.SetData(3, numpy_to_vtkIdTypeArray(triangles.ravel(), deep=1))
    body.SetPoints(coordinates)
    body.SetPolys(polys)
    return body


def measure(file, points):
    """Runs on each process, by pvbatch --sym. Each process writes its line to its own file."""
    import math
    import palpate
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    from vtkmodules.vtkParallelCore import vtkMultiProcessController
    controller = vtkMultiProcessController.GetGlobalController()
    rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
    body = piece(points, rank, ranks)
    tool = palpate.vtkContactTool()
    tool.SetShapeToSphere()
    tool.SetRadius(6.35)
    response = palpate.vtkToolContactResponse()
    response.SetTool(tool)
    response.SetInputData(body)

    def timed(algorithm):
        controller.Barrier()
        begin = time.perf_counter()
        algorithm.Update()
        controller.Barrier()
        return time.perf_counter() - begin
    response_s = timed(response)
    # A path of 1000 ticks on process 0, over the equator and across the seam of two pieces.
    tips, coordinates, lines = vtkPolyData(), vtkPoints(), vtkCellArray()
    coordinates.SetDataTypeToDouble()
    for i in range(1000 if rank == 0 else 0):
        angle = math.pi / 2 + 0.0004 * (i - 500)
        coordinates.InsertNextPoint(99 * math.sin(angle), 0.01 * i, 99 * math.cos(angle))
    if rank == 0:
        lines.InsertNextCell(1000, range(1000))
    tips.SetPoints(coordinates)
    tips.SetLines(lines)
    probe = palpate.vtkToolContactProbe()
    probe.SetInputConnection(0, response.GetOutputPort())
    probe.SetInputData(1, tips)
    probe_s = timed(probe)
    tips.Modified()
    again_s = timed(probe)
    felt = probe.GetOutput().GetPointData().GetArray("NormalForce")
    force = felt.GetValue(999) if rank == 0 else 0.0
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    with open("%s.%d" % (file, rank), "w") as out:
        print(ranks, rank, body.GetNumberOfPoints(), response_s, probe_s, again_s, memory, force, sep=",", file=out)


def main():
    mpiexec, pvbatch, plugins, folder = sys.argv[1:5]
    points = sys.argv[5] if len(sys.argv) > 5 else "2000000"
    counts = [1] + [int(n) for n in sys.argv[6:] or ["2"]]
    best = {}
    environment = dict(os.environ, PV_PLUGIN_PATH=plugins)
    file = os.path.join(folder, "parallel")
    for _ in range(ROUNDS):
        for ranks in counts:
            subprocess.run([mpiexec, "--allow-run-as-root", "--bind-to", "core", "-np", str(ranks), pvbatch, "--dr",
                            "--sym", os.path.abspath(__file__), "measure", file, points],
                           check=True, env=environment, stdin=subprocess.DEVNULL)
            for rank in range(ranks):
                with open("%s.%d" % (file, rank)) as measured:
                    row = dict(zip(COLUMNS, (float(x) for x in measured.read().split(","))))
                os.remove("%s.%d" % (file, rank))
                known = best.setdefault((ranks, rank), row)
                for column in COLUMNS[3:7]:
                    known[column] = min(known[column], row[column])
    with open(file + ".csv", "w", newline="") as out:
        table = csv.DictWriter(out, COLUMNS)
        table.writeheader()
        table.writerows(best.values())
    alone = best[1, 0]
    print("ranks rank   points  response s     probe s   once more s   memory MiB")
    for row in best.values():
        print("%5d %4d %8d %6.2f (%4.2f) %5.2f (%4.2f) %6.3f (%4.2f) %6.0f (%4.2f)" % (
            row["ranks"], row["rank"], row["points"], *(x for column in COLUMNS[3:7] for x in (
                row[column], row[column] / alone[column]))))
    print("in brackets: over one process; the last tip feels %s N" % " and ".join(
        "%.6f" % best[ranks, 0]["force_N"] for ranks in counts))


if sys.argv[1] == "measure":
    measure(sys.argv[2], int(sys.argv[3]))
else:
    main()
