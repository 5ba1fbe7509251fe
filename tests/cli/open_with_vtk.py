#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Opens every frame of a run folder with VTK's own reader and says what is in it.

usage: open_with_vtk.py RUN_FOLDER [PARAVIEW_SCRIPT]    also checks the arrays that a script names
exit codes: 0 all opened; 1 something is wrong (told on standard error); 77 VTK is not installed
"""
import math
import pathlib
import re
import sys
import xml.etree.ElementTree

try:
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError:
    sys.exit(77)


def refuse(file, why):
    print(f"{file}: {why}", file=sys.stderr)
    sys.exit(1)


def open_frame(file):
    reader = vtkXMLPolyDataReader()
    complaints = []
    for event in ("ErrorEvent", "WarningEvent"):
        reader.AddObserver(event, lambda caller, name: complaints.append(name))
    if not reader.CanReadFile(str(file)):
        refuse(file, "VTK does not take it for poly data")
    reader.SetFileName(str(file))
    reader.Update()
    if complaints or reader.GetErrorCode() != 0:
        refuse(file, f"VTK complains: {complaints}, error code {reader.GetErrorCode()}")
    return reader.GetOutput()


def check_arrays(file, fields, count):
    for i in range(fields.GetNumberOfArrays()):
        array = fields.GetArray(i)
        if array.GetNumberOfTuples() != count:
            refuse(file, f"{array.GetName()} has {array.GetNumberOfTuples()} entries for {count}")
        for component in range(array.GetNumberOfComponents()):
            if not all(math.isfinite(bound) for bound in array.GetRange(component)):
                refuse(file, f"{array.GetName()} is not finite")


# Arrays that docs/howto/output-files.md lists for each kind of file: of cells or points, and of the whole file.
ARRAYS = {
    "bodies": ("cells", {"body", "material", "is_free", "velocity", "speed", "angular_velocity", "displacement", "distance"},
               {"body_position", "body_orientation", "TimeValue"}),
    "water": ("points", {"id", "velocity", "speed", "density", "pressure"}, {"spacing", "TimeValue"}),
    "contacts": ("points", {"body_a", "body_b", "force", "normal_force", "shear_force", "overlap", "area", "is_sliding"},
                 {"TimeValue"}),
}


def names(fields):
    return {fields.GetArrayName(i) for i in range(fields.GetNumberOfArrays())}


def check_frame(file, kind, time):
    data = open_frame(file)
    check_arrays(file, data.GetCellData(), data.GetNumberOfCells())
    check_arrays(file, data.GetPointData(), data.GetNumberOfPoints())
    where, expected, of_all = ARRAYS[kind]
    found = names(data.GetCellData() if where == "cells" else data.GetPointData())
    missing = (expected - found) | (of_all - names(data.GetFieldData()))
    if missing:
        refuse(file, f"without {sorted(missing)}")
    if data.GetFieldData().GetArray("TimeValue").GetValue(0) != time:
        refuse(file, f"its time is not the {time} of its collection")
    return data.GetNumberOfCells()


def check_state_script(script, kinds):
    """Every array that a script for ParaView names is in the files that it shows."""
    known = {"CELLS": set(), "POINTS": set()}
    for kind in kinds:
        where, arrays, _ = ARRAYS[kind]
        known["CELLS" if where == "cells" else "POINTS"] |= arrays
    named = re.findall(r'"(CELLS|POINTS)", "(\w+)"', script.read_text())
    for where, array in named:
        if array not in known[where]:
            refuse(script, f"there is no array {array} of {where.lower()} in {sorted(kinds)}")
    if len(named) < 3:
        refuse(script, "names hardly any array: has its form changed?")
    print(f"{script.name}: {len(named)} arrays are there")


def main(folder, script=None):
    kinds = {}
    for collection in sorted(folder.glob("*.pvd")):
        for entry in xml.etree.ElementTree.parse(collection).getroot().iter("DataSet"):
            kind = entry.get("file").removeprefix("frames/").split("_")[0]
            kinds.setdefault(kind, []).append((float(entry.get("timestep")), entry.get("file"), entry.get("part")))
    written = {f"frames/{file.name}" for file in (folder / "frames").glob("*.vt*")}
    if written != {file for frames in kinds.values() for _, file, _ in frames}:
        refuse(folder, f"the collections do not name each of the {len(written)} files once")
    for kind, frames in kinds.items():
        times = [time for time, _, _ in frames]
        if times != sorted(set(times)) or len({part for _, _, part in frames}) != 1:
            refuse(folder, f"{kind}: times {times}")
        cells = sum(check_frame(folder / file, kind, time) for time, file, _ in frames)
        print(f"{kind}: {len(frames)} frames, {cells} cells")
    if script is not None:
        check_state_script(pathlib.Path(script), kinds)


main(pathlib.Path(sys.argv[1]), *sys.argv[2:])
