"""Tests the checks of generated pages: each has to report a figure that is changed in a page, in
its JSON, in prose, or in the engine's results."""

import json
import os
import re
import shutil
import tempfile
import unittest
from unittest import mock

import check_pages
import fresh
import history
import made
import measured
import page_figures
import prose
import readme
import sources

RESULTS = {"about": {"commit": "0123456789ab"}, "quick": False, "scenes": [
    {"scene": "gas", "size": n, "engines": [
        {"engine": "thud", "ms": 1.0}, {"engine": "box2d", "ms": ratio, "beside": {"ms": 7}}]}
    for n, ratio in ((100, 4.0), (400, 6.5))] + [
    {"scene": "pit", "size": 100, "engines": [{"engine": "thud", "ms": 2.5}]}]}


NONE = ("0123456789ab", "0" * 12)


def filled(text, **more):
    return page_figures.fill(text, RESULTS, **more)


class Figures(unittest.TestCase):
    def test_path_leads_to_one_figure(self):
        self.assertEqual(filled("{{scenes > gas & 400 > box2d > ms | .2f}}"), "6.50")
        self.assertEqual(filled("{{scenes > pit > thud > ms | * 1000 | ,.0f}} µs"), "2,500 µs")

    def test_least_and_most_of_ratios_are_of_the_same_element(self):
        path = "scenes > * > engines > box2d > ms | / scenes > * > engines > thud > ms"
        self.assertEqual(filled(f"{{{{least | {path} | .1f}}}} to {{{{most | {path} | .1f}}}}"),
                         "4.0 to 6.5")
        self.assertEqual(filled("{{most | scenes > * pit > engines > thud > ms | .1f}}"), "2.5")

    def test_path_to_none_or_several_is_refused(self):
        for path in ("scenes > gas > thud > ms", "scenes > heap > thud > ms", "scenes > pit > thud",
                     "scenes > * > engines > thud > ms", "nothing"):
            with self.assertRaises(ValueError, msg=path):
                filled("{{" + path + " | .1f}}")

    def test_run_that_was_not_whole_says_what_it_lacks(self):
        self.assertEqual(filled("{{heaps > a | .1f}}", whole=False), page_figures.NOT_MEASURED)

    def test_lines_are_even_again_and_code_stays_whole(self):
        text = filled("- A {{scenes > pit > thud > ms |\n  .1f}}\n  ms " + "word " * 25 + "`a b`\n\nAs\nis.")
        self.assertTrue(text.startswith("- A 2.5 ms word"), text)
        self.assertTrue(all(len(line) <= page_figures.WIDTH for line in text.split("\n")))
        self.assertTrue("`a b`" in text and text.endswith("\n\nAs\nis."), text)


class Prose(unittest.TestCase):
    def numbers(self, text):
        return [number for _, _, number in prose.stray_numbers(text)]

    def test_number_that_is_neither_figure_nor_given_nor_dated_is_found(self):
        self.assertEqual(self.numbers("It takes 46 ms, 2.5 times 10^3."), ["46", "2.5", "10^3"])
        self.assertEqual(self.numbers("It takes {{a | .0f}} ms, `x = 4`, [a](b3.md), v3.2, Box2D."), [])

    def test_what_is_given_is_so_in_its_phrase_alone(self):
        given = "\n<!-- given: 4 substeps; over\n256 pairs -->\n"
        self.assertEqual(self.numbers("At 4 substeps, over 256\npairs" + given), [])
        self.assertEqual(self.numbers("At 4 ms, over 256 pairs." + given), ["4"])
        self.assertEqual(prose.stray_phrases("At 4 substeps." + given), ["over 256 pairs"])

    def test_history_has_a_date_in_its_paragraph_item_row_or_heading(self):
        dated = "(as of 2026-01-02, commit\n0123456789ab)"
        self.assertEqual(self.numbers(f"It took 46 ms {dated}.\n\nIt takes 45 ms."), ["45"])
        self.assertEqual(self.numbers(f"- It took 46 ms {dated}.\n- It takes 45 ms."), ["45"])
        self.assertEqual(self.numbers("| 46 " + dated.replace("\n", " ") + " |\n| 45 |"), ["45"])
        heading = "## Then " + dated.replace("\n", " ")
        self.assertEqual(self.numbers(f"{heading}\n\n46\n\n### More\n\n47\n\n## Now\n\n45\n"), ["45"])

    def test_line_of_what_is_found_is_told(self):
        self.assertEqual(prose.stray_numbers("a\n\nb\nc 7 d\n"), [(4, "c 7 d", "7")])


class Sources(unittest.TestCase):
    NOTES = "# Figures\n\n## a.h\n\na pit takes {{scenes > pit | .1f}} ms a\nstep\n\n<!-- given: 60 % of it -->\n"
    SOURCE = "/* 60 % of it;\n * a pit takes 2.5\n * ms a step. */\n"

    def wrong(self, source):
        with mock.patch.object(page_figures.Figures, "find", lambda self, path: [((), 2.5)]):
            return sources.wrong_in("a.h", source, self.NOTES)

    def test_phrase_is_found_over_the_ends_of_lines_of_comments(self):
        self.assertEqual(self.wrong(self.SOURCE), [])

    def test_other_figure_is_noticed_and_written_in_its_place(self):
        changed = self.SOURCE.replace("2.5", "1,300")
        self.assertIn("a.h has other figures", self.wrong(changed)[0])
        with mock.patch.object(page_figures.Figures, "find", lambda self, path: [((), 2.5)]):
            self.assertEqual(sources.filled(changed, sources.phrases_of(self.NOTES)["a.h"]), self.SOURCE)

    def test_phrase_that_is_gone_and_number_that_nobody_knows_are_noticed(self):
        self.assertIn("stands there 0 times", self.wrong("/* 60 % of it */")[0])
        self.assertEqual(self.wrong(self.SOURCE + "// twice: 85 times\n"),
                         ["a.h:4: '85 times' is neither a figure of the JSON nor given"])
        self.assertEqual(self.wrong(self.SOURCE.replace("60 %", "half")),
                         ["a.h: '60 % of it' is given and not written"])


class Pages(unittest.TestCase):
    """Tests with a copy of the pages of docs/ that is changed."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.docs = os.path.join(scratch.name, "docs")
        shutil.copytree(measured.DOCS, self.docs)
        # As if the whole history were there; the tests also run without it.
        known = mock.patch.object(history, "why_not", lambda commit: "none" if commit in NONE else None)
        known.start()
        self.addCleanup(known.stop)

    def spoil(self, name, change):
        path = os.path.join(self.docs, name)
        text = made.read(path)
        self.assertNotEqual(change(text), text)
        with open(path, "w", encoding="utf-8") as file:
            file.write(change(text))

    def spoil_json(self, page, change):
        def changed(text):
            results = json.loads(text)
            change(results)
            return json.dumps(results)
        self.spoil(page_figures.PAGES[page], changed)

    def test_figure_changed_in_a_page_is_noticed(self):
        self.spoil("stability.md", lambda text: text.replace("0.4773", "0.3773"))
        self.assertIn("docs/stability.md is not what stability.json", made.not_as_made(
            "stability", self.docs)[0])

    def test_figure_changed_in_a_picture_is_noticed(self):
        self.spoil("pictures/catalogue-levels.svg", lambda text: text.replace("<circle", "<ellipse"))
        self.assertIn("catalogue-levels.svg", made.not_as_made("catalogue", self.docs)[0])

    def test_figure_changed_in_the_json_is_noticed_in_page_and_readme(self):
        def twice(results):
            for scene in results["scenes"]:
                scene["engines"][1]["ms_median"] *= 2
        self.spoil_json("performance", twice)
        self.assertTrue(any("performance.md" in line
                            for line in made.not_as_made("performance", self.docs)))
        self.assertTrue(any("README.md has other figures" in line
                            for line in made.loose_documents(self.docs)))

    def test_figure_changed_in_the_json_is_noticed_in_headers_and_typings(self):
        def dearer(results):
            for row in results["growth"]:
                row["grid"]["ns_per_shape"] = 1234
        self.assertEqual(sources.wrong(self.docs), [])
        self.spoil_json("catalogue", dearer)
        self.assertEqual([line.split(" ")[0] for line in sources.wrong(self.docs)],
                         ["engine/include/thud/thud_detection.h"])

    def test_page_of_a_dirty_or_another_commit_is_refused(self):
        for commit in ("0123456789ab-dirty", "unknown", "0123456789ab"):
            self.spoil("tradeoff.md", lambda text: text.replace(
                measured.LINE.search(text).group(1), commit) if measured.LINE.search(text) else text + " ")
            self.assertNotEqual(made.wrong_commit("tradeoff", self.docs), [], commit)

    def test_run_that_was_not_whole_is_refused(self):
        self.spoil_json("tradeoff", lambda results: results["missing"].append("gas"))
        self.assertIn("was not whole", " ".join(made.wrong_commit("tradeoff", self.docs)))

    def test_measured_page_that_nothing_checks_is_noticed(self):
        with open(os.path.join(self.docs, "new.md"), "w", encoding="utf-8") as file:
            file.write("# New\n\nMeasured at commit 0123456789ab on 2026-01-02, p.\n")
        self.assertEqual(len(made.uncovered(self.docs)), 1)

    def test_picture_without_a_commit_is_noticed(self):
        self.assertEqual(made.pictures_without_commit(self.docs), [])
        self.spoil("pictures/pictures.json", lambda text: text.replace('"phone"', '"tablet"'))
        self.assertEqual(len(made.pictures_without_commit(self.docs)), 2)
        self.spoil("pictures/pictures.json", lambda text: text.replace('"tablet"', '"phone"'))
        self.spoil("pictures/pictures.json", lambda text: re.sub('(?<="commit": ").{12}', "0" * 12, text))
        self.assertEqual(len(made.pictures_without_commit(self.docs)), 14)

    def test_readme_with_an_old_figure_is_noticed(self):
        for name, heading in (("README.md", "## In C\n"), ("docs/features.md", "# What thud does\n")):
            text, notes = made.read(readme.path_of(name)), made.read(readme.DOCUMENTS[name])
            self.assertEqual(readme.stray_numbers(text, notes), [])
            extra = text.replace(heading, f"{heading}\nA step takes 4.2 ms.\n")
            self.assertEqual([found[2] for found in readme.stray_numbers(extra, notes)], ["4.2 ms"])


class Commits(unittest.TestCase):
    def test_run_on_a_changed_tree_does_not_write_to_docs(self):
        for commit in ("0123456789ab-dirty", "unknown", ""):
            with self.assertRaises(ValueError, msg=commit):
                measured.refuse_unnamed(measured.DOCS, commit)
            measured.refuse_unnamed("/tmp", commit)
        measured.refuse_unnamed(measured.DOCS, "0123456789ab")

    def test_commit_that_is_none_is_noticed_only_where_that_can_be_told(self):
        def git(shallow):
            return lambda *words: shallow if words[0] == "rev-parse" else None
        for shallow, wrong in (("false\n", True), ("true\n", False), (None, False)):
            with mock.patch.object(history, "git", git(shallow)):
                self.assertEqual(bool(history.why_not("0123456789ab")), wrong, shallow)
                self.assertIsNone(history.since("0123456789ab"))


class Fresh(unittest.TestCase):
    def kept(self):
        return page_figures.read_page("tradeoff")

    def test_figure_that_the_engine_no_longer_reaches_is_named(self):
        anew = self.kept()
        self.assertEqual(fresh.off("tradeoff", self.kept(), anew), [])
        anew["cases"][0]["points"][0]["error"] *= 1.3
        found = fresh.off("tradeoff", self.kept(), anew)
        self.assertEqual(len(found), 1)
        self.assertTrue(found[0].startswith("column_30, draft, error: "), found)

    def test_loss_and_new_figures_are_named(self):
        anew = self.kept()
        anew["cases"][0]["points"][0]["error"] = None
        anew["cases"][1]["case"] = "another"
        found = fresh.off("tradeoff", self.kept(), anew)
        self.assertIn("None now", found[0])
        self.assertIn("and not on the page", found[-1])

    def test_figures_agree_within_the_factor_or_below_the_floor(self):
        self.assertTrue(fresh.agree(4, 5, 0) and fresh.agree(5, 4, 0) and fresh.agree(0, 0, 0))
        self.assertTrue(fresh.agree(1e-9, 1e-6, 1e-5))
        self.assertFalse(fresh.agree(4, 5.1, 0) or fresh.agree(1e-9, 2e-5, 1e-5))
        self.assertFalse(fresh.agree(None, 1, 10) or fresh.agree(0, 1, 0))

    def test_every_page_has_figures_to_measure_anew(self):
        for page in page_figures.PAGES:
            results = page_figures.read_page(page)
            self.assertGreater(len(list(fresh.FIGURES[page](results))), 40, page)
            self.assertEqual(fresh.off(page, results, results), [])

    def test_times_beside_box2d_may_differ_by_their_factor(self):
        kept = page_figures.read_page("performance")
        for factor, wrong in ((1.4, False), (1.6, True)):
            anew = page_figures.read_page("performance")
            next(e for e in anew["scenes"][0]["engines"] if e["engine"] == "box2d")["ms_median"] *= factor
            self.assertEqual(bool(fresh.slow(kept, anew)), wrong)

    def test_wrong_words_are_refused(self):
        for words in ([], ["fresh"], ["made", "x"], ["fresh", "nonsense=x"], ["fresh", "--docs"]):
            with mock.patch("sys.stderr"):
                self.assertEqual(check_pages.main(words), 2, words)


if __name__ == "__main__":
    unittest.main()
