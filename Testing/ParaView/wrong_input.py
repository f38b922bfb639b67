# SPDX-License-Identifier: BSD-3-Clause
"""What the menus offer, and what is said of wrong input."""
import os
import sys
import tempfile
import palpate  # noqa: F401 - gives the client-side objects their class
from paraview import servermanager, simple


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
response = simple.ToolContactResponse(Input=ball)
assert accepts("ToolContactResponse", ball) and accepts("ToolContactResponse", blocks)
assert not accepts("ToolContactResponse", image)
for name in ("ToolContactProbe", "ContactDeflection"):
    assert accepts(name, response) and accepts(name, ball, "Tips")
    assert not accepts(name, image) and not accepts(name, image, "Tips") and not accepts(name, blocks)
assert accepts("SkinSurface", image) and not accepts("SkinSurface", ball)
assert accepts("LayerThickness", ball) and accepts("LayerThickness", image, "Scan")
assert not accepts("LayerThickness", image) and not accepts("LayerThickness", ball, "Scan")
assert accepts("ResponseCurves", response) and not accepts("ResponseCurves", image)

# Blocks are taken one by one.
apart = simple.ToolContactResponse(Input=blocks)
apart.UpdatePipeline()
assert apart.PointData["ResponseForce"] is not None
assert apart.GetDataInformation().GetNumberOfPoints() == 2 * ball.GetDataInformation().GetNumberOfPoints()


def complaint(proxy):
    """The error that updating it reports; standard error is what ParaView writes to."""
    with tempfile.TemporaryFile("w+") as kept:
        sys.stderr.flush()
        usual = os.dup(2)
        os.dup2(kept.fileno(), 2)
        try:
            proxy.UpdatePipeline()
        finally:
            os.dup2(usual, 2)
            os.close(usual)
        kept.seek(0)
        return kept.read()


def check(proxy, *words):
    text = complaint(proxy)
    for word in words:
        assert word in text, (word, text)


check(simple.ToolContactResponse(Input=simple.Plane()), "other than triangles")
check(simple.ToolContactProbe(Body=ball, Tips=bare), "no response 'Response'")
check(simple.ContactDeflection(Body=response, Tips=bare), "output of vtkToolContactProbe", "ContactCell")
check(simple.ResponseCurves(Input=response, PointIds=[1000000]), "Point 1000000")
response.YoungsModulusArrayMPa = ["POINTS", "Nowhere"]
check(response, "Array to process 0 ('Nowhere')")
response.YoungsModulusArrayMPa = None
response.Tool.Radiusmm = -1
check(response, "radius", "positive", "-1")
response.Tool.Radiusmm = 5
assert complaint(response) == ""
