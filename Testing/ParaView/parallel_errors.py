# SPDX-License-Identifier: BSD-3-Clause
"""A fault on one process is an error on all processes, and no process hangs: under mpiexec pvbatch --symmetric.

Each process has its own slab, so that the body has a seam at x = 20, 40...; the fault is on the last process.
"""
from palpate import (vtkContactDeflection, vtkContactRegime, vtkContactTool, vtkToolContactProbe,
                     vtkToolContactResponse)
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSetAttributes, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController

controller = vtkMultiProcessController.GetGlobalController()
RANK, COUNT = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
LAST = RANK == COUNT - 1


def piece():
    """The part of the plane z = 0 that this process has, 20 mm wide, in squares of 2 mm."""
    plane = vtkPlaneSource()
    plane.SetOrigin(20 * RANK, -10, 0)
    plane.SetPoint1(20 * RANK + 20, -10, 0)
    plane.SetPoint2(20 * RANK, 10, 0)
    plane.SetResolution(10, 10)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(plane.GetOutputPort())
    triangles.Update()
    body = vtkPolyData()
    body.CopyStructure(triangles.GetOutput())
    return body


def run(algorithm):
    """The first error of an update, "" if there was none."""
    errors = []

    def note(_, event, text="", errors=errors):
        errors.append(text)
    note.CallDataType = "string0"
    for who in (algorithm, algorithm.GetExecutive()):
        who.AddObserver("ErrorEvent", note)
    algorithm.Update()
    algorithm.RemoveAllObservers()
    return errors[0] if errors else ""


def expect(algorithm, *words):
    error = run(algorithm)
    assert all(word in error for word in words), "process %d: %r lacks one of %r" % (RANK, error, words)
    if words and COUNT > 1:
        assert "on rank %d" % (COUNT - 1) in error, error
    assert words or not error, error


def response_of(body):
    response = vtkToolContactResponse()
    tool = vtkContactTool()
    tool.SetShapeToSphere()
    tool.SetRadius(5)
    response.SetTool(tool)
    response.SetInputData(body)
    return response


def tips_at(*points):
    tips, coordinates = vtkPolyData(), vtkPoints()
    for point in points:
        coordinates.InsertNextPoint(point)
    tips.SetPoints(coordinates)
    return tips


def probe_of(body, tips):
    probe = vtkToolContactProbe()
    probe.SetInputData(0, body)
    probe.SetInputData(1, tips)
    return probe


def good_response():
    response = response_of(piece())
    expect(response)
    body = vtkPolyData()
    body.ShallowCopy(response.GetOutput())
    return body


def check_response():
    broken = piece()
    if LAST:
        broken.GetPolys().InsertNextCell(4, [0, 1, 12, 11])
    expect(response_of(broken), "vtkTriangleFilter")

    modulus = vtkDoubleArray()
    modulus.SetName("E")
    for i in range(piece().GetNumberOfPoints()):
        modulus.InsertNextValue(-1.0 if LAST and i == 7 else 0.1)
    body = piece()
    body.GetPointData().AddArray(modulus)
    response = response_of(body)
    response.SetInputArrayToProcess(0, 0, 0, 0, "E")
    expect(response, "'E'", "point 7", "-1")

    absent = piece()
    if not LAST:
        absent.GetPointData().AddArray(modulus)
    response = response_of(absent)
    response.SetInputArrayToProcess(0, 0, 0, 0, "E")
    expect(response, "'E'")

    # A process without a piece is not an error.
    response = response_of(vtkPolyData() if LAST else piece())
    expect(response)
    assert response.GetOutput().GetNumberOfPoints() == (0 if LAST else 121)


def check_late_faults():
    """A fault detected after the last exchange between processes, and an abort on one process, are reported on all
    processes."""
    for automatic in (False, True):
        for body in (piece(), vtkPolyData() if LAST and COUNT > 1 else piece()):
            response = response_of(body)
            response.SetStrainModelToOgden()
            response.SetOgdenExponent(0.0)
            response.SetAutomaticTerms(automatic)
            error = run(response)
            assert "Ogden's exponent" in error, (automatic, RANK, error)
            assert response.GetOutput().GetNumberOfPoints() == 0

            response = response_of(body)
            response.SetAutomaticTerms(automatic)
            if RANK == 0:
                response.AddObserver("ProgressEvent", lambda caller, event: caller.SetAbortExecute(1))
            assert run(response) == ""
            assert response.GetOutput().GetNumberOfPoints() == 0, (automatic, RANK)


def check_regime():
    body = good_response()
    if LAST:
        body.GetPointData().RemoveArray("ResponseRange")
    regime = vtkContactRegime()
    regime.SetInputData(body)
    expect(regime, "ResponseRange")


def check_probe():
    tips = tips_at((20.5, 0, -1)) if RANK == 0 else vtkPolyData()
    body = good_response()
    if LAST:
        body.GetPointData().RemoveArray("ResponseForce")
    expect(probe_of(body, tips), "ResponseForce")
    body = good_response()
    if LAST:
        body.GetFieldData().GetArray("ResponseExponent").SetValue(0, 1.25)
    if COUNT > 1:
        error = run(probe_of(body, tips))
        assert "different" in error, error
    body, blocks = good_response(), vtkMultiBlockDataSet()
    blocks.SetBlock(0, body)
    expect(probe_of(blocks if LAST else body, tips), "vtkMultiBlockDataSet", "vtkBodySurface")
    wrong = vtkPolyData()
    wrong.DeepCopy(tips_at((1, 1, -1), (2, 2, -1)))
    if LAST:
        lines = vtkCellArray()
        lines.InsertNextCell(2, [0, 5])
        wrong.SetLines(lines)
    expect(probe_of(good_response(), wrong), "polyline 0", "point 5")


def check_dent():
    body = good_response()
    # The seam is at x = 20. The result is the depth at the tip, independent of the piece.
    tips = tips_at((20.5, 0, -1), (19.5, 0, -1), (5, 0, -1)) if RANK == 0 else vtkPolyData()
    probe = probe_of(body, tips)
    expect(probe)
    felt = probe.GetOutput()
    if RANK == 0:
        states = [felt.GetPointData().GetArray("ContactState").GetTuple1(i) for i in range(3)]
        ranks = ([felt.GetPointData().GetArray("ContactRank").GetTuple1(i) for i in range(3)] if COUNT > 1 else [])
        assert states == ([2, 2, 2] if COUNT > 1 else [4, 2, 2]), states
        assert COUNT == 1 or ranks == [1, 0, 0], ranks
    dent = vtkContactDeflection()
    dent.SetInputData(0, body)
    dent.SetInputData(1, felt)
    dent.SetTipIndex(1)
    expect(dent)
    moved = dent.GetOutput().GetPointData().GetArray("ContactDisplacement")
    deepest = -min(moved.GetComponent(i, 2) for i in range(moved.GetNumberOfTuples()))
    # 1 mm under the tip; at a grid point 0.5 mm away it is less by r^2/(2R) = 0.025 mm, on both
    # sides of the seam.
    assert COUNT == 1 or RANK > 1 or abs(deepest - 0.975) < 0.002, (RANK, deepest)
    if COUNT > 1:
        dent.SetTipIndex(3)
        error = run(dent)
        assert "Tip Index 3" in error and "3 tips" in error, error
        bare = vtkPolyData()
        bare.ShallowCopy(felt)
        bare.GetPointData().RemoveArray("ContactRank")
        dent.SetInputData(1, bare)
        dent.SetTipIndex(0)
        error = run(dent)
        assert "ContactRank" in error, error


def check_ghosts():
    """Ghost triangles of a neighbouring piece change nothing and are not in the output."""
    body = piece()
    plain = response_of(body)
    expect(plain)
    with_ghosts = vtkPolyData()
    with_ghosts.DeepCopy(body)
    points, ids = with_ghosts.GetPoints(), []
    for x, y in ((20 * RANK + 20, 0), (20 * RANK + 22, 0), (20 * RANK + 22, 2)):
        ids.append(points.InsertNextPoint(x, y, 0))
    with_ghosts.GetPolys().InsertNextCell(3, ids)
    with_ghosts.AllocateCellGhostArray()
    with_ghosts.GetCellGhostArray().SetValue(with_ghosts.GetNumberOfCells() - 1, vtkDataSetAttributes.DUPLICATECELL)
    ghosts = response_of(with_ghosts)
    expect(ghosts)
    if COUNT > 1:
        assert ghosts.GetOutput().GetNumberOfPoints() == 121 and ghosts.GetOutput().GetNumberOfCells() == 200
        for name in ("ResponseForce", "ResponseNormal", "ResponseValidity"):
            # Removing the ghosts may renumber the points.
            one, other = ({f.GetOutput().GetPoint(i): f.GetOutput().GetPointData().GetArray(name).GetTuple(i)
                           for i in range(121)} for f in (plain, ghosts))
            assert one == other, name


def check_closed():
    """Two halves of a box that is inside out: an error on both processes, which neither half alone could detect."""
    if COUNT != 2:
        return
    corners = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    faces = [(0, 1, 3), (0, 3, 2), (4, 7, 5), (4, 6, 7), (0, 5, 1), (0, 4, 5), (2, 3, 7), (2, 7, 6),
             (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)]
    for outward in (True, False):
        half, points = vtkPolyData(), vtkPoints()
        for c in corners:
            points.InsertNextPoint([20.0 * x for x in c])
        half.SetPoints(points)
        half.AllocateExact(6, 18)
        for face in faces[6 * RANK:6 * RANK + 6]:
            half.InsertNextCell(5, 3, face[::-1] if outward else face)
        error = run(response_of(half))
        assert ("inside out" in error) == (not outward), (outward, error)
        assert outward or "8000 mm" in error, error # 20 mm cubed


for check in (check_response, check_late_faults, check_regime, check_probe, check_dent, check_ghosts, check_closed):
    check()
    controller.Barrier()
if RANK == 0:
    print("done", COUNT)
