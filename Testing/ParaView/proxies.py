# SPDX-License-Identifier: BSD-3-Clause
"""The proxies of the plugin: their classes, labels and defaults, and their numerical results."""
import glob
import math
import os
import sys
from xml.etree import ElementTree
import numpy as np
import palpate
from paraview import servermanager, simple
from paraview.modules.vtkRemotingCore import vtkPVPluginTracker
from vtkmodules.util.numpy_support import vtk_to_numpy

YOUNG, POISSON = 0.05, 0.4                                  # MPa, -
REDUCED = YOUNG / (1 - POISSON**2)
FLOAT = 5e-7                                                # relative error of a stored float

PROPERTIES = {                                              # of each proxy: label -> default
    ("contact_tools", "ContactTool"): {
        "Shape": 2, "Radius (mm)": 5.0, "Half Angle (degrees)": 60.0, "Edge Radius (mm)": 1.0, "Exponent": 2.0,
        "Coefficient (mm^(1-n))": 0.1, "Profile (mm)": 0.0},
    ("sources", "ContactToolSource"): {
        "Tool": None, "Length (mm)": 40.0, "Maximum Radius (mm)": 8.0, "Facets Around Axis": 64},
    ("sources", "TrajectoryReader"): {
        "File Name": "", "Frame Rate (1/s)": 25.0, "Whole Path": 0, "Timestep Values": None},
    ("filters", "BodySurface"): {"Input": None, "Length Unit": 0},
    ("filters", "ToolContactResponse"): {
        "Input": None, "Length Unit": 0, "Tool": None, "Material": 0, "Young's Modulus (MPa)": 0.1,
        "Young's Modulus Array (MPa)": "None", "Poisson's Ratio": 0.45, "Poisson's Ratio Array": "None",
        "Layer Thickness (mm)": 0.0, "Layer Thickness Array (mm)": "None", "Layer Base": 0,
        "Base Young's Modulus (MPa)": 1.0, "Base Poisson's Ratio": 0.45, "Layers Below": None,
        "Second Layer Thickness Array (mm)": "None",
        "Global Compliance Array (mm/N)": "None", "Compliance Excludes Layer": 0, "Whole Body": 1, "Pressed Points Array": "None",
        "Curvature Correction": 1, "Edge Correction": 0, "Maximum Tilt (degrees)": 0.0, "Coupling": 0, "Relaxation": 0,
        "Relaxations": None,
        "Relaxation Array": "None", "Compliance Relaxes": 1, "Strain Model": 0, "Ogden Exponent": 2.0, "Demiray Exponent": 1.0,
        "Error Tolerance": 0.05, "Store Error": 1, "Leave Out Small Effects": 0, "Largest Effect Left Out": 0.01,
        "Maximum Deflection (mm)": 2.0, "Number Of Samples": 8, "Response Name": "Response"},
    ("filters", "ContactRegime"): {
        "Input": None, "Tool": None, "Deflection (mm)": 0.0, "Material": 0, "Young's Modulus (MPa)": 0.1,
        "Young's Modulus Array (MPa)": "None", "Poisson's Ratio": 0.45, "Poisson's Ratio Array": "None",
        "Layer Thickness (mm)": 0.0, "Layer Thickness Array (mm)": "None", "Layer Base": 0,
        "Base Young's Modulus (MPa)": 1.0, "Base Poisson's Ratio": 0.45, "Layers Below": None,
        "Second Layer Thickness Array (mm)": "None",
        "Global Compliance Array (mm/N)": "None", "Compliance Excludes Layer": 0, "Response Name": "Response"},
    ("filters", "ToolContactProbe"): {
        "Body": None, "Tips": None, "Indentation (mm)": 0.0, "Coupled": 0, "Friction Coefficient": 0.0, "Friction Model": 0,
        "Tangential Stiffness (N/mm)": 1.0, "Friction Breakaway": 0.8, "Friction Stick Radius": 0.9,
        "Poisson's Ratio": 0.5, "Relaxation Elements": 16, "Force Form": 1, "Contact Surface": 0, "Response Name": "Response"},
    ("filters", "ContactDeflection"): {
        "Body": None, "Tips": None, "Tip Index": -1, "Poisson's Ratio": 0.45, "Maximum Distance (mm)": 0.0,
        "Response Name": "Response"},
    ("filters", "ToolTouch"): {
        "Input": None, "Tip Position (mm)": 0.0, "Second Tip": 0, "Second Tip Position (mm)": 0.0, "Snap To Surface": 1, "Indentation (mm)": 0.0, "Response Name": "Response",
        "Force Scale (mm/N)": 0.0, "Tool Length (mm)": 0.0, "Poisson's Ratio": 0.45, "Extent Of Dent (contact radii)": 20.0},
    ("filters", "ResponseCurves"): {
        "Input": None, "Selection": None, "Point Ids": 0, "Response Name": "Response", "More Response Names": None,
        "Maximum Number Of Points": 20, "Number Of Rows": 101, "Error Band": 1},
    ("filters", "ContactHistory"): {"Tips": None, "Abscissa": 0},
    ("filters", "MeasuredCurves"): {"Readings": None},
    ("filters", "ReducedContactResponse"): {
        "Input": None, "Tolerance": 0.01, "Maximum Number Of Laws": 8, "Response Name": "Response"},
    ("filters", "ResponseChoice"): {
        "Input": None, "Tolerance": 0.01, "Fraction Of Points Within Tolerance": 1.0, "Deflection (mm)": 0.0, "Maximum Number Of Laws": 8,
        "Response Name": "Response"},
    ("filters", "MeasuredContactResponse"): {
        "Input": None, "Curve Table": None, "Length Unit": 0, "Curves": None, "Measuring Tool": "", "Registration": "",
        "Tool": None, "Body Model": 0, "Poisson's Ratio": 0.45, "Layer Base": 0, "Find First Contact": 1,
        "Noise Of Force (N)": 0.0, "Maximum Hysteresis": 0.2, "Maximum Rate Effect": 0.1, "Maximum Strain": 0.4,
        "Maximum Misfit": 0.02, "Maximum Uncertainty": 0.5, "Maximum Site Distance (mm)": 2.0, "Reach (mm)": 20.0,
        "Maximum Deflection (mm)": 2.0, "Number Of Samples": 8, "Error Tolerance": 0.05, "Store Error": 1,
        "Maximum Tilt (degrees)": 0.0, "Response Name": "Response"},
    ("filters", "ElasticContactResponse"): {
        "Input": None, "Finer Surface": None, "Coarser Body": None, "Length Unit": 0, "Young's Modulus (MPa)": 0.1,
        "Young's Modulus Array (MPa)": "None", "Poisson's Ratio": 0.45, "Poisson's Ratio Array": "None", "Tool": None, "Maximum Deflection (mm)": 2.0,
        "Number Of Samples": 8, "Edge Correction": 0, "Maximum Tilt (degrees)": 0.0, "Relaxations": None, "Error Tolerance": 0.05,
        "Store Error": 1, "Store Motion": 1,
        "Response Name": "Response", "Largest Contact Radius (mm)": 0.0, "Spacing Of Solved Points (mm)": 0.0, "Strain Model": 0,
        "Ogden Exponent": 2.0, "Demiray Exponent": 1.0, "Leave Out Small Effects": 0,
        "Largest Effect Left Out": 0.01, "Layer Thickness (mm)": 0.0, "Layer Thickness Array (mm)": "None", "Memory Limit (MiB)": 0.0, "Solver": 0},
    ("filters", "DirectContactResponse"): {
        "Input": None, "Body": None, "Coarser Body": None, "Refined Surface": None, "Tool": None, "Young's Modulus (MPa)": 0.1,
        "Poisson's Ratio": 0.45, "Maximum Deflection (mm)": 2.0, "Error Tolerance": 0.05, "Fixed Faces": "z-", "Strain Model": 0,
        "Ogden Exponent": 2.0, "Demiray Exponent": 1.0, "Response Name": "Response"},
    ("filters", "NoduleMaterial"): {
        "Input": None, "Length Unit": 0, "Young's Modulus (MPa)": 0.1, "Young's Modulus Array (MPa)": "None",
        "Poisson's Ratio": 0.45, "Poisson's Ratio Array": "None", "Nodules (mm, MPa)": None, "Sampling Points Per Side": 8},
    ("filters", "ScannedMaterial"): {
        "Input": None, "Image": None, "Image Array": "", "Length Unit": 0, "Materials (value, MPa)": None, "Values Are Labels": 1,
        "Young's Modulus (MPa)": 0.1, "Poisson's Ratio": 0.45, "Sampling Points Per Side": 4},
    ("filters", "SegmentedBody"): {
        "Input": None, "Label Array": "", "Tissues": None, "Surface Spacing (mm)": 0.0, "Fixed Faces": "z-"},
    ("filters", "ForceMap"): {"Input": None, "Depth (mm)": 1.0, "Response Name": "Response"},
    ("filters", "NoduleDetectability"): {
        "Input": None, "Length Unit": 0, "Tool": None, "More Tools": None, "Smallest Felt Change": 0.1, "Press Depth (mm)": 0.0,
        "Maximum Deflection (mm)": 2.0, "Number Of Samples": 8, "Error Tolerance": 0.05, "Only Within Validity": 0,
        "Store Responses Without Nodules": 0, "Response Name": "Response", "Largest Contact Radius (mm)": 0.0,
        "Spacing Of Solved Points (mm)": 0.0, "Spacing Of Solved Points Without Nodules (mm)": 0.0, "Memory Limit (MiB)": 0.0, "Solver": 0},
    ("filters", "ElasticCompliance"): {
        "Input": None, "Length Unit": 0, "Young's Modulus (MPa)": 0.1, "Young's Modulus Array (MPa)": "None",
        "Poisson's Ratio": 0.45,
        "Poisson's Ratio Array": "None", "Patch Radius (mm)": 0.0, "Memory Limit (MiB)": 0.0, "Solver": 0,
        "Number Of Modes": 0, "Number Of Coupling Modes": 0, "Loaded Point": -1, "Load Force (N)": 1.0},
    ("filters", "VoxelBody"): {
        "Input": None, "Length Unit": 0, "Spacing (mm)": 0.0, "Fixed Faces": "z-", "Follow Surface": 1},
    ("filters", "GradedBody"): {
        "Input": None, "Length Unit": 0, "Surface Spacing (mm)": 0.0, "Interior Spacing (mm)": 0.0, "Growth Of Cells Inwards": 0.5,
        "Fine Balls (mm)": None, "Largest Deviation From Surface (mm)": 0.0, "Fixed Faces": "z-"},
    ("filters", "SkinSurface"): {
        "Input": None, "Grey Values": "", "Contour Value": 0.0, "Closing Radius (mm)": 6.0,
        "Resolution (mm)": 0.0, "Smoothing Iterations": 30},
    ("filters", "LayerThickness"): {
        "Body": None, "Scan": None, "Grey Values": "", "Grey Value Of Bone": 35.0, "Maximum Depth (mm)": 20.0,
        "Edge Width (mm)": 3.0, "Smoothing Radius (mm)": 3.0},
}


def fetched(proxy, name, point_data=True):
    data = servermanager.Fetch(proxy)
    return vtk_to_numpy((data.GetPointData() if point_data else data).GetArray(name))


def fetched_cells(proxy, name):
    return vtk_to_numpy(servermanager.Fetch(proxy).GetCellData().GetArray(name))


def definitions():
    """Every proxy that the plugin's files define, as group, name, element."""
    folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Plugin/ParaView/ServerManager")
    files = glob.glob(folder + "/*.xml")
    assert files, folder
    for file in files:
        for group in ElementTree.parse(file).getroot():
            for element in group:
                if element.get("name"):
                    yield group.get("name"), element.get("name"), element


def check_loaded():
    """The plugin has been loaded automatically from its folder, with settings that do not contain it (--dr)."""
    tracker = vtkPVPluginTracker.GetInstance()
    mine = [i for i in range(tracker.GetNumberOfPlugins()) if tracker.GetPluginName(i) == "Palpate"]
    assert len(mine) == 1 and tracker.GetPluginLoaded(mine[0]), mine
    assert tracker.GetPluginFileName(mine[0]).startswith(os.environ["PV_PLUGIN_PATH"])


def check_definitions():
    """The list above contains every proxy of the plugin's files. Every property has help, also those of
    representations."""
    found = {(group, name) for group, name, _ in definitions() if group != "representations"}
    assert found == PROPERTIES.keys(), found ^ PROPERTIES.keys()
    for _, name, element in definitions():
        for item in element.iter():
            if item.tag.endswith("Property") and item.tag not in ("Property", "RequiredProperties") and item.get("name"):
                text = item.findtext("Documentation") or ""
                assert len(text.strip()) > 10, (name, item.get("name"), text)


def check_properties():
    """Labels and defaults are as listed, the defaults equal those of the class, and everything is documented."""
    manager = servermanager.ProxyManager()
    for (group, name), expected in PROPERTIES.items():
        proxy = manager.NewProxy(group, name)
        assert proxy.GetDocumentation().GetDescription(), name
        hints = proxy.GetHints()
        if group != "contact_tools" and not hints.FindNestedElementByName("ReaderFactory"):
            menu = hints.FindNestedElementByName("ShowInMenu").GetAttribute("category")
            assert menu.startswith("Palpate"), (name, menu)     # the submenu is checked by test_panels.py
        made = proxy.GetClientSideObject()
        # the class itself or, for the plugin's own vtkPV..., the corresponding class of the package
        assert type(made) is getattr(palpate, made.GetClassName().replace("vtkPV", "vtk")), type(made)
        found = {}
        keys = proxy.NewPropertyIterator()
        keys.Begin()
        while not keys.IsAtEnd():
            item = keys.GetProperty()
            label = item.GetXMLLabel()
            assert item.GetDocumentation() and item.GetDocumentation().GetDescription(), (name, label)
            value = None
            if not item.IsA("vtkSMProxyProperty") and not item.GetInformationOnly():
                count = item.GetNumberOfElements()
                value = item.GetElement(count - 1) if count else None
                getter = getattr(made, "Get" + keys.GetKey(), None)
                if getter:
                    given = getter()
                    all_of_it = tuple(item.GetElement(i) for i in range(count)) if isinstance(given, tuple) else value
                    assert (given or "") == (all_of_it or ""), (name, label, given, all_of_it)
            found[label] = value
            keys.Next()
        assert found == expected, (name, found)


def direct_tool(specification):
    tool = palpate.vtkContactTool()
    assert tool.SetSpecification(specification)
    return tool


def check_stack():
    """The table of layers reaches the filter. Two equal layers have the same force as one layer."""
    body = simple.Plane(Origin=(-20, -20, 0), Point1=(20, -20, 0), Point2=(-20, 20, 0), XResolution=4, YResolution=4)
    body = simple.Triangulate(Input=body)
    forces = []
    for thickness, below in ((6, []), (2, [3, YOUNG, POISSON, 0, 1, YOUNG, POISSON, 0])):
        response = simple.ToolContactResponse(Input=body)
        response.YoungsModulusMPa = YOUNG
        response.PoissonsRatio = POISSON
        response.LayerThicknessmm = thickness
        response.LayersBelow = below
        response.UpdatePipeline()
        assert response.GetClientSideObject().GetNumberOfAddedLayers() == len(below) // 4
        forces.append(fetched(response, "ResponseForce"))
    assert np.allclose(*forces, rtol=1e-6), forces


def check_relaxation():
    """The table of relaxations reaches the filter. A relaxation chosen by name replaces it."""
    response = simple.ToolContactResponse(Input=simple.Triangulate(Input=simple.Plane()))
    response.Relaxations = [0.5, 0.1, 0.3, 2]
    expected = {"Custom": [0.5, 0.3], "Skin of a mouse": [2.57], "Soft tissue of a limb": [0.15],
                "Rubber of the paper (assumed)": [0.05, 0.05]}
    for name in (*expected, "Custom"):
        response.Relaxation = name
        response.UpdatePipeline()
        body = servermanager.Fetch(response)
        assert list(palpate.contract.relaxation(body)["strength"]) == expected[name], name
    response.Relaxations = []
    response.UpdatePipeline()
    assert palpate.contract.relaxation(servermanager.Fetch(response)) is None


def with_response(body):
    response = simple.ToolContactResponse(Input=body)
    response.Tool.Shape = "Paraboloid"                      # the samples store the law of this shape exactly
    response.Tool.Radiusmm = 6.35
    response.YoungsModulusMPa = YOUNG
    response.PoissonsRatio = POISSON
    response.CurvatureCorrection, response.ErrorTolerance, response.WholeBody = 0, 0, 0   # the tool's own law
    response.UpdatePipeline()
    made = response.GetClientSideObject()
    assert type(made) is palpate.vtkToolContactResponse
    assert type(made.GetTool()) is palpate.vtkContactTool
    assert made.GetTool().GetSpecification() == "paraboloid:6.35"
    return response


def check_ball():
    """A ball pressed at its side: curves, forces, displacement, the table of curves."""
    tool = direct_tool("paraboloid:6.35")
    response = with_response(simple.Sphere(Radius=50, ThetaResolution=60, PhiResolution=60))
    depths = 2 * (np.arange(1, 9) / 8) ** 2
    expected = [tool.GetForce(depth, REDUCED) for depth in depths]
    forces = fetched(response, "ResponseForce")
    np.testing.assert_allclose(forces, np.tile(expected, (len(forces), 1)), rtol=FLOAT)

    press = simple.Line(Point1=(53, 0, 5), Point2=(48, 0, 5), Resolution=10)
    probe = simple.ToolContactProbe(Body=response, Tips=press)
    assert type(probe.GetClientSideObject()) is palpate.vtkToolContactProbe
    depth = fetched(probe, "Deflection")
    assert depth[0] == 0 and 1.6 < depth[-1] < 2, depth     # the facets are slightly inside the ball
    expected = [tool.GetForce(d, REDUCED) for d in depth]
    np.testing.assert_allclose(fetched(probe, "NormalForce"), expected, rtol=FLOAT, atol=1e-15)
    force = fetched(probe, "Force")
    np.testing.assert_allclose(np.linalg.norm(force, axis=1), expected, rtol=FLOAT, atol=1e-15)
    assert force[-1][0] > 0.98 * expected[-1]               # the force points out of the body
    probe.Indentationmm = 0.1
    deeper = fetched(probe, "Deflection")
    np.testing.assert_allclose(deeper[-1] - depth[-1], 0.1, atol=1e-3) # the normals of the facets are interpolated

    curves = simple.ResponseCurves(Input=response, PointIds=[3, 7], NumberOfRows=5)
    assert type(curves.GetClientSideObject()) is palpate.vtkResponseCurves
    rows = servermanager.Fetch(curves).GetRowData()
    depth = vtk_to_numpy(rows.GetArray("Deflection (mm)"))
    np.testing.assert_allclose(depth, [0, 0.5, 1, 1.5, 2], rtol=1e-15)
    expected = [tool.GetForce(d, REDUCED) for d in depth]
    np.testing.assert_allclose(vtk_to_numpy(rows.GetArray("Response at point 7 (N)")), expected, rtol=FLOAT)


def check_friction():
    """A tool dragged over a plate has Coulomb's limit of friction. Separate points have no friction."""
    flat = simple.Triangulate(Input=simple.Plane(
        Origin=(-20, -20, 0), Point1=(20, -20, 0), Point2=(-20, 20, 0), XResolution=10, YResolution=10))
    drag = simple.Line(Point1=(-2, 0.3, -1), Point2=(2, 0.3, -1), Resolution=200)
    probe = simple.ToolContactProbe(Body=with_response(flat), Tips=drag)
    for model in ("Elasto-plastic", "Dahl", "Shape-derived"):
        probe.FrictionCoefficient = 0.5
        probe.FrictionModel = model
        probe.TangentialStiffnessNmm = 0.5
        probe.PoissonsRatio = POISSON
        friction, normal = fetched(probe, "FrictionForce"), fetched(probe, "NormalForce")
        np.testing.assert_allclose(friction[-1], [-0.5 * normal[-1], 0, 0], atol=1e-3 * normal[-1])
        assert fetched(probe, "ContactState")[5] == 1 and fetched(probe, "ContactState")[-1] == 2
        np.testing.assert_allclose(fetched(probe, "Force"),
                                   normal[:, None] * fetched(probe, "Normal") + friction, atol=1e-14)
        probe.FrictionCoefficient = 0
        assert not fetched(probe, "FrictionForce").any()
    loose = simple.ExtractSurface(Input=simple.PointSource(Center=(0, 0, -1), Radius=0.1, NumberOfPoints=20))
    probe.Tips = loose
    probe.FrictionCoefficient = 0.5
    assert fetched(probe, "NormalForce").all() and not fetched(probe, "FrictionForce").any()
    for form in ("Paper", "Normalized direction", "Energy-consistent"):
        for surface in ("Facets", "Smooth"):
            probe.ForceForm, probe.ContactSurface = form, surface
            assert fetched(probe, "NormalForce").all()      # a plate has the same force everywhere


def check_plane():
    """On a flat body the displacement field is the tool's closed form, at every point of the field."""
    tool = direct_tool("paraboloid:6.35")
    flat = simple.Triangulate(Input=simple.Plane(
        Origin=(-20, -20, 0), Point1=(20, -20, 0), Point2=(-20, 20, 0), XResolution=40, YResolution=40))
    response = with_response(flat)
    tips = simple.Line(Point1=(0.25, 0.5, 1), Point2=(0.25, 0.5, -1.5), Resolution=5)
    probe = simple.ToolContactProbe(Body=response, Tips=tips)
    np.testing.assert_allclose(fetched(probe, "Deflection"), [0, 0, 0, 0.5, 1, 1.5], atol=1e-7) # float tips
    dent = simple.ContactDeflection(Body=response, Tips=probe, TipIndex=4, PoissonsRatio=POISSON)
    assert type(dent.GetClientSideObject()) is palpate.vtkContactDeflection
    moved = fetched(dent, "ContactDisplacement")
    points = vtk_to_numpy(servermanager.Fetch(dent).GetPoints().GetData())
    for point, found in zip(points, moved):
        away = point[:2] - (0.25, 0.5)
        r, u = math.hypot(*away), [0, 0]
        tool.GetSurfaceDisplacement(r, 1.0, POISSON, u)
        np.testing.assert_allclose(found, [*(u[0] * away / r), -u[1]], atol=1e-6) # floats, of 1 mm


def check_tool():
    source = simple.ContactTool(Lengthmm=30)
    source.Tool.Shape = "Flat"
    source.Tool.Radiusmm = 4
    source.UpdatePipeline()
    assert type(source.GetClientSideObject()) is palpate.vtkContactToolSource
    np.testing.assert_allclose(source.GetDataInformation().GetBounds(), [-4, 4, -4, 4, 0, 30], atol=1e-6)


def check_layer():
    """A layer of 10 mm, incompressible, under a sphere 2 mm deep: 1.66943909743 times the half-space's force
    (Data/Reference/liver_slab_h10.csv), and a negative regime index: 1 - 1.669^(2/3)."""
    flat = simple.Triangulate(Input=simple.Plane(
        Origin=(-20, -20, 0), Point1=(20, -20, 0), Point2=(-20, 20, 0), XResolution=2, YResolution=2))
    response = with_response(flat)
    response.PoissonsRatio = 0.5
    response.LayerThicknessmm = 10
    force = fetched(response, "ResponseForce")[0, 7]
    half_space = direct_tool("paraboloid:6.35").GetForce(2.0, YOUNG / 0.75)
    np.testing.assert_allclose(force, 1.66943909743 * half_space, rtol=2 * FLOAT)
    regime = simple.ContactRegime(Input=response, Deflectionmm=2, YoungsModulusMPa=YOUNG, PoissonsRatio=0.5,
                                  LayerThicknessmm=10)
    regime.Tool.Shape = "Paraboloid"
    regime.Tool.Radiusmm = 6.35
    assert type(regime.GetClientSideObject()) is palpate.vtkContactRegime
    np.testing.assert_allclose(fetched(regime, "RegimeIndex"), 1 - 1.66943909743 ** (2 / 3), rtol=1e-5)
    assert np.all(fetched(regime, "RegimeVerdict") == 0)


def check_compliance():
    """A ball on its foot has a compliance at every point, which is halved if the ball is twice as stiff."""
    ball = simple.Sphere(Radius=10, ThetaResolution=40, PhiResolution=40)
    solid = simple.VoxelBody(Input=ball, Spacingmm=2.5)
    compliance = simple.ElasticCompliance(Input=solid, YoungsModulusMPa=YOUNG, PoissonsRatio=POISSON)
    values = fetched(compliance, "GlobalCompliance")
    assert type(solid.GetClientSideObject()) is palpate.vtkVoxelBody
    assert type(compliance.GetClientSideObject()) is palpate.vtkElasticCompliance
    height = vtk_to_numpy(servermanager.Fetch(compliance).GetPoints().GetData())[:, 2]
    assert np.median(values) > 0, values
    # The same solid in centimetres.
    small = simple.Transform(Input=solid, Transform="Transform")
    small.Transform.Scale = [0.1, 0.1, 0.1]
    again = simple.ElasticCompliance(Input=small, YoungsModulusMPa=YOUNG, PoissonsRatio=POISSON, LengthUnit="cm")
    np.testing.assert_allclose(fetched(again, "GlobalCompliance"), values, rtol=1e-4) # coordinates rounded to floats
    compliance.YoungsModulusMPa = 2 * YOUNG
    np.testing.assert_allclose(fetched(compliance, "GlobalCompliance"), values / 2, rtol=1e-6) # cancellation
    assert not servermanager.Fetch(compliance).GetPointData().HasArray("LoadedDisplacement")
    compliance.LoadedPoint = int(height.argmax())
    compliance.LoadForceN = 0.1
    moved = fetched(compliance, "LoadedDisplacement")
    assert moved[height.argmax(), 2] < 0, moved


def check_true_shape():
    """A ball on its foot under a tool: softer than a curved half-space; the force is proportional to E; a further tool
    needs no new solution."""
    ball = simple.Sphere(Radius=10, ThetaResolution=40, PhiResolution=40)
    solid = simple.VoxelBody(Input=ball, Spacingmm=2.5)
    shaped = simple.ElasticContactResponse(Input=solid, YoungsModulusMPa=YOUNG, PoissonsRatio=POISSON)
    shaped.Tool.Shape = "Sphere"
    shaped.Tool.Radiusmm = 5
    shaped.MaximumDeflectionmm = 0.5
    force = fetched(shaped, "ResponseForce")
    made = shaped.GetClientSideObject()
    assert type(made) is palpate.vtkElasticContactResponse
    assert made.GetNumberOfSolutions() > 0
    body = servermanager.Fetch(shaped)
    top = vtk_to_numpy(body.GetPoints().GetData())[:, 2].argmax()
    assert body.GetPointData().GetArray("ResponseStatus").GetValue(top) == 0
    hertz = 4 / 3 * REDUCED * (1 / (1 / 5 + 1 / 10)) ** 0.5 * 0.5 ** 1.5
    assert 0.7 * hertz < force[top, -1] < 1.02 * hertz, (force[top], hertz)
    shaped.Tool.Radiusmm = 2
    smaller = fetched(shaped, "ResponseForce")
    assert smaller[top, -1] < force[top, -1] and made.GetNumberOfSolutions() == 0
    shaped.YoungsModulusMPa = 2 * YOUNG
    np.testing.assert_allclose(fetched(shaped, "ResponseForce")[top], 2 * smaller[top], rtol=1e-4)
    # On a separate surface, in the body's unit: the ball that was filled. Unlike the voxels it is
    # smooth.
    shaped.FinerSurface = ball
    felt = fetched(shaped, "ResponseForce")
    points = vtk_to_numpy(servermanager.Fetch(shaped).GetPoints().GetData())
    assert len(points) == servermanager.Fetch(ball).GetNumberOfPoints() and shaped.GetClientSideObject().GetNumberOfSolutions() == 0
    above = points[:, 2].argmax()
    assert 0.7 < felt[above, -1] / (2 * smaller[top, -1]) < 1.4, (felt[above], 2 * smaller[top])


def check_nodules():
    """A hard ball in a ball increases the force above it but not elsewhere, and most for the tool whose size is closer
    to the hard ball's size."""
    ball = simple.Sphere(Radius=10, ThetaResolution=40, PhiResolution=40)
    solid = simple.VoxelBody(Input=ball, Spacingmm=1.5)
    material = simple.NoduleMaterial(Input=solid, YoungsModulusMPa=YOUNG, PoissonsRatio=POISSON)
    material.NodulesmmMPa = [0, 0, 6, 2.5, 10 * YOUNG]
    moduli = fetched_cells(material, "YoungsModulus")
    assert np.isclose(moduli.max(), 10 * YOUNG) and np.isclose(moduli.min(), YOUNG), moduli
    np.testing.assert_allclose(fetched_cells(material, "YoungsModulusWithout"), YOUNG, rtol=1e-12)
    felt = simple.NoduleDetectability(Input=material, MaximumDeflectionmm=0.5)
    felt.Tool.Shape = "Sphere"
    felt.Tool.Radiusmm = 2
    felt.MoreTools = ["sphere:6"]
    change = fetched(felt, "ForceChange")
    made = felt.GetClientSideObject()
    assert type(made) is palpate.vtkNoduleDetectability and made.GetNumberOfTools() == 2
    points = vtk_to_numpy(servermanager.Fetch(felt).GetPoints().GetData())
    top, side = points[:, 2].argmax(), points[:, 0].argmax()
    assert (change[top] > 0.1).all() and (abs(change[side]) < 0.05).all(), (change[top], change[side])
    assert fetched(felt, "StrongestTool")[top] == change[top].argmax()
    assert fetched(felt, "Felt")[top].all() and not fetched(felt, "Felt")[side].any()
    felt.SmallestFeltChange = 0.9
    assert not fetched(felt, "Felt")[top].any()


def check_scanned():
    """Wavelet as a scan of stiffness: E of each cell is within the range of the map, larger in the middle, and the same
    in any unit."""
    ball = simple.Sphere(Radius=8, ThetaResolution=40, PhiResolution=40)
    solid = simple.VoxelBody(Input=ball, Spacingmm=2)
    scanned = simple.ScannedMaterial(Input=solid, Image=simple.Wavelet(), ImageArray=["POINTS", "RTData"], ValuesAreLabels=0)
    scanned.MaterialsvalueMPa = [100, YOUNG, 0.45, 250, 10 * YOUNG, 0.48]
    moduli = fetched_cells(scanned, "YoungsModulus")
    grid = servermanager.Fetch(scanned)
    middles = np.array([grid.GetCell(i).GetBounds() for i in range(grid.GetNumberOfCells())]).reshape(-1, 3, 2).mean(axis=2)
    away = np.linalg.norm(middles, axis=1)
    assert YOUNG <= moduli.min() < 5 * YOUNG < moduli.max() <= 10 * YOUNG, moduli
    assert moduli[away < 3].mean() > 1.5 * moduli[away > 7].mean()
    ratios = fetched_cells(scanned, "PoissonRatio")
    assert 0.45 <= ratios.min() and ratios.max() <= 0.48


def check_segmented():
    """Three filters from an image of labels to the map: above a hard ball under the upper face the force is larger."""
    labels = simple.Calculator(Input=simple.Wavelet(), ResultArrayName="Label",
                               Function="if(abs(coordsZ) > 6, 0, if(mag(coords - 2*kHat) < 2.6, 2, 1))")
    body = simple.SegmentedBody(Input=labels, LabelArray=["POINTS", "Label"], SurfaceSpacingmm=4)
    body.Tissues = [1, YOUNG, POISSON, 2, 10 * YOUNG, POISSON]
    moduli = fetched_cells(body, "YoungsModulus")
    assert YOUNG <= moduli.min() < 1.01 * YOUNG and 5 * YOUNG < moduli.max() <= 10 * YOUNG, moduli
    assert type(body.GetClientSideObject()) is palpate.vtkSegmentedBody
    assert body.GetClientSideObject().GetNumberOfFineRegions() == 1
    felt = simple.ElasticContactResponse(Input=body, YoungsModulusArrayMPa=["CELLS", "YoungsModulus"],
                                         PoissonsRatioArray=["CELLS", "PoissonRatio"], MaximumDeflectionmm=0.5, SpacingOfSolvedPointsmm=2)
    felt.Tool.Shape = "Sphere"
    felt.Tool.Radiusmm = 2
    mapped = simple.ForceMap(Input=felt, Depthmm=0.4)
    force = fetched(mapped, "ForceAtDepth")
    points = vtk_to_numpy(servermanager.Fetch(mapped).GetPoints().GetData())
    upper = points[:, 2] > points[:, 2].max() - 0.6                  # without the rounded edges
    away = np.hypot(points[:, 0], points[:, 1])
    above, beside = np.nanmax(force[upper & (away < 1.5)]), np.nanmedian(force[upper & (away > 5) & (away < 7)])
    # The force is larger by at least 10 %. For a ball of 3 mm radius, 2 mm deep and ten times as
    # hard, it is larger by 23 to 30 % (Data/Studies/nodule/nodule.md).
    assert above > 1.1 * beside, (above, beside)


def check_skin():
    """Wavelet's values grow towards its centre: the skin is a closed surface around it."""
    scan = simple.Wavelet()
    scan.UpdatePipeline()
    skin = simple.SkinSurface(Input=scan, ContourValue=200, ClosingRadiusmm=0)
    assert list(skin.GreyValues) == ["POINTS", "RTData"], list(skin.GreyValues)
    skin.UpdatePipeline()
    assert type(skin.GetClientSideObject()) is palpate.vtkSkinSurface
    assert skin.GetDataInformation().GetNumberOfCells() > 100


def check_thickness():
    """A ball of 8 mm with a dark core of 4 mm, blurred over 2 mm: thickness of the layer, and the response with it."""
    scan = simple.Calculator(Input=simple.Wavelet(), ResultArrayName="Grey",
                             Function="max(0, min(100, 50 + 50*(mag(coords) - 4)))")
    ball = simple.Sphere(Radius=8, ThetaResolution=60, PhiResolution=60)
    layer = simple.LayerThickness(Body=ball, Scan=scan)
    layer.GreyValues = ["POINTS", "Grey"]
    assert type(layer.GetClientSideObject()) is palpate.vtkLayerThickness
    np.testing.assert_allclose(fetched(layer, "LayerThickness"), 4, atol=0.25) # tolerance for voxels of 1 mm
    response = with_response(layer)
    soft = fetched(response, "ResponseForce")
    response.LayerThicknessArraymm = ["POINTS", "LayerThickness"]
    assert np.all(fetched(response, "ResponseForce") > soft)


def check_trajectory():
    """Tips that move down onto a plate in 1 s. At each time the output has the tips up to that time. All tips press on
    a plate."""
    file = sys.argv[1] + "/trajectory.csv"
    with open(file, "w", encoding="utf-8") as csv:
        csv.write("time_s,tip_x_mm,tip_y_mm,tip_z_mm\n")
        csv.writelines(f"{i / 100!r},0.25,0.5,{1 - 2 * i / 100!r}\n" for i in range(101))
    tips = simple.PalpateTrajectoryReader(FileName=file, FrameRate1s=10)
    made = tips.GetClientSideObject()
    assert type(made) is palpate.vtkTrajectoryReader
    np.testing.assert_allclose(tips.TimestepValues, np.arange(11) / 10, atol=1e-12)
    for time, count in ((0.0, 1), (0.4, 41), (0.75, 76), (1.0, 101)):
        tips.UpdatePipeline(time)
        assert made.GetOutput().GetNumberOfPoints() == count, (time, made.GetOutput().GetNumberOfPoints())
    tips.WholePath = 1
    flat = simple.Triangulate(Input=simple.Plane(
        Origin=(-20, -20, 0), Point1=(20, -20, 0), Point2=(-20, 20, 0), XResolution=10, YResolution=10))
    depth = fetched(simple.ToolContactProbe(Body=with_response(flat), Tips=tips), "Deflection")
    np.testing.assert_allclose(depth, np.maximum(0, 2 * np.arange(101) / 100 - 1), atol=1e-7) # float mesh


check_loaded()
check_definitions()
check_properties()
check_ball()
check_friction()
check_plane()
check_tool()
check_layer()
check_stack()
check_relaxation()
check_compliance()
check_true_shape()
check_nodules()
check_scanned()
if palpate.vtkSegmentedBody.IsAvailable():                   # with CGAL
    check_segmented()
check_skin()
check_thickness()
check_trajectory()
