# SPDX-License-Identifier: BSD-3-Clause
"""Bodies with an edge, a horn and a nodule: the error of the half-space law on them, and the cost of true shape."""
import math
import time

import pictures
import rows as study

METHODS = {"half-space": "#d55e00", "half-space, edges felt": "#009e73", "half-space, body in series": "#e69f00",
           "true shape, coarse": "#56b4e9", "true shape": "#0072b2"}
HALF_SPACE, EDGES_FELT, IN_SERIES, COARSE, TRUE = METHODS
COLUMNS = ("body", "tool", "case", "method", "depth_mm", "true_force_N", "force_N", "error", "stated_error", "made_s",
           "points", "hot_ns")
TEXTS = COLUMNS[:4]
BODIES = ("edge", "horn", "nodule")
DEEPER = 1.1                # curves extend a tenth beyond the deepest press
TICKS, PASSES, WANDER = 4000, 7, 0.4    # ticks and passes of the timed path; its distance from the place, mm


def read(text):
    return study.read(text, TEXTS)


class Response:
    """The curves of one tool on one body, by one method."""

    def __init__(self, method, body, tool, compliance=None):
        import palpate
        import shape_bodies
        began = time.perf_counter()
        mesh = body.meshes["coarse" if method == COARSE else "fine"]
        deepest = DEEPER * max(depth for _, _, depth, _ in body.at(tool))
        if method in (COARSE, TRUE):
            law = palpate.vtkElasticContactResponse()
            law.SetInputData(mesh)
            if body.name == "nodule":
                arrays_of_cells(law)
            pressed = shape_bodies.on_true_surface(body.name, tool)
        else:
            law = palpate.vtkToolContactResponse()
            pressed = tool
            if method == IN_SERIES:
                law.SetInputData(compliance)
                law.SetInputArrayToProcess(2, 0, 0, 0, "GlobalCompliance")
            else:
                outside = palpate.vtkBodySurface()
                outside.SetInputData(mesh)
                law.SetInputConnection(outside.GetOutputPort())
                law.SetEdgeCorrection(method == EDGES_FELT)
        law.SetTool(shape_bodies.tool(pressed))
        law.SetYoungsModulus(shape_bodies.YOUNG)
        law.SetPoissonRatio(shape_bodies.POISSON)
        law.SetMaximumDeflection(deepest)
        law.AddObserver("WarningEvent", lambda *_: None)    # most points are not pressed and have no response
        law.Update()
        self.made = time.perf_counter() - began
        self.surface = law.GetOutput()
        status = self.surface.GetPointData().GetArray("ResponseStatus")
        states = [status.GetTuple1(i) for i in range(status.GetNumberOfTuples())]
        self.points = sum(state in (0, 5) for state in states)      # state 5, next to an edge, has a curve too
        self.place = self.surface.GetPoint(self.surface.FindPoint(*body.place))
        self.middle = (0.0, 0.0, 0.0) if body.name == "horn" else None

    def tip(self, depth, across=(0.0, 0.0)):
        """Returns the position of a tip at a depth under the place, or moved sideways from it by `across`, mm."""
        x, y, z = self.place[0] + across[0], self.place[1] + across[1], self.place[2]
        if self.middle is None:
            return x, y, z - depth
        size = math.sqrt(x * x + y * y + z * z)             # the depth is towards the middle of the ball
        radius = math.sqrt(sum(c * c for c in self.place))
        return tuple(c / size * (radius - depth) for c in (x, y, z))

    def probe(self, tips, follows):
        """Returns an updated probe of the tips, and its input. `follows`: the tips are one path; otherwise independent."""
        import palpate
        from vtkmodules.vtkCommonCore import VTK_DOUBLE, vtkPoints
        from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
        points, lines, path = vtkPoints(), vtkCellArray(), vtkPolyData()
        points.SetDataType(VTK_DOUBLE)
        for tip in tips:
            points.InsertNextPoint(*tip)
        path.SetPoints(points)
        if follows:
            lines.InsertNextCell(len(tips), range(len(tips)))
            path.SetLines(lines)
        probe = palpate.vtkToolContactProbe()
        probe.SetInputData(0, self.surface)
        probe.SetTipData(path)
        probe.Update()
        return probe, path

    def forces(self, depths):
        """Yields the force along the normal and its stated error for each depth; (None, None) without a response."""
        probe, _ = self.probe([self.tip(depth) for depth in depths], False)
        data = probe.GetOutput().GetPointData()
        felt = data.GetArray("NormalForce"), data.GetArray("RelativeError"), data.GetArray("ContactState")
        for i in range(len(depths)):
            force, error, state = (array.GetTuple1(i) for array in felt)
            yield (force, None if math.isnan(error) else error) if state in (1, 2) else (None, None)

    def tick(self, deepest):
        """Returns the median time per tip (ns) of a path around the place, on one thread; None if a tip has no contact."""
        from vtkmodules.vtkCommonCore import vtkSMPTools
        reach = self.surface.GetPointData().GetArray("ResponseRange").GetTuple1(self.surface.FindPoint(*self.place))
        deepest = min(deepest, 0.9 * reach)
        tips = []
        for i in range(TICKS):
            angle, depth = 0.013 * i, deepest * (0.6 + 0.35 * math.sin(0.0071 * i))
            tips.append(self.tip(depth, (WANDER * math.cos(angle), WANDER * math.sin(2 * angle))))
        vtkSMPTools.Initialize(1)
        probe, path = self.probe(tips, True)                # copies the body for the kernel
        times = []
        for _ in range(PASSES):
            path.Modified()
            began = time.perf_counter()
            probe.Update()
            times.append(time.perf_counter() - began)
        vtkSMPTools.Initialize(0)                           # resets to the default number of threads
        states = probe.GetOutput().GetPointData().GetArray("ContactState")
        felt = sum(states.GetTuple1(i) in (1, 2) for i in range(TICKS))
        return 1e9 * sorted(times)[PASSES // 2] / TICKS if felt == TICKS else None


def arrays_of_cells(filter):
    """Sets the arrays of vtkNoduleMaterial as E and ν of each cell."""
    filter.SetInputArrayToProcess(0, 0, 0, 1, "YoungsModulus")
    filter.SetInputArrayToProcess(1, 0, 0, 1, "PoissonRatio")


def compliance_of(body):
    """Returns the surface with C_g, which is the same for all tools, and the computing time in s."""
    import palpate
    import shape_bodies
    began = time.perf_counter()
    compliance = palpate.vtkElasticCompliance()
    compliance.SetInputData(body.meshes["fine"])
    compliance.SetYoungsModulus(shape_bodies.YOUNG)
    compliance.SetPoissonRatio(shape_bodies.POISSON)
    if body.name == "nodule":
        arrays_of_cells(compliance)
    compliance.Update()
    return compliance.GetOutput(), time.perf_counter() - began


def rows_of(body, methods=tuple(METHODS), timed=True):
    """Yields a row per tool, depth and method."""
    compliance, before = compliance_of(body) if IN_SERIES in methods else (None, 0.0)
    for tool in body.tools():
        presses = body.at(tool)
        depths = [depth for _, _, depth, _ in presses]
        for method in methods:
            response = Response(method, body, tool, compliance)
            made = response.made + (before if method == IN_SERIES else 0.0)
            ns = response.tick(max(depths)) if timed else None
            for (_, case, depth, truth), (force, stated) in zip(presses, response.forces(depths)):
                yield dict(body=body.name, tool=tool, case=case, method=method, depth_mm=depth, true_force_N=truth,
                           force_N=force, error=None if force is None else force / truth - 1, stated_error=stated,
                           made_s=float("{:.2g}".format(made)) if timed else None, points=response.points,
                           hot_ns=ns and float("{:.3g}".format(ns)))


def measure(quick, say):
    """Returns the rows of all bodies. Calls `say` with the reason for each body that is left out."""
    import shape_bodies
    rows = []
    for body in shape_bodies.bodies(quick):
        if isinstance(body, str):
            say(body)
        else:
            # C_g of all points takes half a minute, so a quick run leaves it out.
            rows += rows_of(body, [method for method in METHODS if not (quick and method == IN_SERIES)])
    return rows


def of(rows, body, method):
    return [row for row in rows if row["body"] == body and row["method"] == method]


def groups(rows):
    """Returns the title and rows of each line of the table: a line for each body; for nodules one per depth and modulus."""
    found = {}
    for row in rows:
        nodule = row["body"] == "nodule"
        name = "nodule, {:g} mm deep, ×{}".format(abscissa(row), modulus(row)) if nodule else row["body"]
        found.setdefault(name, []).append(row)
    return found


def worst(rows):
    """Returns the row with the largest |error| of the rows that have a force, or None."""
    there = [row for row in rows if row["error"] is not None]
    return max(there, key=lambda row: abs(row["error"])) if there else None


def cell(rows):
    if not rows:
        return ""
    row = worst(rows)
    missing = sum(each["error"] is None for each in rows)
    if row is None:
        return "no force"
    stated = row["stated_error"]
    text = "{:+.1f} %".format(100 * row["error"])
    if stated is not None:
        text += (" ({:.1f})" if stated < 1 else " ({:.0f})").format(100 * stated)
    return text + ("; {} of {} without a force".format(missing, len(rows)) if missing else "")


def span(rows, name, form):
    """Returns the range of a column over the rows as text, "least to largest"."""
    values = [row[name] for row in rows if row[name] is not None]
    texts = list(dict.fromkeys(form.format(value) for value in (min(values), max(values)))) if values else ["–"]
    return " to ".join(texts)


def tables(rows):
    """Returns the results as Markdown tables."""
    head = "| {} | " + " | ".join(METHODS) + " |"
    lines = ["**On edges, horns and nodules**: largest error of the force over tools and depths, in brackets what the probe "
             "states there", "", head.format("body"), "|---" * (len(METHODS) + 1) + "|"]
    for name, mine in groups(rows).items():
        lines.append("| {} | {} |".format(name, " | ".join(
            cell([row for row in mine if row["method"] == method]) for method in METHODS)))
    lines += ["", "**What it takes**: seconds to make the response of one tool / points that have one / a tick, ns", "",
              head.format("body"), "|---" * (len(METHODS) + 1) + "|"]
    for body in BODIES:
        mine = [of(rows, body, method) for method in METHODS]
        if any(mine):
            lines.append("| {} | {} |".format(body, " | ".join("{} s / {} / {} ns".format(
                span(each, "made_s", "{:.2g}"), span(each, "points", "{:.0f}"), span(each, "hot_ns", "{:.0f}"))
                if each else "" for each in mine)))
    return "\n".join(lines) + "\n"


def abscissa(row):
    """Returns a/e, a/R, or the depth of the nodule's top in mm."""
    return float(row["case"].split(",")[0].split("=")[1])


def modulus(row):
    return row["case"].split(" x")[1]


MARKS = {"flat": ("s", "none", "flat"), "sphere:6.35": ("o", "-", "sphere of 6.35 mm"),
         "sphere:1.6": ("^", "--", "sphere of 1.6 mm")}
NODULES = {"10": ("D", "-", "nodule 10 times as hard"), "0.2": ("v", "--", "nodule a fifth as hard")}


def lines_of(rows, body, method):
    """Yields the mark, the line style and the rows of each line of a panel."""
    mine = of(rows, body, method)
    if body == "nodule":
        for ratio, (mark, line, _) in NODULES.items():
            tops = dict.fromkeys(abscissa(row) for row in mine if modulus(row) == ratio)
            most = [worst([row for row in mine if modulus(row) == ratio and abscissa(row) == top]) for top in tops]
            yield mark, line, [row for row in most if row]
    else:
        for tool, (mark, line, _) in MARKS.items():
            yield mark, line, [row for row in mine if row["tool"].startswith(tool) and row["error"] is not None]


PANELS = {"edge": ("3 mm from the edge of a block", "contact radius over distance from the edge, a/e"),
          "horn": ("pole of half a ball of 10 mm", "contact radius over radius of the ball, a/R"),
          "nodule": ("over a nodule of 3 mm: the largest error", "depth of the nodule's top, mm")}


ASIDE = {"edge": 0.006, "horn": 0.0025, "nodule": 0.07}


def draw(rows, file):
    pyplot = pictures.pyplot_or_none()
    if pyplot is None or not rows:
        return False
    figure, panels = pyplot.subplots(1, 3, figsize=(14.5, 5.8), sharey=True)
    for panel, (body, (title, label)) in zip(panels, PANELS.items()):
        for number, (method, colour) in enumerate(METHODS.items()):
            aside = ASIDE[body] * (number - 2)            # moves overlapping marks apart
            for mark, line, mine in lines_of(rows, body, method):
                panel.plot([abscissa(row) + aside for row in mine], [100 * row["error"] for row in mine], color=colour,
                           marker=mark, linestyle=line, linewidth=1.0, markersize=6,
                           markeredgecolor="white", markeredgewidth=0.5)
        panel.axhspan(-5, 5, color="0.9", zorder=0)
        panel.axhline(0, color="black", linewidth=0.8)
        panel.set_title(title)
        panel.set_xlabel(label)
        panel.margins(x=0.08)
    ticks = (-50, -20, -10, -5, -2, 0, 2, 5, 10, 20, 50, 100, 200)
    panels[0].set_yscale("symlog", linthresh=5, linscale=1.3)
    panels[0].set_ylim(-70, 300)
    panels[0].set_yticks(ticks)
    panels[0].set_yticklabels(["{:+d}".format(tick) if tick else "0" for tick in ticks])
    panels[0].minorticks_off()
    panels[0].set_ylabel("force over that of the table, less one, % (linear within 5)")
    panels[2].set_xticks([1, 2, 3, 5])
    handles = [panels[0].plot([], [], color=colour, linewidth=4, label=method)[0] for method, colour in METHODS.items()]
    handles += [panels[0].plot([], [], color="0.3", marker=mark, linestyle=line, linewidth=1, label=name)[0]
                for mark, line, name in list(MARKS.values()) + list(NODULES.values())]
    handles.append(panels[0].fill_between([], [], [], color="0.9", label="within 5 %"))
    figure.legend(handles=handles, loc="lower center", ncol=5, frameon=False)
    figure.tight_layout(rect=(0, 0.1, 1, 1))
    pictures.save(pyplot, figure, file)
    return True
