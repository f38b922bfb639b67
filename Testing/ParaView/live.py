# SPDX-License-Identifier: BSD-3-Clause
"""Plays Live*.xml, the dock Live Touch, in the ParaView program, with a simulated device that receives the forces.

    pvpython live.py PARAVIEW FOLDER-OF-EVENTS FOLDER [NAME...]      needs an X server

The device is this script: the 64-byte reports (Interactors/Transports/PROTOCOL.md) over a local socket. It moves into
the body and stores every force that it receives.
"""
import binascii
import os
import socket
import struct
import subprocess
import sys
import threading
import time
import numpy as np
import palpate
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

program, events, folder = sys.argv[1:4]
chosen = sys.argv[4:]
if not os.environ.get("DISPLAY"):
    print("no DISPLAY: the program was not started")
    sys.exit(77)
STATE, FORCE, DESCRIPTION, HELLO = 1, 2, 3, 4
RATE = 500.0        # states per second
DEEP = 11.5e-3      # m, how far the hand moves below its origin, which is 10 mm above the surface
REDUCED = 0.1 / (1 - 0.45**2)  # MPa, the default material


def report(kind, flags, content):
    head = struct.pack("<4B", 0x50, kind, 1, flags) + content
    head += bytes(60 - len(head))
    return head + struct.pack("<I", binascii.crc32(head))


class Hand(threading.Thread):
    """A device that moves 1.5 mm into the body, against the surface normal at the handle's initial position."""

    def __init__(self):
        super().__init__(daemon=True)
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))
        self.socket.settimeout(1 / RATE)
        self.name = f"bridge:udp:{self.socket.getsockname()[1]}"
        self.forces = []     # for each force report: time, enabled, size in N
        self.ending = False

    def run(self):
        host, begin, sequence = None, None, 0
        # The view looks along -z, and up is y, so device and body have the same axes. The handle
        # begins at the initial position of a touch. Perspective changes the direction by up to 5
        # degrees, which reduces the depth by 0.05 mm.
        start = [0.0, 0.0, 0.0]
        assert palpate.vtkToolTouch.FindStart(read_body(), "Response", (0, 0, 1), (0, 1, 0), start)
        inward = -np.array(start) / np.linalg.norm(start)
        due = time.monotonic()
        while not self.ending:
            try:
                data, sender = self.socket.recvfrom(256)
            except socket.timeout:
                data = b""
            now = time.monotonic()
            if len(data) == 64 and data[1] == HELLO:
                host, begin = sender, begin or now
                answer = struct.pack("<4f3f2f16sI", 5, 2000, 1e4, 10, 0.1, 0.1, 0.1, RATE, 0.1, b"Palpate test",
                                     struct.unpack_from("<I", data, 4)[0])
                self.socket.sendto(report(DESCRIPTION, 1, answer), host)
            elif len(data) == 64 and data[1] == FORCE:
                self.forces.append((now, data[3] & 1, np.linalg.norm(struct.unpack_from("<3f", data, 16))))
            if host and now >= due:
                due = now + 1 / RATE
                sequence += 1
                at = inward * DEEP * np.clip((now - begin - 0.5) / 1.0, 0, 1)
                self.socket.sendto(report(STATE, 1, struct.pack("<IQ3f3fII", sequence, int(now * 1e6), *at, 0, 0, 0,
                                                                0, 0)), host)


def play(name, hand=None, *options):
    """Plays name.xml. Returns the time at which the program had ended."""
    with open(f"{events}/{name}.xml", encoding="utf-8") as file:
        text = file.read().replace("@DEVICE@", hand.name if hand else "")
    script = f"{folder}/{name}.xml"
    with open(script, "w", encoding="utf-8") as file:
        file.write(text)
    data = [] if name == "LivePress" else [f"--data={folder}/live_body.vtp"]
    played = subprocess.run(
        [program, "--dr", *options, *data, "--test-script=" + script, "--test-directory=" + folder, "--exit"],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=240, check=False,
        env={**os.environ, "DASHBOARD_TEST_FROM_CTEST": "1"})    # ParaView asks no questions
    print(name, played.stdout)
    assert played.returncode == 0, (name, played.returncode)
    return time.monotonic()


def make_body():
    sphere = simple.Sphere(Radius=50, ThetaResolution=120, PhiResolution=120)
    simple.SaveData(folder + "/live_body.vtp", simple.ToolContactResponse(sphere, WholeBody=0), DataMode="Binary")


def read_body():
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(folder + "/live_body.vtp")
    reader.Update()
    return reader.GetOutput()


def read(name):
    """Red, green and blue of the pixels of a picture."""
    reader = vtkPNGReader()
    reader.SetFileName(f"{folder}/{name}")
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int).T


def press():
    # Expected numbers of LivePress.xml: a flat punch of 5 mm has F = 2 E* R d.
    for text, modulus, deep in (("1.254", 1.0, 1.0), ("0.627", 0.5, 1.0), ("0.313", 0.5, 0.5)):
        # The facets of the sphere reduce the depth by 1e-4 mm. The label has three digits.
        assert abs(float(text) - 2 * REDUCED * modulus * 5 * deep) < 6e-4
    for old in ("live_touched.png", "live_stopped.png"):
        if os.path.exists(f"{folder}/{old}"):
            os.remove(f"{folder}/{old}")
    play("LivePress")
    colours = {
        # An arrow for half of the response's largest force is a quarter of the body's length, 173
        # mm. The pixels of its label are included.
        "arrow": (lambda red, green, blue: (red > green + 60) & (red > blue + 80), 100),
        "handle": (lambda red, green, blue: (red > 200) & (green > 180) & (blue < 60), 20),
        # Behind the tool the warm white of the body looks grey. The background is bluer and darker.
        "tool": (lambda red, green, blue: (abs(red - blue) < 6) & (red > 110), 200)}
    touched, stopped = read("live_touched.png"), read("live_stopped.png")
    differs = (touched != stopped).any(axis=0)
    for part, (test, least) in colours.items():
        seen, left = (np.sum(test(*picture) & differs) for picture in (touched, stopped))
        print(part, seen, left)
        # A few pixels of the body's shaded rim have the same grey as the tool.
        assert seen > least and left <= seen / 50, part


def end_in_touch(name, quiet):
    """A script that ends the touch. The device has received a force, and its last report contains no force and is not
    enabled."""
    hand = Hand()
    hand.start()
    ended = play(name, hand)
    time.sleep(0.2)
    hand.ending = True
    hand.join()
    size = np.array([force for _, _, force in hand.forces])
    # Hertz's law of the 5 mm sphere at 1.5 mm; the exact sphere gives up to a tenth less.
    hertz = 4 / 3 * REDUCED * np.sqrt(5) * 1.5**1.5
    assert 0.8 * hertz < size.max() < 1.02 * hertz, (name, size.max(), hertz)
    moment, enabled, last = hand.forces[-1]
    assert (enabled, last) == (0, 0.0), (name, enabled, last)
    print(name, len(size), "forces, the last", ended - moment, "s before the end")
    assert ended - moment > quiet, (name, ended - moment)


def remote():
    server = os.path.join(os.path.dirname(program), "pvserver")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    with subprocess.Popen([server, f"--server-port={port}"], stdout=subprocess.PIPE, text=True) as running:
        try:
            while "Accepting connection" not in running.stdout.readline():
                assert running.poll() is None, "pvserver has ended"
            play("LiveRemote", None, f"--url=cs://127.0.0.1:{port}")
        finally:
            running.terminate()


cases = {
    "press": press,
    # The script continues for 1.5 s after the end of the touch. Nothing is sent in that time.
    "delete": lambda: end_in_touch("LiveDelete", 1.4),
    "close": lambda: end_in_touch("LiveCloseView", 1.4),
    "reset": lambda: end_in_touch("LiveReset", 1.4),
    "quit": lambda: end_in_touch("LiveQuit", 0.0),
    "led": lambda: play("LiveLed"),
    "remote": remote,
    "refused": lambda: play("LiveRefused"),
}
os.makedirs(folder, exist_ok=True)
make_body()
for case in chosen or cases:
    cases[case]()
