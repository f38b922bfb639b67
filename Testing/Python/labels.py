# SPDX-License-Identifier: BSD-3-Clause
"""Images of labels for tests: arrays indexed by z, y and x, as images and as NIfTI files."""
import gzip
import struct

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData


def block(size, spacing, ball=None, margin=0):
    """A block of label 1 with a ball of label 2, within `margin` voxels of label 0.

    `ball`: x, y, depth of its top, radius; mm.
    `size`: number of voxels of the block along x, y and z. Without a margin the first voxel has its centre at the
    origin, and the block extends beyond it by half a voxel.
    """
    z, y, x = (spacing * each for each in np.meshgrid(*map(np.arange, size[::-1]), indexing="ij"))
    labels = np.ones(size[::-1], np.int16)
    if ball is not None:
        middle_x, middle_y, depth, radius = ball
        middle_z = top(size, spacing) - depth - radius
        labels[(x - middle_x) ** 2 + (y - middle_y) ** 2 + (z - middle_z) ** 2 < radius ** 2] = 2
    return np.pad(labels, margin)


def top(size, spacing):
    """Height of the upper face of a block without a margin, mm."""
    return (size[2] - 0.5) * spacing


def image(labels, spacing, origin=(0.0, 0.0, 0.0)):
    made = vtkImageData()
    made.SetDimensions(labels.shape[::-1])
    made.SetSpacing(*np.broadcast_to(spacing, 3).tolist())
    made.SetOrigin(*origin)
    made.GetPointData().SetScalars(numpy_to_vtk(labels.ravel(), deep=True))
    return made


def write_nifti(path, labels, affine):
    """NIfTI-1 of 16-bit labels. `affine`: 3 x 4 matrix from the indices of a voxel along x, y and z to mm."""
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, *labels.shape[::-1], 1, 1, 1, 1)
    struct.pack_into("<2h", header, 70, 4, 16)                       # int16
    affine = np.asarray(affine, float)
    struct.pack_into("<8f", header, 76, 1.0, *np.linalg.norm(affine[:, :3], axis=0), 0, 0, 0, 0)
    struct.pack_into("<3f", header, 108, 352.0, 1.0, 0.0)            # offset of the data; slope, intercept
    header[123] = 2                                                  # mm
    struct.pack_into("<2h", header, 252, 0, 1)                       # the sform is used
    for row in range(3):
        struct.pack_into("<4f", header, 280 + 16 * row, *affine[row])
    header[344:348] = b"n+1\0"
    data = bytes(header) + labels.astype("<i2").tobytes()
    path.write_bytes(gzip.compress(data) if path.name.endswith(".gz") else data)
