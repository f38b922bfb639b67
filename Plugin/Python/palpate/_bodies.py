# SPDX-License-Identifier: BSD-3-Clause
"""The forms in which a body may be given: see as_body."""
import os

from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkAlgorithmOutput

from . import _arrays, _filters
from .palpateResponse import vtkBodySurface


def as_body(body):
    """A vtkPolyData of triangles in mm, from any of

    - a vtkPolyData, or a wrapper of one (vtkmodules.numpy_interface.dataset_adapter.PolyData);
    - another data set (a volume, blocks): its outer surface, by vtkBodySurface;
    - a vtkAlgorithm, or one of its output ports: its updated output;
    - (points, triangles): (n, 3) coordinates and (m, 3) numbers of points, counter-clockwise seen from outside;
    - the name of a file, in mm: .vtp, .stl, .ply, .obj, .vtk, .vtu or .vti.
    """
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


def shallow_copy(body):
    """Another vtkPolyData with the same arrays, to which more can be added."""
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


def _surface_of(data):
    surface = vtkBodySurface()
    surface.SetInputDataObject(data)
    return _filters.run(surface).GetOutput()


def _reader(name):
    from vtkmodules import vtkIOGeometry, vtkIOLegacy, vtkIOPLY, vtkIOXML
    readers = {".vtp": vtkIOXML.vtkXMLPolyDataReader, ".vtu": vtkIOXML.vtkXMLUnstructuredGridReader,
               ".vti": vtkIOXML.vtkXMLImageDataReader, ".vtk": vtkIOLegacy.vtkDataSetReader,
               ".stl": vtkIOGeometry.vtkSTLReader, ".obj": vtkIOGeometry.vtkOBJReader,
               ".ply": vtkIOPLY.vtkPLYReader}
    end = os.path.splitext(name)[1].lower()
    if end == ".palpate":
        raise ValueError("'%s' is for servo loops, of one tool and without the points' order; save a body as .vtp"
                         % name)
    if end not in readers:
        raise ValueError("'%s' is of unknown kind; a body may be %s" % (name, " ".join(sorted(readers))))
    return readers[end]()


def _hint(name):
    """VTK before 9.3.1 does not read its own raw data with expat since 2.6, nor with Debian's patched 2.5."""
    version = (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion())
    if version > (9, 3) or not name.lower().endswith((".vtp", ".vtu", ".vti")):
        return ""
    with open(name, "rb") as file:
        raw = b'encoding="raw"' in file.read()
    return ("; the reason may be that VTK %s and this system's expat do not agree on raw appended data: save it with "
            "the data mode Binary" % vtkVersion.GetVTKVersion()) if raw else ""


def _read(name):
    reader = _reader(name)
    with open(name, "rb"):                          # FileNotFoundError, PermissionError
        reader.SetFileName(name)
    with _filters.unprinted() as complaints:
        reader.Update()
        data = reader.GetOutputDataObject(0)
    if complaints or data is None or data.GetNumberOfPoints() == 0:
        raise RuntimeError("'%s' could not be read: %s%s" % (
            name, "".join(complaints) or "there are no points in it", _hint(name) if complaints else ""))
    return data
