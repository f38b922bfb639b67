# SPDX-License-Identifier: BSD-3-Clause
"""Writes the CalculiX input deck of one case, and reads the forces from the results of CalculiX."""
import re

import numpy as np

import cases

# N/mm^3. Under the mean pressures here (0.02 to 0.05 MPa) the tool penetrates by 1e-4 mm.
CONTACT_STIFFNESS = 400.0
# CalculiX expands an axisymmetric element to a wedge of 2 degrees and prints the forces on it.
WEDGES = 180
QUARTERS = 4


def lines(values, between="\n"):
    """Returns the values as text, twelve per line; CalculiX reads at most 16. An element continues after a comma."""
    values = [str(v) for v in values]
    return between.join(", ".join(values[i:i + 12]) for i in range(0, len(values), 12)) + "\n"


def nodes_and_elements(mesh, kind, name, first_node, first_element):
    axial = mesh.points.shape[1] == 2
    text = "*NODE, NSET=N{}\n".format(name)
    text += "".join("{}, {}{}\n".format(first_node + i, ", ".join("%.12g" % x for x in point),
                                        ", 0" if axial else "")
                    for i, point in enumerate(mesh.points))
    text += "*ELEMENT, TYPE={}, ELSET=E{}\n".format(kind, name)
    text += "".join(lines([first_element + e, *(nodes + first_node)], ",\n")
                    for e, nodes in enumerate(mesh.elements))
    text += "*SURFACE, TYPE=ELEMENT, NAME=S{}\n".format(name)
    return text + "".join("{}, S{}\n".format(first_element + e, face) for e, face in mesh.contact)


def node_set(name, where):
    return "*NSET, NSET={}\n".format(name) + lines(np.flatnonzero(where) + 1)


def material(name, law, young, poisson):
    if law == "linear":
        return "*MATERIAL, NAME={}\n*ELASTIC\n{:.12g}, {:.12g}\n".format(name, young, poisson)
    # W = C10 (I1bar - 3) + (J - 1)^2 / D1, with the shear modulus 2 C10 and the bulk modulus 2 / D1.
    shear, bulk = young / (2 * (1 + poisson)), young / (3 * (1 - 2 * poisson))
    return "*MATERIAL, NAME={}\n*HYPERELASTIC, NEO HOOKE\n{:.12g}, {:.12g}\n".format(
        name, shear / 2, 2 / bulk)


def write(case, coarseness):
    """Returns the text of the deck, the factor of the force for the whole body, and the number of nodes of the body."""
    body = cases.body_mesh(case, coarseness)
    tool = cases.tool_mesh(case, coarseness)
    axial = case.body.half_width == 0
    up, kind = (2, "CAX8R") if axial else (3, "C3D20R")
    points, height = body.points, body.points[:, -1]
    radius = np.abs(points[:, 0]) if axial else np.hypot(points[:, 0], points[:, 1])

    # Contact is searched only on the part of the surface that the tool can reach.
    body.contact = [(e, face) for e, face in body.contact
                    if np.min(radius[body.elements[e]]) < 0.95 * case.tool.radius]
    text = "** {}: {}\n".format(case.name, case.body.description)
    text += nodes_and_elements(body, kind, "BODY", 1, 1)
    text += material("BODY", case.material, cases.YOUNGS_MODULUS, case.body.poisson_ratio)
    text += "*SOLID SECTION, ELSET=EBODY, MATERIAL=BODY\n"

    if tool is None:
        text += node_set("TOOL", np.isclose(height, 0) & (radius < case.tool.radius * (1 + 1e-9)))
    else:
        text += nodes_and_elements(tool, kind, "TOOL", len(points) + 1, len(body.elements) + 1)
        text += "*NSET, NSET=TOOL\nNTOOL\n"
        # Every node of the tool is prescribed, so its stiffness does not matter.
        text += material("TOOL", "linear", 100, 0.3) + "*SOLID SECTION, ELSET=ETOOL, MATERIAL=TOOL\n"
        text += ("*SURFACE INTERACTION, NAME=FRICTIONLESS\n*SURFACE BEHAVIOR, "
                 "PRESSURE-OVERCLOSURE=LINEAR\n{:g}\n".format(CONTACT_STIFFNESS) +
                 "*CONTACT PAIR, INTERACTION=FRICTIONLESS, TYPE=SURFACE TO SURFACE\nSBODY, STOOL\n")

    fixed = {"base": np.isclose(height, -case.body.thickness),
             "rim": np.isclose(radius, case.body.half_length),
             "ends": np.isclose(points[:, 0], case.body.half_length)}[case.body.support]
    first = up if case.body.support == "ends" else 1
    text += node_set("SUPPORT", fixed) + node_set("XPLANE", np.isclose(points[:, 0], 0))
    text += "*BOUNDARY\nSUPPORT, {}, {}\nXPLANE, 1, 1\n".format(first, up)
    if not axial:
        text += node_set("YPLANE", np.isclose(points[:, 1], 0)) + "*BOUNDARY\nYPLANE, 2, 2\n"
    if tool is not None:
        text += "*BOUNDARY\nTOOL, 1, {}\n".format(up - 1)

    text += "".join(steps(case, axial, up))
    return text, WEDGES if axial else QUARTERS, len(points)


def steps(case, axial, up):
    flat, deflections = case.tool.shape == "flat", cases.deflections(case)
    geometry = ", NLGEOM" if case.material == "neohooke" else ""
    # Nodal forces on second-order faces have both signs under any pressure; those on edges have
    # one.
    totals = "YES" if flat and axial else "ONLY"
    # Without contact and large strain CalculiX solves a step in one increment. Then there is one
    # step per depth.
    ends = deflections if flat and not geometry else deflections[-1:]
    # The first increment after zero contact is the least accurate. The wide steps of the quarter
    # models are halved, so that this increment is not one of the depths.
    substeps = 1 if axial or flat else 2
    for end in ends:
        yield "*STEP, INC={}{}\n*STATIC, DIRECT\n{:.12g}, {:.12g}\n".format(
            2 * substeps * len(deflections), geometry, 1 / (substeps * len(deflections)), 1 / len(ends))
        # Residuals ten times below CalculiX's default for contact, so that tool and support
        # balance.
        yield "*CONTROLS, PARAMETERS=FIELD\n{:g}\n".format(1e-6 if flat else 5e-4)
        yield "*BOUNDARY\nTOOL, {0}, {0}, {1:.12g}\n".format(up, -end)
        yield "*NODE PRINT, NSET=TOOL, TOTALS={}\nRF\n".format(totals)
        yield "*NODE PRINT, NSET=SUPPORT, TOTALS=ONLY\nRF\n*END STEP\n"


def forces(text, case, factor):
    """Returns the force at each deflection that was reached, from the tables that CalculiX prints.

    Raises ValueError if tool and support do not balance, or if a flat pulls on the body."""
    axial = case.body.half_width == 0
    number = r"\s+(\S+)"
    count = len(cases.deflections(case))
    totals = {"TOOL": [], "SUPPORT": []}
    for name, time, *vector in re.findall(
            r"total force \(fx,fy,fz\) for set (\w+) and time" + 4 * number, text):
        # Skips increments between the depths, and an increment of length 0 that CalculiX may add at
        # the end.
        if len(totals[name]) < count and np.isclose(float(time) * count, len(totals[name]) + 1, rtol=1e-5):
            totals[name].append(float(vector[1 if axial else 2]))
    pressed, held = -factor * np.array(totals["TOOL"]), factor * np.array(totals["SUPPORT"])
    pressed = pressed[:len(held)]
    # The residual tolerance of CalculiX is relative to the mean nodal force.
    if np.any(np.abs(pressed - held) > 2e-3 * np.abs(pressed).max(initial=0)):
        raise ValueError("{}: tool and support differ by {:.2g} N".format(
            case.name, np.abs(pressed - held).max()))
    for block in re.findall(r"\n forces .* for set TOOL .*\n\n((?:\s+\d+\s.*\n)+)", text):
        pulls = max(float(line.split()[2 if axial else 3]) for line in block.strip().split("\n"))
        if pulls * factor > 1e-3 * pressed.max():
            raise ValueError("{}: the surface would leave the flat ({:.2g} N)".format(
                case.name, pulls * factor))
    return pressed
