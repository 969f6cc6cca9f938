# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of campaigns share."""
from pathlib import Path

HERE = Path(__file__).resolve().parent
PLAN = HERE / "plan.toml"
DATABASE_PLAN = HERE / "database_plan.toml"
#: What may differ between two runs of one campaign: times and hosts, locks.
VOLATILE = {"manifest.json", "ro-crate-metadata.json", "campaign.lock"}


def files_of(folder):
    """The bytes of every file of a campaign that must not depend on where and in what order its cases ran."""
    files = (p for p in folder.rglob("*") if p.is_file() and p.name not in VOLATILE and folder / "slurm" not in p.parents)
    return {str(p.relative_to(folder)): p.read_bytes() for p in files}


def different(one, other):
    """Names of the files that two campaigns do not have alike."""
    ours, theirs = files_of(one), files_of(other)
    return sorted(name for name in ours.keys() | theirs.keys() if ours.get(name) != theirs.get(name))
