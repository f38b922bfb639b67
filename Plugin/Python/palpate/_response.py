# SPDX-License-Identifier: BSD-3-Clause
"""palpate.response and palpate.regime: the law of a tool at each point of a body."""
from __future__ import annotations

import inspect
from typing import Any, Callable, Mapping, NamedTuple, Optional, Sequence, Tuple

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData

from . import _arrays, _filters, _tissues, _words
from ._bodies import as_body, shallow_copy, warn_about_size
from ._types import Base, Body, Layer, PerPoint, Reals, Strain, Tool
from .palpateResponse import vtkContactRegime, vtkContactTool, vtkToolContactResponse

BASES = {"bonded": vtkToolContactResponse.Bonded, "slip": vtkToolContactResponse.Slip}
STRAINS = {"small": vtkToolContactResponse.SmallStrain, "neo-hooke": vtkToolContactResponse.NeoHooke,
           "ogden": vtkToolContactResponse.Ogden, "demiray": vtkToolContactResponse.Demiray}


def response(body: Body, tool: Tool = "sphere:5", young: PerPoint = 0.1, poisson: PerPoint = 0.45,
             layer: Optional[PerPoint] = None, base: Base = "bonded", compliance: Optional[PerPoint] = True,
             maximum_deflection: float = 2.0, samples: int = 8, name: str = "Response",
             compliance_excludes_layer: bool = False, curvature: bool = True, strain: Strain = "small",
             error_tolerance: float = 0.05, layers: Sequence[Layer] = (), automatic: Optional[float] = None,
             edges: bool = False, relax: Sequence[Tuple[PerPoint, float]] = (), compliance_relaxes: bool = True,
             coupling: bool = False, tilt: float = 0.0, points: Optional[Reals] = None,
             tissues: Optional[Mapping[float, Tuple[float, float]]] = None, fixed: str = "z-", spacing: float = 0.0,
             progress: Optional[Callable[[str, float], Any]] = None) -> vtkPolyData:
    """Attaches to each point of a body the force-deflection curve of a tool pressed there.

    Parameters
    ----------
    body : the surface to touch, in mm: a vtkPolyData of triangles or a wrapper of one, a vtkAlgorithm, a pair of arrays
        (points, triangles) of shapes (n, 3) and (m, 3), counter-clockwise seen from outside, or the name of a file
        (.vtp .stl .ply .obj .vtk .vtu). The body is not changed. An image is refused: palpate.vtkSkinSurface makes
        a surface of a scan, and palpate.vtkBodyFileReader reads a scan.
    tool : "flat:R", "sphere:R", "paraboloid:R", "cone:DEGREES", "truncated:R,DEGREES", "blunted:R,DEGREES",
        "rounded:R,EDGE", "power:EXPONENT,COEFFICIENT" or "profile:FILE.csv" (radii in mm, half angles in degrees from
        the axis); or a vtkContactTool.
    young : Young's modulus, MPa, > 0.
    poisson : Poisson's ratio, 0 to 0.5.
    layer : thickness of an elastic layer on a rigid base, mm; None or 0 means a half-space.
    base : "bonded" if the layers are bonded to the rigid base, "slip" if they slip on it without friction, or
        ("elastic", young, poisson) for an elastic half-space instead of the rigid base.
    layers : up to three more layers below `layer`, from top to bottom, each as (thickness in mm, Young's modulus in MPa,
        Poisson's ratio). A fourth element True means that the layer slips below the layer above. The thickness of the
        first of these layers may vary like `layer`; the moduli are then constant.
    compliance : global compliance of the body, mm/N, in series with the local dent. With True, it is computed from the
        shape of a closed body of one material without layers, as by vtkBodyCompliance, within seconds; the next call
        reads it from a cache. It depends on the side at which the body is held. This is the side on which the body
        stands best; the model names it. The compliance is omitted for an open body, a body of few large triangles, and
        with layers, a material that varies or coupling. With None or False there is no global compliance.
    maximum_deflection : depth of the last sample of each curve, mm, > 0.
    samples : number of samples per curve, 2 to 256.
    name : prefix of the array names; several tools on one body need several names.
    compliance_excludes_layer : True if the compliance was computed without the base of the layers, so that both add up.
    curvature : whether the law includes the curvature of the body, which is computed from the mesh. With False, the body
        counts as flat.
    strain : law of the material at large strain, "small", "neo-hooke", ("ogden", ALPHA) or ("demiray", B).
    error_tolerance : tolerance relative to the force, 0.05 for 5 %. Validity is the depth at which the estimated error
        exceeds the tolerance, and the error at each sample is stored in NAME + Error. With 0, Validity is the depth at
        which the first assumption of the law fails, and no error is stored.
    automatic : tolerance relative to the force, 0.01 (or True) for 1 %. Layers, curvature and finite strain are omitted
        from the law if together they change the force by at most this fraction. "neo-hooke" is added if it is tabulated
        for the tool and changes the force by more. The field array NAME + Terms lists the included and omitted terms,
        with the reasons. With None or False, the terms are those of the other arguments.
    edges : whether sharp edges have an effect in palpate.probe and in sessions. Then a contact near an edge
        is softer and is pushed off the body, and its force falls to zero gradually as it passes over the edge. With
        False, the force drops to zero at the edge.
    relax : relaxation of the body as up to four pairs (strength, seconds). E(t) = E (1 + sum of strength exp(-t/seconds)),
        where E is the slow modulus, that of `young` and of the curves. A strength may vary from point to point like
        `young`. Relaxation has an effect over time: in palpate.probe along paths with times, and in sessions.
    compliance_relaxes : whether the `compliance` relaxes like the material. With False, it is elastic.
    coupling : whether several tools of palpate.probe(..., coupled=True) affect one another. They do so through the
        half-space or the layers and, if the body has a `compliance` and a point array 'CouplingModes'
        (vtkElasticCompliance), through the global deformation of the body.
    tilt : largest tilt of the tool from the body's normal, degrees. With 0, the tool counts as upright. Above 0, force and
        torque depend on the axis that is passed to palpate.probe or to a session.
    points : the points of the body that get a response, as indices or as booleans of shape (n,). The other points have
        status 4 and no curve. None means all points.
    tissues : {label: (young in MPa, poisson)} if the body is a segmentation, which is a vtkImageData of labels in mm or a
        file name (.nii, .nii.gz or .vti). poisson is at most 0.499. Voxels with other labels are empty. vtkSegmentedBody
        fills the tissues with tetrahedra, and vtkElasticContactResponse solves them, which takes seconds to minutes. The
        response is on the surface of the tetrahedra and includes the shape of the body, its tissues and its support.
        Not with young, poisson, layer, base, layers, compliance, curvature, automatic, coupling or points.
    fixed : with tissues, sides of the bounding box at which the body is held, as "z-" or "x-:2,x+:2" (depths in mm).
    spacing : with tissues, length of the tetrahedra at the surface, mm. With 0, it is chosen from the size of the body.
        Tetrahedra are smaller in regions that other tissues enclose.
    progress : with tissues, a function that is called as progress(step, fraction), with a text and a number from 0 to 1.

    young, poisson, layer and compliance may each be a number, an array of one value per point, shape (n,), or the
    name of a point array of the body.

    Returns
    -------
    vtkPolyData : the body with its arrays and, per point, NAME + Force (samples columns, N), Stiffness (N/mm), Normal,
        Range (mm), Status, Validity (the depth to which the law holds, mm), Limit. See palpate.curves and palpate.probe.
        The body contains the given arrays without a copy, as YoungsModulus, PoissonRatio, LayerThickness and
        GlobalCompliance; these arrays must not be changed afterwards.

    Raises ValueError with the message of vtkToolContactResponse, TypeError for arguments of another type, OSError and
    RuntimeError for files. Points without a response cause a RuntimeWarning, and so does a body below 5 or above 5000
    mm, whose coordinates may be in metres. Masked values cause a ValueError. Runs on all threads of vtkSMPTools. The
    results are bit for bit the same for any number of threads. A point takes about 0.1 microseconds, with a layer or a
    compliance 1 to 5.
    """
    if tissues is not None:
        _tissues.refuse(locals(), {name: each.default for name, each in inspect.signature(response).parameters.items()})
        return _tissue_response(body, tissues, fixed, spacing, progress, tool, maximum_deflection, samples, name, strain,
                                error_tolerance, edges, relax, tilt)
    made = vtkToolContactResponse()
    body = as_body(body)
    warn_about_size(body)
    made.SetWholeBody(compliance is True)
    given = _set_material(made, body, young, poisson, layer, base, None if isinstance(compliance, bool) else compliance,
                          compliance_excludes_layer, layers)
    made.SetInputData(given)
    kind = _tool(tool)
    made.SetTool(kind)
    made.SetMaximumDeflection(_arrays.number(maximum_deflection, "maximum_deflection (mm)"))
    made.SetNumberOfSamples(_count(samples, "samples"))
    made.SetResponseName(_text(name, "name"))
    made.SetCurvatureCorrection(bool(curvature))
    made.SetEdgeCorrection(bool(edges))
    made.SetMaximumTilt(_arrays.number(tilt, "tilt (degrees)"))
    made.SetCoupling(bool(coupling))
    _set_relaxation(made, given, relax)
    made.SetComplianceRelaxes(bool(compliance_relaxes))
    _set_points(made, given, points)
    _set_strain(made, strain)
    tolerance = _arrays.number(error_tolerance, "error_tolerance")
    made.SetErrorTolerance(tolerance)
    if automatic is not None and automatic is not False:
        made.AutomaticTermsOn()
        if automatic is not True:
            made.SetTermTolerance(_arrays.number(automatic, "automatic"))
    return _filters.run(made, others=[kind]).GetOutput()


def _tissue_response(body, tissues, fixed, spacing, progress, tool, maximum_deflection, samples, name, strain, error_tolerance,
                     edges, relax, tilt):
    def setting(felt):
        kind = _tool(tool)
        felt.SetTool(kind)
        felt.SetMaximumDeflection(_arrays.number(maximum_deflection, "maximum_deflection (mm)"))
        felt.SetNumberOfSamples(_count(samples, "samples"))
        felt.SetResponseName(_text(name, "name"))
        felt.SetErrorTolerance(_arrays.number(error_tolerance, "error_tolerance"))
        felt.SetEdgeCorrection(bool(edges))
        felt.SetMaximumTilt(_arrays.number(tilt, "tilt (degrees)"))
        _set_strain(felt, strain)
        for i, pair in enumerate(relax):
            what = "relax[%d]" % i
            if not isinstance(pair, (tuple, list)) or len(pair) != 2:
                raise ValueError("%s must be (strength, seconds), but is %r" % (what, pair))
            felt.AddRelaxation(_arrays.number(pair[0], what + ": strength"), _arrays.number(pair[1], what + ": seconds"))
        return [kind]

    _tool(tool)                                         # reports an invalid tool before minutes of work
    solid = _tissues.fill(body, tissues, spacing, _text(fixed, "fixed"), progress)
    return _tissues.press(solid, setting, progress)


def _set_relaxation(made, body, relax):
    count = body.GetNumberOfPoints()
    strengths = []
    for i, pair in enumerate(relax):
        what = "relax[%d]" % i
        if not isinstance(pair, (tuple, list)) or len(pair) != 2:
            raise ValueError("%s must be (strength, seconds), but is %r" % (what, pair))
        strength, seconds = pair
        if isinstance(strength, str):
            name = _name_of_array(body, strength, what + ": strength")
            strength = _arrays.to_numpy(body.GetPointData().GetArray(name))
        varies = np.ndim(strength) > 0
        strengths.append(_arrays.reals(strength, what + ": strength", (count,)) if varies
                         else _arrays.number(strength, what + ": strength"))
        made.AddRelaxation(0.0 if varies else strengths[-1], _arrays.number(seconds, what + ": seconds"))
    if any(np.ndim(strength) > 0 for strength in strengths):
        local = np.column_stack([np.broadcast_to(strength, (count,)) for strength in strengths]).astype(float)
        body.GetPointData().AddArray(_arrays.to_vtk(local, "RelaxationStrength"))
        made.SetInputArrayToProcess(5, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "RelaxationStrength")


def _set_points(made, body, points):
    if points is None:
        return
    count = body.GetNumberOfPoints()
    _arrays.refuse_masked(points, "points")
    given = np.asarray(points)
    if given.size == 0:
        given = given.astype(int)
    if given.dtype.kind not in "biu" or given.ndim != 1:
        raise TypeError("points must be indices or booleans, but is %r" % (points,))
    if given.dtype.kind == "b" and len(given) != count:
        raise ValueError("points must have %d booleans, one for each point of the body, but has %d" % (count, len(given)))
    if given.dtype.kind != "b":
        for point in given[(given < 0) | (given >= count)][:1]:
            raise ValueError("points: there is no point %d: the body has %d points" % (point, count))
    pressed = np.zeros(count, np.uint8)
    pressed[given] = 1
    body.GetPointData().AddArray(_arrays.to_vtk(pressed, "Pressed"))
    made.SetInputArrayToProcess(6, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "Pressed")


def _set_strain(made, strain):
    name, parameter = (strain, None) if isinstance(strain, str) else strain
    made.SetStrainModel(_words.value_of(name, STRAINS, "strain"))
    if name == "ogden":
        made.SetOgdenExponent(_arrays.number(parameter, "strain: the exponent of 'ogden'"))
    if name == "demiray":
        made.SetDemirayExponent(_arrays.number(parameter, "strain: the exponent of 'demiray'"))


class Regime(NamedTuple):
    """The regime of each point of a body: whether the body deforms locally or globally. See palpate.regime."""

    index: np.ndarray                                   # type: ignore[assignment]  # hides tuple.index
    sensitivity: np.ndarray
    verdict: np.ndarray


def regime(body: Body, deflection: Optional[float] = None, tool: Optional[Tool] = None, young: PerPoint = 0.1,
           poisson: PerPoint = 0.45, layer: Optional[PerPoint] = None, base: Base = "bonded",
           compliance: Optional[PerPoint] = None, name: str = "Response", compliance_excludes_layer: bool = False,
           layers: Sequence[Layer] = ()) -> Regime:
    """Computes whether a body deforms locally or globally under a tool, and therefore whether the tool's shape matters.

    Parameters
    ----------
    body, young, poisson, layer, base, compliance, compliance_excludes_layer, layers : as in palpate.response. If the body
        has the response `name`, the material must be that of the response.
    deflection : depth of the tool, mm, > 0. None means half of the response's range at each point.
    tool : as in palpate.response. None means the tool of the response `name`.

    Returns
    -------
    Regime, a tuple of arrays of one value per point, shape (n,):
        index : float32, fraction of the deflection that is global; 0 local, 1 global, negative above a near base;
        sensitivity : float32, dlnF/dln(size of the tool) at this depth;
        verdict : uint8; 0 the shape matters, 1 mixed, 2 a point force suffices.
    At points without a stable contact, index and sensitivity are NaN and the verdict is 0.

    Raises ValueError with the message of vtkContactRegime, also if material and response disagree by more than 2 %;
    TypeError for arguments of another type.
    """
    found = vtkContactRegime()
    given = _set_material(found, as_body(body), young, poisson, layer, base, compliance, compliance_excludes_layer,
                          layers)
    found.SetInputData(given)
    found.SetResponseName(_text(name, "name"))
    kind = None if tool is None else _tool(tool)
    if kind is not None:
        found.SetTool(kind)
    if deflection is not None:
        depth = _arrays.number(deflection, "deflection (mm)")
        if not depth > 0:
            raise ValueError("deflection must be positive (mm), but is %g" % depth)
        found.SetDeflection(depth)
    points = _filters.run(found, others=[] if kind is None else [kind]).GetOutput().GetPointData()
    return Regime(*(_arrays.to_numpy(points.GetArray(array))
                    for array in ("RegimeIndex", "ToolSensitivity", "RegimeVerdict")))


def _set_material(algorithm, body, young, poisson, layer, base, compliance, excludes, layers):
    """Sets the material of the algorithm. Returns the body with the given arrays."""
    if isinstance(base, (tuple, list)) and len(base) == 3 and base[0] == "elastic":
        algorithm.SetLayerBase(vtkToolContactResponse.ElasticBase)
        algorithm.SetBaseYoungsModulus(_arrays.number(base[1], "base: young (MPa)"))
        algorithm.SetBasePoissonRatio(_arrays.number(base[2], "base: poisson"))
    elif base not in BASES:
        raise ValueError("base must be 'bonded', 'slip' or ('elastic', young, poisson), but is %r" % (base,))
    else:
        algorithm.SetLayerBase(BASES[base])
    second = _add_layers(algorithm, layers)
    algorithm.SetComplianceExcludesLayer(bool(excludes))
    body = shallow_copy(body)
    for index, (argument, value, array, setter) in enumerate((
            ("young (MPa)", young, "YoungsModulus", algorithm.SetYoungsModulus),
            ("layer (mm)", layer, "LayerThickness", algorithm.SetLayerThickness),
            ("compliance (mm/N)", compliance, "GlobalCompliance", None),
            ("poisson", poisson, "PoissonRatio", algorithm.SetPoissonRatio),
            ("layers[0] (mm)", second, "SecondThickness", None))):
        if value is None and setter in (None, algorithm.SetLayerThickness):
            continue
        if np.ndim(value) == 0 and not isinstance(value, str):
            value = _arrays.number(value, argument)
            if setter is not None:
                setter(value)
                continue
            value = np.full(body.GetNumberOfPoints(), value)
        if isinstance(value, str):
            array = _name_of_array(body, value, argument)
        else:
            values = _arrays.reals(value, argument, (body.GetNumberOfPoints(),))
            body.GetPointData().AddArray(_arrays.to_vtk(values, array))
            body.GetPointData().RemoveArray(array + "Error")  # the error belongs to the replaced array
        algorithm.SetInputArrayToProcess(index, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, array)
    return body


def _name_of_array(body, name, argument):
    points = body.GetPointData()
    if points.GetArray(name) is not None:
        return name
    try:
        advice = "for the number leave out the quotes: %g" % float(name)
    except ValueError:
        there = [points.GetArrayName(i) for i in range(points.GetNumberOfArrays())]
        advice = "it has %s" % (", ".join(map(repr, there)) or "none")
    raise ValueError("%s: the body has no point array '%s'; %s" % (argument, name, advice))


def _add_layers(algorithm, layers):
    """Adds the layers. Returns the thickness of the first layer if it varies, otherwise None."""
    second = None
    for i, layer in enumerate(layers):
        what = "layers[%d]" % i
        if not isinstance(layer, (tuple, list)) or len(layer) not in (3, 4):
            raise ValueError("%s must be (thickness, young, poisson) or these and whether it slips, but is %r"
                             % (what, layer))
        thickness = layer[0]
        if i == 0 and (isinstance(thickness, str) or np.ndim(thickness) > 0):
            second, thickness = thickness, 1.0
        algorithm.AddLayer(_arrays.number(thickness, what + " (mm)"), _arrays.number(layer[1], what + ": young (MPa)"),
                           _arrays.number(layer[2], what + ": poisson"), bool(layer[3]) if len(layer) == 4 else False)
    return second


def _tool(tool: Tool) -> vtkContactTool:
    if isinstance(tool, vtkContactTool):
        return tool
    made = vtkContactTool()
    listener = _filters.Listener(made)
    made.SetSpecification(_text(tool, "tool"))
    listener.stop()
    if listener.errors:
        raise ValueError(listener.errors[0])
    return made


def _count(value, argument):
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, np.integer)):
        raise TypeError("%s must be a whole number, but is %r" % (argument, value))
    return int(value)


def _text(value, argument):
    if not isinstance(value, str):
        raise TypeError("%s must be a string, but is %r" % (argument, value))
    return value
