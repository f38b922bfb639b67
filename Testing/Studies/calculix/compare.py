#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the finite-element curves with linear theory: prints tables and, with --plot FILE, draws a picture.

  compare.py [--data DIR] [--plot FILE.png]
"""
import argparse
import pathlib

import numpy as np

import cases
import theory

DATA = pathlib.Path(__file__).resolve().parents[3] / "Data" / "Studies" / "calculix"


def read_curve(path):
    """Returns deflections (mm) and forces (N) of a CSV file with a curve."""
    with open(path, encoding="utf-8") as curve:
        rows = [line.strip().split(",") for line in curve if not line.startswith("#")]
    columns = {name: i for i, name in enumerate(rows[0])}
    return tuple(np.array([float(row[columns[name]]) for row in rows[1:]])
                 for name in ("deflection_mm", "force_N"))


def reduced_modulus(body):
    return cases.YOUNGS_MODULUS / (1 - body.poisson_ratio ** 2)


def predicted(case, deflections):
    """Returns the forces of the exact small-strain law of a block or a bonded layer."""
    modulus = reduced_modulus(case.body)
    if case.body is cases.BLOCK:
        return np.array([theory.half_space_force(case.tool.shape, case.tool.radius, modulus, d)
                         for d in deflections])
    layer = theory.BondedLayer(case.body.thickness, case.body.poisson_ratio)
    return np.array([layer.force(case.tool.shape, case.tool.radius, modulus, d) for d in deflections])


def contact_radii(case, deflections):
    """Returns the contact radius of the small-strain law, divided by the tool radius."""
    if case.body is cases.BLOCK:
        return np.array([theory.half_space_contact_radius(case.tool.shape, case.tool.radius, d)
                         for d in deflections]) / case.tool.radius
    layer = theory.BondedLayer(case.body.thickness, case.body.poisson_ratio)
    return np.array([layer.contact_radius(case.tool.shape, case.tool.radius, d)
                     for d in deflections]) / case.tool.radius


def compliance(case, deflections, forces):
    """Returns C_g (mm/N) of the series model at each depth: the deflection beyond that of a half-space, over the force."""
    modulus = reduced_modulus(case.body)
    local = [theory.half_space_deflection(case.tool.shape, case.tool.radius, modulus, f) for f in forces]
    return (deflections - local) / forces


def depth_of_error(deflections, ratio, error):
    """Returns the depth, interpolated, from which on |ratio - 1| exceeds the error; NaN if there is no such depth."""
    beyond = np.abs(ratio - 1) > error
    if not beyond[-1]:
        return np.nan
    first = len(beyond) - np.argmin(beyond[::-1]) if not beyond.all() else 0
    if first == 0:
        return 0.0
    low, high = np.abs(ratio[first - 1:first + 1] - 1)
    step = deflections[first] - deflections[first - 1]
    return deflections[first - 1] + (error - low) / (high - low) * step


def local_bodies(curves):
    for name, (deflections, forces) in curves.items():
        case = cases.CASES[name]
        if case.body.support != "base":
            continue
        ratio, contact = forces / predicted(case, deflections), contact_radii(case, deflections)
        print("\n{}: force over the exact small-strain law".format(name))
        print("  depth mm", " ".join("%6.3f" % d for d in deflections))
        print("  a / R   ", " ".join("%6.3f" % a for a in contact))
        print("  ratio   ", " ".join("%6.4f" % r for r in ratio))
        for error in (0.05, 0.1):
            depth = depth_of_error(deflections, ratio, error)
            print("  {:.0f} % from {:.3g} mm: a/R = {:.3g}, depth/thickness = {:.3g}".format(
                100 * error, depth, np.interp(depth, deflections, contact), depth / case.body.thickness))


def linear_against_finite_strain(curves):
    print()
    for name, (deflections, linear) in curves.items():
        finite = curves.get(name.replace("-linear", "-neohooke"))
        if not name.endswith("-linear") or finite is None:
            continue
        ratio = linear / finite[1]
        print("{}: CalculiX's small strain over Neo-Hooke {:.3f} at the end; 5 % from {:.3g} mm, 10 % from "
              "{:.3g} mm".format(name, ratio[-1], *(depth_of_error(deflections, ratio, e) for e in (0.05, 0.1))))


def plates(curves):
    for body in (cases.CLAMPED, cases.EDGES):
        modulus = reduced_modulus(body)
        for material in ("linear", "neohooke"):
            found = {tool: curves.get("{}-{}-{}".format(body.name, tool.name, material))
                     for tool in (cases.FLAT, cases.LARGE, cases.SMALL)}
            if any(curve is None for curve in found.values()):
                continue
            print("\n{}, {}: C_g E* (1/mm) at each depth".format(body.name, material))
            for tool, (deflections, forces) in found.items():
                case = cases.CASES["{}-{}-{}".format(body.name, tool.name, material)]
                print("  %-10s" % tool.name, " ".join(
                    "%6.3f" % c for c in compliance(case, deflections, forces) * modulus))
            everyone = np.array([forces for _, forces in found.values()])
            spread = np.ptp(everyone, axis=0) / everyone.mean(axis=0)
            print("  spread    ", " ".join("%6.3f" % s for s in spread))
            deflections, forces = found[cases.FLAT]
            case = cases.CASES["{}-{}-{}".format(body.name, cases.FLAT.name, material)]
            identified = compliance(case, deflections, forces)[0]
            for tool, (deflections, forces) in found.items():
                model = [theory.series_force(tool.shape, tool.radius, modulus, identified, d)
                         for d in deflections]
                print("  series model with the flat's first C_g over %-10s" % tool.name, " ".join(
                    "%6.3f" % r for r in model / forces))


def plot(curves, path):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    bodies = [cases.BLOCK, cases.LAYER, cases.CLAMPED, cases.EDGES]
    figure, axes = pyplot.subplots(2, 2, figsize=(12, 9))
    for axis, body in zip(axes.flat, bodies):
        modulus = reduced_modulus(body)
        for colour, tool in zip(("C0", "C1", "C2"), (cases.LARGE, cases.SMALL, cases.FLAT)):
            for material, mark in (("linear", "o"), ("neohooke", "x")):
                case = cases.CASES["{}-{}-{}".format(body.name, tool.name, material)]
                if case.name in curves:
                    axis.plot(*curves[case.name], mark, color=colour, fillstyle="none",
                              label="{}, {} (computed)".format(tool.name, material))
            reach = np.linspace(0, case.largest_deflection, 40)[1:]
            flat = curves.get("{}-{}-linear".format(body.name, cases.FLAT.name))
            if body.support == "base":
                axis.plot(reach, predicted(case, reach), color=colour,
                          label=tool.name + ", exact small-strain law")
            elif flat is not None:
                c = compliance(cases.CASES["{}-{}-linear".format(body.name, cases.FLAT.name)], *flat)[0]
                axis.plot(reach, [theory.series_force(tool.shape, tool.radius, modulus, c, d) for d in reach],
                          color=colour, label=tool.name + ", series model, C_g from the flat")
        axis.set(title=body.description, xlabel="deflection, mm", ylabel="force, N")
        axis.title.set_fontsize(8)
        axis.legend(fontsize=6)
    figure.tight_layout()
    figure.savefig(path, dpi=90)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--data", type=pathlib.Path, default=DATA)
    parser.add_argument("--plot", type=pathlib.Path)
    arguments = parser.parse_args()
    curves = {name: read_curve(arguments.data / (name + ".csv")) for name in cases.CASES
              if (arguments.data / (name + ".csv")).exists()}
    local_bodies(curves)
    linear_against_finite_strain(curves)
    plates(curves)
    if arguments.plot:
        plot(curves, arguments.plot)


if __name__ == "__main__":
    main()
