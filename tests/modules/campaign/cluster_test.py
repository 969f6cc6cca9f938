# SPDX-License-Identifier: GPL-3.0-or-later
"""What `./dev slurm up` configures, without starting it: loopback only, and a key that its owner alone may read."""
import os
import pathlib
import re
import stat
import tempfile
import unittest

import cluster


class Configuration(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name) / "slurm"
        before = os.umask(0)  # the worst one
        self.addCleanup(os.umask, before)
        cluster.prepare(self.folder)
        self.text = (self.folder / "slurm.conf").read_text(encoding="utf-8")

    def values(self, key):
        return re.findall(rf"\b{key}=(\S+)", self.text)

    def mode(self, name):
        return stat.S_IMODE((self.folder / name).stat().st_mode)

    def test_the_daemons_listen_on_the_loopback_address_only(self):
        self.assertEqual(self.values("CommunicationParameters"), ["NoInAddrAny,NoCtldInAddrAny"])
        self.assertTrue(all(value.endswith("(127.0.0.1)") for value in self.values("SlurmctldHost")))
        self.assertEqual(self.values("NodeAddr"), ["127.0.0.1"] * len(cluster.NODES))
        ports = self.values("SlurmctldPort") + self.values("Port")
        self.assertEqual(len(set(ports)), 1 + len(cluster.NODES))

    def test_the_key_is_private_random_and_the_one_that_is_used(self):
        self.assertEqual(self.mode("munge.key"), 0o400)
        self.assertEqual(self.mode("."), 0o700)
        key = (self.folder / "munge.key").read_bytes()
        self.assertEqual(len(key), 1024)
        self.assertGreater(len(set(key)), 200)
        self.assertIn(f"--key-file={self.folder}/munge.key", cluster.munged(self.folder))
        self.assertEqual(self.values("AuthType"), ["auth/munge"])
        self.assertEqual(self.values("CryptoType"), ["crypto/munge"])
        self.assertEqual(self.values("AuthInfo"), [f"socket={self.folder}/munge.socket"])

    def test_an_old_key_is_not_taken(self):
        with self.assertRaises(FileExistsError):
            cluster.make_key(self.folder)

    def test_everything_lies_in_the_folder_and_runs_as_its_owner(self):
        for key in ("StateSaveLocation", "SlurmctldPidFile", "SlurmctldLogFile", "SlurmdPidFile", "SlurmdLogFile", "SlurmdSpoolDir"):
            self.assertTrue(all(value.startswith(f"{self.folder}/") for value in self.values(key)), key)
        for name in ("state", *(f"spool-{node}" for node in cluster.NODES)):
            self.assertEqual(self.mode(name), 0o700)
        self.assertEqual(self.values("SlurmUser"), self.values("SlurmdUser"))


if __name__ == "__main__":
    unittest.main()
