# SPDX-License-Identifier: BSD-3-Clause
"""Forces of four tools on a half-space: prints a table of force in N over deflection in mm.

    ./run python Plugin/Python/examples/tool_curves.py
"""
from palpate import vtkContactTool

young, poisson = 0.05, 0.45                                 # MPa, -
reduced = young / (1 - poisson**2)
tools = []
for specification in ("flat:5", "sphere:6.35", "paraboloid:6.35", "cone:60"):
    tool = vtkContactTool()
    tool.SetSpecification(specification)                    # radii in mm, half angle in degrees
    tools.append(tool)

print("mm".rjust(6), *(tool.GetSpecification().rjust(16) for tool in tools))
for deflection in (0.0, 0.4, 0.8, 1.2, 1.6, 2.0):
    forces = [tool.GetForce(deflection, reduced) for tool in tools]
    print("%6.1f" % deflection, *("%16.6f" % force for force in forces))
