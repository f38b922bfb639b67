#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares pictures with baselines, as Testing/Cxx/Interaction/Picture.h does.

    compare_pictures.py FOLDER BASELINES PREFIX PICTURE [PICTURE ...]
    compare_pictures.py --self-test FOLDER PICTURE [PICTURE ...]

Picture FOLDER/overview.png is compared with BASELINES/PREFIXoverview.png; difference images go to
FOLDER/difference/. How a baseline is accepted: Testing/Baseline/README.md.

--self-test adds a small fault to a corner of each picture and checks that it is detected: a missing letter, a shift
by three pixels (a shift by one pixel must pass), colours a tenth darker.

Exit code: 0 all pictures match, 1 some do not, 77 the scene was not run (see run_scene.py).
"""
import sys
from pathlib import Path

from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

import numpy

FORGIVEN_LEVELS = 10  # per pixel, red + green + blue; Picture.h states the reasons for both numbers
THRESHOLD = 5.0  # number of pixels with the largest possible difference
# Rows from the bottom, columns; a part is faster to compare than the whole picture.
CORNER = (slice(0, 300), slice(0, 400))
SKIPPED = 77


def read(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def pixels(picture):
    """Rows from the bottom, columns, channels."""
    width, height, _ = picture.GetDimensions()
    return vtk_to_numpy(picture.GetPointData().GetScalars()).reshape(height, width, -1)


def difference(one, other, path=None):
    """The difference in the unit of THRESHOLD; infinite for pictures of different size."""
    if one.GetDimensions() != other.GetDimensions():
        return float("inf")
    if numpy.array_equal(pixels(one), pixels(other)):
        return 0.0  # the usual case, which needs no image filter
    compare = vtkImageDifference()
    compare.SetThreshold(FORGIVEN_LEVELS)
    compare.SetInputData(one)
    compare.SetImageData(other)
    compare.Update()
    if path:
        writer = vtkPNGWriter()
        writer.SetInputData(compare.GetOutput())
        writer.SetFileName(str(path))
        writer.Write()
    return compare.GetThresholdedError()


def compare_with_baseline(picture, baseline, image):
    """Compares the picture with X.png, or with X_1.png if it exists. Prints and returns whether they match."""
    if not baseline.exists():
        print(f"{picture}: there is no baseline {baseline}")
        return False
    found = difference(read(baseline), read(picture), image)
    other = baseline.with_stem(baseline.stem + "_1")
    if found > THRESHOLD and other.exists():
        found, baseline = difference(read(other), read(picture), image), other
    verdict = "alike" if found <= THRESHOLD else f"DIFFERENT, see {image}"
    print(f"{picture} and {baseline}: image difference {found:.4g}, at most {THRESHOLD} passes: {verdict}")
    return found <= THRESHOLD


def as_picture(array):
    picture = vtkImageData()
    picture.SetDimensions(array.shape[1], array.shape[0], 1)
    scalars = numpy_to_vtk(array.reshape(-1, array.shape[2]), deep=1)
    picture.GetPointData().SetScalars(scalars)
    return picture


def faults(array):
    """Tuples (description, picture, whether the fault must be detected)."""
    lower = numpy.roll(array, -1, axis=0)
    yield "one pixel lower", lower, False
    yield "three pixels lower", numpy.roll(array, -3, axis=0), True
    row, column = numpy.argwhere(array.sum(axis=2) < 150)[0]  # a dark pixel, of text, line or legend
    blotted = array.copy()
    blotted[max(row - 8, 0):row + 8, max(column - 8, 0):column + 8] = 255
    yield "a letter gone", blotted, True
    yield "a tenth darker", (0.9 * array).astype(array.dtype), True


def self_test(pictures):
    good = True
    for picture in pictures:
        sound = pixels(read(picture))[CORNER]
        for what, array, noticed in faults(sound):
            found = difference(as_picture(sound), as_picture(array))
            as_it_should = (found > THRESHOLD) == noticed
            good = good and as_it_should
            print(f"{picture}: {what}: image difference {found:.4g}{'' if as_it_should else ': WRONG'}")
    return good


def main(arguments):
    if len(arguments) < 3 or (arguments[0] != "--self-test" and len(arguments) < 4):
        print(__doc__)
        return 2
    testing = arguments[0] == "--self-test"
    folder = Path(arguments[1] if testing else arguments[0])
    pictures = [folder / name for name in arguments[2 if testing else 3:]]
    if folder.is_dir() and not any(folder.iterdir()):
        print(f"skipped: {folder} is empty, the scene could not be run here")
        return SKIPPED
    if testing:
        return 0 if self_test(pictures) else 1
    baselines, prefix = Path(arguments[1]), arguments[2]
    images = folder / "difference"
    images.mkdir(exist_ok=True)
    alike = [compare_with_baseline(picture, baselines / (prefix + picture.name), images / picture.name)
             for picture in pictures]
    return 0 if all(alike) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
