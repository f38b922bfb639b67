#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes Filters/Mechanics/FiniteStrain/NeoHookeTables.inc by the finite-strain solver.

    make_tables.py PROGRAM FILE     PROGRAM: bin/palpateStrainTables of the build (a target of its own)

Cost: about half an hour on two processors.
"""
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

LAYERS = ["0.5", "1", "2", "4"]
THICK = ["2", "4", "8", "16"]
NAMES = {"sphere": "Sphere", "flat": "Flat", "cone75": "Cone75", "cone60": "Cone60", "cone45": "Cone45"}


def table(program, name):
    return subprocess.run([program, name], check=True, capture_output=True, text=True).stdout


def main():
    program, path = sys.argv[1:]
    names = list(NAMES) + [f"layer{h}" for h in LAYERS] + [f"{tool}layer{h}" for tool in ("sphere", "flat") for h in THICK]
    with ThreadPoolExecutor(2) as threads:
        rows = dict(zip(names, threads.map(lambda name: table(program, name), names)))
    with open(path, "w", encoding="utf-8") as file:
        file.write("// SPDX-License-Identifier: BSD-3-Clause\n"
                   "// c = F_finite/F_small of Neo-Hooke; rows: Poisson's ratio, columns: the root of the depth\n"
                   "// over the deepest; 0: no equilibrium found.\n"
                   "constexpr double TableRatios[Ratios] = { 0.0, 0.15, 0.3, 0.4, 0.45, 0.48, 0.495 };\n"
                   "constexpr double TableRoots[Roots] = { 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0 };\n"
                   f"constexpr double TableLayers[] = {{ {', '.join(LAYERS)} }}; // h/R\n"
                   f"constexpr double ThickLayers[] = {{ {', '.join(THICK)} }};\n")
        for name, variable in NAMES.items():
            file.write(f"constexpr HalfSpaceTable {variable} = {{\n{rows[name]}}};\n")
        for variable, name, heights in (("Layers", "layer", LAYERS), ("SphereLayers", "spherelayer", THICK),
                                        ("FlatLayers", "flatlayer", THICK)):
            file.write(f"constexpr HalfSpaceTable {variable}[] = {{\n")
            for height in heights:
                file.write(f"  {{ // h = {height} R\n{rows[name + height]}  }},\n")
            file.write("};\n")


if __name__ == "__main__":
    main()
