# SPDX-License-Identifier: GPL-3.0-or-later
"""What the compiler and the linker were asked for stands in the program and in the Python module."""
import os
import re
import subprocess
import unittest

from common import BRASH

MODULE = os.environ["BRASH_MODULE"]


def readelf(*words):
    return subprocess.run(["readelf", "--wide", *words], check=True, capture_output=True, text=True).stdout


@unittest.skipIf(bool(os.environ.get("BRASH_SANITIZE")), "sanitizers bring their own")
class Binary(unittest.TestCase):
    def test_the_table_of_the_loader_is_full_at_the_start_and_then_read_only(self):
        for file in (BRASH, MODULE):
            self.assertIn("GNU_RELRO", readelf("--program-headers", file))
            dynamic = readelf("--dynamic", file)
            self.assertTrue("BIND_NOW" in dynamic or re.search(r"FLAGS.*NOW", dynamic), file)
        self.assertRegex(readelf("--file-header", BRASH), r"Type:\s+DYN")

    def test_no_stack_can_be_executed(self):
        for file in (BRASH, MODULE):
            stack = next(line for line in readelf("--program-headers", file).splitlines() if "GNU_STACK" in line)
            self.assertIn("RW ", stack)
            self.assertNotIn("RWE", stack)

    def test_stacks_and_buffers_are_guarded(self):
        if not os.environ.get("BRASH_FORTIFIED"):
            self.skipTest("built without optimisation")
        for file in (BRASH, MODULE):
            symbols = readelf("--dyn-syms", file)
            self.assertIn("__stack_chk_fail", symbols, file)
            self.assertRegex(symbols, r"__(mem|str|v?s?n?printf|read|realpath|fdelt|explicit)\w*_chk", file)

    def test_jumps_land_where_they_may(self):
        # The loader's note needs every object, also those of the C library; the code is what counts here.
        if os.uname().machine != "x86_64":
            self.skipTest("no CET on this machine")
        for file in (BRASH, MODULE):
            code = subprocess.run(["objdump", "--disassemble", "--no-show-raw-insn", "--section=.text", file],
                                  check=True, capture_output=True, text=True).stdout
            self.assertGreater(code.count("endbr64"), 500, file)


if __name__ == "__main__":
    unittest.main()
