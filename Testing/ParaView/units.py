# SPDX-License-Identifier: BSD-3-Clause
"""A body in cm or m has the responses of the same body in mm. If the size suggests another unit, a question is printed.
A named material replaces the numbers."""
import re
import numpy as np
import palpate  # noqa: F401 - gives the client-side objects their class
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from complaint import complaint

QUESTION = "is the Length Unit right?"


def arrays(proxy):
    data = servermanager.Fetch(proxy)
    found = {"points": vtk_to_numpy(data.GetPoints().GetData())}
    for i in range(data.GetPointData().GetNumberOfArrays()):
        array = data.GetPointData().GetArray(i)
        found[array.GetName()] = vtk_to_numpy(array)
    return found


def scaled(source, factor):
    moved = simple.Transform(Input=source, Transform="Transform")
    moved.Transform.Scale = [factor] * 3
    return moved


def check_units():
    ball = simple.Sphere(Radius=50, ThetaResolution=40, PhiResolution=40)
    usual = arrays(simple.ToolContactResponse(Input=ball, WholeBody=0))
    for unit, factor in (("cm", 0.1), ("m", 0.001)):
        response = simple.ToolContactResponse(Input=scaled(ball, factor), LengthUnit=unit, WholeBody=0)
        assert QUESTION not in complaint(response)
        found = arrays(response)
        assert found.keys() == usual.keys()
        for key, values in usual.items():
            # Coordinates are floats that are rounded twice, to 6e-8 of 50 mm. The bound on the
            # curvature divides their differences by the squares of edges of some mm.
            np.testing.assert_allclose(found[key], values, rtol=2e-5, atol=2e-5, err_msg=f"{unit}: {key}")
    # With the compliance of the whole body, rounded coordinates give other finite elements. Their
    # error is in the response.
    in_mm, in_cm = (arrays(simple.ToolContactResponse(Input=body, LengthUnit=unit))
                    for body, unit in ((ball, "mm"), (scaled(ball, 0.1), "cm")))
    force, stated = in_mm["ResponseForce"], in_mm["ResponseError"] + in_cm["ResponseError"]
    assert not np.allclose(force, usual["ResponseForce"], rtol=0.02)
    difference = np.abs(in_cm["ResponseForce"] / force - 1)
    assert (difference <= stated)[stated < 1].all() and np.median(difference) < 1e-3, np.median(difference)
    # Other filters for bodies have the same property.
    for name in ("BodySurface", "VoxelBody"):
        make = getattr(simple, name)
        made = make(Input=scaled(ball, 0.1), LengthUnit="cm", **({"Spacingmm": 10} if name == "VoxelBody" else {}))
        assert QUESTION not in complaint(made)
        np.testing.assert_allclose(made.GetDataInformation().GetBounds(), [-50, 50] * 3, atol=2, err_msg=name)


def check_question():
    """The question is asked once, below 5 mm and above 5 m. It is not repeated for another tool."""
    for radius, asked in ((2.4, True), (2.6, False), (2400, False), (2600, True)):
        response = simple.ToolContactResponse(Input=simple.Sphere(Radius=radius, ThetaResolution=40, PhiResolution=41),
                                              WholeBody=0)
        said = complaint(response)
        assert said.count(QUESTION) == asked, (radius, said)
        response.Tool.Radiusmm = 3
        assert QUESTION not in complaint(response)
    response.LengthUnit = "cm"                              # 26 m across, so the question must be asked again
    assert QUESTION in complaint(response)


def check_materials(make):
    """Every material has the numbers that its help text cites. Custom uses the numbers of the user."""
    proxy = make()
    entry = proxy.SMProxy.GetProperty("Material")
    text = entry.GetDocumentation().GetDescription()
    names = proxy.GetProperty("Material").Available
    assert names[0] == "Custom" and len(names) > 4
    cited = {}
    for name in names[1:]:
        # The modulus E, the measured quantity, and (author year, method).
        line = re.search(re.escape(name) + r": (\d[\d.]*\d)\b[^()]*\([A-Z][^()]* (19|20)\d\d, [^()]*\)", text)
        assert line, name
        cited[name] = float(line.group(1))
    assert "scatter" in text
    made = proxy.GetClientSideObject()
    proxy.YoungsModulusMPa, proxy.PoissonsRatio = 0.25, 0.3
    for name in (*names[1:], "Custom"):
        proxy.Material = name
        proxy.UpdateVTKObjects()
        expected = (0.25, 0.3) if name == "Custom" else (cited[name], 0.5)
        assert (made.GetYoungsModulus(), made.GetPoissonRatio()) == expected, (name, made.GetYoungsModulus())
        assert (proxy.YoungsModulusMPa, proxy.PoissonsRatio) == (0.25, 0.3) # the numbers of the user are unchanged
    proxy.Material = names[1]
    proxy.YoungsModulusMPa = 0.5                            # not used
    proxy.UpdateVTKObjects()
    assert made.GetYoungsModulus() == cited[names[1]]
    return names, cited


def check_force_of_material():
    """A flat punch has the force 2 a E* depth. A modulus per point overrides the material."""
    ball = simple.Sphere(Radius=50)
    body = simple.Calculator(Input=ball, ResultArrayName="Stiff", Function="0.05 + 0.001 * abs(coordsX)")
    names, cited = check_materials(lambda: simple.ToolContactResponse(Input=body, WholeBody=0))
    check_materials(lambda: simple.ContactRegime(Input=simple.ToolContactResponse(Input=body, WholeBody=0)))
    response = simple.ToolContactResponse(Input=body, Material=names[4], CurvatureCorrection=0, WholeBody=0)
    response.Tool.Shape = "Flat"
    np.testing.assert_allclose(arrays(response)["ResponseForce"][:, -1], 2 * 5 * 2 * cited[names[4]] / 0.75, rtol=1e-6)
    response.YoungsModulusArrayMPa = ["POINTS", "Stiff"]
    found = arrays(response)
    np.testing.assert_allclose(found["ResponseForce"][:, -1], 2 * 5 * 2 * found["Stiff"] / 0.75, rtol=1e-6)


check_units()
check_question()
check_force_of_material()
