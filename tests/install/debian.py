# SPDX-License-Identifier: GPL-3.0-or-later
"""A bare Debian in a folder, made by debootstrap from the mirrors and with the settings that this machine's apt has."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

SUITES = {"12": "bookworm", "13": "trixie"}
# Mounts end with the command that made them, and so do the processes that it leaves behind.
ENTER = ("unshare", "--mount", "--pid", "--fork", "--kill-child", "sh", "-ec",
         'mount -t proc proc "$0/proc"; mount -t tmpfs tmpfs "$0/dev/shm"; exec chroot "$0" "$@"')
ENVIRONMENT = {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "DEBIAN_FRONTEND": "noninteractive", "HOME": "/root",
               "LC_ALL": "C.UTF-8"}


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def missing():
    """What this machine lacks to make a Debian, as words of a message; empty if it lacks nothing."""
    needed = (("root", os.geteuid() == 0), ("debootstrap", shutil.which("debootstrap")))
    return " and ".join(name for name, there in needed if not there)


def sources(suite):
    """Pairs of mirror and suite for another Debian: the ones that apt has here, $DEBIAN_MIRROR before them."""
    here = re.search(r"^VERSION_CODENAME=(\w+)", pathlib.Path("/etc/os-release").read_text(), re.MULTILINE)[1]
    known = re.findall(r"^'(\S+)/dists/(\S+)/InRelease'", output("apt-get", "update", "--print-uris"), re.MULTILINE)
    pairs = [(mirror, name.replace(here, suite)) for mirror, name in known
             if here in SUITES.values() and re.fullmatch(f"{here}(-updates|-security)?", name)]
    if "DEBIAN_MIRROR" in os.environ:
        pairs.insert(0, (os.environ["DEBIAN_MIRROR"], suite))
    if suite not in (name for _, name in pairs):
        sys.exit(f"no mirror of Debian: apt has none for {here}. Set DEBIAN_MIRROR to the address of one.")
    return pairs


class Debian:
    """A Debian of debootstrap's smallest kind. A call runs a shell command in it."""

    def __init__(self, folder, release):
        """Makes Debian `release`, a key of SUITES, in `folder`, or takes the complete one that is there."""
        self.path = pathlib.Path(folder).resolve()
        self.complete = self.path / "etc/apt/sources.list.d/brash.list"
        if not self.complete.exists():
            self._make(SUITES[release])

    def _make(self, suite):
        pairs = sources(suite)
        mirror = next(mirror for mirror, name in pairs if name == suite)
        proxy = re.search(r"='(.*)'", output("apt-config", "shell", "proxy", "Acquire::http::Proxy"))
        remove(self.path)
        subprocess.run(["debootstrap", "--variant=minbase", suite, self.path, mirror], check=True, stdout=subprocess.DEVNULL,
                       env={**os.environ, **({"http_proxy": proxy[1]} if proxy else {})})
        for name in ("hosts", "resolv.conf"):
            shutil.copy(f"/etc/{name}", self.path / "etc")
        # Certificates that an administrator added: npm needs them there where it needs them here.
        added = pathlib.Path("/usr/local/share/ca-certificates")
        if added.is_dir():
            shutil.copytree(added, self.path / added.relative_to("/"), dirs_exist_ok=True)
        (self.path / "etc/apt/apt.conf.d/90acquire").write_text(output("apt-config", "dump", "Acquire"))
        # dpkg is several times faster when it does not wait for the disk; nobody needs this Debian after a power cut.
        (self.path / "etc/dpkg/dpkg.cfg.d/unsafe-io").write_text("force-unsafe-io\n")
        (self.path / "etc/apt/sources.list").unlink()
        self.complete.write_text("".join(f"deb {mirror} {name} main\n" for mirror, name in pairs))

    def run(self, command, **options):
        """Runs `command`, as subprocess.run does with these options."""
        return subprocess.run([*ENTER, self.path, "sh", "-ec", command], env=ENVIRONMENT, text=True, check=False, **options)

    def __call__(self, command):
        """What `command` prints; an error with the same text if it fails."""
        done = self.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode != 0:
            raise AssertionError(f"{command}\n{done.stdout}")
        return done.stdout

    def files(self):
        """All names below the folder, relative to it."""
        return output("find", self.path, "-xdev", "-printf", "%P\n").splitlines()


def remove(folder):
    """Removes a Debian, but nothing that is mounted in it."""
    subprocess.run(["rm", "-rf", "--one-file-system", folder], check=True)
