# SPDX-License-Identifier: BSD-3-Clause
"""A force device as a separate program, for `palpate --device bridge:unix:PATH`. It implements the 64-byte reports of
Interactors/Transports/PROTOCOL.md. SI units.

    with BridgePeer(path) as peer:
        peer.position = (0, 0, -0.011)     target of the hand, m; the hand moves there at 30 mm/s
        peer.forces                        forces from the host: (time.monotonic(), enabled, x, y, z), s and N
"""
import math
import socket
import struct
import threading
import time
import zlib

STATE, FORCE, DESCRIPTION, HELLO = 1, 2, 3, 4
PERIOD = 1e-3  # s
SPEED = 0.03  # m/s


def report(kind, flags, body):
    head = struct.pack("<BBBB", 0x50, kind, 1, flags) + body
    head = head.ljust(60, b"\0")
    return head + struct.pack("<I", zlib.crc32(head))


def description(nonce):
    """Describes the device: 6 N, 2500 N/m, 4000 N/s, 8 N s/m, 80 mm, 1 kHz, time-out 0.1 s, because a busy test machine
    may pause."""
    body = struct.pack("<9f", 6.0, 2500.0, 4000.0, 8.0, 0.08, 0.08, 0.08, 1000.0, 0.1)
    return report(DESCRIPTION, 1, body.ljust(52, b"\0") + struct.pack("<I", nonce))


class BridgePeer:
    def __init__(self, path):
        self.position = (0.0, 0.0, 0.0)
        self.forces = []
        self._hand = (0.0, 0.0, 0.0)
        self._host = None
        self._sequence = 0
        self._begin = time.monotonic()
        self._socket = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        self._socket.bind(str(path))
        self._socket.setblocking(False)
        self._ends = threading.Event()
        self._thread = threading.Thread(target=self._run)

    def __enter__(self):
        self._thread.start()
        return self

    def __exit__(self, *_):
        self._ends.set()
        self._thread.join()
        self._socket.close()

    def is_pushing(self):
        """Whether the last force report contains a force."""
        return bool(self.forces) and math.dist(self.forces[-1][2:], (0, 0, 0)) > 0.05

    def _run(self):
        while not self._ends.wait(PERIOD):
            self._receive_all()
            self._move()
            self._send_state()

    def _receive_all(self):
        while True:
            try:
                data, sender = self._socket.recvfrom(65)
            except BlockingIOError:
                return
            if data[1] == HELLO:
                self._host = sender
                self._send(description(struct.unpack_from("<I", data, 4)[0]))
            elif data[1] == FORCE:
                self.forces.append(
                    (time.monotonic(), bool(data[3] & 1), *struct.unpack_from("<3f", data, 16)))

    def _move(self):
        way = [to - at for to, at in zip(self.position, self._hand)]
        share = min(1.0, SPEED * PERIOD / max(math.hypot(*way), 1e-12))
        self._hand = tuple(at + share * step for at, step in zip(self._hand, way))

    def _send_state(self):
        self._sequence += 1
        clock = int(1e6 * (time.monotonic() - self._begin))
        self._send(report(STATE, 1, struct.pack("<IQ3f", self._sequence, clock, *self._hand)))

    def _send(self, data):
        if self._host:
            try:
                self._socket.sendto(data, self._host)
            except OSError:
                pass  # the host has ended or does not read; a device would not detect that either
