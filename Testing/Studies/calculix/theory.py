# SPDX-License-Identifier: BSD-3-Clause
"""Linear contact theory in numpy: the laws with which the finite elements are compared.

Rigid frictionless tool, force in N for depths in mm, reduced modulus E* = E / (1 - nu^2) in MPa.
Half-space: Galin; Sneddon 1965; Popov and Hess, method of dimensionality reduction. Bonded layer: the
same reduced problem with the kernel of the layer (Lebedev and Ufliand 1958), by Nystrom's method. Plate:
Levy's series for two opposite edges supported and two free (Timoshenko and Woinowsky-Krieger).
"""
import numpy as np


def one_dimensional_profile(shape, radius):
    """Returns the profile g(x) of the method of dimensionality reduction."""
    if shape == "flat":
        return lambda x: np.zeros_like(x)
    if shape == "paraboloid":
        return lambda x: x * x / radius
    return lambda x: 0.5 * x * np.log((radius + x) / (radius - x))


def bisect(function, low, high):
    """Returns the root of a rising function."""
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if function(middle) < 0 else (low, middle)
    return 0.5 * (low + high)


def half_space_contact_radius(shape, radius, deflection):
    if shape == "flat":
        return radius
    g = one_dimensional_profile(shape, radius)
    return bisect(lambda a: g(a) - deflection, 0.0, radius * (1 - 1e-12))


def half_space_force(shape, radius, reduced_modulus, deflection):
    a = half_space_contact_radius(shape, radius, deflection)
    if shape == "flat":
        return 2 * reduced_modulus * radius * deflection
    log = np.log((radius + a) / (radius - a))
    return reduced_modulus * (0.5 * (a * a + radius * radius) * log - a * radius)


def half_space_deflection(shape, radius, reduced_modulus, force):
    deepest = 3 * radius if shape == "sphere" else force / (2 * reduced_modulus * radius) + 1
    return bisect(lambda d: half_space_force(shape, radius, reduced_modulus, d) - force, 0.0, deepest)


def series_force(shape, radius, reduced_modulus, compliance, deflection):
    """Returns the force F for which deflection = half-space deflection(F) + compliance F."""
    local = bisect(lambda d: d + compliance * half_space_force(shape, radius, reduced_modulus, d) - deflection,
                   0.0, deflection)
    return half_space_force(shape, radius, reduced_modulus, local)


class BondedLayer:
    """Elastic layer of `thickness` bonded to a rigid base."""

    def __init__(self, thickness, poisson_ratio, nodes=16):
        self.thickness = thickness
        self.nodes, self.weights = np.polynomial.legendre.leggauss(nodes)
        # 1 - W falls as omega^2 exp(-2 omega), which is negligible at 25.
        x, w = np.polynomial.legendre.leggauss(100)
        self.omega = 12.5 * (x + 1)
        k, decay = 3 - 4 * poisson_ratio, np.exp(-2 * self.omega)
        self.spectrum = 12.5 * w * (
            (k * (1 - decay ** 2) - 4 * self.omega * decay) /
            (k * (1 + decay ** 2) + (4 * self.omega ** 2 + 1 + k * k) * decay) - 1)

    def kernel(self, s):
        return np.cos(np.multiply.outer(s, self.omega)) @ self.spectrum

    def _solve(self, shape, radius, a):
        """Returns the depth for contact radius a (0 for flat: any depth), i1 and ig, where F/(2 E*) = depth * i1 - ig."""
        g = one_dimensional_profile(shape, radius)
        h = self.thickness
        x, w = 0.5 * a * (self.nodes + 1), 0.5 * a * self.weights

        def row(at):
            return (self.kernel((x + at) / h) + self.kernel((x - at) / h)) * w / (np.pi * h)
        matrix = np.eye(len(x)) + np.array([row(at) for at in x])
        unit, profile = np.linalg.solve(matrix, np.column_stack([np.ones_like(x), g(x)])).T
        edge = row(a)
        depth = (g(np.array(a)) - edge @ profile) / (1 - edge @ unit)
        return depth, w @ unit, w @ profile

    def contact_radius(self, shape, radius, deflection):
        if shape == "flat":
            return radius
        widest = 2 * np.sqrt(radius * deflection) if shape == "paraboloid" else radius * (1 - 1e-9)
        return bisect(lambda a: self._solve(shape, radius, a)[0] - deflection, 1e-6 * widest, widest)

    def force(self, shape, radius, reduced_modulus, deflection):
        if shape == "flat":
            return 2 * reduced_modulus * deflection * self._solve(shape, radius, radius)[1]
        a = self.contact_radius(shape, radius, deflection)
        depth, unit, profile = self._solve(shape, radius, a)
        return 2 * reduced_modulus * (depth * unit - profile)


def thin_plate_compliance(length, width, thickness, young, poisson_ratio, terms=400):
    """Returns the deflection per force under a central point load. The edges at the ends of `length` are simply
    supported, the two others free. Kirchhoff: no shear deformation."""
    rigidity = young * thickness ** 3 / (12 * (1 - poisson_ratio ** 2))
    b, nu, total = 0.5 * width, poisson_ratio, 0.0
    for m in range(1, terms, 2):
        alpha = m * np.pi / length
        # W(y) of sin(alpha x), 0 <= y <= b, from functions that decay from the load and from the
        # free edge. The derivatives are with respect to alpha y.
        fall = np.exp(-alpha * b)

        def derivatives(t, scale):
            """Returns the rows W, W', W'', W''' of exp(-t) and t exp(-t), times `scale`."""
            return scale * np.array([[1, t], [-1, 1 - t], [1, t - 2], [-1, 3 - t]])
        signs = np.array([[1], [-1], [1], [-1]])
        at_load = np.hstack([derivatives(0, 1), signs * derivatives(alpha * b, fall)])
        at_edge = np.hstack([derivatives(alpha * b, fall), signs * derivatives(0, 1)])
        equations = np.array([at_load[1], at_load[3], at_edge[2] - nu * at_edge[0],
                              at_edge[3] - (2 - nu) * at_edge[1]])
        # Each side carries half of the mode's part 2/L of the unit load: D W''' = 1/L.
        unknowns = np.linalg.solve(equations, [0, 1 / (length * rigidity * alpha ** 3), 0, 0])
        total += at_load[0] @ unknowns
    return total
