# SPDX-License-Identifier: BSD-3-Clause
"""Theory of a sampled spring on a mass. SI units; only numpy, without Palpate.

The mass m (kg) with damping b (N s/m), in a hand that is a spring and a damper, obeys
m v' = F - (b + b_h) v - k_h x; the force F = -K x_k is held for a period T and acts `delay` periods late.

exact_limit     largest stable K: the spectral radius of the matrix from tick to tick is one
closed_limit    the same limit without hand and delay: b (1-e)/[(m/b)(1-e) - eT], e = exp(-bT/m)
relaxing_limit  the same limit for a spring that relaxes, F = -K (x + Σ h_i), h_i ← e_i h_i + c_i Δx, e_i = exp(-T/τ_i),
                c_i = p_i (1 - e_i) τ_i/T: exact if the speed of the tip is constant in a tick
passive_relaxing 2b/T over 1 + Σ p_i tanh(x_i)/x_i, x_i = T/2τ_i: the instantaneous stiffness counts
pair_limit      for two flat ends on a half-space, r apart: K (1 -+ K C) for the opposite and the common motion, K C = 2a/(π r)
passive_limit   2b/T: no motion of a hand can extract energy (Colgate and Schenkel 1997)
delay_bound     b/(T/2 + t_d): limit of a continuous loop with the delay of hold and transport; approximate
encoder_bound   min(2b/T, 2 f_c/Δ): rounding to Δ is held by friction f_c (Diolaiti et al. 2006)
leaked          F_max v (T + 2 t_d): energy that a press and release at speed v extracts
"""
import functools
import math

import numpy as np

MASS = 0.1              # kg, mass of the simulated device
STRONGEST_PUSH = 10.0   # N, as in part b


def exponential(matrix):
    """Returns the exponential of a matrix, by halving and Taylor's series."""
    halvings = max(0, int(math.ceil(math.log2(max(1e-300, np.abs(matrix).sum(1).max())))) + 4)
    term = total = np.eye(len(matrix))
    for i in range(1, 18):
        term = term @ matrix / (i * 2.0 ** halvings)
        total = total + term
    for _ in range(halvings):
        total = total @ total
    return total


def held(mass, damping, stiffness, time):
    """Returns (A, B), where the state (x, v) after `time` is A state + B F."""
    system = np.array([[0, 1, 0], [-stiffness / mass, -damping / mass, 1 / mass], [0, 0, 0]]) * time
    moved = exponential(system)
    return moved[:2, :2], moved[:2, 2]


def tick_matrix(spring, mass, damping, period, delay, hand_stiffness, hand_damping):
    """Returns the matrix from the state (x, v, delayed forces, the oldest first) to the state a tick later."""
    whole = int(math.floor(delay + 1e-9))
    part = max(0.0, delay - whole)
    late = whole + (1 if part > 1e-9 else 0)
    total = damping + hand_damping
    first, first_push = held(mass, total, hand_stiffness, part * period)
    second, second_push = held(mass, total, hand_stiffness, (1 - part) * period)
    pushes = [second @ first_push, second_push]      # effect of the old force, and of the new one after its arrival
    matrix = np.zeros((2 + late, 2 + late))
    matrix[:2, :2] = second @ first
    now = np.zeros(2 + late)                         # the force of this tick, -K x
    now[0] = -spring
    sent = [np.eye(2 + late)[2 + i] for i in range(late)] + [now]
    if part > 1e-9:
        matrix[:2] += np.outer(pushes[0], sent[0]) + np.outer(pushes[1], sent[1])
    else:
        matrix[:2] += np.outer(pushes[1], sent[0])
    for i in range(late):
        matrix[2 + i] = sent[i + 1]
    return matrix


@functools.lru_cache(None)
def exact_limit(mass, damping, period, delay=0.0, hand_stiffness=0.0, hand_damping=0.0):
    low, high = 0.0, 40 * (damping + hand_damping) / period
    for _ in range(60):
        middle = 0.5 * (low + high)
        matrix = tick_matrix(middle, mass, damping, period, delay, hand_stiffness, hand_damping)
        if np.abs(np.linalg.eigvals(matrix)).max() < 1:
            low = middle
        else:
            high = middle
    return low


def branches_of(material):
    """Returns [(p, τ)] of a material such as "1:0.1 0.5:2"; [] for "elastic"."""
    return [] if material == "elastic" else [tuple(map(float, each.split(":"))) for each in material.split()]


def relaxing_matrix(spring, branches, mass, damping, period, delay):
    """As tick_matrix, without a hand, for the state (x, v, decayed h_i, delayed forces)."""
    kept = [math.exp(-period / tau) for _, tau in branches]
    added = [spring * p * (1 - e) * tau / period for (p, tau), e in zip(branches, kept)]
    whole, n = int(round(delay)), len(branches)
    moved, push = held(mass, damping, 0.0, period)
    matrix = np.zeros((2 + n + whole, 2 + n + whole))
    matrix[:2, :2] = moved
    now = np.zeros(2 + n + whole)
    now[0] = -spring - sum(added)
    now[2:2 + n] = -1
    for i in range(n):                               # h_i = (decayed value) + c_i x; later e_i h_i - c_i x
        matrix[2 + i, 2 + i] = kept[i]
        matrix[2 + i, 0] = (kept[i] - 1) * added[i]
    sent = [np.eye(2 + n + whole)[2 + n + i] for i in range(whole)] + [now]
    matrix[:2] += np.outer(push, sent[0])
    for i in range(whole):
        matrix[2 + n + i] = sent[i + 1]
    return matrix


@functools.lru_cache(None)
def relaxing_limit(material, mass, damping, period, delay=0.0):
    low, high = 0.0, 400 * damping / period
    for _ in range(60):
        middle = 0.5 * (low + high)
        matrix = relaxing_matrix(middle, branches_of(material), mass, damping, period, delay)
        low, high = (middle, high) if np.abs(np.linalg.eigvals(matrix)).max() < 1 else (low, middle)
    return low


def passive_relaxing(material, damping, period):
    x = [(p, period / (2 * tau)) for p, tau in branches_of(material)]
    return passive_limit(damping, period) / (1 + sum(p * math.tanh(each) / each for p, each in x))


def closed_limit(mass, damping, period):
    e = math.exp(-damping * period / mass)
    return damping * (1 - e) / (mass / damping * (1 - e) - e * period)


def passive_limit(damping, period):
    return 2 * damping / period


def delay_bound(damping, period, delay):
    return damping / (period * (0.5 + delay))


def encoder_bound(damping, period, step, friction):
    return min(passive_limit(damping, period), 2 * friction / step)


def leaked(force, speed, period, delay):
    return force * speed * period * (1 + 2 * delay)


def force_at_stiffness(tool, stiffness, modulus):
    """Returns the force (N) at which dF/dδ = 2 E* a equals K (N/m), with E* in MPa; inf: at no force; 0: from first contact
    on; None: no closed form."""
    name, _, size = tool.partition(":")
    if name not in ("paraboloid", "sphere", "cone", "flat"):
        return None
    size = float(size)
    a = 1e-3 * stiffness / (2 * modulus)  # mm
    if name == "paraboloid":
        return 4 / 3 * modulus * a ** 3 / size
    if name == "cone":
        return 0.5 * math.pi * modulus * a * a / math.tan(math.radians(size))
    if a >= size:
        return math.inf
    if name == "flat":
        return 0.0
    return modulus * (0.5 * (a * a + size * size) * math.log((size + a) / (size - a)) - a * size)


def modulus_at(tool, stiffness, force):
    """Returns E* (MPa) of the half-space on which the stiffness under the tool at this force (N) is K (N/m)."""
    if tool.startswith("flat"):
        return 1e-3 * stiffness / (2 * float(tool.partition(":")[2]))
    low, high = 1e-6, 1e6
    for _ in range(100):
        middle = math.sqrt(low * high)
        # On a stiffer body the stiffness K is reached at a smaller force.
        low, high = (middle, high) if force_at_stiffness(tool, stiffness, middle) > force else (low, middle)
    return low


def pair_limit(alone, apart_radii, motion):
    """Returns the limit of K for two flat ends. C times the force on one end lowers the other end, so that the stiffness is
    K/(1 - K C) for opposite motion and K/(1 + K C) for common motion."""
    share = 2 / (math.pi * apart_radii)
    return alone * (1 - share if motion == "opposite" else 1 + share)
