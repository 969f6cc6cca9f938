#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Memory and time of a watched run under attack, beside those of a run alone.

live_attacks.py BRASH CASE FOLDER [DURATION]

Each kind of attack lasts as long as a run of the case. Results must be those of the run alone.
"""
import collections
import os
import re
import shutil
import socket
import subprocess
import sys
import threading
import time
from pathlib import Path
from urllib.parse import urlparse

RESULTS = ["run.nc", "history.csv", "events.csv", "summary.json"]
GIGABYTE = 1 << 30
PIECE = b"X-Filler: " + 1014 * b"a" + b"\r\n"


class Client:
    """A client that attacks the server at `address`; `counts` keeps the answers."""

    def __init__(self, address, counts):
        self.url, self.counts = urlparse(address), counts
        self.host = f"Host: {self.url.netloc}\r\n"

    def connect(self):
        return socket.create_connection((self.url.hostname, self.url.port), timeout=10)

    def ask(self, request):
        """Sends a request; counts the status."""
        with self.connect() as connection:
            connection.sendall(request.encode())
            self.counts["answer " + (connection.recv(64).decode(errors="replace").split(" ") + ["none", "none"])[1]] += 1

    def pour(self, first, piece):
        """Sends `first`, and then up to a gigabyte of pieces."""
        with self.connect() as connection:
            connection.sendall(first.encode())
            sent = 0
            try:
                while sent < GIGABYTE:
                    sent += connection.send(piece)
            finally:
                self.counts["most bytes taken"] = max(self.counts["most bytes taken"], sent)

    # Each of these is done again and again.
    def nothing(self):
        with self.connect() as connection:
            connection.recv(1)
        self.counts["connections ended by the server"] += 1

    def header(self):
        self.pour(f"GET {self.url.path} HTTP/1.1\r\n{self.host}", PIECE)

    def header_without_token(self):
        self.pour(f"GET / HTTP/1.1\r\n{self.host}", PIECE)

    def body(self):
        self.pour(f"POST {self.url.path}pause HTTP/1.1\r\n{self.host}Content-Length: {GIGABYTE}\r\n\r\n", PIECE)

    def chunks(self):
        self.pour(f"POST {self.url.path}pause HTTP/1.1\r\n{self.host}Transfer-Encoding: chunked\r\n\r\n", b"400\r\n" + 1024 * b"a" + b"\r\n")

    def slow(self):
        with self.connect() as connection:
            for letter in f"GET {self.url.path} HTTP/1.1\r\n{self.host}\r\n":
                connection.send(letter.encode())
                time.sleep(0.5)

    def deaf(self):
        """Watches, and takes no byte of the stream."""
        with self.connect() as connection:
            connection.sendall(f"GET {self.url.path}events HTTP/1.1\r\n{self.host}\r\n".encode())
            time.sleep(60)

    def strange(self):
        for lines in ("Host: evil.example\r\n", f"Host: evil.example:{self.url.port}\r\n",
                      self.host + "Origin: http://evil.example\r\n", self.host + "Origin: null\r\n"):
            self.ask(f"POST {self.url.path}stop HTTP/1.1\r\n{lines}\r\n")
        self.ask(f"POST /{32 * '0'}/stop HTTP/1.1\r\n{self.host}\r\n")


ATTACKS = {"1000 connections": ("nothing", 1000), "a gigabyte of header": ("header", 4),
           "the same without the token": ("header_without_token", 4), "a gigabyte of body": ("body", 4),
           "a gigabyte in chunks": ("chunks", 4), "slow clients": ("slow", 100), "deaf watchers": ("deaf", 50),
           "wrong hosts, origins and tokens": ("strange", 8)}


class Watched:
    """A run, with the most memory that it held."""

    def __init__(self, command):
        self.begun, self.kilobytes, self.said = time.monotonic(), 0, ""
        self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        self.found = threading.Event()
        threading.Thread(target=self.listen, daemon=True).start()

    def listen(self):
        for line in self.process.stderr:
            self.said += line
            if "watch at" in line:
                self.found.set()

    def end(self):
        """Waits for the end; seconds of wall and processor time, and the most memory [MB]."""
        _, status, usage = os.wait4(self.process.pid, 0)
        if status:
            raise RuntimeError(self.said)
        return time.monotonic() - self.begun, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def attack(address, what, n, run):
    counts, end = collections.Counter(), threading.Event()

    def again_and_again():
        client = Client(address, counts)
        while not end.is_set():
            try:
                getattr(client, what)()
                counts["done"] += 1
            except OSError as error:
                counts[type(error).__name__] += 1
            time.sleep(0.05)

    threading.stack_size(256 * 1024)
    for _ in range(n):
        threading.Thread(target=again_and_again, daemon=True).start()
    figures = run.end()
    end.set()
    return figures, counts


def main():
    brash, case, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    duration = sys.argv[4] if len(sys.argv) > 4 else "8"
    shutil.rmtree(folder, ignore_errors=True)
    command = [brash, "run", case, "--threads", "1", "--set", f"time.duration={duration}", "--set",
               "output.statistics_from=0", "-o"]
    print("attack                                wall [s]  processor [s]  most memory [MB]")
    alone = Watched([*command, folder / "alone"]).end()
    print("{:36} {:9.1f} {:14.1f} {:17.0f}".format("none, not watched", *alone))
    whole = [(folder / "alone" / name).read_bytes() for name in RESULTS]
    faults = 0
    for name, (what, n) in ATTACKS.items():
        run = Watched([*command, folder / "watched", "--replace", "--view"])
        run.found.wait()
        figures, counts = attack(re.search(r"watch at  (\S+)", run.said).group(1), what, n, run)
        same = whole == [(folder / "watched" / name).read_bytes() for name in RESULTS]
        faults += not same or figures[2] > alone[2] + 100
        print("{:36} {:9.1f} {:14.1f} {:17.0f}  {}{}".format(name, *figures, dict(counts), "" if same else "  OTHER RESULTS"),
              flush=True)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
