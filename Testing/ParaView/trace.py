# SPDX-License-Identifier: BSD-3-Clause
"""A trace of a pipeline of every filter is recorded while it is built. It runs in pvbatch and gives the same numbers:

    pvpython trace.py FOLDER PVBATCH
"""
import os
import subprocess
import sys
from contextlib import contextmanager

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
from pipeline import build, check_same, numbers             # noqa: E402
from paraview import smtrace                                # noqa: E402

FOLDER, PVBATCH = os.path.join(sys.argv[1], "trace"), sys.argv[2] # a separate folder, because tests run in parallel
os.makedirs(FOLDER, exist_ok=True)
SCRIPT, RESULT = os.path.join(FOLDER, "traced.py"), os.path.join(FOLDER, "traced.npz")



@contextmanager
def applied(proxy):
    """A context whose changes are traced, as by Apply in ParaView's panel."""
    change = smtrace.PropertiesModified(proxy.SMProxy)
    yield
    change.finalize()


smtrace.start_trace()
sources = build(FOLDER, applied)
expected = numbers(sources)
trace = smtrace.stop_trace()
for name in ("ToolContactResponse", "ResponseCurves", "ContactHistory", "MeasuredContactResponse"):
    assert name + "(" in trace, (name, trace)

with open(SCRIPT, "w", encoding="utf-8") as script:
    script.write(trace + f"""
import sys
import numpy
sys.path.insert(0, {HERE!r})
from pipeline import numbers
numpy.savez({RESULT!r}, **numbers({sources!r}))
""")
if os.path.exists(RESULT):
    os.remove(RESULT)
done = subprocess.run([PVBATCH, "--dr", SCRIPT], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                      timeout=800, check=False)
print(trace, done.stdout, sep="\n")
assert done.returncode == 0, done.returncode
with np.load(RESULT) as found:
    check_same(dict(found), expected)
