# SPDX-License-Identifier: BSD-3-Clause
"""Measures the cost of moving Touch's handle in ParaView: pvpython touch_move.py [FILE.csv]      needs an X server

The body has 163 842 vertices and is 290 mm long, like a head. The tip goes around it in steps of about 3 mm. For
comparison, the same run measures two frames of the same body in ParaView without Touch: one of the body at rest, and
one after ParaView's own Transform has moved all points, which are sent again, as after a dent. It also measures the
filter alone, without ParaView. The numbers are medians in ms; ratios are more meaningful than times.
"""
import statistics
import sys
import time
from pathlib import Path
import numpy as np
import palpate  # for GetClientSideObject() # pylint: disable=unused-import
from paraview import servermanager, simple

sys.path.insert(0, str(Path(__file__).parent.parent / "ParaView"))
import organ # pylint: disable=wrong-import-position

MOVES = 30
WARM = 5                                                    # uncounted moves


def timed(view, change, update):
    """Medians over all moves: of the update alone, and of the update with its frame."""
    updates, frames = [], []
    for i in range(WARM + MOVES):
        change(i)
        begin = time.perf_counter()
        update()
        middle = time.perf_counter()
        simple.Render(view)
        end = time.perf_counter()
        if i >= WARM:
            updates.append(middle - begin)
            frames.append(end - begin)
    return 1000 * statistics.median(updates), 1000 * statistics.median(frames)


def main(file=None):
    source = simple.TrivialProducer()
    body = organ.organ(level=7, size=3.0)
    source.GetClientSideObject().SetOutput(body)
    response = simple.ToolContactResponse(Input=source)
    response.UpdatePipeline()
    view = simple.CreateView("RenderView")
    view.ViewSize = [1000, 700]
    rows = []

    shown = simple.Show(response, view)
    simple.ResetCamera(view)
    camera = view.GetActiveCamera()
    rows.append(("body at rest", *timed(view, lambda i: camera.Azimuth(0.5), lambda: None)))
    simple.Hide(response, view)

    moved = simple.Transform(Input=response)
    shown = simple.Show(moved, view)
    shown.ColorArrayName = [None, ""]

    def shift(i):
        moved.Transform.Translate = [0.01 * i, 0, 0]
    rows.append(("ParaView's Transform", *timed(view, shift, lambda: moved.UpdatePipeline(view.ViewTime))))
    simple.Hide(moved, view)

    touch = simple.Touch(Input=response)
    for port in range(4):
        simple.Show(servermanager.OutputPort(touch, port), view)

    def move(i):
        angle = 0.025 * i
        touch.TipPositionmm = [140 * np.cos(angle), 100 * np.sin(angle), 40]
    rows.append(("Touch", *timed(view, move, lambda: touch.UpdatePipeline(view.ViewTime))))

    # The filter without ParaView, because ParaView gathers information on all ports and their
    # arrays at each update.
    inner = touch.GetClientSideObject()

    def put(i):
        angle = 0.025 * i
        inner.SetTipPosition(140 * np.cos(angle), 100 * np.sin(angle), 40)
    rows.append(("vtkToolTouch alone", *timed(view, put, inner.Update)))

    rest, frame = rows[0][2], rows[1][2]
    lines = ["what,update_ms,update_and_frame_ms,frames_at_rest,frames_of_transform"]
    lines += [f"{what},{update:.2f},{both:.2f},{both / rest:.2f},{both / frame:.2f}" for what, update, both in rows]
    print(f"{body.GetNumberOfPoints()} vertices, {MOVES} moves")
    print("\n".join(lines))
    if file:
        Path(file).write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
