# SPDX-License-Identifier: BSD-3-Clause
"""Makes small bodies and scans, and their files in the formats that the viewer reads."""
import struct

from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLWriter
from vtkmodules.vtkIOImage import vtkNIFTIImageWriter
from vtkmodules.vtkIOLegacy import vtkDataSetWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataWriter, vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter)

import numpy


def sphere(radius=25.0):
    """A closed sphere with outward triangles. Vertices are about 1 mm apart at the pole +z, where sessions press by
    default."""
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetThetaResolution(64)
    source.SetPhiResolution(64)
    source.Update()
    return source.GetOutput()


def cube(side=40.0):
    """Of twelve triangles, about the origin."""
    source = vtkCubeSource()
    for set_length in (source.SetXLength, source.SetYLength, source.SetZLength):
        set_length(side)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    triangles.Update()
    return triangles.GetOutput()


def image(values, spacing=(1.0, 1.0, 1.0)):
    """Makes an image from an array indexed [x, y, z]."""
    data = vtkImageData()
    data.SetDimensions(values.shape)
    data.SetSpacing(spacing)
    array = numpy_to_vtk(values.ravel(order="F").astype(numpy.float32), deep=1)
    array.SetName("Grey")
    data.GetPointData().SetScalars(array)
    return data


def distances(size, centre):
    """Distance of every voxel from a point, mm, in a cube of `size` voxels of 1 mm."""
    x, y, z = numpy.ogrid[:size, :size, :size]
    return numpy.sqrt((x - centre[0]) ** 2 + (y - centre[1]) ** 2 + (z - centre[2]) ** 2)


def ball_grey(size=48, radius=16.3, centre=None):
    """Grey levels of a ball: 100 inside, 0 outside, a ramp of 2 mm, 50 at the radius."""
    centre = centre or (0.5 * (size - 1),) * 3
    return numpy.clip(50.0 + 50.0 * (radius - distances(size, centre)), 0.0, 100.0)


def block(points=(21, 21, 11)):
    """Tetrahedra that fill a block, by default of 30 x 30 x 20 mm."""
    cut = vtkDataSetTriangleFilter()
    cut.SetInputData(image(numpy.zeros(points), (1.5, 1.5, 2.0)))
    cut.Update()
    return cut.GetOutput()


NIFTI_KINDS = {1: numpy.uint8, 2: numpy.uint8, 4: numpy.int16, 8: numpy.int32, 16: numpy.float32, 64: numpy.float64}


def nifti(values, kind=16, sform=None, qform=None, qfac=1.0, sides=(1.0, 1.0, 1.0), scale=(1.0, 0.0), unit=2,
          dim=None, order="<"):
    """The bytes of a NIfTI-1 file, as the format defines them. `qform`: b, c, d and the offset."""
    head = bytearray(352)
    struct.pack_into(order + "i", head, 0, 348)
    struct.pack_into(order + "8h", head, 40, *(dim or (3, *values.shape, 1, 1, 1, 1)))
    struct.pack_into(order + "2h", head, 70, kind, 8 * numpy.dtype(NIFTI_KINDS[kind]).itemsize)
    struct.pack_into(order + "8f", head, 76, qfac, *sides, 1, 1, 1, 1)
    struct.pack_into(order + "3f", head, 108, 352, *scale)
    head[123] = unit
    struct.pack_into(order + "2h", head, 252, qform is not None, sform is not None)
    struct.pack_into(order + "6f", head, 256, *(qform or (0,) * 6))
    struct.pack_into(order + "12f", head, 280, *(numpy.zeros(12) if sform is None else numpy.ravel(sform)))
    head[344:348] = b"n+1\0"
    return bytes(head) + values.ravel(order="F").astype(numpy.dtype(NIFTI_KINDS[kind]).newbyteorder(order)).tobytes()


def lump():
    """Grey levels of a body of three overlapping balls, which looks different from each side."""
    grey = numpy.zeros((34, 30, 26))
    x, y, z = numpy.ogrid[:34, :30, :26]
    for centre, radius in (((14, 14, 12), 8.2), ((22, 14, 12), 5.1), ((14, 20, 15), 4.3)):
        away = numpy.sqrt((x - centre[0]) ** 2 + (y - centre[1]) ** 2 + (z - centre[2]) ** 2)
        grey = numpy.maximum(grey, numpy.clip(50 + 50 * (radius - away), 0, 100))
    return grey


WRITERS = {
    ".stl": vtkSTLWriter, ".ply": vtkPLYWriter, ".obj": vtkOBJWriter, ".vtk": vtkDataSetWriter,
    ".vtp": vtkXMLPolyDataWriter, ".vtu": vtkXMLUnstructuredGridWriter,
    ".vti": vtkXMLImageDataWriter, ".nii.gz": vtkNIFTIImageWriter,
}


def write(data, path, **settings):
    """Writes `data` in the format of the file name. Settings: DataMode=..., FileType=..."""
    extension = ".nii.gz" if path.name.endswith(".nii.gz") else path.suffix.lower()
    writer = WRITERS[extension]()
    writer.SetFileName(str(path))
    for name, value in settings.items():
        getattr(writer, f"Set{name}")(value)
    writer.SetInputData(data)
    writer.Write()  # the result is ignored, because its meaning depends on the writer
    if writer.GetErrorCode() != 0 or path.stat().st_size == 0:
        raise OSError(f"cannot write {path}")
    return path
