# SPDX-License-Identifier: GPL-3.0-or-later
"""The version of CMakeLists.txt is the one that citation, metadata and changelog name: docs/releasing.md."""
import json
import os
import pathlib
import re
import unittest

import yaml

SOURCE = pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
VERSION = re.search(r"project\(brash VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text())[1]
CITATION = yaml.safe_load((SOURCE / "CITATION.cff").read_text(encoding="utf-8"))
METADATA = json.loads((SOURCE / "codemeta.json").read_text(encoding="utf-8"))
HEADINGS = re.findall(r"^## (.*)$", (SOURCE / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE)


class Release(unittest.TestCase):
    def test_citation_and_metadata_name_the_version_of_the_build(self):
        self.assertEqual(CITATION["version"], VERSION)
        self.assertEqual(METADATA["version"], VERSION)
        self.assertEqual(str(CITATION["date-released"]), METADATA["datePublished"])

    def test_the_newest_cut_of_the_changelog_is_that_version_on_that_day(self):
        self.assertEqual(HEADINGS[0], "Unreleased")
        for heading in HEADINGS[1:]:
            self.assertRegex(heading, r"^\d+\.\d+\.\d+ - \d{4}-\d\d-\d\d$")
        # Nothing has been cut before 0.2.0.
        if VERSION != "0.1.0":
            self.assertEqual(HEADINGS[1:2], [f"{VERSION} - {CITATION['date-released']}"])
        self.assertEqual(HEADINGS[1:], sorted(HEADINGS[1:], key=lambda h: [int(n) for n in h.split()[0].split(".")], reverse=True))

    def test_citation_and_metadata_say_the_same(self):
        self.assertEqual(METADATA["description"], CITATION["abstract"])
        self.assertEqual(METADATA["keywords"], CITATION["keywords"])
        self.assertTrue(METADATA["license"].endswith("/" + CITATION["license"]))
        for path in (METADATA["readme"], METADATA["buildInstructions"]):
            self.assertTrue((SOURCE / path).is_file(), path)

    def test_each_reference_names_what_it_is_for_and_dois_are_dois(self):
        for reference in CITATION["references"]:
            self.assertLessEqual({"type", "title", "authors", "year", "notes"}, set(reference), reference["title"])
            if "doi" in reference:
                self.assertRegex(reference["doi"], r"^10\.\d{4,}/\S+$")
        cited_by_reports = (SOURCE / "modules/report/viewer/src/bibliography.ts").read_text(encoding="utf-8")
        dois = {reference["doi"] for reference in CITATION["references"] if "doi" in reference}
        self.assertLessEqual(set(re.findall(r'doi: "([^"]*)"', cited_by_reports)), dois)


if __name__ == "__main__":
    unittest.main()
