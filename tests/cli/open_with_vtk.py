#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Opens every frame of a run folder with VTK's own reader and says what is in it.

usage: open_with_vtk.py RUN_FOLDER
exit codes: 0 all opened; 1 something is wrong (told on standard error); 77 VTK is not installed
"""
import math
import pathlib
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


def main(folder):
    for collection in sorted(folder.glob("*.pvd")):
        frames = list(xml.etree.ElementTree.parse(collection).getroot().iter("DataSet"))
        times = [float(frame.get("timestep")) for frame in frames]
        if not frames or times != sorted(set(times)):
            refuse(collection, f"times {times}")
        cells = 0
        for frame, time in zip(frames, times):
            file = folder / frame.get("file")
            data = open_frame(file)
            check_arrays(file, data.GetCellData(), data.GetNumberOfCells())
            check_arrays(file, data.GetPointData(), data.GetNumberOfPoints())
            stored = data.GetFieldData().GetArray("TimeValue")
            if stored is None or stored.GetValue(0) != time:
                refuse(file, f"its time is not the {time} of {collection.name}")
            cells += data.GetNumberOfCells()
        print(f"{collection.name}: {len(frames)} frames, {cells} cells")


main(pathlib.Path(sys.argv[1]))
