# SPDX-License-Identifier: Apache-2.0
"""What stored rows of results say about the cases of today: which hold in a world in which nothing moves, which are of
an older case, and how the bands of today judge them. Used by tools/results."""
import hashlib
import json
import pathlib
import re
import subprocess
import tomllib

root = pathlib.Path(__file__).resolve().parent.parent
still_file = root / "validation" / "results" / "still" / "rows.json"
words_alone = ("title", "source", "expect", "vary")  # of a case: no run depends on them


def inputs_of(text):
    """What a run depends on, of the text of a case: all but words, expected answers and comparisons of runs."""
    case = tomllib.loads(text)
    runs = [{key: value for key, value in one.items() if key not in ("name", "ratio", "order")}
            for one in case.get("vary", [])]
    inputs = {key: value for key, value in case.items() if key not in words_alone} | {"vary": runs}
    return hashlib.sha256(json.dumps(inputs, sort_keys=True).encode()).hexdigest()[:16]


def case_path(entry):
    return root / "validation" / entry["suite"] / entry["case"] / "case.toml"


def inputs_today(entry):
    path = case_path(entry)
    return inputs_of(path.read_text()) if path.exists() else None


def inputs_at_commit(entry):
    """None where the commit is not there, or had no such case."""
    file = f"{entry['commit']}:{case_path(entry).relative_to(root)}"
    shown = subprocess.run(["git", "show", file], cwd=root, capture_output=True, text=True)
    return inputs_of(shown.stdout) if shown.returncode == 0 else None


def is_of_older_case(entry):
    return entry.get("inputs") != inputs_today(entry)


def still_rows():
    return json.loads(still_file.read_text()) if still_file.exists() else {}


def keep_still_rows(files):
    """A case of an output of `riprap validate --still --json` replaces what was kept of it."""
    kept = still_rows()
    for file in files:
        document = json.loads(pathlib.Path(file).read_text())
        found = {}
        for row in document["results"]:
            suite, _, case = row["case"].rpartition("/")
            names = found.setdefault(f"{suite or document['suite']}/{case}", [])
            if row["kind"] == "physics" and row["verdict"] in ("reproduced", "close"):
                names.append(row["quantity"])
        kept.update(found)
    still_file.parent.mkdir(parents=True, exist_ok=True)
    still_file.write_text(json.dumps({case: kept[case] for case in sorted(kept) if kept[case]}, indent=1,
                                     ensure_ascii=False) + "\n")


def holds_still(entry, row, still):
    """Whether a row that is right would be right if nothing moved, too."""
    return (row["kind"] == "physics" and row["verdict"] in ("reproduced", "close")
            and row["quantity"] in still.get(f"{entry['suite']}/{entry['case']}", []))


def citations_of(entry):
    """Citation of every expected answer and comparison of the case of today, by name."""
    text = case_path(entry).read_text() if case_path(entry).exists() else ""
    case = tomllib.loads(text)
    lists = [case.get("expect", [])] + [one.get(key, []) for one in case.get("vary", []) for key in ("ratio", "order")]
    return {row["name"]: row.get("citation", "") for rows in reversed(lists) for row in rows}


def name_of_answer(row):
    """Name in the case file of what a row reports: without the words on the run."""
    return re.split(r"; |, over that of the case as it stands|, order of convergence over ", row["quantity"])[0]


def strengths_of(entry, strengths):
    """What each row of an entry is compared with, as validation/strengths.toml tells by citations."""
    citations = citations_of(entry)

    def strength(row):
        cited = citations.get(row["quantity"], citations.get(name_of_answer(row)))
        if row["kind"] != "physics" or row["verdict"] == "under_specified":
            return ""
        if cited is None:
            return "not known"  # of a case that had other answers
        fits = [line["of"] for line in strengths if any(re.search(what, row["quantity"]) for what in line.get("rows", []))]
        fits += [line["of"] for line in strengths if any(re.search(what, cited) for what in line["cites"])]
        return next(iter(fits), "exact")
    return [strength(row) for row in entry["rows"]]


def strength_lines():
    return tomllib.loads((root / "validation" / "strengths.toml").read_text())["strength"]


def values_by_strength(entries, strengths):
    """(right, all) values by strength. Rows of a case with the same value judge one value, right where all are."""
    values = {}
    for entry in entries:
        for row, strength in zip(entry["rows"], strengths_of(entry, strengths)):
            if strength:
                # a missing value, and nought, may be that of several quantities
                same = row["value"] if row["value"] else row["quantity"]
                key = (entry["suite"], entry["case"], entry["version"], row["unit"], same)
                values.setdefault(key, []).append((strength, row["verdict"] in ("reproduced", "close")))
    found = {}
    for rows in values.values():
        one = found.setdefault(rows[0][0], [0, 0])
        one[0] += all(is_right for _, is_right in rows)
        one[1] += 1
    return found


def judge_ratios_again(entry):
    """Judges stored ratios of runs by the bands that the case has today."""
    text = case_path(entry).read_text() if case_path(entry).exists() else ""
    for one in tomllib.loads(text).get("vary", []):
        for ratio in one.get("ratio", []):
            if "low" not in ratio:
                continue
            told = re.compile(re.escape(ratio["name"] + ", over that of the case as it stands; " + one.get("name", "")))
            for row in entry["rows"]:
                if told.match(row["quantity"]) and row["low"] is not None and row["exact"] is None:
                    row["low"], row["high"] = ratio["low"], ratio["high"]
                    is_within = row["value"] is not None and row["low"] <= row["value"] <= row["high"]
                    row["verdict"] = "reproduced" if is_within else "not_reproduced"
