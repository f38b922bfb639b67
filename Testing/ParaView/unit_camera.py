# SPDX-License-Identifier: BSD-3-Clause
"""After a change of Length Unit the view shows the whole body. No other change moves the camera. Played in the program:

    pvpython unit_camera.py PARAVIEW FOLDER-OF-EVENTS FOLDER      needs an X server
"""
import shutil
import sys
from pathlib import Path
import numpy as np
from paraview import simple
import organ
from program import need_display, pixels, play

PROGRAM, EVENTS, FOLDER = sys.argv[1], sys.argv[2], Path(sys.argv[3]) / "unit_camera"
OWN = {"CameraPosition": [130, -40, 170], "CameraFocalPoint": [10, 5, 3], "CameraViewUp": [0, 1, 0]}


def loaded(name):
    """Loads a state. Returns its view and its response."""
    simple.ResetSession()
    simple.LoadState(str(FOLDER / name))
    return simple.GetActiveViewOrCreate("RenderView"), simple.FindSource("ToolContactResponse1")


def camera(name):
    view, _ = loaded(name)
    return {key: np.array(getattr(view, key)) for key in OWN}


def direction(seen):
    way = seen["CameraPosition"] - seen["CameraFocalPoint"]
    return way / np.linalg.norm(way)


def check_fits(name, unit, factor):
    """The body fills the picture. The camera looks at the middle of the body, from a distance of some body lengths."""
    view, response = loaded(name + ".pvsm")
    assert response.LengthUnit == unit, response.LengthUnit
    size = 2 * factor * organ.SEMI_AXES[0]
    distance = np.linalg.norm(np.array(view.CameraPosition) - view.CameraFocalPoint)
    assert size < distance < 5 * size, (unit, distance, size)
    assert np.linalg.norm(view.CameraFocalPoint) < 0.2 * size, (unit, list(view.CameraFocalPoint))


need_display()
shutil.rmtree(FOLDER, ignore_errors=True)
FOLDER.mkdir(parents=True)
organ.write(str(FOLDER / "organ.vtp"), 0.001)
play(PROGRAM, EVENTS + "/UnitInGui.xml", FOLDER)
for unit, factor in (("cm", 0.01), ("m", 1.0)):
    colours = pixels(str(FOLDER / (unit + ".png")))
    shown = (abs(colours - colours[0]).sum(axis=1) > 60).mean()
    assert 0.15 < shown < 0.9, (unit, shown)
    check_fits(unit, unit, factor)

view, _ = loaded("m.pvsm")
for key, value in OWN.items():
    setattr(view, key, value)
simple.SaveState(str(FOLDER / "own.pvsm"))
play(PROGRAM, EVENTS + "/UnitOfState.xml", FOLDER, "--state=" + str(FOLDER / "own.pvsm"))
for step in ("loaded.pvsm", "young.pvsm"):
    for key, value in camera(step).items():
        np.testing.assert_allclose(value, OWN[key], rtol=1e-12, err_msg=f"{step}: {key}")
assert loaded("young.pvsm")[1].YoungsModulusMPa == 0.05
check_fits("again", "cm", 0.01)
np.testing.assert_allclose(direction(camera("again.pvsm")),
                           direction({key: np.array(value) for key, value in OWN.items()}), atol=1e-9)
