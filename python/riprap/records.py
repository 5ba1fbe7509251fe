# SPDX-License-Identifier: Apache-2.0
"""What a run left in its folder, and studies of many runs."""
import base64 as _base64
import csv as _csv
import difflib as _difflib
import io as _io
import itertools as _itertools
import json as _json
import os as _os
import pathlib as _pathlib
import re as _re
import xml.etree.ElementTree as _xml
import zlib as _zlib
from collections.abc import Callable as _Callable
from collections.abc import Iterable as _Iterable
from collections.abc import Mapping as _Mapping
from collections.abc import Sequence as _Sequence
from typing import Any as _Any

import numpy as _np

from ._riprap import Case as _Case
from .errors import FileError as _FileError


def _unknown(kind, name, known):
    """A KeyError that names the nearest word there is."""
    near = _difflib.get_close_matches(str(name), [str(one) for one in known], 1, 0.5)
    hint = f"; did you mean '{near[0]}'?" if near else f"; there are: {', '.join(known)}" if known else ""
    return KeyError(f"there is no {kind} '{name}'{hint}")


def _text_of(path):
    """What a file of a run holds. A pipe in its place would wait for a writer."""
    if _os.path.exists(path) and not _os.path.isfile(path):
        raise _FileError(f"cannot read '{path}': not a regular file")
    with _pathlib.Path(path).open(newline="", encoding="utf-8", errors="replace") as file:
        return file.read()


def _number(path, line, column, field):
    """The number of a field of a table; NaN where it is empty."""
    try:
        return float(field) if field else _np.nan
    except ValueError:
        raise _FileError(f"cannot read '{path}': line {line}, column {column + 1} is {field!r:.60}, "
                         "where a number should be") from None


class Table(dict[str, _np.ndarray]):
    """Columns of a table by name, as arrays; `units` has the unit of each."""

    def __init__(self, path: str | _os.PathLike[str]) -> None:
        super().__init__()
        self.units: dict[str, str] = {}
        text = _text_of(path)
        try:
            rows = list(_csv.reader(_io.StringIO(text[:text.rfind("\n") + 1])))  # a run may be writing the last line
        except _csv.Error as error:
            raise _FileError(f"cannot read '{path}': {error}") from None
        heads = rows[0] if rows else []
        for line, row in enumerate(rows[1:], 2):
            if len(row) != len(heads):
                raise _FileError(f"'{path}' is damaged: line {line} has {len(row)} fields, the first has {len(heads)}")
        for k, head in enumerate(heads):
            name, _, unit = head.partition(" [")
            self.units[name] = unit.rstrip("]")
            self[name] = _np.array([_number(path, line, k, row[k]) for line, row in enumerate(rows[1:], 2)])

    def __missing__(self, name):
        raise _unknown("column", name, list(self))

    def at(self, time: float) -> dict[str, float]:
        """The last row at or before a time [s], as a dict."""
        row = max(0, int(_np.searchsorted(self["time"], time * (1 + 1e-12), side="right")) - 1)
        return {name: float(values[row]) for name, values in self.items()}

    def to_pandas(self) -> _Any:
        """The same as a pandas DataFrame, the time as its index."""
        import pandas

        frame = pandas.DataFrame(dict(self))
        return frame.set_index("time") if "time" in frame else frame

    def __repr__(self):
        rows = len(next(iter(self.values()))) if self else 0
        return f"<riprap.Table of {rows} rows: {', '.join(self)}>"


_NUMBERS = {"Float32": "<f4", "Float64": "<f8", "Int32": "<i4", "Int64": "<i8", "UInt8": "u1"}


def _array(element):
    """The values of a DataArray, base64 and zlib by blocks, as riprap writes them."""
    if element.get("format") == "ascii":
        return _np.array((element.text or "").split(), float)
    text = _re.sub(r"\s", "", element.text or "")
    if not text:
        return _np.empty(0)
    count = int.from_bytes(_base64.b64decode(text[:12])[:8], "little")
    head = -(-8 * (3 + count) // 3) * 4
    sizes = _np.frombuffer(_base64.b64decode(text[:head])[24:24 + 8 * count], "<u8")
    packed, parts, at = _base64.b64decode(text[head:]), [], 0
    for size in sizes:
        parts.append(_zlib.decompress(packed[at:at + int(size)]))
        at += int(size)
    values = _np.frombuffer(b"".join(parts), _NUMBERS[element.get("type")])
    components = int(element.get("NumberOfComponents", 1))
    return values.reshape(-1, components) if components > 1 else values


def _renamed(arrays):
    return {{"Points": "position"}.get(name, name): values for name, values in arrays.items()}


def _per_body(arrays):
    """Arrays with a row for every body, from those with a row for every face."""
    faces = arrays.get("body", _np.empty(0))
    _, first = _np.unique(faces, return_index=True)
    bodies = {"position": arrays.get("body_position"), "orientation": arrays.get("body_orientation")}
    for name, values in arrays.items():
        if len(values) == len(faces) and name not in ("body", "offsets", "Points", "connectivity", "body_position", "body_orientation"):
            bodies[name] = values[first]
    return {name: values for name, values in bodies.items() if values is not None}


class Frame:
    """What a run wrote for one time: arrays of the water, the bodies and the contacts by name, read when they are asked for.

    frame.water["position"], frame.water["pressure"]: a row for every particle; frame.bodies["position"],
    frame.bodies["velocity"]: a row for every body, in the order of bodies.csv; `time` [s].
    """

    def __init__(self, time: float, files: dict[str, _pathlib.Path]) -> None:
        self.time = time
        self._files = files
        self._read = {}

    def _part(self, kind):
        if kind not in self._read:
            arrays = {}
            if kind in self._files:
                path = self._files[kind]
                try:
                    for element in _xml.fromstring(_text_of(path)).iter("DataArray"):
                        arrays.setdefault(element.get("Name"), _array(element))
                except (ValueError, LookupError, _xml.ParseError, _zlib.error) as error:
                    raise _FileError(f"'{path}' is damaged: {error}") from None
                arrays = _per_body(arrays) if kind == "bodies" else _renamed(arrays)
            self._read[kind] = _Arrays(kind, arrays)
        return self._read[kind]

    @property
    def water(self) -> dict[str, _np.ndarray]:
        return self._part("water")

    @property
    def bodies(self) -> dict[str, _np.ndarray]:
        return self._part("bodies")

    @property
    def contacts(self) -> dict[str, _np.ndarray]:
        return self._part("contacts")

    @property
    def surface(self) -> dict[str, _np.ndarray]:
        """Of the grid fluid."""
        return self._part("surface")

    def __repr__(self):
        return f"<riprap.Frame at {self.time:.6g} s: {', '.join(sorted(self._files))}>"


class _Arrays(dict):
    def __init__(self, kind, arrays):
        super().__init__(arrays)
        self._kind = kind

    def __missing__(self, name):
        raise _unknown(f"array of the {self._kind}", name, list(self))

    def __repr__(self):
        return f"<riprap arrays of the {self._kind}: {', '.join(self) or 'none'}>"


class Run:
    """The folder of a run: `summary` (a dict), `probes` and `ledger` (tables), `body_names`, `times` and `frames`."""

    def __init__(self, folder: str | _os.PathLike[str]) -> None:
        self.folder = _pathlib.Path(folder)
        if not (self.folder / "run.json").is_file():
            parent = self.folder.parent
            runs = [one.name for one in parent.iterdir() if (one / "run.json").is_file()] if parent.is_dir() else []
            near = _difflib.get_close_matches(self.folder.name, runs, 1, 0.5)
            raise _FileError(f"'{folder}' holds no run" + (f"; did you mean '{parent / near[0]}'?" if near else ""))

    @property
    def summary(self) -> dict[str, _Any]:
        path = self.folder / "summary.json"
        if not path.exists():
            return {}
        try:
            summary = _json.loads(_text_of(path))
        except ValueError:
            raise _FileError(f"cannot read '{path}': it is no JSON, or ends in the middle") from None
        if not isinstance(summary, dict):
            raise _FileError(f"cannot read '{path}': it is no summary of a run")
        return summary

    @property
    def status(self) -> str:
        return self.summary.get("status", "not finished")

    @property
    def probes(self) -> Table:
        return Table(self.folder / "probes.csv")

    @property
    def ledger(self) -> Table:
        return Table(self.folder / "ledger.csv")

    def __getitem__(self, name: str) -> _np.ndarray:
        """A column of the probes or the ledger: run["block.displacement.x"]"""
        tables = [table for table in (self.probes, self.ledger) if table]
        for table in tables:
            if name in table:
                return table[name]
        raise _unknown("column", name, [column for table in tables for column in table])

    @property
    def frames(self) -> list[Frame]:
        """What was written at each time (list of Frame); nothing is read before it is asked for."""
        found = {}
        for listing in ("out.pvd", "contacts.pvd"):
            path = self.folder / listing
            if not path.is_file():
                continue
            text = path.read_text()  # of a run that goes on, the end may be missing
            for time, file in _re.findall(r'<DataSet timestep="([^"]+)"[^>]*file="([^"]+)"', text):
                kind = _pathlib.PurePath(file).name.split("_")[0]
                found.setdefault(float(time), {})[kind] = self.folder / file
        return [Frame(time, files) for time, files in sorted(found.items())]

    @property
    def times(self) -> _np.ndarray:
        """Of the frames [s]."""
        return _np.array([frame.time for frame in self.frames])

    def frame(self, time: float) -> Frame:
        """The frame nearest to a time [s]."""
        frames = self.frames
        if not frames:
            raise LookupError(f"the run in '{self.folder}' has no frames")
        return min(frames, key=lambda frame: abs(frame.time - time))

    def view(self) -> _pathlib.Path:
        """Writes the page of the run, as `riprap view` does, and gives its path (pathlib.Path)."""
        from ._riprap import _write_page

        path = self.folder / "index.html"
        _write_page(self.folder, path)
        return path

    def _repr_html_(self):
        """The page of the run, within a notebook."""
        import html

        page = html.escape(self.view().read_text(), quote=True)
        return f'<iframe srcdoc="{page}" style="width: 100%; height: 560px; border: 0"></iframe>'

    @property
    def body_names(self) -> list[str]:
        """Names of the bodies, in the order of their numbers; empty while the run goes on."""
        path = self.folder / "bodies.csv"
        if not path.is_file():
            return []
        with path.open(newline="") as file:
            return [row["name [-]"] for row in _csv.DictReader(file)]

    @property
    def answers(self) -> dict[str, dict[str, _Any]]:
        """The expected answers: value, band and verdict by name."""
        return {one["name"]: one for one in self.summary.get("expects", [])}

    def __repr__(self):
        return f"<riprap.Run '{self.folder}': {self.status}>"


def open(folder: str | _os.PathLike[str]) -> Run:  # noqa: A001
    """The run in a folder, to look at: riprap.open("runs/stack").probes["level"]"""
    return Run(folder)


def _toml(value):
    """A value of an override; JSON of numbers, texts, truth values and lists of them is TOML."""
    return _json.dumps(value, default=lambda array: array.tolist())


def _run_point(case, overrides, folder, threads):
    import riprap

    riprap.set_threads(threads)
    try:
        if isinstance(case, str):
            loaded = riprap.load(case, overrides=overrides)
        else:
            text, place, given = case
            loaded = riprap.loads(text, folder=place, overrides=given + [f"{key}={_toml(value)}" for key, value in overrides.items()])
        riprap.run(loaded, folder, resume=True, quiet=True)
        return ""
    except Exception as error:  # noqa: BLE001 - told in the table; the other runs go on
        return str(error)


class Study(list):
    """Runs of a study: dicts of "set", "run" (riprap.Run) and "error"."""

    def table(self):
        """A DataFrame, a row per run: what was set, "status", "error", expected answers by their name, and of each gauge and
        body column the last value. Needs pandas."""
        import pandas

        return pandas.DataFrame([_row_of(one) for one in self])


def _row_of(one):
    run = one["run"]
    row = dict(one["set"], status=run.status if run else "failed", error=one["error"])
    if run is None:
        return row
    for answer in run.summary.get("expects", []):
        row[answer["name"]] = answer["value"]
    if (run.folder / "probes.csv").is_file():
        row.update({name: float(values[-1]) for name, values in run.probes.items()
                    if name not in ("time", "step") and len(values)})
    return row


def sweep(
    case: str | _os.PathLike[str] | _Case,
    vary: _Mapping[str, _Sequence[_Any]] | _Iterable[_Mapping[str, _Any]],
    out: str | _os.PathLike[str],
    *,
    jobs: int | None = None,
    threads: int = 1,
    map: _Callable[..., _Iterable[_Any]] | None = None,  # noqa: A002
) -> Study:
    """Runs a case once for each combination of the values in `vary`, {"key": [a, b], ...}, or for each dict of a list.

    `case` is a file, a folder, a name from riprap.list(), or a riprap.Case with what replaced its keys.

    Each run is a process of its own, `jobs` at a time (default: as many as there are cores), in a folder of `out`. Runs that
    are finished stay, so that a study that was stopped goes on. Returns a Study, a list of dicts: "set", "run" (riprap.Run) and
    "error"; its table() is a DataFrame. Leaves sweep.json and a page that compares, index.html, in `out`. Call it below
    `if __name__ == "__main__":` in a script.

    `map` runs the runs elsewhere instead: map(function, arguments) of a pool, of mpi4py.futures or of Dask's client, whose
    machines see `out` under the same path. It keeps the order and calls the function once for each run; what it returns are the answers or futures of them.
    """
    if isinstance(vary, dict):
        points = [dict(zip(vary, values)) for values in _itertools.product(*vary.values())]
    else:
        points = [dict(point) for point in vary]
    out = _pathlib.Path(out)
    folders = [out / f"run_{k + 1:03}" for k in range(len(points))]
    from ._riprap import _write_study_page

    study = _runs_of(case, points, folders, jobs, threads, map)
    (out / "sweep.json").write_text(_study_json(case, study, folders))
    _write_study_page(out)
    return study


def ensemble(
    case: str | _os.PathLike[str] | _Case,
    members: int,
    out: str | _os.PathLike[str],
    *,
    jobs: int | None = None,
    threads: int = 1,
    map: _Callable[..., _Iterable[_Any]] | None = None,  # noqa: A002
) -> Study:
    """Runs `members` of a case with [[spread]], each with values of its own, the same as `riprap run --ensemble` draws.

    Members are run folders `member-1`, ... of `out`, made as the runs of `sweep` are, several at a time or by `map`; those
    that are finished stay. Returns a Study, and leaves ensemble.csv (member, seed, exit code, values), bands.csv (least,
    mean, largest and quantiles of what is recorded, over time), ensemble.json and index.html in `out`.
    """
    import riprap

    from ._riprap import _draws, _write_ensemble

    loaded = case if isinstance(case, _Case) else riprap.load(case)
    seed, points = _draws(loaded, members)
    out = _pathlib.Path(out)
    folders = [out / f"member-{k + 1}" for k in range(members)]
    study = _runs_of(case, points, folders, jobs, threads, map)
    (out / "ensemble.json").write_text(_study_json(case, study, folders))
    heading = ["member [-]", "seed [-]", "exit_code [-]", *(f"{key} [SI]" for key in points[0])]
    rows = [[k + 1, seed, _code_of(one), *one["set"].values()] for k, one in enumerate(study)]
    (out / "ensemble.csv").write_text("".join(",".join(str(value) for value in row) + "\n" for row in [heading, *rows]))
    for left_out in _write_ensemble(out, folders):
        import warnings

        warnings.warn(left_out, RuntimeWarning, stacklevel=2)
    return study


def _code_of(one):
    """Exit code that the run of a study has, as `riprap run` would end with; empty where it has not ended."""
    run = one["run"]
    if run is None or run.status not in ("finished", "failed"):
        return "" if not one["error"] else 3
    if run.status == "failed":
        return 4
    return int(any(answer["verdict"] == "failed" for answer in run.summary.get("expects", [])))


def _runs_of(case, points, folders, jobs, threads, way):
    """Runs what is not finished of a study, and lists all of it."""
    case = (case.text, str(case.folder), case.overrides) if isinstance(case, _Case) else str(case)
    folders[0].parent.mkdir(parents=True, exist_ok=True)
    errors = [""] * len(points)

    def is_finished(folder):
        return (folder / "summary.json").is_file() and Run(folder).status == "finished"

    asked = [k for k, folder in enumerate(folders) if not is_finished(folder)]
    for k in asked:
        errors[k] = "no answer came from the map"
    tasks = [(case, points[k], str(folders[k].resolve()), threads) for k in asked]
    for k, error in zip(asked, _answers_of(way(_run_task, tasks)) if way else _answers_of_processes(tasks, jobs, threads)):
        errors[k] = error
    return Study({"set": point, "run": Run(folder) if (folder / "run.json").is_file() else None, "error": error}
                 for point, folder, error in zip(points, folders, errors))


def _run_task(task):
    return _run_point(*task)


def _answers_of(asked):
    """What a map gave: answers, or futures of them. A future that fails is the error of its run alone."""
    answers = iter(asked)
    while True:
        try:
            one = next(answers)
            answer = one.result() if hasattr(one, "result") else one
        except StopIteration:
            return
        except Exception as error:  # noqa: BLE001 - told in the table; the other runs go on
            answer = f"{type(error).__name__}: {error}"
        yield answer


def _answers_of_processes(tasks, jobs, threads):
    import concurrent.futures
    import multiprocessing

    workers = jobs or max(1, (_os.cpu_count() or 1) // max(1, threads))
    context = multiprocessing.get_context("spawn")
    with concurrent.futures.ProcessPoolExecutor(workers, mp_context=context) as pool:
        yield from _answers_of([pool.submit(_run_task, task) for task in tasks])


def _study_json(case, runs, folders):
    """The text of sweep.json, as `riprap sweep` leaves it."""
    listed = []
    for one, folder in zip(runs, folders):
        run, summary = one["run"], one["run"].summary if one["run"] else {}
        tables = run.probes if run and (run.folder / "probes.csv").is_file() else {}
        columns = {name: {"unit": tables.units[name], "min": float(_np.nanmin(values)), "max": float(_np.nanmax(values)),
                          "last": float(values[-1])}
                   for name, values in tables.items() if name not in ("time", "step") and _np.isfinite(values).any()}
        listed.append({"name": folder.name, "set": {key: _shown(value) for key, value in one["set"].items()},
                       "status": run.status if run else "failed", "reason": one["error"], "wall_seconds": summary.get("wall_seconds"),
                       "answers": summary.get("expects", []), "columns": columns})
    title = case.title if isinstance(case, _Case) else str(case)
    return _json.dumps({"case": title, "set": [], "runs": listed}, indent=1).replace("NaN", "null")


def _shown(value):
    return value if isinstance(value, str) else _json.dumps(value)
