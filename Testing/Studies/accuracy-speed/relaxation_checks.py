# SPDX-License-Identifier: BSD-3-Clause
"""Checks of test_accuracy_speed.py for the rows of bodies that relax."""
import relaxation
import rows as study


class RelaxationChecks:
    """Errors that are the same on every machine. The reference sheet has their values (8.3, tick_battery.csv,
    tick_variants.csv)."""

    def error(self, method, tool, **wanted):
        return relaxation.worst(self.rows, method=method, tool=tool, **wanted)["error"]

    def test_all_is_there(self):
        rows = study.select(self.rows, part="force")
        self.assertEqual(study.distinct(rows, "path"),
                         ["stop and go", "Ting", "hold and release", "two triangles", "sine", "random presses"])
        self.assertEqual(study.distinct(rows, "method"), list(relaxation.METHODS))
        self.assertEqual({row["tool"] for row in rows}, set(relaxation.TOOLS))

    def test_the_foundation_is_the_theory(self):
        # Compared with tables of another code. 256 elements and one step per tick are both of second order in the error:
        # (16/256)² times the 0.26 % of 16 elements, and (T/τ)²/12 at a sharp turn with τ = 20 ms.
        for path in ("stop and go", "Ting"):
            for tool in relaxation.TOOLS:
                self.assertLess(self.error("exact: 256 elements", tool, path=path), 2e-4)

    def test_elements(self):
        for tool, sixteen, eight in (("flat", 2e-4, 2e-4), ("sphere", 4e-3, 1.3e-2), ("cone", 9.1e-3, 3e-2)):
            self.assertLess(self.error("16 elements", tool), 1.2 * sixteen)
            self.assertLess(self.error("8 elements", tool), 1.2 * eight)
        for tool in ("sphere", "cone"):
            errors = [self.error("{} elements".format(count), tool) for count in (4, 8, 16, 32)]
            for fewer, more in zip(errors, errors[1:]):
                self.assertLess(more, 0.6 * fewer)   # nearly second order

    def test_one_sided(self):
        # The reference sheet has 0.01 % for the flat, 10 % for the sphere and 12 % for the cone, for other presses.
        self.assertLess(self.error("quasi-linear, one-sided", "flat"), 2e-4)
        self.assertLess(self.error("quasi-linear, one-sided", "sphere"), 0.13)
        self.assertLess(self.error("quasi-linear, one-sided", "cone"), 0.15)

    def test_clamped(self):
        # A single press of a flat is correct. The next one is wrong, because the memory contains
        # the negative force that was cut off. For rounded tools the first press is already wrong.
        self.assertLess(self.error("quasi-linear, clamped", "flat", path="Ting"), 2e-4)
        self.assertLess(self.error("quasi-linear, clamped", "flat", path="hold and release"), 2e-4)
        for tool in relaxation.TOOLS:
            self.assertGreater(self.error("quasi-linear, clamped", tool), 0.2)
            self.assertLess(self.error("16 elements", tool), 0.05 * self.error("quasi-linear, clamped", tool))
