# SPDX-License-Identifier: BSD-3-Clause
"""palpate.probe: the contact force at tool tips."""
from __future__ import annotations

import weakref
from typing import Any, List, Literal, NamedTuple, Optional, Tuple, Union, overload

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData

from . import _arrays, _filters, _words
from ._bodies import as_body, shallow_copy
from ._types import Body, Reals
from .palpateResponse import vtkToolContactProbe

CHOICES = {
    "friction_model": {"elasto-plastic": vtkToolContactProbe.ElastoPlastic, "dahl": vtkToolContactProbe.Dahl,
                       "shape-derived": vtkToolContactProbe.ShapeDerived},
    "force_form": {"paper": vtkToolContactProbe.Paper, "normalized-direction": vtkToolContactProbe.NormalizedDirection,
                   "energy-consistent": vtkToolContactProbe.EnergyConsistent},
    "surface": {"facets": vtkToolContactProbe.Facets, "smooth": vtkToolContactProbe.Smooth}}


class Probe(NamedTuple):
    """The contact at each of n tips, in their order. See palpate.probe."""

    forces: np.ndarray
    deflection: np.ndarray
    normal_force: np.ndarray
    friction: np.ndarray
    normal: np.ndarray
    contact_point: np.ndarray
    contact_cell: np.ndarray
    contact_state: np.ndarray
    memory: np.ndarray
    error: np.ndarray
    torque: np.ndarray
    tilt: np.ndarray


class CoupledProbe(Tuple[np.ndarray, np.ndarray]):
    """Contacts of tools that press together: the pair (forces, stiffness), with the fields of Probe as attributes."""

    felt: Probe
    stiffness: np.ndarray

    def __new__(cls, felt: Probe, stiffness: np.ndarray) -> CoupledProbe:
        pair = super().__new__(cls, (felt.forces, stiffness))  # type: ignore[arg-type]  # mypy 1.0 on tuple.__new__
        pair.felt, pair.stiffness = felt, stiffness
        return pair

    def __getattr__(self, name: str) -> np.ndarray:
        if name == "felt":                              # while the pair is being copied, the attribute is not set yet
            raise AttributeError(name)
        return getattr(self.felt, name)

    def __reduce__(self):
        return CoupledProbe, (self.felt, self.stiffness)


FrictionModel = Literal["elasto-plastic", "dahl", "shape-derived"]
ForceForm = Literal["paper", "normalized-direction", "energy-consistent"]
Surface = Literal["facets", "smooth"]


# For type checkers: calls with coupled=True return a CoupledProbe, all other calls a Probe.
@overload
def probe(body: Body, tips: Union[Reals, vtkPolyData], *, path: bool = ..., time: Optional[Reals] = ...,
          friction: float = ..., tangential_stiffness: float = ..., friction_model: FrictionModel = ...,
          friction_breakaway: float = ..., friction_stick_radius: float = ..., poisson: float = ...,
          force_form: ForceForm = ..., surface: Surface = ..., indentation: float = ..., name: str = ...,
          relaxation_elements: int = ..., axis: Optional[Reals] = ..., coupled: Literal[False] = ...) -> Probe: ...


@overload
def probe(body: Body, tips: Union[Reals, vtkPolyData], *, path: bool = ..., time: Optional[Reals] = ...,
          friction: float = ..., tangential_stiffness: float = ..., friction_model: FrictionModel = ...,
          friction_breakaway: float = ..., friction_stick_radius: float = ..., poisson: float = ...,
          force_form: ForceForm = ..., surface: Surface = ..., indentation: float = ..., name: str = ...,
          relaxation_elements: int = ..., axis: Optional[Reals] = ..., coupled: Literal[True]) -> CoupledProbe: ...


def probe(body: Body, tips: Union[Reals, vtkPolyData], *, path: bool = False, time: Optional[Reals] = None,
          friction: float = 0.0, tangential_stiffness: float = 1.0, friction_model: FrictionModel = "elasto-plastic",
          friction_breakaway: float = 0.8, friction_stick_radius: float = 0.9, poisson: float = 0.5,
          force_form: ForceForm = "normalized-direction", surface: Surface = "facets", indentation: float = 0.0,
          name: str = "Response", relaxation_elements: int = 16, axis: Optional[Reals] = None,
          coupled: bool = False) -> Union[Probe, CoupledProbe]:
    """Computes the contact force at given tool tips with the kernel of the servo tick.

    Parameters
    ----------
    body : a body with a response, as palpate.response returns it, or a saved body, "body.vtp".
    tips : positions of the tool's tip, mm, in the frame of the body, with the shape (n, 3), or (3,) for one tip. float32
        and float64 are not copied. A vtkPolyData is also accepted; its polylines are paths.
    path : if False, the tips are independent; the contact of each tip is searched in the whole body, without friction. If
        True, the tips are one path; the contact is followed from tip to tip, with friction.
    time : time of each tip of a path, s, shape (n,); must not decrease. Only the force of a body that relaxes depends on
        the time. Without times, and for independent tips, this force is that of the slow response.
    friction : Coulomb's coefficient of friction, >= 0; for paths only.
    tangential_stiffness : stiffness of the contact while it sticks, N/mm, > 0.
    friction_model : "elasto-plastic", "dahl" or "shape-derived" (from the response itself).
    friction_breakaway, friction_stick_radius : for "elasto-plastic" friction, the fraction of the limit up to which the
        contact sticks elastically, 0 to 1, and the fraction at which half of a displacement is creep.
    poisson : Poisson's ratio, 0 to 0.5, for "shape-derived" friction.
    force_form : "paper", "normalized-direction" or "energy-consistent", the method that combines the three curves of a
        triangle into one force.
    surface : "facets" (the triangles) or "smooth" (a patch through the vertices and normals of each triangle).
    indentation : distance by which each tip is first moved inward, mm, so that points on the surface press.
    name : prefix of the response arrays.
    relaxation_elements : number of parallel elements of a body that relaxes, 0 (quasi-linear) to 32.
    axis : axis of the tool, from the tip up its shaft, of any length; shape (3,) for all tips, or the shape of `tips`.
        With tilts in the response, the force depends on the axis, and there are torques. None: along the body's normal.
    coupled : if True, up to 64 tips of the same time press together and affect one another. The body must be made with
        palpate.response(..., coupling=True). Without path these are all tips, or the tips of the same `time`. With
        path=True, `tips` has the shape (n, k, 3) for k tools at n times, and each field of the result has n rows of k.
        The result is used as forces, stiffness = palpate.probe(..., coupled=True).

    Returns
    -------
    Probe, a tuple: forces, deflection, *rest = palpate.probe(body, tips). Its fields have one row per tip:
        forces (n, 3) : total force on the tool, N;
        deflection (n,) : depth of the tip below its contact point, mm; 0 outside the body;
        normal_force (n,) : part of the force along `normal`, N;
        friction (n, 3) : part of the force due to friction, N;
        normal (n, 3) : unit normal of the contact, outward; zeros without contact;
        contact_point (n, 3) : point on the undeformed body, mm;
        contact_cell (n,) : index of the triangle, -1 without contact;
        contact_state (n,) : 0 none, 1 stick, 2 slide, 3 beyond the response's range, 4 lost at an open border,
            5 invalid (the tip is not finite, or the point has no response), 6 tilted beyond the range of the response
            (the force is that of the largest tilt);
        memory (n,) : for a body that relaxes, the excess of normal_force over the slow response, N; otherwise 0;
        error (n,) : estimated relative error of the force (0.04 for 4 %); 0 without contact; NaN beyond the range, and if
            the response stores no error;
        torque (n, 3) : torque about the tip, N mm; zeros without an axis;
        tilt (n,) : angle of the axis from `normal`, degrees; 0 without an axis.
    With coupled=True a CoupledProbe, a pair with the same fields as attributes:
        forces : as above;
        stiffness (n, k), for a path (n, k, k) : derivative of each tip's slow normal force with respect to the depth of
            each of the k tips that press together, N/mm; positive for the tip itself, negative for others, 0 without
            force.

    Raises ValueError with the message of vtkToolContactProbe, TypeError for arguments of another type, OSError and
    RuntimeError for files. Defects of the mesh cause a RuntimeWarning. Independent tips run on all threads of
    vtkSMPTools and take 0.5 to 1 microsecond each. The results are bit for bit the same for any number of threads. A
    path runs on one thread. The first call on a body builds a search structure (0.3 s for 150 thousand points), which
    is kept for the next call on the same body.
    """
    body = as_body(body)
    shape = np.shape(tips)[:-1] if coupled and path and np.ndim(tips) == 3 else None
    tips = _as_tips(tips, path, time, axis, coupled)
    if tips.GetNumberOfPoints() == 0:
        raise ValueError("there are no tips to probe")
    friction = _arrays.number(friction, "friction")
    if friction != 0.0 and tips.GetNumberOfLines() == 0:
        raise ValueError("friction acts along a path only: give path=True")
    with _prepared(body, name) as felt:
        felt.SetTipData(tips)
        felt.SetFrictionModel(_choose("friction_model", friction_model))
        felt.SetForceForm(_choose("force_form", force_form))
        felt.SetContactSurface(_choose("surface", surface))
        felt.SetFrictionCoefficient(friction)
        felt.SetTangentialStiffness(_arrays.number(tangential_stiffness, "tangential_stiffness"))
        felt.SetFrictionBreakaway(_arrays.number(friction_breakaway, "friction_breakaway"))
        felt.SetFrictionStickRadius(_arrays.number(friction_stick_radius, "friction_stick_radius"))
        felt.SetPoissonRatio(_arrays.number(poisson, "poisson"))
        felt.SetIndentation(_arrays.number(indentation, "indentation"))
        felt.SetRelaxationElements(relaxation_elements)
        felt.SetCoupled(bool(coupled))
        points = _filters.run(felt).GetOutput().GetPointData()
        arrays = [points.GetArray(array) for array in (
            "Force", "Deflection", "NormalForce", "FrictionForce", "Normal", "ContactPoint", "ContactCell",
            "ContactState", "MemoryForce", "RelativeError", "Torque", "Tilt")]
        stiffness = points.GetArray("CoupledStiffness")
    count = tips.GetNumberOfPoints()
    *others, memory, error, torque, tilt = arrays
    values = [*map(_arrays.to_numpy, others), np.zeros(count) if memory is None else _arrays.to_numpy(memory),
              np.full(count, np.nan) if error is None else _arrays.to_numpy(error),
              np.zeros((count, 3)) if torque is None else _arrays.to_numpy(torque),
              np.zeros(count) if tilt is None else _arrays.to_numpy(tilt)]
    found = Probe(*values)
    if not coupled:
        return found
    stiffness = _arrays.to_numpy(stiffness)
    stiffness = stiffness.reshape(count, -1)
    if shape is not None:                               # the points are ordered tool by tool
        *fields, stiffness = (np.swapaxes(each.reshape(shape[::-1] + each.shape[1:]), 0, 1)
                              for each in (*found, stiffness))
        found = Probe(*fields)
    return CoupledProbe(found, stiffness)


def _as_tips(tips, path, time, axis, coupled):
    if isinstance(tips, vtkPolyData):
        if path or time is not None or axis is not None:
            raise ValueError("path, time and axis are for arrays of tips; a vtkPolyData has polylines and arrays 'Time' "
                             "and 'ToolAxis'")
        return tips
    lines = 1
    if path and coupled:
        tips = _arrays.reals(tips, "tips of a path that is coupled", (None, None, 3))
        moments, lines = tips.shape[:2]
        if axis is not None:
            axis = np.swapaxes(np.broadcast_to(_arrays.reals(axis, "axis", np.shape(axis)), tips.shape), 0, 1)
            axis = axis.reshape(-1, 3)
        if time is not None:
            time = np.tile(_arrays.reals(time, "time (s)", (moments,)), lines)
        tips = np.ascontiguousarray(np.swapaxes(tips, 0, 1)).reshape(-1, 3)
    elif np.ndim(tips) == 1:
        tips = np.asanyarray(tips)[None, :]             # asanyarray keeps a mask, so that masked values can be refused
    tips = _arrays.reals(tips, "tips", (None, 3))
    made = vtkPolyData()
    made.SetPoints(_arrays.to_points(tips))
    if path and len(tips) > 0:
        made.SetLines(_arrays.to_cells(np.arange(len(tips)), len(tips) // lines))
    if time is not None:
        made.GetPointData().AddArray(_arrays.to_vtk(_arrays.reals(time, "time (s)", (len(tips),)), "Time"))
    if axis is not None:
        axis = np.broadcast_to(_arrays.reals(axis, "axis", (3,)), tips.shape) if np.ndim(axis) == 1 else axis
        axis = np.array(_arrays.reals(axis, "axis", (len(tips), 3)), dtype=float)
        made.GetPointData().AddArray(_arrays.to_vtk(axis, "ToolAxis"))
    return made


def _choose(argument, value):
    return _words.value_of(value, CHOICES[argument], argument)


class _prepared:
    """The filter for a body. Its search structure is used again if the body is the unchanged body of the last call.

    The filter references the body's arrays. It is freed with the body, or when another body is used. No other thread can
    get the filter while it is in use."""

    _kept: List[Any] = []

    def __init__(self, body, name):
        self.body, self.name = body, name
        self.state = (body.GetMTime(), name)

    def __enter__(self):
        try:
            owner, state, self.filter = self._kept.pop()
        except IndexError:
            owner, state = (lambda: None), None
        if owner() is not self.body or state != self.state:
            self.filter = vtkToolContactProbe()
            self.filter.SetInputData(0, shallow_copy(self.body))
            self.filter.SetResponseName(self.name)
        return self.filter

    def __exit__(self, kind, *_):
        self.filter.SetInputData(1, None)               # releases the tips
        if kind is None:
            self._kept[:] = [(weakref.ref(self.body, self._forget), self.state, self.filter)]

    @classmethod
    def _forget(cls, owner):
        cls._kept[:] = [kept for kept in cls._kept if kept[0] is not owner]
