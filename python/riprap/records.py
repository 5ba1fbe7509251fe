# SPDX-License-Identifier: Apache-2.0
"""What a run left in its folder, and studies of many runs."""
import csv as _csv
import itertools as _itertools
import json as _json
import os as _os
import pathlib as _pathlib

import numpy as _np


class Table(dict):
    """Columns of a table by name, as arrays; `units` has the unit of each."""

    def __init__(self, path):
        super().__init__()
        self.units = {}
        with _pathlib.Path(path).open(newline="") as file:
            rows = [row for row in _csv.reader(file)]
        heads = rows[0] if rows else []
        body = [row for row in rows[1:] if len(row) == len(heads)]  # a run may be writing the last one
        for k, head in enumerate(heads):
            name, _, unit = head.partition(" [")
            self.units[name] = unit.rstrip("]")
            self[name] = _np.array([float(row[k]) if row[k] else _np.nan for row in body])

    def to_pandas(self):
        """The same as a pandas DataFrame, the time as its index."""
        import pandas

        frame = pandas.DataFrame(dict(self))
        return frame.set_index("time") if "time" in frame else frame

    def __repr__(self):
        rows = len(next(iter(self.values()))) if self else 0
        return f"<riprap.Table of {rows} rows: {', '.join(self)}>"


class Run:
    """The folder of a run: `summary` (a dict), `probes` and `ledger` (tables), `times` of its frames."""

    def __init__(self, folder):
        self.folder = _pathlib.Path(folder)
        if not (self.folder / "run.json").is_file():
            from .errors import FileError

            raise FileError(f"'{folder}' holds no run")

    @property
    def summary(self):
        path = self.folder / "summary.json"
        return _json.loads(path.read_text()) if path.is_file() else {}

    @property
    def status(self):
        return self.summary.get("status", "not finished")

    @property
    def probes(self):
        return Table(self.folder / "probes.csv")

    @property
    def ledger(self):
        return Table(self.folder / "ledger.csv")

    @property
    def answers(self):
        """The expected answers: value, band and verdict by name."""
        return {one["name"]: one for one in self.summary.get("expects", [])}

    def __repr__(self):
        return f"<riprap.Run '{self.folder}': {self.status}>"


def open(folder):  # noqa: A001
    """The run in a folder, to look at: riprap.open("runs/stack").probes["level"]"""
    return Run(folder)


def _run_point(case, overrides, folder, threads):
    import riprap

    riprap.set_threads(threads)
    try:
        riprap.run(riprap.load(case, overrides=overrides), folder, resume=True, quiet=True)
        return ""
    except Exception as error:  # noqa: BLE001 - told in the table; the other runs go on
        return str(error)


def sweep(case, vary, out, *, jobs=None, threads=1):
    """Runs a case once for each combination of the values in `vary`, {"key": [a, b], ...}, or for each dict of a list.

    Each run is a process of its own, `jobs` at a time (default: as many as there are cores), in a folder of `out`. Runs that
    are finished stay, so that a study that was stopped goes on. Returns a list of dicts: "set", "run" (riprap.Run) and
    "error". Call it below `if __name__ == "__main__":` in a script.
    """
    import concurrent.futures
    import multiprocessing

    if isinstance(vary, dict):
        points = [dict(zip(vary, values)) for values in _itertools.product(*vary.values())]
    else:
        points = [dict(point) for point in vary]
    out = _pathlib.Path(out)
    out.mkdir(parents=True, exist_ok=True)
    folders = [out / f"run_{k + 1:03}" for k in range(len(points))]
    errors = [""] * len(points)

    def is_finished(folder):
        return (folder / "summary.json").is_file() and Run(folder).status == "finished"

    workers = jobs or max(1, (_os.cpu_count() or 1) // max(1, threads))
    context = multiprocessing.get_context("spawn")
    with concurrent.futures.ProcessPoolExecutor(workers, mp_context=context) as pool:
        asked = {}
        for k, (point, folder) in enumerate(zip(points, folders)):
            if not is_finished(folder):
                asked[pool.submit(_run_point, str(case), point, str(folder), threads)] = k
        for done in concurrent.futures.as_completed(asked):
            errors[asked[done]] = done.result()
    return [{"set": point, "run": Run(folder) if (folder / "run.json").is_file() else None, "error": error}
            for point, folder, error in zip(points, folders, errors)]
