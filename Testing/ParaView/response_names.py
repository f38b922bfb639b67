# SPDX-License-Identifier: BSD-3-Clause
"""Filters that read a response offer the names of the responses on a body. Any other name can be typed and is kept."""
import sys
from paraview import servermanager, simple

READERS = ("ContactRegime", "ToolContactProbe", "ContactDeflection", "Touch", "ReducedContactResponse", "ResponseCurves")


def name_and_choice(reader, body):
    probing = reader in ("ToolContactProbe", "ContactDeflection")
    proxy = getattr(simple, reader)(**({"Body": body, "Tips": tips} if probing else {"Input": body}))
    names = proxy.ResponseName
    return names if isinstance(names, str) else names[0], list(proxy.GetProperty("ResponseName").Available)


ball = simple.Sphere(Radius=50)
ball.UpdatePipeline()
tips = simple.Line()
cone = simple.ToolContactResponse(Input=ball, ResponseName="Cone")
cone.UpdatePipeline()
both = simple.ToolContactResponse(Input=cone, ResponseName="Ball")
both.UpdatePipeline()
three = simple.ToolContactResponse(Input=both)
three.UpdatePipeline()
# An array whose name resembles a part of a response is not a response.
odd = simple.Calculator(Input=three, ResultArrayName="WrongRange", Function="coordsX")
odd.UpdatePipeline()
for reader in READERS:
    # The default is the name of the body's response; Response if there is one of that name.
    assert name_and_choice(reader, cone) == ("Cone", ["Cone"]), reader
    name, choice = name_and_choice(reader, both)
    assert name in ("Ball", "Cone") and sorted(choice) == ["Ball", "Cone"], (reader, name, choice)
    name, choice = name_and_choice(reader, odd)
    assert name == "Response" and sorted(choice) == ["Ball", "Cone", "Response"], (reader, name, choice)
    # Without a choice the name does not change.
    assert name_and_choice(reader, ball) == ("Response", ["Response"]), reader

# A name from a script is kept even if the body does not have this response yet. The name is among
# the choices when the body changes.
regime = simple.ContactRegime(Input=cone)
regime.ResponseName = "Later"
regime.UpdateVTKObjects()
regime.Input = both
assert regime.ResponseName == "Later"
assert sorted(regime.GetProperty("ResponseName").Available) == ["Ball", "Cone", "Later"]
# A saved state restores the name.
state = sys.argv[1] + "/response_names.pvsm"
simple.RenameSource("regime", regime)
regime.ResponseName = "Ball"
simple.SaveState(state)
simple.ResetSession()
simple.LoadState(state)
assert simple.FindSource("regime").ResponseName == "Ball"
verdict = servermanager.Fetch(simple.FindSource("regime")).GetPointData().GetArray("RegimeVerdict")
assert verdict and verdict.GetNumberOfTuples() == 50
