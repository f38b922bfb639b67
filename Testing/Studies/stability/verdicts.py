# SPDX-License-Identifier: BSD-3-Clause
"""A table of the stability study: for each method and failure a verdict and the number on which it is based.

survives   the failure has no effect, within the tolerance stated with each rule below
bounded    the failure has an effect, but the effect ends, or generates no energy
fails      the loop oscillates, requests a force that is not a number, generates energy, or jumps or drifts strongly

A cell is {group, method, failure, verdict, number, unit}. The thresholds are chosen by this study, each with its reason.
"""
import itertools

SURVIVES, BOUNDED, FAILS = "survives", "bounded", "fails"
RENDERINGS = ("point spring", "law at run time", "stored, none", "stored, cap", "stored, passivity",
              "stored, chain at 2b/T", "stored, chain")
FAULTS = {"dropped": "20 % dropped", "late": "5 % late: by 5 ms", "nan": "2 % NaN", "stall": "0.1 s hang: of the device",
          "host": "0.1 s hang: of the host", "unplug": "unplugged 0.3 s", "delay": "1 ms delay"}
STILL = 0.1           # mm/s; not perceptible by a hand
NO_ENERGY = 1e-6      # mJ: tolerance of PassivityControl
LITTLE_ENERGY = 0.1   # mJ; a tenth of the energy stored by the tissue of part f at its deepest
QUADRATURE = 1e-5     # fraction of force times path, in loops
RATE = 1000.0
RUBBER = 3.45         # MPa


def first(rows, **wanted):
    for row in rows:
        if all(row[name] == value for name, value in wanted.items()):
            return row
    return None


def cell(group, method, failure, verdict, number, unit):
    return {"group": group, "method": method, "failure": failure, "verdict": verdict, "number": float(number),
            "unit": unit}


def press_of(rows, method, modulus):
    """Returns the row of part b for this rendering of the 6.35 mm sphere (or its secant) on the body of this modulus."""
    wanted = {"rate_Hz": RATE, "modulus_MPa": modulus}
    if method == "point spring":
        return first(rows, model="spring", evaluated="law", start="held", **wanted)
    if method == "law at run time":
        return first(rows, model="sphere:6.35", evaluated="law", start="held", **wanted)
    return first(rows, model="sphere:6.35", start="dropped", control=method.partition(", ")[2], **wanted)


def stiff_cell(rows, method):
    modulus = max(row["modulus_MPa"] for row in rows)
    row = press_of(rows, method, modulus)
    name = "too stiff"
    if row["limit_N"] >= 10.0:
        return cell("rendering", method, name, SURVIVES, row["limit_N"], "N push")
    if row["generated_mJ"] <= NO_ENERGY:
        return cell("rendering", method, name, BOUNDED, row["last_speed_mm_s"], "mm/s ring")
    return cell("rendering", method, name, FAILS, row["limit_N"], "N push")


def fault_cell(rows, method, failure):
    row = first(rows, method=method, failure=failure, rate_Hz=RATE)
    sound = first(rows, method=method, failure="none", rate_Hz=RATE)
    name = FAULTS[failure]
    numb = row["numb_share"] - sound["numb_share"]
    if row["not_finite"] > 0:
        return cell("rendering", method, name, FAILS, row["not_finite"], "NaN forces")
    if row["last_speed_mm_s"] > STILL:
        return cell("rendering", method, name, FAILS, row["last_speed_mm_s"], "mm/s buzz")
    if row["generated_mJ"] > LITTLE_ENERGY:
        return cell("rendering", method, name, FAILS, row["generated_mJ"], "mJ")
    if row["generated_mJ"] > NO_ENERGY:
        return cell("rendering", method, name, BOUNDED, row["generated_mJ"], "mJ")
    if numb > 0.05:
        return cell("rendering", method, name, BOUNDED, 100 * numb, "% no force")
    return cell("rendering", method, name, SURVIVES, row["generated_mJ"], "mJ")


def friction_cells(rows):
    models = list(dict.fromkeys(row["model"] for row in rows))

    def value(model, what, setting=0.0):
        row = first(rows, model=model, what=what, rate_Hz=RATE, setting=setting)
        return None if row is None else row["value"]

    def graded(number, good, bad):
        return SURVIVES if number <= good else BOUNDED if number <= bad else FAILS

    passive = 2 * RATE  # 2b/T of 1 N s/m
    for model in models:
        # Drift in mm in 8 s; the amplitude of the oscillation is about 0.4 mm.
        drift = abs(value(model, "drift_mm"))
        yield cell("friction", model, "drift", graded(drift, 1e-3, 1.0), drift, "mm")
        stuck, ripple = value(model, "stuck_share", 5.0), value(model, "speed_ripple", 5.0)
        yield cell("friction", model, "stick and slip", FAILS if stuck > 0 else graded(ripple, 0.01, 1.0),
                   100 * ripple, "% speed ripple")
        rest = value(model, "rest_speed_mm_s", 0.5)
        yield cell("friction", model, "rest, σ₀ = b/T", graded(rest, STILL, 1.0), rest, "mm/s")
        stick = value(model, "stiffest_stick_N_per_m")
        if stick is not None:
            yield cell("friction", model, "stiffest stick, of 2b/T", SURVIVES if stick >= 0.99 * passive else FAILS,
                       stick / passive, "×")


def geometry_cells(rows):
    def worst(name, column, **wanted):
        found = [row[column] for row in rows if row["body"].startswith(name)
                 and all(row[key] == value for key, value in wanted.items())]
        return max(found) if found else None

    def graded(number, good, bad):
        return SURVIVES if number <= good else BOUNDED if number <= bad else FAILS

    for edges, surface, form in itertools.product(("dropped", "felt"), ("Facets", "Smooth"),
                                                  ("Paper", "NormalizedDirection", "EnergyConsistent")):
        method = f"{surface}, {form}" + (", edges felt" if edges == "felt" else "")
        wanted = {"surface": surface, "form": form, "edges": edges}
        # A force jump of 1 % is not noticeable (a tenth of the just-noticeable difference); a jump of 10 % is.
        for name, title in (("edge 90", "90° edge"), ("groove", "groove"), ("slab", "3 mm slab")):
            jump = worst(name, "force_jump", **wanted)
            if jump is not None:
                yield cell("geometry", method, f"jump: {title}", graded(jump, 0.01, 0.1), 100 * jump, "%")
        for name, title in (("sphere", "coarse mesh"), ("sphere, varied", "varied response")):
            found = [row for row in rows if row["body"] == name
                     and all(row[key] == value for key, value in wanted.items())]
            middle = sorted(found, key=lambda row: row["edge_mm"])[len(found) // 2]
            if name == "sphere":
                yield cell("geometry", method, f"jump: {title}", graded(middle["force_jump"], 0.01, 0.1),
                           100 * middle["force_jump"], "%")
            gain = middle["loop_gain"]
            yield cell("geometry", method, f"loops: {title}", graded(gain, QUADRATURE, 1e-3), 100 * gain, "%")
        controlled, bare = middle["generated_controlled_mJ"], middle["generated_mJ"]
        yield cell("geometry", method, "soft to stiff, 5 laps", FAILS if bare > LITTLE_ENERGY else graded(
            bare, NO_ENERGY, LITTLE_ENERGY), bare, "mJ")
        yield cell("geometry", method, "the same, controlled", graded(controlled, NO_ENERGY, LITTLE_ENERGY),
               controlled, "mJ")


ELEMENTS = {16.0: "16 elements", 0.0: "quasi-linear"}


def material_name(material):
    return "elastic" if material == "elastic" else "three branches" if " " in material else f"τ = {material.split(':')[1]} s"


def relaxing_cells(tables):
    """Yields cells for bodies that relax: a spring, the 6.35 mm sphere under 10 N, and closed paths over a body whose response
    varies."""
    for material in dict.fromkeys(row["material"] for row in tables["relaxing-press"]):
        for elements, way in ELEMENTS.items():
            method = material_name(material) + (f", {way}" if material != "elastic" else "")
            if material == "elastic" and elements == 0:
                continue
            for late, title in ((0.0, "stable slow stiffness, of theory's"), (1.0, "the same, 1 tick late")):
                row = first(tables["relaxing"], material=material, elements=elements, rate_Hz=RATE, delay_ticks=late)
                if row is not None:
                    yield cell("relaxing", method, title, SURVIVES if abs(row["error"]) < 1e-3 else FAILS,
                               row["limit_N_per_m"] / row["exact_N_per_m"], "×")
            for control in ("none", "cap", "passivity", "chain at 2b/T", "chain"):
                row = first(tables["relaxing-press"], model="sphere:6.35", material=material, elements=elements,
                            rate_Hz=RATE, control=control)
                if row["rests"]:
                    yield cell("relaxing", method, f"10 N: {control}", SURVIVES, row["last_speed_mm_s"], "mm/s")
                else:
                    quiet = row["generated_mJ"] <= NO_ENERGY
                    yield cell("relaxing", method, f"10 N: {control}", BOUNDED if quiet else FAILS, row["last_speed_mm_s"],
                               "mm/s ring")
    for form in dict.fromkeys(row["form"] for row in tables["relaxing-paths"]):
        for elements, way in ELEMENTS.items():
            for row in tables["relaxing-paths"]:
                if row["form"] == form and row["elements"] == elements:
                    verdict = SURVIVES if row["loop_gain"] <= QUADRATURE else BOUNDED if row["loop_gain"] <= 1e-3 else FAILS
                    yield cell("relaxing paths", f"{form}, {way}", row["path"], verdict, 100 * row["loop_gain"], "%")


def hands_cells(tables):
    """Yields cells for two tools that are coupled by a half-space: flat ends as springs, and two tools under 10 N each."""
    for row in tables["hands"]:
        if row["rate_Hz"] == RATE and row["apart_radii"] == min(other["apart_radii"] for other in tables["hands"]):
            late = ", 1 tick late" if row["delay_ticks"] else ""
            yield cell("hands", "flat ends, 2 radii apart", f"stable stiffness, {row['motion']}, of one alone{late}",
                       SURVIVES if abs(row["error"]) < 1e-3 else FAILS, row["limit_N_per_m"] / row["alone_N_per_m"], "×")
    for row in tables["hands-press"]:
        if row["rate_Hz"] == RATE:
            method, failure = f"{row['model']}, {row['apart_mm']:g} mm apart", f"10 N each: {row['control']}"
            if row["rests"]:
                yield cell("hands", method, failure, SURVIVES, row["last_speed_mm_s"], "mm/s")
            else:
                quiet = row["generated_mJ"] <= NO_ENERGY
                yield cell("hands", method, failure, BOUNDED if quiet else FAILS, row["last_speed_mm_s"], "mm/s ring")


def judge(tables):
    cells = []
    for method in RENDERINGS:
        cells.append(stiff_cell(tables["press"], method))
        cells += [fault_cell(tables["faults"], method, failure) for failure in FAULTS]
    cells += friction_cells(tables["friction"])
    cells += geometry_cells(tables["geometry"])
    cells += relaxing_cells(tables)
    cells += hands_cells(tables)
    return cells


def grid(cells, group):
    """Returns (methods, failures, {(method, failure): cell}) of a group, in their order."""
    mine = [c for c in cells if c["group"] == group]
    return (list(dict.fromkeys(c["method"] for c in mine)), list(dict.fromkeys(c["failure"] for c in mine)),
            {(c["method"], c["failure"]): c for c in mine})


def words(c):
    if c is None:
        return "–"
    number = "0" if c["number"] == 0 else "< 0.001" if 0 < c["number"] < 1e-3 else f"{c['number']:.3g}"
    return f"{number} {c['unit']}"


def markdown(cells):
    lines = []
    for group in ("rendering", "friction", "geometry", "relaxing", "relaxing paths", "hands"):
        methods, failures, found = grid(cells, group)
        lines += ["", f"| {group} | " + " | ".join(failures) + " |", "|---" * (len(failures) + 1) + "|"]
        for method in methods:
            row = [found.get((method, failure)) for failure in failures]
            lines.append(f"| {method} | " + " | ".join(
                "–" if c is None else f"**{c['verdict']}** {words(c)}" for c in row) + " |")
    return "\n".join(lines[1:]) + "\n"
