# SPDX-License-Identifier: BSD-3-Clause
"""The filters that the menus offer, and the messages for wrong input."""
import palpate  # noqa: F401 - gives the client-side objects their class
from paraview import servermanager, simple

from complaint import check_complaint as check, complaint


def accepts(filter_name, source, key="Input"):
    """Whether the menu would offer the filter for this source."""
    source.UpdatePipeline()
    item = servermanager.ProxyManager().NewProxy("filters", filter_name).GetProperty(key)
    item.SetUncheckedInputConnection(0, source.SMProxy, 0)
    return bool(item.IsInDomains())


ball = simple.Sphere(Radius=50)
image = simple.Wavelet()
blocks = simple.GroupDatasets(Input=[ball, simple.Sphere(Radius=20, Center=(100, 0, 0))])
bare = simple.Line()
cells = simple.UnstructuredCellTypes()
response = simple.ToolContactResponse(Input=ball, WholeBody=0)
table = simple.ResponseCurves(Input=response)
for name in ("BodySurface", "ToolContactResponse", "MeasuredContactResponse", "VoxelBody"):
    assert all(accepts(name, body) for body in (ball, blocks, image, cells)), name
    assert not accepts(name, table), name
assert accepts("ContactRegime", response) and not accepts("ContactRegime", image) and not accepts("ContactRegime", blocks)
assert accepts("ElasticCompliance", cells) and not accepts("ElasticCompliance", ball)
for name in ("ToolContactProbe", "ContactDeflection"):
    assert accepts(name, response) and accepts(name, ball, "Tips")
    assert not accepts(name, image) and not accepts(name, image, "Tips") and not accepts(name, blocks)
assert accepts("SkinSurface", image) and not accepts("SkinSurface", ball)
assert accepts("LayerThickness", ball) and accepts("LayerThickness", image, "Scan")
assert not accepts("LayerThickness", image) and not accepts("LayerThickness", ball, "Scan")
assert accepts("ResponseCurves", response) and not accepts("ResponseCurves", image)

# Data without a surface: an error that names the filter to apply first.
cloud = simple.PointSource(NumberOfPoints=12)
for make in (simple.BodySurface, simple.ToolContactResponse, simple.VoxelBody, simple.MeasuredContactResponse):
    check(make(Input=cloud), "no triangles", "12 points", "Delaunay 3D")
    check(make(Input=bare), "no triangles", "lines", "Tube")
    check(make(Input=table), "vtkTable is not a body", "Table To Points")
    check(make(Input=simple.GroupDatasets(Input=[ball, table])), "block 'ResponseCurves", "vtkTable is not a body")
check(simple.ElasticCompliance(Input=ball), "vtkPolyData has no volume", "Voxel Body")
check(simple.ElasticContactResponse(Input=ball), "vtkPolyData has no volume", "Voxel Body")
hole = simple.TrivialProducer()
pierced = servermanager.Fetch(ball).NewInstance()
pierced.DeepCopy(servermanager.Fetch(ball))
pierced.GetPoints().SetPoint(7, float("nan"), 0, 0)
hole.GetClientSideObject().SetOutput(pierced)
check(simple.ToolContactResponse(Input=hole), "triangles with a coordinate that is not finite", "left out")
check(simple.ToolContactProbe(Body=ball, Tips=bare), "no response 'Response'")
check(simple.ContactDeflection(Body=response, Tips=bare), "output of Tool Contact Probe", "ContactCell")
check(simple.ResponseCurves(Input=response, PointIds=[1000000]), "Point 1000000")
response.YoungsModulusArrayMPa = ["POINTS", "Nowhere"]
check(response, "Young's Modulus Array 'Nowhere' (array to process 0)")
response.YoungsModulusArrayMPa = None
response.Tool.Radiusmm = -1
check(response, "radius", "positive", "-1")
response.Tool.Radiusmm = 5
assert complaint(response) == ""

# A value out of range: the message names the property by its label. With the previous value the
# filter works again.
flat = simple.Triangulate(Input=simple.Plane(Origin=(-20, -20, 0), Point1=(20, -20, 0), Point2=(-20, 20, 0)))
pressed = simple.ToolContactResponse(Input=flat)
WRONG = (
    (pressed, "YoungsModulus", 0), (pressed, "MaximumDeflection", 0), (pressed, "ErrorTolerance", -1),
    (pressed, "TermTolerance", -1), (pressed, "LayerThickness", -1), (pressed, "MaximumTilt", -1),
    (simple.ToolContactProbe(Body=pressed, Tips=flat), "FrictionCoefficient", -1),
    (simple.Touch(Input=pressed), "Reach", 0),
    (simple.ContactDeflection(Body=pressed, Tips=simple.ToolContactProbe(Body=pressed, Tips=flat)), "PoissonRatio", 0.7),
    (simple.ResponseChoice(Input=pressed), "Share", 0),
    (simple.ReducedContactResponse(Input=pressed), "MaximumNumberOfLaws", 17),
    (simple.VoxelBody(Input=ball), "Spacing", -1), (simple.SkinSurface(Input=image), "ClosingRadius", -1))
for proxy, name, wrong in WRONG:
    item = proxy.SMProxy.GetProperty(name)
    label = item.GetXMLLabel().split(" (")[0]
    usual = item.GetElement(0)
    item.SetElement(0, wrong)
    proxy.SMProxy.UpdateVTKObjects()
    text = complaint(proxy)
    assert label in text, (name, label, text)
    item.SetElement(0, usual)
    proxy.SMProxy.UpdateVTKObjects()
    assert "ERR" not in complaint(proxy), name
