# SPDX-License-Identifier: BSD-3-Clause
# Names that `import palpate` offers. The build of Palpate makes the stubs of the wrapped modules.
from . import contract as contract, tilts as tilts
from ._curves import Curves as Curves, curves as curves
from ._measured import Measured as Measured, measured as measured
from ._probe import CoupledProbe as CoupledProbe, Probe as Probe, probe as probe
from ._version import __version__ as __version__
from ._response import Regime as Regime, regime as regime, response as response
from .palpateComparison import *
from .palpateInteraction import *
from .palpateMeasuredResponse import *
from .palpateResponse import *
from .palpateSolidResponse import *
