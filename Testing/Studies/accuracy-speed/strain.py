# SPDX-License-Identifier: BSD-3-Clause
"""Reads the output of `palpateAccuracySpeed --strain`: responses compared with curves at finite strain."""
import pictures
import rows as study

METHODS = {"small strain": ("#d55e00", "-"), "small strain, curvature": ("#e69f00", "--"),
           "finite strain, stored": ("#0072b2", "-")}
PRESSED = (0.3, 0.9)       # contact radius over tool radius, from and to
ON_BALL = 0.15             # least contact radius over tool radius on a ball, whose curves end at 0.3
THICKNESS = (0.1, 0.5)     # depth over thickness
TEXTS = ("part", "code", "tool", "method")


def read(text):
    return study.read(text, TEXTS)


def radius(tool):
    """Returns the radius of a sphere or flat, mm; None for a cone."""
    shape, size = tool.split(":")
    return float(size) if shape in ("sphere", "flat") else None


def case(row):
    return row["code"], row["tool"], row["thickness_mm"], row["ball_mm"], row["nu"]


def name(key):
    code, tool, thickness, ball, nu = key
    body = "ball of {:g} mm".format(ball) if ball else "layer of {:g} mm".format(thickness) if thickness else "half-space"
    return "{}, {}, ν = {:g}".format(tool, body, nu)


def is_pressed(row):
    """Whether the depth is usual in palpation: a/R 0.3 to 0.9 (on a ball 0.15 to 0.3); δ/R from 0.1 for a flat; δ/h 0.1 to
    0.5 on a layer; any depth for a cone."""
    if row["thickness_mm"]:
        return THICKNESS[0] <= row["depth_mm"] / row["thickness_mm"] <= THICKNESS[1] * (1 + 1e-9)
    size = radius(row["tool"])
    if size is None:
        return True
    along = row["depth_mm"] if row["tool"].startswith("flat") else row["contact_radius_mm"]
    least = 0.1 if row["tool"].startswith("flat") else ON_BALL if row["ball_mm"] else PRESSED[0]
    return least <= along / size <= PRESSED[1]


def cases(rows):
    return list(dict.fromkeys(case(row) for row in rows))


def of(rows, key, method, part="force"):
    return [row for row in rows if row["part"] == part and case(row) == key and row["method"] == method]


def worst(rows, key, method):
    """Returns the row with the largest |error| at usual depths (is_pressed), or None."""
    pressed = [row for row in of(rows, key, method) if is_pressed(row)]
    return max(pressed, key=lambda row: abs(row["error"])) if pressed else None


def tables(rows):
    """Returns the results as Markdown tables."""
    lines = ["**Against finite strain itself**: largest error of the force at depths at which people press (a/R 0.3 to 0.9, "
             "δ/h 0.1 to 0.5; flat: δ/R from 0.1, ball: a/R 0.15 to 0.3), in brackets what the response states there; median time of a tick", "",
             "| body | by | small strain | with curvature | finite strain, stored | tick, hot |", "|---|---|---|---|---|---|"]
    for key in cases(rows):
        cells = []
        for method in METHODS:
            row = worst(rows, key, method)
            cells.append("" if row is None or (method.endswith("curvature") and not key[3]) else
                         "{:+.1f} % ({:.1f})".format(100 * row["error"], 100 * row["stated_error"]))
        times = [row["hot_ns"] for method in METHODS for row in of(rows, key, method, "time")]
        lines.append("| {} | {} | {} | {} |".format(name(key), key[0], " | ".join(cells),
                                                    " / ".join("{:.0f} ns".format(t) for t in times)))
    return "\n".join(lines) + "\n"


PANELS = (
    ("sphere on a half-space", "contact radius over tool radius, a/R", lambda key: not key[2] and not key[3] and
     key[1].startswith("sphere"), lambda row: row["contact_radius_mm"] / radius(row["tool"])),
    ("sphere on a bonded layer", "depth over thickness, δ/h", lambda key: key[2] > 0,
     lambda row: row["depth_mm"] / row["thickness_mm"]),
    ("sphere of 1 mm on balls of 5 and 20 mm", "contact radius over tool radius, a/R", lambda key: key[3] > 0,
     lambda row: row["contact_radius_mm"] / radius(row["tool"])),
)
MARKS = {0.3: "v", 0.45: "o", 0.49: "s", 0.495: "^"}


def draw(rows, file):
    pyplot = pictures.pyplot_or_none()
    if pyplot is None:
        return False
    figure, panels = pyplot.subplots(1, 3, figsize=(14.5, 5.6))
    for panel, (title, label, wanted, place) in zip(panels, PANELS):
        for key in cases(rows):
            if not wanted(key):
                continue
            for method, (colour, line) in METHODS.items():
                if method.endswith("curvature") and not key[3]:
                    continue  # equal to the row without
                mine = of(rows, key, method)
                lines = key[0] != "CalculiX"
                panel.plot([place(row) for row in mine], [100 * row["error"] for row in mine], color=colour,
                           linestyle=line if lines else "none", linewidth=0.9, marker=MARKS[key[4]],
                           markersize=3.5 if lines else 5, fillstyle="full" if lines else "none")
            last = of(rows, key, "small strain")[-1]
            text = ("h = {:.2g} R".format(key[2] / radius(key[1])) if key[2] else
                    "ball of {:g} R".format(key[3]) if key[3] else "")
            panel.annotate(text, (place(last), 100 * last["error"]), xytext=(4, 0), textcoords="offset points",
                           fontsize=6.5, va="center")
        panel.axhline(0, color="black", linewidth=0.8)
        panel.axhspan(-1, 1, color="0.9", zorder=0)
        panel.set_title(title)
        panel.set_xlabel(label)
        panel.margins(x=0.13)
    panels[0].set_ylabel("force of the response over that of finite strain, less one, %")
    handles = [panels[0].plot([], [], linestyle=line, color=colour, label=method)[0]
               for method, (colour, line) in METHODS.items()]
    handles += [panels[0].plot([], [], linestyle="none", marker=mark, markersize=5, color="0.3",
                               label="ν = {:g}".format(nu))[0] for nu, mark in MARKS.items()]
    handles += [panels[0].plot([], [], linestyle="-", marker="o", markersize=3.5, color="0.3",
                               label="against the solver, on balls another code")[0],
                panels[0].plot([], [], linestyle="none", marker="o", markersize=5, fillstyle="none", color="0.3",
                               label="against CalculiX")[0]]
    handles.append(panels[0].fill_between([], [], [], color="0.9", label="within 1 %"))
    figure.legend(handles=handles, loc="lower center", ncol=5, frameon=False)
    figure.tight_layout(rect=(0, 0.11, 1, 1))
    pictures.save(pyplot, figure, file)
    return True


