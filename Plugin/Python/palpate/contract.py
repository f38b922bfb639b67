# SPDX-License-Identifier: BSD-3-Clause
"""The data contract of Palpate's response arrays, evaluated in numpy.

It works in any Python and ParaView, without the plugin. Units: mm, N, MPa. The arrays of a response share a prefix. The
samples i = 1..n are at d_i = range (i/n)^2. Between them F(d) = d^m r(s), s = sqrt(d/range), r a cubic Hermite spline;
below d_1 the force is the power F_1 (d/d_1)^q, q = K_1 d_1/F_1; beyond the range it follows the last tangent.
"""
import numpy as np


def _fetch(data, name, optional=False):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    array = data.GetArray(name)
    if array is None and not optional:
        raise KeyError("array '%s' is missing" % name)
    return None if array is None else vtk_to_numpy(array)


def load(body, prefix="Response"):
    """Reads the response arrays of a vtkPolyData, in either form of storage, as a dictionary of numpy arrays.

    Returns force and stiffness (points x n, N and N/mm), normal (points x 3), range (points, mm),
    status (points) and exponent m. Raises KeyError with the name of a missing array.
    """
    points, field, fetch = body.GetPointData(), body.GetFieldData(), lambda data, name: _fetch(data, prefix + name)
    n = int(fetch(field, "Samples")[0])
    if field.GetArray(prefix + "Basis") is not None:
        basis = fetch(field, "Basis").reshape(-1, 2 * n).astype(float)
        coefficient = fetch(points, "Coefficient").reshape(-1, len(basis)).astype(float)
        force, stiffness = np.hsplit(coefficient @ basis, 2)
    else:
        force = fetch(points, "Force").reshape(-1, n).astype(float)
        stiffness = fetch(points, "Stiffness").reshape(-1, n).astype(float)
    return {"force": force, "stiffness": stiffness, "normal": fetch(points, "Normal").astype(float),
            "range": fetch(points, "Range").astype(float), "status": fetch(points, "Status"),
            "exponent": float(fetch(field, "Exponent")[0])}


def evaluate(response, point, deflection):
    """Returns force (N) and stiffness dF/dd (N/mm) at points (integers) and deflections (mm), which are broadcast together."""
    point, d = np.broadcast_arrays(np.asarray(point), np.asarray(deflection, dtype=float))
    f, k = response["force"][point], response["stiffness"][point]
    reach, m, n = response["range"][point], response["exponent"], response["force"].shape[1]
    with np.errstate(all="ignore"):
        # Between samples, rho(s) = F / s^(2m) is interpolated; the factor range^m cancels.
        s = np.sqrt(d / reach)
        i = np.clip(np.nan_to_num(s * n, nan=1.0).astype(int), 1, n - 1)
        knots = np.arange(1, n + 1) / n
        weight = knots ** (-2.0 * m)
        rho = weight * f
        slope = 2.0 * weight * (reach[..., None] * knots * k - m * f / knots)
        left, right = (i - 1)[..., None], i[..., None]
        a, b = (np.take_along_axis(rho, j, -1)[..., 0] for j in (left, right))
        da, db = (np.take_along_axis(slope, j, -1)[..., 0] for j in (left, right))
        h, t = 1.0 / n, s * n - i
        value = ((2*t**3 - 3*t**2 + 1) * a + (t**3 - 2*t**2 + t) * h * da
                 + (3*t**2 - 2*t**3) * b + (t**3 - t**2) * h * db)
        rate = ((6*t**2 - 6*t) / h * (a - b) + (3*t**2 - 4*t + 1) * da + (3*t**2 - 2*t) * db)
        force = s ** (2 * m) * value
        stiffness = s ** (2 * m) * (2 * m * value / s + rate) / (2 * reach * s)
        # below the first sample
        first = reach / n**2
        q = np.where(f[..., 0] == 0, 0.0, k[..., 0] * first / f[..., 0])
        start = np.where(f[..., 0] == 0, 0.0, f[..., 0] * (d / first) ** q)
        force = np.where(s * n < 1, start, force)
        stiffness = np.where(s * n < 1, q * start / d, stiffness)
    force = np.where(d >= reach, f[..., -1] + k[..., -1] * (d - reach), force)
    stiffness = np.where(d >= reach, k[..., -1], stiffness)
    return np.where(d <= 0, 0.0, force), np.where(d <= 0, 0.0, stiffness)


def relaxation(body, prefix="Response"):
    """Returns the relaxation E(t) = E (1 + sum of p exp(-t/tau)) as a dictionary with "time" tau (s), "strength" p (k, or
    points x k), and the "elastic" compliance in series (points, mm/N, or None). Returns None without relaxation."""
    points, field, fetch = body.GetPointData(), body.GetFieldData(), lambda data, name: _fetch(data, prefix + name, True)
    time, strength = fetch(field, "RelaxationTime"), fetch(field, "RelaxationStrength")
    local = fetch(points, "LocalRelaxation")
    return None if time is None else {
        "time": time.ravel(), "strength": strength.ravel() if local is None else local.reshape(-1, time.size),
        "elastic": fetch(points, "ElasticCompliance")}


def coupling(body, prefix="Response"):
    """Returns a function of two point numbers: the displacement of one point per force at the other, mm/N. Returns None
    without coupling. C = (n.n)+ g(r/h) / (pi r E*) + sum of modes is for points: contact radii do not limit r."""
    points, field, fetch = body.GetPointData(), body.GetFieldData(), lambda data, name: _fetch(data, prefix + name, True)
    law, modes = fetch(field, "Coupling"), fetch(points, "CouplingModes")
    modulus, thickness = fetch(points, "CouplingModulus"), fetch(points, "CouplingThickness")
    if law is None:
        return None
    (constant, layer, _), knots = law[0], law[1:]

    def compliance(one, other):
        pair = [one, other]
        mean = lambda values, otherwise: otherwise if values is None else np.sqrt(np.prod(values[pair].astype(float)))
        normals = fetch(points, "Normal")[pair].astype(float)
        facing = max(0.0, normals[0] @ normals[1] / np.prod(np.linalg.norm(normals, axis=1)))
        r = np.linalg.norm(np.subtract(body.GetPoint(one), body.GetPoint(other)))
        share = 1.0
        if len(knots):
            x = r / mean(thickness, layer)
            k = min(int(80 * x / (1 + x)), len(knots) - 2)
            t = min(80 * x / (1 + x) - k, 1.0)
            (a, da, _), (b, db, _) = knots[k:k + 2]
            share = ((2*t**3 - 3*t**2 + 1) * a + (t**3 - 2*t**2 + t) * da / 80
                     + (3*t**2 - 2*t**3) * b + (t**3 - t**2) * db / 80)
        surface = facing * share / (np.pi * r * mean(modulus, constant)) if constant > 0 else 0.0
        moved = 0.0 if modes is None else modes.reshape(len(modes), -1)[pair].astype(float).prod(axis=0).sum()
        return surface + moved
    return compliance
