# SPDX-License-Identifier: BSD-3-Clause
"""Reads the rows of palpateAccuracySpeed; computes rows for all tools together, Pareto fronts and orders of convergence."""
import csv
import math

REFERENCE = "reference"
ALL = "all"               # all tools together
ROUNDING = 1e-6           # smaller errors are rounding of float32 and count as equal
TEXTS = ("part", "scene", "tool", "method")
POOLED_SQUARES = ("error", "error_sites", "error_path", "error_calculix")
POOLED_MEANS = ("bytes_per_vertex", "model_bytes_per_vertex", "noticed", "vertices", "edge_mm")
POOLED_MEDIANS = ("hot_ns", "onset_ns", "cold_ns")


def read(text, texts=TEXTS):
    """Reads CSV rows. Values are numbers, or None for an empty field, except in the columns `texts`."""
    rows = list(csv.DictReader(text.splitlines()))
    for row in rows:
        for name, value in row.items():
            if name not in texts:
                row[name] = float(value) if value else None
    return rows


def select(rows, **wanted):
    return [row for row in rows if all(row[name] == value for name, value in wanted.items())]


def distinct(rows, name):
    return list(dict.fromkeys(row[name] for row in rows))


def median(values):
    ordered = sorted(values)
    middle = len(ordered) // 2
    return ordered[middle] if len(ordered) % 2 else 0.5 * (ordered[middle - 1] + ordered[middle])


def pool(rows):
    """Returns a row for all tools together for each scene and method: root mean squares of errors, medians of times."""
    pooled = []
    for scene in distinct(rows, "scene"):
        for method in distinct(select(rows, scene=scene), "method"):
            mine = select(rows, scene=scene, method=method)
            row = dict(mine[0], tool=ALL)
            for names, join in ((POOLED_SQUARES, lambda v: math.sqrt(sum(x * x for x in v) / len(v))),
                                (POOLED_MEANS, lambda v: sum(v) / len(v)), (POOLED_MEDIANS, median),
                                (("tips", "unanswered"), sum)):
                for name in names:
                    values = [each[name] for each in mine if each[name] is not None]
                    row[name] = join(values) if values else None
            pooled.append(row)
    return pooled


def front(rows):
    """Returns the Pareto front of hot time and error: each method for which no other method is better in one of the two and
    at least as good in the other. Errors below ROUNDING are equal; of equal methods the one with fewer bytes is chosen."""
    def key(row):
        return row["hot_ns"], max(row["error"], ROUNDING), row["model_bytes_per_vertex"]
    judged = [row for row in rows if row["method"] != REFERENCE and row["hot_ns"] and row["error"] is not None]
    best = []
    least = math.inf
    for row in sorted(judged, key=key):
        error = max(row["error"], ROUNDING)
        if error < least:
            best.append(row)
            least = error
    return best


def mark_fronts(rows):
    """Sets the column `pareto` to 1 for rows on the front of their scene and tool, otherwise to 0."""
    for row in rows:
        row["pareto"] = 0
    for scene in distinct(rows, "scene"):
        for tool in distinct(rows, "tool"):
            for row in front(select(rows, scene=scene, tool=tool)):
                row["pareto"] = 1


def order(points):
    """Returns the slope of log error over log size, by least squares. None if fewer than three sizes have an error above
    ROUNDING."""
    usable = [(math.log(p["size"]), math.log(p["error"])) for p in points if p["error"] and p["error"] > ROUNDING]
    if len(usable) < 3:
        return None
    x, y = (sum(values) / len(usable) for values in zip(*usable))
    return sum((a - x) * (b - y) for a, b in usable) / sum((a - x) ** 2 for a, _ in usable)


def mark_orders(rows):
    for row in rows:
        row["order"] = order(select(rows, part=row["part"], scene=row["scene"], method=row["method"]))
