# SPDX-License-Identifier: BSD-3-Clause
"""The bodies, tools and materials of the study, and the mesh of each pair. Units mm, N, MPa."""
from dataclasses import dataclass

import numpy as np

import mesh

YOUNGS_MODULUS = 0.1


@dataclass(frozen=True)
class Body:
    name: str
    poisson_ratio: float
    thickness: float
    half_length: float  # radius of a round body
    half_width: float   # 0: round, hence axisymmetric; otherwise a quarter model
    support: str        # "base" bonded, "rim" clamped, "ends" |x| = half_length held in z only
    description: str


@dataclass(frozen=True)
class Tool:
    shape: str
    radius: float

    @property
    def name(self):
        return f"{self.shape}{self.radius:g}"


@dataclass(frozen=True)
class Case:
    body: Body
    tool: Tool
    material: str  # "linear" or "neohooke"
    largest_deflection: float
    suffix: str = ""

    @property
    def name(self):
        return f"{self.body.name}-{self.tool.name}-{self.material}{self.suffix}"


BLOCK = Body("block", 0.45, 2000, 2000, 0, "base",
             "cylinder, radius and height 2000 mm, base bonded: stands for a half-space")
LAYER = Body("layer10", 0.45, 10, 100, 0, "base",
             "layer 10 mm thick, radius 100 mm, bonded to a rigid base")
CLAMPED = Body("plateclamped", 0.3, 4, 30, 0, "rim",
               "round plate, radius 30 mm, 4 mm thick, clamped at its rim (u_r = u_z = 0)")
EDGES = Body("plateedges", 0.45, 6, 30, 20, "ends",
             "plate 60 x 40 x 6 mm, supported at the faces x = -30 and x = 30 (u_z = 0 there)")
QUARTER_LAYER = Body("layer10quarter", 0.45, 10, 60, 60, "base",
                     "block 120 x 120 x 10 mm bonded to a rigid base, three-dimensional quarter model")

LARGE, SMALL, FLAT = Tool("sphere", 6.35), Tool("sphere", 1.6), Tool("flat", 1.6)
HUGE = Tool("sphere", 20)

CASES = {case.name: case for case in [
    Case(body, tool, material, deepest)
    for body, depths in {
        BLOCK: {LARGE: 2.0, SMALL: 0.8, FLAT: 0.6},
        LAYER: {LARGE: 3.0, SMALL: 0.8, FLAT: 0.6},
        CLAMPED: {LARGE: 2.0, SMALL: 2.0, FLAT: 2.0},
        EDGES: {LARGE: 3.0, SMALL: 3.0, FLAT: 3.0},
        QUARTER_LAYER: {LARGE: 2.0},
    }.items()
    for tool, deepest in depths.items()
    for material in (["linear"] if body is QUARTER_LAYER else ["linear", "neohooke"])
] + [
    # Cases for the depth up to which small-strain theory is valid.
    Case(BLOCK, LARGE, "neohooke", 5.0, "-deep"),
    Case(LAYER, LARGE, "neohooke", 4.5, "-deep"),
    Case(LAYER, HUGE, "neohooke", 4.5, "-deep")]}


def deflections(case):
    """Returns equally spaced deflections. The quarter models are slower and have half as many."""
    count = 16 if case.body.half_width == 0 else 8
    return case.largest_deflection * np.arange(1, count + 1) / count


def body_mesh(case, coarseness):
    """Returns a mesh of the body, finest under the tool; `coarseness` multiplies the size of the elements there."""
    body, tool = case.body, case.tool
    largest = 0.6 if body.support != "base" else 2.0 if body.thickness < 100 else np.inf
    contact = 0.63 * tool.radius if case.largest_deflection < 0.4 * tool.radius else 0.85 * tool.radius
    if body.half_width > 0:
        return quarter_mesh(body, tool, coarseness)
    if tool.shape == "flat":
        # Finer elements at the rim, where the pressure is singular, fail at large strain.
        first = (0.01 if case.material == "linear" else 0.08) * coarseness
        radii = mesh.graded_about(tool.radius, first, body.half_length, 1.3, 0.2 * coarseness)
        depths = mesh.graded(first, first, body.thickness, 1.3, largest * coarseness)
    else:
        first = min(tool.radius / 32, 0.3) * coarseness
        radii = mesh.graded(first, contact, body.half_length, 1.35, max(3 * largest, 2) * coarseness
                            if body.thickness < 100 else np.inf)
        depths = mesh.graded(first, 0.5 * contact, body.thickness, 1.35, largest * coarseness)
    return mesh.half_section(radii, -depths[::-1])


def quarter_mesh(body, tool, coarseness):
    # The rim of the flat is a line of the mesh; the contact of the sphere is within its first
    # rings.
    side = max(2, round(3 / coarseness))
    if tool.shape == "flat":
        inner = tool.radius - mesh.graded(0.05 * coarseness, 0.05 * coarseness, 0.7 * tool.radius, 1.8)[::-1]
        outer = tool.radius + mesh.graded(0.05 * coarseness, 0.05 * coarseness, 10 - tool.radius, 1.8,
                                          3 * coarseness)
        rings = np.concatenate([inner, outer[1:]])
        first = 0.05 * coarseness
        heights = mesh.graded(first, first, body.thickness, 1.8, 2 * coarseness)
    else:
        first = tool.radius / 10 * coarseness
        rings = 0.2 * tool.radius + mesh.graded(first, 0.4 * tool.radius, 10 - 0.2 * tool.radius, 1.5,
                                                3 * coarseness)
        heights = mesh.graded(first, 0.2 * tool.radius, body.thickness, 1.5, 2 * coarseness)
    far = mesh.graded(0.15 * coarseness, 0.15 * coarseness, 1, 1.25)
    plane, elements = mesh.quarter_plane(side, rings, (body.half_length, body.half_width, far))
    return mesh.quarter_body(plane, elements, -heights[::-1])


def tool_mesh(case, coarseness):
    """Returns a shell of the rigid sphere; None for the flat, for which the nodes of the surface are prescribed."""
    radius = case.tool.radius
    if case.tool.shape == "flat":
        return None
    if case.body.half_width > 0:
        side = round(8 / coarseness)
        plane, elements = mesh.quarter_plane(
            side, radius * np.linspace(0.2, 0.9, round(24 / coarseness) + 1))
        return mesh.quarter_sphere(radius, plane, elements, 0.1 * radius)
    opening = (0.98 if case.suffix else 0.92) * radius
    return mesh.sphere_section(radius, opening, round(60 / coarseness), 0.1 * radius)
