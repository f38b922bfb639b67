# SPDX-License-Identifier: BSD-3-Clause
"""Client and server with the plugin on both sides: remote.py FOLDER PLUGIN "COMMAND OF THE SERVER"

The server starts without the plugin and gets it from the client. Its results are compared with those of ParaView
without a server. With one process they are bitwise equal. With several processes they agree to a millionth, because
normals at seams are summed in another order.
"""
import os
import shlex
import socket
import subprocess
import sys
import threading
import traceback
import numpy as np
import raw_xml
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

FOLDER, PLUGIN, SERVER = sys.argv[1], sys.argv[2], shlex.split(sys.argv[3])
FILE = os.path.join(FOLDER, "remote_%d.vtp" % os.getpid())


def start_server():
    """Starts a server that listens on a free port. Returns the server, its port, and its output."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    # The server starts without the plugin. This process may itself belong to MPI, which mpiexec
    # does not accept.
    environment = {k: v for k, v in os.environ.items()
                   if k != "PV_PLUGIN_PATH" and not k.startswith(("OMPI_", "PMIX_", "OPAL_", "ORTE_"))}
    server = subprocess.Popen(SERVER + ["--server-port=%d" % port, "--dr"], text=True,
                              env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    watch = threading.Timer(120, server.kill)
    watch.daemon = True
    watch.start()
    said = []
    for line in server.stdout:
        said.append(line)
        if "Accepting connection" in line:
            watch.cancel()
            threading.Thread(target=lambda: said.extend(server.stdout), daemon=True).start()
            return server, port, said
    raise RuntimeError("the server did not start: " + "".join(said))


def build(spread):
    body = simple.XMLPolyDataReader(FileName=[FILE])
    pieces = simple.RedistributeDataSet(Input=body) if spread else body
    response = simple.ToolContactResponse(Input=pieces, YoungsModulusMPa=0.05, MaximumDeflectionmm=4, WholeBody=0)
    response.Tool.Shape = "Sphere"
    response.Tool.Radiusmm = 6.35
    press = simple.Line(Point1=(0, 51, 0.4), Point2=(6, 47, 0.7), Resolution=40)
    probe = simple.ToolContactProbe(Body=response, Tips=press, FrictionCoefficient=0.3)
    dent = simple.ContactDeflection(Body=response, Tips=probe)
    return response, probe, dent


def numbers(proxies):
    """All arrays of the points. Those of bodies are sorted by coordinates, and each point occurs once."""
    result = {}
    for name, proxy in zip(("response", "probe", "dent"), proxies):
        data = servermanager.Fetch(proxy)
        order = slice(None)
        if name != "probe":
            order = np.unique(np.round(vtk_to_numpy(data.GetPoints().GetData()), 4) + 0.0, axis=0,
                              return_index=True)[1]
        arrays = data.GetPointData()
        for i in range(arrays.GetNumberOfArrays()):
            if arrays.GetArrayName(i) not in ("ContactCell", "ContactRank", "vtkGhostType", "Texture Coordinates",
                                               "RelativeError"):   # on one process only
                result[name, arrays.GetArrayName(i)] = vtk_to_numpy(arrays.GetArray(i))[order]
    return result


def compare(expected):
    ranks = servermanager.ActiveConnection.GetNumberOfDataPartitions()
    pipeline = build(ranks > 1)
    found = numbers(pipeline)
    assert set(found) == set(expected), set(found) ^ set(expected)
    for key, array in expected.items():
        size = np.abs(array.astype(float)).max()
        off = np.abs(found[key].astype(float) - array.astype(float)).max()
        assert off <= (0 if ranks == 1 else 1e-6 * size), (key, off, size)
    assert np.abs(expected["probe", "FrictionForce"]).max() > 0.01
    simple.Show(pipeline[2])
    simple.Render()
    return ranks


def run():
    simple.SaveData(FILE, simple.Sphere(Radius=50, ThetaResolution=80, PhiResolution=80), DataMode="Binary")
    expected = numbers(build(False))
    simple.ResetSession()
    server, port, said = start_server()
    try:
        simple.Connect("127.0.0.1", port)
        assert servermanager.ActiveConnection.IsRemote()
        simple.LoadPlugin(PLUGIN, remote=True)
        simple.LoadPlugin(PLUGIN, remote=False, ns=globals())
        ranks = compare(expected)
        assert not any("ERR|" in line for line in said), "".join(said)
        print("done", ranks, flush=True)
    finally:
        server.terminate()
        server.wait(60)
        os.remove(FILE)


if "mpiexec" in SERVER[0]:
    raw_xml.need_raw_xml()
try:
    run()
except BaseException: # noqa: the exception is printed; a normal exit would contact a server that no longer exists
    traceback.print_exc()
    sys.stderr.flush()
    os._exit(1)
os._exit(0)
