# SPDX-License-Identifier: BSD-3-Clause
"""Converts the forms in which a body may be given; as_body lists them."""
import os
import warnings

from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkAlgorithmOutput

from . import _arrays, _filters
from .palpateResponse import vtkBodyFileReader, vtkBodySurface


def as_body(body):
    """Returns a vtkPolyData of triangles in mm, with at least one triangle. The body may be

    - a vtkPolyData, or a wrapper of one (vtkmodules.numpy_interface.dataset_adapter.PolyData);
    - another data set (a volume, blocks) except an image, whose outer surface vtkBodySurface makes;
    - a vtkAlgorithm, or one of its output ports, whose updated output is used;
    - (points, triangles), with (n, 3) coordinates and (m, 3) point indices, counter-clockwise seen from outside;
    - the name of a file with coordinates in mm (.vtp, .stl, .ply, .obj, .vtk or .vtu), read by vtkBodyFileReader.
    """
    made = _any_body(body)
    if made.GetNumberOfPoints() == 0:
        raise ValueError("the body is empty: it has no points")
    if made.GetNumberOfPolys() + made.GetNumberOfStrips() == 0:
        raise ValueError("the body has no triangles, only %d points" % made.GetNumberOfPoints())
    return made


def _any_body(body):
    if isinstance(body, (str, os.PathLike)):
        return _surface_of(_read(os.fspath(body)))
    if isinstance(body, (vtkAlgorithm, vtkAlgorithmOutput)):
        body = _filters.output_of(body)
    body = getattr(body, "VTKObject", body)
    if isinstance(body, vtkPolyData):
        return body
    if isinstance(body, vtkDataObject):
        return _surface_of(body)
    if isinstance(body, (tuple, list)) and len(body) == 2:
        return _from_arrays(*body)
    raise TypeError("body must be a vtkPolyData, another data set, a vtkAlgorithm, (points, triangles) or the name "
                    "of a file, but is a %s" % type(body).__name__)


def as_labels(body):
    """Returns a vtkImageData of labels in mm. The labels may be an image, a vtkAlgorithm or its output port, or the name of
    a file .nii, .nii.gz, .vti or .vtk."""
    if isinstance(body, (str, os.PathLike)):
        body = _read(os.fspath(body))
    elif isinstance(body, (vtkAlgorithm, vtkAlgorithmOutput)):
        body = _filters.output_of(body)
    body = getattr(body, "VTKObject", body)
    if not isinstance(body, vtkImageData):
        raise TypeError("with tissues the body must be an image of labels (vtkImageData, or a .nii, .nii.gz or .vti file), "
                        "but is a %s" % type(body).__name__)
    if body.GetNumberOfPoints() == 0:
        raise ValueError("the image of labels is empty: it has no voxels")
    return body


def shallow_copy(body):
    """Returns another vtkPolyData with the same arrays, to which more arrays can be added."""
    copy = vtkPolyData()
    copy.ShallowCopy(body)
    return copy


def _from_arrays(points, triangles):
    points = _arrays.reals(points, "points", (None, 3))
    triangles = _arrays.indices(triangles, "triangles", 3)
    made = vtkPolyData()
    made.SetPoints(_arrays.to_points(points))
    made.SetPolys(_arrays.to_cells(triangles, 3))
    return made


def warn_about_size(body):
    """Warns about a doubtful size, as the viewer does. For example, 0.3 mm are probably 0.3 m, given in metres."""
    bounds = body.GetBounds()
    longest = max(bounds[i + 1] - bounds[i] for i in (0, 2, 4))
    if vtkBodySurface.IsSizeDoubtful(longest):
        warnings.warn("the longest side of the body is %.3g mm: are its coordinates in mm? Multiply those in metres by "
                      "1000" % longest, RuntimeWarning, stacklevel=3)


def _surface_of(data):
    if isinstance(data, vtkImageData):
        raise ValueError("an image is not a body; give tissues={label: (young, poisson)} if its values are labels, or "
                         "make a surface of it first: the skin of a scan by "
                         "palpate.vtkSkinSurface (its ContourValue is the grey level of the skin), its box by "
                         "palpate.vtkBodySurface")
    surface = vtkBodySurface()
    surface.AskAboutSizeOff()                       # warn_about_size warns about the size
    surface.SetInputDataObject(data)
    return _filters.run(surface).GetOutput()


def _read(name):
    extensions = vtkBodyFileReader.GetFileExtensions().split()
    if name.lower().endswith(".palpate"):
        raise ValueError("'%s' is for servo loops, of one tool and without the points' order; save a body as .vtp"
                         % name)
    if not name.lower().endswith(tuple(extensions)):
        raise ValueError("'%s' is of unknown kind; a body may be %s" % (name, " ".join(sorted(extensions))))
    reader = vtkBodyFileReader()
    with open(name, "rb"):                          # raises FileNotFoundError or PermissionError
        reader.SetFileName(name)
    return _filters.run(reader, RuntimeError).GetOutput()
