# SPDX-License-Identifier: BSD-3-Clause
"""A forehead of skin, skull and brain from a scan, as finite elements; prints a sphere's force, also for simpler laws.

    ./run python Plugin/Python/examples/head_of_tissues.py      (the scan is Debian's mricron-data: Colin 27, 1 mm)
"""
import numpy
import palpate
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

SCANS = "/usr/share/mricron/templates/"
BONE = 35                                                   # grey value below which a voxel is bone or air
TISSUES = ((1, 0.035, 0.49), (2, 50, 0.3), (3, 0.003, 0.49)) # label, MPa, Poisson's ratio: skin, skull, brain
TOOL, DEPTH = "sphere:6.35", 0.8                            # mm
X, Z, HALF, BEHIND = 95, 125, 22, 34                        # mm: centre of the forehead, size of the piece


def voxels(name):
    """Returns grey values with the indices z, y and x, 1 mm apart; y points to the nose."""
    reader = vtk.vtkNIFTIImageReader()
    reader.SetFileName(SCANS + name)
    reader.Update()
    image = reader.GetOutput()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1]).astype(float)


def image(values):
    made = vtk.vtkImageData()
    made.SetDimensions(values.shape[::-1])
    made.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=True))
    return made


grey, brain = voxels("ch2.nii.gz"), voxels("ch2bet.nii.gz") > 0
inside = numpy.maximum.accumulate((grey >= BONE)[:, ::-1], axis=1)[:, ::-1] # behind the first bright voxel
front = int(numpy.where(inside[Z, :, X])[0].max())
piece = numpy.zeros_like(grey)
cut = (slice(Z - HALF, Z + HALF), slice(front - BEHIND, None), slice(X - HALF, X + HALF))
piece[cut] = inside[cut]
blurred, surface = vtk.vtkImageGaussianSmooth(), vtk.vtkFlyingEdges3D()
blurred.SetInputData(image(piece))
blurred.SetStandardDeviations(1, 1, 1)                      # one voxel: removes the steps of the voxels
surface.SetInputConnection(blurred.GetOutputPort())
surface.SetValue(0, 0.5)
whole, smooth = vtk.vtkPolyDataConnectivityFilter(), vtk.vtkWindowedSincPolyDataFilter()
whole.SetInputConnection(surface.GetOutputPort())
whole.SetExtractionModeToLargestRegion()
smooth.SetInputConnection(whole.GetOutputPort())
smooth.SetPassBand(0.05)
smooth.Update()
points = vtk_to_numpy(smooth.GetOutput().GetPoints().GetData())
here = points[numpy.hypot(points[:, 0] - X, points[:, 2] - Z) < 1.5]
here = here[here[:, 1].argmax()].astype(float)              # on the skin

solid = palpate.vtkGradedBody()                             # held at the cut faces
solid.SetInputConnection(smooth.GetOutputPort())
solid.SetSurfaceSpacing(4)
solid.AddFineBall(*here, 8, 1.5)                            # fine at the contact
solid.SetFixedFaces("x-:2,x+:2,y-:2,z-:2,z+:2")
tissues = palpate.vtkScannedMaterial()                      # each cell has the material of the image at its position
tissues.SetInputConnection(solid.GetOutputPort())
tissues.SetImageData(image(numpy.where(brain, 3.0, numpy.where(inside & (grey < BONE), 2.0, 1.0))))
for tissue in TISSUES:
    tissues.AddMaterial(*tissue)
tool = palpate.vtkContactTool()
tool.SetSpecification(TOOL)
felt = palpate.vtkElasticContactResponse()
felt.SetInputConnection(tissues.GetOutputPort())
for index, name in enumerate(("YoungsModulus", "PoissonRatio")):
    felt.SetInputArrayToProcess(index, 0, 0, 1, name)
felt.SetTool(tool)
felt.SetMaximumDeflection(DEPTH)
felt.SetSourceSpacing(3)
felt.AddObserver("WarningEvent", lambda *_: None)           # points that are held have no response
felt.Update()
thickness = float((grey[Z, front - 20:front + 1, X][::-1] < BONE)[2:].argmax() + 2) # mm, to the first dark voxel
body = felt.GetOutput()
laws = [palpate.response(body, TOOL, *TISSUES[0][1:], layer=h, maximum_deflection=DEPTH) for h in (thickness, None)]
forces = [palpate.curves(each, body.FindPoint(here), deflection=DEPTH).force[0] for each in (body, *laws)]
print("%.1f mm of skin; true tissues %.4f N, a layer as thick %.4f N, skin alone %.4f N" % (thickness, *forces))
