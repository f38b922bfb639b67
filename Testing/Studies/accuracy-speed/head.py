# SPDX-License-Identifier: BSD-3-Clause
"""Writes the head of a scan to files for palpateAccuracySpeed: skin, and thickness of the soft tissue over the bone.

The format is that of readStudyBody (StudyBody.h). Lengths are in mm.
"""
import pathlib

SCAN = pathlib.Path("/usr/share/mricron/templates/ch2.nii.gz")  # Debian's mricron-data: Colin 27


def write_body(file, points, inverse_thickness, triangles):
    """Writes a body: points n × 3, inverse_thickness n (1/mm; 0: no bone below the point), triangles m × 3."""
    import numpy as np
    with open(file, "wb") as stream:
        stream.write("palpate-study {} {}\n".format(len(points), len(triangles)).encode())
        for array, kind in ((points, "=f8"), (inverse_thickness, "=f8"), (triangles, "=i4")):
            stream.write(np.ascontiguousarray(array, kind).tobytes())


def write_head(file, resolution):
    """Writes the skin with triangles of about `resolution` mm; 0: the resolution of the scan, 1 mm."""
    import numpy as np
    from palpate import vtkLayerThickness, vtkSkinSurface
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkNIFTIImageReader
    reader, skin, layer = vtkNIFTIImageReader(), vtkSkinSurface(), vtkLayerThickness()
    reader.SetFileName(str(SCAN))
    skin.SetInputConnection(reader.GetOutputPort())
    skin.SetResolution(resolution)
    layer.SetInputConnection(0, skin.GetOutputPort())
    layer.SetInputConnection(1, reader.GetOutputPort())
    layer.Update()
    body = layer.GetOutput()
    thickness = vtk_to_numpy(body.GetPointData().GetArray("LayerThickness")).astype(float)
    inverse = np.divide(1.0, thickness, out=np.zeros_like(thickness), where=thickness > 0)
    write_body(file, vtk_to_numpy(body.GetPoints().GetData()), inverse,
               vtk_to_numpy(body.GetPolys().GetConnectivityArray()).reshape(-1, 3))


def prepare(folder, resolutions):
    """Writes the files and returns them from fine to coarse, with "". If the scan or the package palpate is missing, returns
    no files and the reason."""
    if not SCAN.exists():
        return [], "{} is missing (Debian's mricron-data)".format(SCAN)
    try:
        import palpate  # noqa: F401
    except ImportError as error:
        return [], "the package palpate is not on the path ({})".format(error)
    files = []
    for resolution in resolutions:
        file = folder / "head-{:g}mm.body".format(resolution or 1)
        write_head(file, resolution)
        files.append(file)
    return files, ""
