# SPDX-License-Identifier: BSD-3-Clause
"""Writes tables and pictures of the study. Without matplotlib there are no pictures."""
import csv

import numpy as np

try:
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
except ImportError:
    pyplot = None


def write_table(path, columns):
    """Writes a dictionary of columns as CSV: text, or numbers with seven digits; an empty field for NaN."""
    def text(value):
        if isinstance(value, str):
            return value
        return "" if np.isnan(value) else "%.7g" % value
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows([text(value) for value in row] for row in zip(*columns.values()))


def read_table(path):
    """Returns the columns of a CSV file, as numbers if all values of the column are numbers."""
    with open(path, encoding="utf-8") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))

    def column(values):
        try:
            return np.array([float(value) if value else np.nan for value in values])
        except ValueError:
            return np.array(values)
    return {name: column([row[i] for row in rows[1:]]) for i, name in enumerate(rows[0])}


def picture(columns, width=11.0, rows=1):
    """Returns a figure and its panels, row by row, or (None, None) without matplotlib."""
    if pyplot is None:
        return None, None
    pyplot.rcParams.update({"font.size": 9, "axes.grid": True, "grid.alpha": 0.3, "axes.axisbelow": True,
                            "legend.fontsize": 8, "axes.titlesize": 10, "lines.linewidth": 1.6})
    figure, panels = pyplot.subplots(rows, columns, figsize=(width, 3.9 * rows))
    return figure, panels.ravel()


def save(figure, path):
    # The file has no date and no version, so that equal numbers result in an identical file.
    figure.tight_layout()
    figure.savefig(path, dpi=80, metadata={"Software": None}, pil_kwargs={"optimize": True})
    pyplot.close(figure)
