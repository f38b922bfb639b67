# SPDX-License-Identifier: BSD-3-Clause
"""The six clicks of the manual, played in the ParaView program on a body that this script makes.

    pvpython walk.py PARAVIEW WALK_THROUGH.XML BASELINES FOLDER [PICTURES]      needs an X server

Open, Apply, Tool Contact Response, Apply, Touch, Apply: then the view shows the dent, the tool, the
force arrow and the numbers. The saved state has the numbers of the tool's closed form. It is drawn in a
view of fixed size, which is compared with a baseline. The program's own picture is compared too, if its
window has room for a view of that size. With PICTURES, the pictures of manual and help are written to
that folder, as paraview_*.png.
"""
import math
import os
import shutil
import sys
from pathlib import Path
import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator
import organ
from program import play

STEPS = ("body.png", "response.png", "touch.png")
SIZE = (844, 527)
BACKGROUND = (0.32, 0.34, 0.43)                             # ParaView's background until 5.13; version 6 has another
SMALL = 200_000                                             # largest size of a picture in the repository, bytes
YOUNG, POISSON, RADIUS, RANGE = 0.1, 0.45, 5.0, 2.0         # defaults of Tool Contact Response


def force_on(curvatures, depth):
    """Force on the exact sphere (Sneddon 1965) on a body with these curvatures, N. The profiles of tool and body are
    added: the square of the effective radius is the product of both sums of curvatures. The result is multiplied by the
    factor of Hertz's ellipse (reference: Johnson 1985, 4.2)."""
    def at(a):
        log = math.log((RADIUS + a) / (RADIUS - a))
        own = 0.5 * a * log
        one, other = (own + k * a**2 for k in curvatures)
        whole = math.sqrt(one * other)
        force = 0.5 * (a**2 + RADIUS**2) * log - a * RADIUS + 4 / 3 * a * (whole - own)
        return whole, force * (1 + math.log(one / other) ** 2 / 48)

    low, high = 1e-6, 0.999 * RADIUS
    while high - low > 1e-9:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if at(middle)[0] < depth else (low, middle)
    return YOUNG / (1 - POISSON**2) * at(low)[1]


def force_in_series(curvatures, compliance, depth):
    """Force on the sphere on the surface of a body with the global compliance `compliance` (mm/N), N."""
    low, high = 0.0, 2.0 * depth                            # the deflection of the surface
    while high - low > 1e-9:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if middle + compliance * force_on(curvatures, middle) < depth else (low, middle)
    return force_on(curvatures, low)


def compliance_at(place):
    """The compliance of the whole body in the response, mm/N, interpolated between the corners of the triangle."""
    body = servermanager.Fetch(simple.FindSource("ToolContactResponse1"))
    locator = vtkStaticCellLocator()
    locator.SetDataSet(body)
    locator.BuildLocator()
    closest, cell, part, distance = [0.0] * 3, reference(0), reference(0), reference(0.0)
    locator.FindClosestPoint(place, closest, cell, part, distance)
    corners, inside, weights = [0.0] * 3, [0.0] * 3, [0.0] * 3
    body.GetCell(int(cell)).EvaluatePosition(closest, corners, part, inside, distance, weights)
    values = body.GetPointData().GetArray("GlobalCompliance")
    ids = body.GetCell(int(cell)).GetPointIds()
    return sum(weight * values.GetValue(ids.GetId(k)) for k, weight in enumerate(weights))


def check_numbers(state):
    """The result of the clicks: the sphere is half of Range deep in the curved body, on all four ports."""
    simple.LoadState(str(state))
    touch = simple.FindSource("Touch1")
    assert touch and simple.FindSource("ToolContactResponse1")
    arrow = servermanager.Fetch(touch, idx=2)
    field = arrow.GetFieldData()
    place = field.GetArray("TipPosition").GetTuple3(0)
    compliance = compliance_at(place)
    assert compliance != 0                                  # mm/N: the default response includes the whole body
    expected = force_in_series(organ.curvatures(place), compliance, RANGE / 2)
    felt = field.GetArray("NormalForce").GetValue(0)
    # The curvature reduces the force by 5 %, the held side raises it by 2 %. The mesh gives the curvature to some per cent.
    np.testing.assert_allclose(felt, expected, rtol=5e-3)
    error = field.GetArray("RelativeError").GetValue(0)
    assert 0.01 < error < 0.1, error
    np.testing.assert_allclose(field.GetArray("Deflection").GetValue(0), RANGE / 2, rtol=1e-3)
    scale = field.GetArray("ForceScale").GetValue(0)
    tail = np.array(field.GetArray("TipPosition").GetTuple3(0))
    length = np.linalg.norm(vtk_to_numpy(arrow.GetPoints().GetData()) - tail, axis=1).max()
    np.testing.assert_allclose(length, scale * felt, rtol=1e-3)
    text = servermanager.Fetch(touch, idx=3).GetValue(0, 0).ToString()
    assert f"Force {felt:.3f} N \u00b1 {100 * error:.0f} %" in text and "Deflection 1.00 mm" in text, text
    dent = vtk_to_numpy(servermanager.Fetch(touch, idx=0).GetPointData().GetArray("Dent (mm)"))
    assert 0.9 * RANGE / 2 < dent.max() <= RANGE / 2, dent.max() # deepest at a vertex near the tip
    view = simple.GetActiveViewOrCreate("RenderView")
    shown = [simple.GetRepresentation(servermanager.OutputPort(touch, port), view) for port in range(4)]
    assert all(proxy.Visibility for proxy in shown)
    assert simple.GetRepresentation(simple.FindSource("ToolContactResponse1"), view).Visibility == 0
    view.ViewSize = SIZE
    view.UseColorPaletteForBackground = 0
    view.Background = BACKGROUND
    simple.SaveScreenshot(str(state.with_name("state.png")), view)
    return tail


def check_moved(state, before):
    """A new position in the panel takes effect without Apply: it is in the state, and the tip has moved."""
    simple.ResetSession()
    simple.LoadState(str(state))
    touch = simple.FindSource("Touch1")
    assert touch.TipPositionmm[0] == -20, list(touch.TipPositionmm)
    tip = servermanager.Fetch(touch, idx=2).GetFieldData().GetArray("TipPosition").GetTuple3(0)
    assert tip[0] < before[0] - 10, (tip, before)



def main(program, events, baselines, folder, pictures=None):
    if not os.environ.get("DISPLAY"):
        print("no DISPLAY: the program was not started")
        return 77
    folder = Path(folder) / "walk"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    organ.write(str(folder / "organ.vtp"))
    play(program, events, folder)
    for step in STEPS:
        assert 0 < (folder / step).stat().st_size < SMALL, step
    check_moved(folder / "moved.pvsm", check_numbers(folder / "walk.pvsm"))
    assert (folder / "moved.png").read_bytes() != (folder / "touch.png").read_bytes() # the picture has changed as well
    if pictures:
        for step in STEPS:
            shutil.copy(folder / step, Path(pictures) / ("paraview_" + step))
    sys.path.insert(0, str(Path(__file__).parent.parent / "Viewer"))
    import compare_pictures # pylint: disable=import-outside-toplevel
    drawn = [name for name in ("state.png", STEPS[-1])
             if compare_pictures.read(folder / name).GetDimensions() == (*SIZE, 1)]
    assert "state.png" in drawn
    baseline = Path(baselines) / "ParaView-state.png"
    alike = [compare_pictures.compare_with_baseline(folder / name, baseline, folder / ("difference_" + name))
             for name in drawn]
    return 0 if all(alike) else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
