# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes brash.1.gz, changelog.gz and changelog.Debian.gz: documents.py PROGRAM SOURCES FOLDER MAINTAINER

The manual page is the program's help. The date is that of the release in CITATION.cff, so the same sources give the
same bytes.
"""
import datetime
import email.utils
import gzip
import pathlib
import re
import subprocess
import sys

HEAD = r""".TH BRASH 1 "{date}" "brash {version}" "User Commands"
.SH NAME
brash \- simulate how a structure breaks floating ice
.SH SYNOPSIS
.B brash
.I COMMAND
[\fIARGUMENTS\fR]
.SH DESCRIPTION
A structure is driven into an ice sheet. The sheet is cut by exact cracks where a failure model says that it breaks; the
floes are rigid bodies in water; the loads go to statistics. Each command explains itself with
.BR "brash COMMAND \-\-help" .
"""
TAIL = r""".SH FILES
.TP
.I /usr/share/brash/examples
the files that the tutorials read in \fIexperiments\fR; \fIvalidation/cone.toml\fR is a case to begin with
.TP
.I /usr/share/brash/models
failure models; \fBBRASH_MODEL_PATH\fR names another folder
.TP
.I /usr/share/doc/brash/docs
tutorials, theory and reference
"""
DEBIAN = """brash ({version}-1) unstable; urgency=medium

  * Version {version}; changelog.gz tells what is new.

 -- {maintainer}  {date}
"""


def roff(text):
    """Literal text in roff: backslashes, hyphens and lines that begin like a request are escaped."""
    return re.sub(r"^([.'])", r"\\&\1", text.replace("\\", r"\e").replace("-", r"\-"), flags=re.MULTILINE)


def helps(program, path=()):
    text = subprocess.run([program, *path, "--help"], check=True, capture_output=True, text=True).stdout
    if path:
        yield f'.SS "brash {" ".join(path)}"\n.nf\n{roff(text)}.fi\n'
    for command in re.findall(r"^  ([a-z]+) +\S", text.partition("Subcommands:")[2], re.MULTILINE):
        yield from helps(program, (*path, command))


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(gzip.compress(text.encode(), 9, mtime=0))


def main():
    program, sources, folder, maintainer = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]), sys.argv[4]
    citation = (sources / "CITATION.cff").read_text()
    # The program adds its commit between releases, but a Debian version has no blanks.
    released, version = (re.search(rf"^{key}: *(\S+)$", citation, re.MULTILINE)[1] for key in ("date-released", "version"))
    date = datetime.datetime.fromisoformat(released).replace(tzinfo=datetime.timezone.utc)
    page = HEAD.format(date=released, version=version) + ".SH COMMANDS\n" + "".join(helps(program)) + TAIL
    write(folder / "brash.1.gz", page)
    write(folder / "changelog.gz", (sources / "CHANGELOG.md").read_text())
    write(folder / "changelog.Debian.gz",
          DEBIAN.format(version=version, maintainer=maintainer, date=email.utils.format_datetime(date)))


if __name__ == "__main__":
    main()
