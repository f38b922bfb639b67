#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""palpate.contract implements the data contract in numpy. It is compared with the kernel: with vtkResponseCurves at
single points, and with vtkToolContactProbe between points and beyond the range. Random bodies, both storage forms.

Both sides read the same float32 arrays and calculate in double, but in another order. TOLERANCE allows 1e-12 of the
largest sample of a curve: about 1e-16 per operation, times the differences of neighbouring samples, weighted by up to
(n/i)^(2m) near the tip.
"""
import math
import os
import re
import unittest

import numpy as np

import palpate
from palpate import (contract, tilts, vtkContactTool, vtkReducedContactResponse, vtkResponseChoice, vtkResponseCurves,
                     vtkToolContactProbe, vtkToolContactResponse)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_DOUBLE, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource

TOLERANCE = 1e-12
RADIUS = 20.0


def add_array(data, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=1)
    array.SetName("Response" + name)
    data.AddArray(array)


def random_body(random, exponent, samples, laws=0, ranges=(0.5, 2.0)):
    """A ball whose points have independent, increasing curves. The compact form is used if laws > 0."""
    source = vtkSphereSource()
    source.SetRadius(RADIUS)
    source.SetThetaResolution(12)
    source.SetPhiResolution(9)
    source.Update()
    body = vtkPolyData()
    body.CopyStructure(source.GetOutput())
    points, field, count = body.GetPointData(), body.GetFieldData(), body.GetNumberOfPoints()
    rows = laws or count
    fractions = (np.arange(1, samples + 1) / samples) ** 2
    force = np.sort(random.uniform(0.5, 1.5, (rows, samples)) * fractions ** exponent, axis=1)
    stiffness = force * exponent / fractions * random.uniform(0.5, 1.5, (rows, samples))
    if laws:
        add_array(field, "Basis", np.hstack([force, stiffness]).astype(np.float32))
        add_array(points, "Coefficient", random.uniform(0.1, 2.0, (count, laws)).astype(np.float32))
    else:
        add_array(points, "Force", force.astype(np.float32))
        add_array(points, "Stiffness", stiffness.astype(np.float32))
    normals = vtk_to_numpy(body.GetPoints().GetData()) / RADIUS
    add_array(points, "Normal", normals.astype(np.float32))
    add_array(points, "Range", random.uniform(*ranges, count).astype(np.float32))
    add_array(points, "Status", np.zeros(count, np.uint8))
    add_array(field, "Exponent", np.array([exponent]))
    add_array(field, "Samples", np.array([samples], np.int32))
    return body


def all_bodies():
    random = np.random.default_rng(1729)
    for exponent in (1.0, 1.5, 2.0):
        for samples in (2, 8, 13):
            for laws in (0, 1, 3):
                yield (exponent, samples, laws), random_body(random, exponent, samples, laws)


def random_tips(random, count, depths):
    directions = random.normal(size=(count, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    # Facets of the ball are up to 2 mm below its radius.
    positions = directions * (RADIUS - random.uniform(*depths, count))[:, None]
    tips, points = vtkPolyData(), vtkPoints()
    points.SetData(numpy_to_vtk(positions, deep=1, array_type=VTK_DOUBLE))
    tips.SetPoints(points)
    return tips


def area_coordinates(body, cell, point):
    """Indices of the corners of a triangle, and the area coordinates of a point on it."""
    ids = [body.GetCell(cell).GetPointId(k) for k in range(3)]
    a, b, c = (np.array(body.GetPoint(i)) for i in ids)
    normal = np.cross(b - a, c - a)
    areas = [np.cross(c - b, point - b), np.cross(a - c, point - c), np.cross(b - a, point - a)]
    return ids, np.array([area @ normal for area in areas]) / (normal @ normal)


class AgainstTheTable(unittest.TestCase):
    """Compares Filters/Contact/ResponseContract.h, the table that all C++ code uses, with the arrays that filters
    attach and with those that palpate.contract reads."""

    ROW = re.compile(r"PALPATE_ARRAY\((\w+), *(\w+), *(\w+), *(\w+), *(\w+), *\"")
    TYPES = {"Float": "float", "Double": "double", "Int": "int", "UnsignedChar": "unsigned char",
             "Text": "string"}

    def setUp(self):
        header = os.path.join(os.path.dirname(__file__), "../../Filters/Contact/ResponseContract.h")
        with open(header, encoding="utf-8") as file:
            self.rows = self.ROW.findall(file.read())
        self.assertEqual(len(self.rows), 41)

    def test_filters_attach_what_the_table_says(self):
        ball = vtkSphereSource()
        ball.SetRadius(RADIUS)
        response = vtkToolContactResponse()
        response.SetTool(vtkContactTool())
        response.SetNumberOfSamples(7)
        response.SetErrorTolerance(0.05)
        response.StoreErrorOn()
        response.EdgeCorrectionOn()
        response.AddRelaxation(0.5, 0.1)
        response.AddRelaxation(0.25, 2.0)
        response.ComplianceRelaxesOff()
        response.ComplianceExcludesLayerOn()
        response.CouplingOn()
        response.SetMaximumTilt(30)
        ball.Update()
        body = ball.GetOutput()
        count = body.GetNumberOfPoints()
        for index, name, values in ((0, "Modulus", np.full(count, 0.2)), (1, "Thickness", np.linspace(5.0, 9.0, count)),
                                    (2, "GlobalCompliance", np.full(count, 0.1)),
                                    (5, "Strengths", np.full((count, 2), 0.75)),
                                    (None, "CouplingModes", np.full((count, 3), 0.01))):
            array = numpy_to_vtk(values, deep=1)
            array.SetName(name)
            body.GetPointData().AddArray(array)
            if index is not None:
                response.SetInputArrayToProcess(index, 0, 0, 0, name)
        response.SetInputData(body)
        compact = vtkReducedContactResponse()
        compact.SetInputConnection(response.GetOutputPort())
        compact.Update()
        for filter, form, absent in ((response, "PerPoint", "Compact"), (compact, "Compact", "PerPoint")):
            body = filter.GetOutput()
            laws = body.GetFieldData().GetArray("ResponseBasis")
            width = {"One": 1, "Three": 3, "Five": 5, "Samples": 7, "TwoSamples": 14, "Branches": 2, "Modes": 3,
                     "Two": 2, "Four": 4, "Seven": 7,
                     "TiltLaws": int(body.GetFieldData().GetArray("ResponseTilt").GetComponent(0, 6)),
                     "Laws": laws.GetNumberOfTuples() if laws else 0}
            for name, place, kind, components, use in self.rows:
                data = body.GetPointData() if place == "Points" else body.GetFieldData()
                array = data.GetAbstractArray("Response" + name)
                with self.subTest(array=name, form=form):
                    if use == absent:
                        self.assertIsNone(array)
                        continue
                    # Arrays of other filters, and of stacks.
                    if use == "Remark" or name in ("LayerStack", "SecondThickness"):
                        self.assertEqual(array is not None, name.startswith("Reduction") and filter is compact)
                        continue
                    self.assertIsNotNone(array)
                    self.assertEqual(array.GetDataTypeAsString(), self.TYPES[kind])
                    if (place, components) == ("Fields", "Branches"):
                        self.assertEqual((array.GetNumberOfComponents(), array.GetNumberOfTuples()), (1, 2))
                        continue
                    self.assertEqual(array.GetNumberOfComponents(), width[components])
                    if place == "Points":
                        self.assertEqual(array.GetNumberOfTuples(), body.GetNumberOfPoints())

    def test_stacks_and_remarks(self):
        plane = vtkPlaneSource()
        plane.SetResolution(4, 4)
        plane.SetPoint1(20, 0, 0)
        plane.SetPoint2(0, 20, 0)
        triangles = vtkTriangleFilter()
        triangles.SetInputConnection(plane.GetOutputPort())
        response = vtkToolContactResponse()
        response.SetInputConnection(triangles.GetOutputPort())
        response.SetTool(vtkContactTool())
        response.SetLayerThickness(4.0)
        response.AddLayer(6.0, 0.2, 0.45)
        response.AutomaticTermsOn()
        response.SetTermTolerance(1e-6)
        response.AddRelaxation(0.5, 0.1)
        choice = vtkResponseChoice()
        choice.SetInputConnection(response.GetOutputPort())
        choice.Update()
        body = choice.GetOutput()
        for name, place, kind, components, use in self.rows:
            if name in ("LayerThickness", "LayerBase", "LayerStack", "SecondThickness", "Terms", "Choice", "RelaxationElements"):
                with self.subTest(array=name):
                    data = body.GetPointData() if place == "Points" else body.GetFieldData()
                    array = data.GetAbstractArray("Response" + name)
                    self.assertIsNotNone(array)
                    self.assertEqual(array.GetDataTypeAsString(), self.TYPES[kind])
                    self.assertEqual(array.GetNumberOfComponents(), {"One": 1, "Four": 4}[components])

    def test_the_numpy_contract_reads_what_evaluation_needs(self):
        read = set()
        for module in (contract, tilts):
            with open(module.__file__, encoding="utf-8") as file:
                read |= set(re.findall(r'fetch\(\w+, "(\w+)"\)', file.read()))
        needed = {name for name, *_, use in self.rows if use in ("Evaluation", "PerPoint", "Compact", "Relaxation", "Coupling", "Tilt")}
        self.assertEqual(read, needed)


class Coupling(unittest.TestCase):
    def pressed(self, **material):
        """Presses two flat ends at two points of a plate, and compares the forces with the linear system of the
        contract."""
        x, y = np.meshgrid(np.arange(9) * 3.0, np.arange(9) * 3.0)
        points = np.column_stack([x.ravel(), y.ravel(), np.zeros(81)])
        corner = (np.arange(8)[:, None] * 9 + np.arange(8)).ravel()
        triangles = np.vstack([np.column_stack([corner, corner + 1, corner + 10]),
                               np.column_stack([corner, corner + 10, corner + 9])])
        body = palpate.response((points, triangles), "flat:1", poisson=0.4, coupling=True, maximum_deflection=0.5,
                                **material)
        one, other = 30, 32
        tips = points[[one, other]] - [0, 0, 0.2]
        together = palpate.probe(body, tips, coupled=True).normal_force
        alone = palpate.probe(body, tips)
        between = contract.coupling(body)(one, other)
        self.assertAlmostEqual(between, contract.coupling(body)(other, one), places=12)
        own = 0.2 / alone.normal_force
        expected = np.linalg.solve([[own[0], between], [between, own[1]]], [0.2, 0.2])
        # The curve of a flat end is a straight line. It is stored as floats, like the normals of
        # the points.
        np.testing.assert_allclose(together, expected, rtol=2e-6)
        return body, between

    def test_the_probe_solves_it(self):
        body, between = self.pressed(young=0.5)
        self.assertAlmostEqual(between, (1 - 0.16) / (np.pi * 0.5 * 6.0), places=7)      # Boussinesq; normals are floats
        self.pressed(young=0.5, layer=4.0)
        random = np.random.default_rng(4)
        self.pressed(young=random.uniform(0.3, 0.6, 81), layer=random.uniform(3.0, 6.0, 81))

    def test_without_arrays_there_is_none(self):
        self.assertIsNone(contract.coupling(random_body(np.random.default_rng(2), 1.5, 8)))

    def test_modes_add_up(self):
        body = random_body(np.random.default_rng(2), 1.5, 8)
        modes = np.random.default_rng(5).normal(size=(body.GetNumberOfPoints(), 3)).astype(np.float32)
        add_array(body.GetFieldData(), "Coupling", np.zeros((1, 3)))                     # without a surface
        add_array(body.GetPointData(), "CouplingModes", modes)
        self.assertAlmostEqual(contract.coupling(body)(3, 7), float(modes[3].astype(float) @ modes[7]), places=6)


class Tilts(unittest.TestCase):
    """palpate.tilts compared with the probe: force and torque are derivatives of one work."""

    def felt(self, body, depth, angle):
        tips, points = vtkPolyData(), vtkPoints()
        points.SetDataTypeToDouble()
        points.InsertNextPoint(0.3, 0.7, -depth)
        tips.SetPoints(points)
        axis = numpy_to_vtk(np.array([[math.sin(angle), 0.0, math.cos(angle)]]), deep=1)
        axis.SetName("ToolAxis")
        tips.GetPointData().AddArray(axis)
        probe = vtkToolContactProbe()
        probe.SetInputData(body)
        probe.SetTipData(tips)
        probe.Update()
        data = probe.GetOutput().GetPointData()
        return data.GetArray("NormalForce").GetTuple1(0), -data.GetArray("Torque").GetComponent(0, 1)

    def test_force_and_torque_are_those_of_the_work(self):
        plane = vtkPlaneSource()
        plane.SetOrigin(-20, -20, 0)
        plane.SetPoint1(20, -20, 0)
        plane.SetPoint2(-20, 20, 0)
        plane.SetResolution(4, 4)
        triangles = vtkTriangleFilter()
        triangles.SetInputConnection(plane.GetOutputPort())
        for tool in ("flat:2", "cone:60", "sphere:5"):
            response = vtkToolContactResponse()
            response.SetInputConnection(triangles.GetOutputPort())
            made = vtkContactTool()
            made.SetSpecification(tool)
            response.SetTool(made)
            response.SetMaximumTilt(20)
            response.Update()
            body = response.GetOutput()
            table, stored = tilts.load(body), contract.load(body)

            def work(depth, angle):
                deep = depth + float(tilts.deepest(table, angle)[0])
                if deep <= 0.0:
                    return 0.0
                steps = np.linspace(0.0, deep, 4001)
                forces = contract.evaluate(stored, np.zeros(steps.size, int), steps)[0]
                upright = float(np.sum(0.5 * (forces[1:] + forces[:-1]) * np.diff(steps)))
                return upright * tilts.factor(table, deep, angle)

            for depth, angle in ((0.5, 0.1), (0.9, 0.3), (-0.02, 0.25)):
                step = 1e-4
                force, torque = self.felt(body, depth, angle)
                by_depth = (work(depth + step, angle) - work(depth - step, angle)) / (2 * step)
                by_angle = (work(depth, angle + step) - work(depth, angle - step)) / (2 * step)
                with self.subTest(tool=tool, depth=depth):     # central differences of a sum of 4000 trapezoids
                    self.assertAlmostEqual(force, by_depth, delta=2e-4 * max(force, 1e-3))
                    self.assertAlmostEqual(torque, by_angle, delta=5e-4 * max(abs(torque), 1e-3))

    def test_without_tilts_there_are_none(self):
        self.assertIsNone(tilts.load(random_body(np.random.default_rng(2), 1.5, 8)))


class Relaxation(unittest.TestCase):
    def test_it_reads_what_was_written(self):
        body = random_body(np.random.default_rng(2), 1.5, 8)
        self.assertIsNone(contract.relaxation(body))
        add_array(body.GetFieldData(), "RelaxationStrength", np.array([[0.5, 0.25]]))     # one tuple of two components
        add_array(body.GetFieldData(), "RelaxationTime", np.array([0.1, 2.0]))
        read = contract.relaxation(body)
        self.assertEqual(list(read["strength"]), [0.5, 0.25])
        self.assertEqual(list(read["time"]), [0.1, 2.0])
        self.assertIsNone(read["elastic"])
        count = body.GetNumberOfPoints()
        local = np.random.default_rng(3).random((count, 2)).astype(np.float32)
        add_array(body.GetPointData(), "LocalRelaxation", local)
        add_array(body.GetPointData(), "ElasticCompliance", np.full(count, 0.25, np.float32))
        read = contract.relaxation(body)
        np.testing.assert_array_equal(read["strength"], local)
        np.testing.assert_array_equal(read["elastic"], 0.25)


class AgainstTheKernel(unittest.TestCase):
    def test_curves_of_single_points(self):
        for name, body in all_bodies():
            with self.subTest(exponent_samples_laws=name):
                response = contract.load(body)
                curves = vtkResponseCurves()
                curves.SetInputData(body)
                ids = list(range(0, body.GetNumberOfPoints(), 7))
                for i in ids:
                    curves.AddPointId(i)
                curves.SetNumberOfRows(211)  # several rows are below the first sample
                curves.Update()
                table = curves.GetOutput()
                depth = vtk_to_numpy(table.GetColumn(0))
                for column, i in enumerate(ids, 1):
                    kernel = vtk_to_numpy(table.GetColumn(column))
                    inside = depth <= response["range"][i]
                    self.assertTrue(np.isnan(kernel[~inside]).all())
                    force, _ = contract.evaluate(response, i, depth[inside])
                    scale = np.abs(response["force"][i]).max()
                    np.testing.assert_allclose(kernel[inside], force, rtol=0, atol=TOLERANCE * scale)

    def test_blends_under_random_tips(self):
        random = np.random.default_rng(7)
        reached = set()
        for name, body in all_bodies():
            with self.subTest(exponent_samples_laws=name):
                response = contract.load(body)
                probe = vtkToolContactProbe()
                probe.SetInputData(body)
                tips = random_tips(random, 80, (0.0, 5.0))
                probe.SetTipData(tips)
                probe.Update()
                data = probe.GetOutput().GetPointData()
                get = lambda key: vtk_to_numpy(data.GetArray(key))
                for i in np.flatnonzero(get("ContactCell") >= 0):
                    depth = get("Deflection")[i]
                    ids, weights = area_coordinates(body, get("ContactCell")[i], get("ContactPoint")[i])
                    force, _ = contract.evaluate(response, ids, depth)
                    scale = np.abs(force).max() + np.abs(response["force"][ids]).max()
                    # Weights are computed from coordinates of 20 mm on facets of 10 mm.
                    self.assertAlmostEqual(get("NormalForce")[i], weights @ force,
                                           delta=10 * TOLERANCE * scale)
                    beyond = (depth > response["range"][ids]).any()
                    self.assertEqual(get("ContactState")[i], 3 if beyond else 2)
                    direction = weights @ response["normal"][ids]
                    direction /= np.linalg.norm(direction)
                    np.testing.assert_allclose(get("Force")[i], (weights @ force) * direction,
                                               rtol=0, atol=10 * TOLERANCE * scale)
                    reached.add(bool(beyond))
        self.assertEqual(reached, {False, True})


class ByDefinition(unittest.TestCase):
    def test_power_laws_are_exact(self):
        for exponent in (1.0, 1.5, 2.0):
            body = random_body(np.random.default_rng(3), exponent, 8)
            response = contract.load(body)
            reach = response["range"][:, None]
            depth = reach * (np.arange(1, 9) / 8) ** 2
            response["force"] = 3 * depth ** exponent
            response["stiffness"] = 3 * exponent * depth ** (exponent - 1)
            points = np.arange(len(reach))[:, None]
            probes = reach * np.geomspace(1e-6, 1, 300)
            force, stiffness = contract.evaluate(response, points, probes)
            np.testing.assert_allclose(force, 3 * probes ** exponent, rtol=1e-13)
            np.testing.assert_allclose(stiffness, 3 * exponent * probes ** (exponent - 1), rtol=1e-12)

    def test_samples_are_met_and_stiffness_is_the_derivative(self):
        for name, body in all_bodies():
            with self.subTest(exponent_samples_laws=name):
                response = contract.load(body)
                samples = response["force"].shape[1]
                points = np.arange(len(response["range"]))[:, None]
                reach = response["range"][:, None]
                depth = reach * (np.arange(1, samples + 1) / samples) ** 2
                force, stiffness = contract.evaluate(response, points, depth)
                np.testing.assert_allclose(force, response["force"], rtol=1e-12)
                np.testing.assert_allclose(stiffness, response["stiffness"], rtol=1e-12)
                # Central differences have an error of h² F'''/6 and 1e-16 F/h, with h = 1e-6 of the
                # depth. They are compared only between samples, because the second derivative jumps
                # at samples.
                middle = reach * ((np.arange(0, samples + 2) + 0.5) / samples) ** 2
                step = 1e-6 * middle
                above, _ = contract.evaluate(response, points, middle + step)
                below, _ = contract.evaluate(response, points, middle - step)
                _, slope = contract.evaluate(response, points, middle)
                np.testing.assert_allclose((above - below) / (2 * step), slope, rtol=1e-6,
                                           atol=1e-6 * np.abs(slope).max())

    def test_ends(self):
        body = random_body(np.random.default_rng(5), 1.5, 8)
        response = contract.load(body)
        reach = response["range"][0]
        force, stiffness = contract.evaluate(response, 0, [-1.0, 0.0, reach, reach + 0.5, math.nan])
        self.assertEqual(list(force[:2]) + list(stiffness[:2]), [0.0] * 4)
        self.assertEqual(force[2], response["force"][0, -1])
        self.assertAlmostEqual(force[3], force[2] + 0.5 * stiffness[2], delta=1e-14)
        self.assertTrue(math.isnan(force[4]))
        response["force"][0, 0] = 0.0  # q = 0: there is no force below the first sample
        force, stiffness = contract.evaluate(response, 0, reach / 100)
        self.assertEqual((float(force), float(stiffness)), (0.0, 0.0))

    def test_shapes_broadcast(self):
        response = contract.load(random_body(np.random.default_rng(6), 2.0, 8))
        force, stiffness = contract.evaluate(response, np.arange(4)[:, None], np.linspace(0, 1, 5))
        self.assertEqual(force.shape, (4, 5))
        self.assertEqual(stiffness.shape, (4, 5))
        one, _ = contract.evaluate(response, 2, 0.25)
        # numpy's vector and scalar powers differ in the last bit.
        self.assertAlmostEqual(float(one), force[2, 1], delta=1e-15)

    def test_missing_arrays_are_named(self):
        for name in ("Force", "Stiffness", "Normal", "Range", "Status"):
            body = random_body(np.random.default_rng(8), 1.5, 8)
            body.GetPointData().RemoveArray("Response" + name)
            with self.assertRaisesRegex(KeyError, "Response" + name):
                contract.load(body)
        for name in ("Samples", "Exponent"):
            body = random_body(np.random.default_rng(8), 1.5, 8)
            body.GetFieldData().RemoveArray("Response" + name)
            with self.assertRaisesRegex(KeyError, "Response" + name):
                contract.load(body)

    def test_it_stays_short(self):
        with open(contract.__file__, encoding="utf-8") as file:
            self.assertLessEqual(len(file.readlines()), 110)  # 80, plus the lines for tools that press at the same time


if __name__ == "__main__":
    unittest.main(verbosity=2)
