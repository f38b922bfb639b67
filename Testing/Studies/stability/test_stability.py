#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The short version of ./run study stability, and the results of the whole study in Data/Studies/stability.

    test_stability.py PROGRAM [UNITTEST ARGS]       PROGRAM: palpateStability

Limits are compared with theory.py, which does not use Palpate, and energies with zero. Verdicts of failures are checked.
"""
import csv
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import run       # noqa: E402
import theory    # noqa: E402
import verdicts  # noqa: E402

DATA = pathlib.Path(__file__).resolve().parents[3] / "Data"
PROGRAM = pathlib.Path(sys.argv.pop(1)) if len(sys.argv) > 1 else None


def reference(name):
    with open(DATA / "Reference" / name, encoding="utf-8") as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


class Theory(unittest.TestCase):
    """Compares theory.py with the reference table, whose eigenvalues come from another program."""

    def test_limits(self):
        for row in reference("stability_K_limits.csv"):
            period, damping = row["T_s"], row["b_Ns_per_m"]
            self.assertAlmostEqual(theory.closed_limit(0.1, damping, period) / row["Jury"], 1, delta=1e-9)
            self.assertAlmostEqual(theory.exact_limit(0.1, damping, period) / row["Jury"], 1, delta=1e-8)
            self.assertAlmostEqual(theory.exact_limit(0.1, damping, period, 1.0) / row["eig_delay1"], 1, delta=1e-8)

    def test_relaxing_limits(self):
        with open(DATA / "Reference" / "rate" / "stability_prony.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        for row in rows:
            material = " ".join(":".join(each) for each in zip(row["p"].split(), row["tau_s"].split()))
            mass, damping, period = (float(row[name]) for name in ("m_kg", "b", "T_s"))
            self.assertAlmostEqual(theory.passive_relaxing(material, damping, period) / float(row["K_passive_closed"]), 1,
                                   delta=1e-12)
            # The change of the eigenvalues is less than 1e-3 of a relative change of K. Therefore their rounding causes a
            # thousand times as large an error of K.
            for delay, name in ((0.0, "K_stable_eig"), (1.0, "K_stable_eig_delay1")):
                found = theory.relaxing_limit(material, mass, damping, period, delay)
                self.assertAlmostEqual(found / float(row[name]), 1, delta=1e-6, msg=material)


class Rows:
    """Checks that apply to the rows of a whole study and of a quick study."""

    def check_limit(self, row, tolerance):
        """Checks that the limit is the predicted one, and that motion decays below the limit and grows above it."""
        self.assertLess(abs(row["error"]), tolerance, row)
        self.assertLess(row["growth_below"], 1, row)
        self.assertGreater(row["growth_above"], 1, row)

    def test_exact_limits(self):
        for row in self.tables["limits"]:
            # The bisection ends at 1e-11; the response is stored as float32. The required accuracy is 1 %.
            self.assertLess(abs(row["error"]), 1e-5, row)

    def test_relaxing_limits(self):
        self.assertEqual({row["material"] for row in self.tables["relaxing"]},
                         {"1:0.01", "1:0.1", "1:1", "0.5:0.02 0.8:0.2 1.2:2"})
        for row in self.tables["relaxing"]:
            # The limit is identified from some hundred readings of a response in float32, with up to six poles.
            self.check_limit(row, 1e-3)

    def test_relaxing_under_control(self):
        for row in self.tables["relaxing-press"]:
            if row["control"] != "none":
                self.assertLessEqual(row["generated_mJ"], verdicts.NO_ENERGY, row)
            if row["control"] in ("passivity", "chain"):
                self.assertEqual(row["rests"], 1, row)

    def test_relaxing_paths_give_no_energy(self):
        for row in self.tables["relaxing-paths"]:
            self.assertLessEqual(row["generated_controlled_mJ"], verdicts.NO_ENERGY, row)
            if row["form"] == "EnergyConsistent":
                self.assertLessEqual(row["loop_gain"], verdicts.QUADRATURE, row)

    def test_limits_of_two_hands(self):
        self.assertEqual({row["motion"] for row in self.tables["hands"]}, {"opposite", "common"})
        for row in self.tables["hands"]:
            # Boussinesq's C and the curves are float32. The rounds of a tick are exact for springs.
            self.check_limit(row, 1e-4)

    def test_two_hands_under_control(self):
        for row in self.tables["hands-press"]:
            if row["control"] != "none":
                self.assertLessEqual(row["generated_mJ"], verdicts.NO_ENERGY, row)
            # At 2b/T no damping is left for the energy that two hands exchange.
            if row["control"] == "chain":
                self.assertEqual(row["rests"], 1, row)

    def test_rest_on_an_encoder(self):
        for row in self.tables["encoder"]:
            if row["coulomb_N"] == 0:
                self.assertGreater(row["half_swing_um"], 0.3 * row["encoder_um"], row)  # never at rest
            elif row["friction_N_per_m"] < 5 * theory.passive_limit(1.0, 1 / row["rate_Hz"]):
                self.assertGreater(row["restful_N_per_m"], 0.99 * row["bound_N_per_m"], row)
                # Above 2 f_c/Δ a rest position need not exist. The search has steps of 0.05 %.
                self.assertLess(row["restful_N_per_m"], 1.05 * row["friction_N_per_m"], row)

    def test_force_limits(self):
        for row in run.select(self.tables["press"], control="none", start="held"):
            if 1e-3 < row["limit_N"] < theory.STRONGEST_PUSH:
                # 0.05 % by the criterion, 0.1 % by the bisection
                if row["depth_mm"] < 8:  # at larger depths, depth and stiffness are those at 8 mm
                    self.assertAlmostEqual(row["stiffness_N_per_m"] / row["exact_N_per_m"], 1, delta=0.01)
                if row["exact_force_N"] != "":
                    # 0.2 % in stiffness is 0.6 % in the force of δ^1.5. Stored curves add 5e-4.
                    self.assertAlmostEqual(row["limit_N"] / row["exact_force_N"], 1, delta=0.01)
            elif row["limit_N"] == 0:
                self.assertGreater(row["stiffness_N_per_m"], 0.99 * row["exact_N_per_m"], row)

    def test_control_lets_no_energy_out(self):
        for row in self.tables["press"]:
            if row["control"] != "none":
                self.assertLessEqual(row["generated_mJ"], verdicts.NO_ENERGY, row)
        for row in self.tables["geometry"]:
            self.assertLessEqual(row["generated_controlled_mJ"], verdicts.NO_ENERGY, row)

    def test_half_of_the_stiffness_comes_to_rest(self):
        for control in ("passivity", "chain"):
            for row in run.select(self.tables["press"], control=control):
                self.assertEqual(row["limit_N"], theory.STRONGEST_PUSH, row)

    def test_cylinder(self):
        for row in self.tables["cylinder"]:
            # 0.05 % in stiffness by the criterion, to the power 3/2 for a sphere and 2 for a cone;
            # 0.03 % by the bisection.
            self.assertAlmostEqual(row["modulus_MPa"] / row["exact_modulus_MPa"], 1, delta=0.01)

    def test_leak(self):
        for row in run.select(self.tables["leak"], control="none"):
            # The error is of first order in the path per tick over the depth of 2 mm. A delayed force doubles the error, and
            # the turn may be between two ticks.
            slack = 0.01 + (1 + row["delay_ticks"]) * 1e3 * row["speed_m_s"] / row["rate_Hz"] / 2.0
            self.assertAlmostEqual(row["leaked_mJ"] / row["expected_mJ"], 1, delta=slack)

    def test_friction(self):
        def value(model, what, setting=0.0):
            return verdicts.first(self.tables["friction"], model=model, what=what, rate_Hz=1000.0,
                                  setting=setting)["value"]

        self.assertGreater(value("Dahl", "drift_mm"), 5)            # 9.26 mm by Dahl's closed form
        self.assertLess(abs(value("elasto-plastic", "drift_mm")), 1e-3)
        self.assertLess(abs(value("stick-slide", "drift_mm")), 1e-3)
        self.assertGreater(value("signum", "drift_mm"), 5)
        for model in ("elasto-plastic", "z8", "stick-slide", "Dahl"):
            self.assertAlmostEqual(value(model, "stiffest_stick_N_per_m") / 2003.33889, 1, delta=0.01)


def committed():
    tables = {}
    for part in run.PARTS:
        rows = run.read((DATA / "Studies" / "stability" / f"{part}.csv").read_text(encoding="utf-8"))
        tables[part] = rows
    return tables


class Quick(Rows, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.tables = run.study(PROGRAM, is_quick=True)
        cls.cells = {(c["method"], c["failure"]): c["verdict"] for c in verdicts.judge(cls.tables)}

    def test_faults(self):
        for fault in verdicts.FAULTS.values():
            # A device that hangs keeps its force whatever the loop does. The chain survives all
            # other faults.
            expected = verdicts.FAILS if fault == verdicts.FAULTS["stall"] else verdicts.SURVIVES
            self.assertEqual(self.cells["stored, chain", fault], expected, fault)
        self.assertEqual(self.cells["law at run time", "2 % NaN"], verdicts.FAILS)
        self.assertEqual(self.cells["law at run time", verdicts.FAULTS["host"]], verdicts.FAILS)
        self.assertEqual(self.cells["stored, chain", "too stiff"], verdicts.SURVIVES)
        self.assertEqual(self.cells["point spring", "too stiff"], verdicts.FAILS)


class Committed(Rows, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.tables = committed()

    def test_verdicts_are_those_of_the_rows(self):
        text = (DATA / "Studies" / "stability" / "verdicts.md").read_text(encoding="utf-8")
        # Rows are written with six digits, verdicts with three.
        self.assertEqual(verdicts.markdown(verdicts.judge(self.tables)).count("**fails**"), text.count("**fails**"))


if __name__ == "__main__":
    unittest.main()
