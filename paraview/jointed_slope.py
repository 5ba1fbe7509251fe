# SPDX-License-Identifier: Apache-2.0
"""ParaView's view of a run of cases/jointed_slope: blocks by speed, over time.

    paraview --script=paraview/jointed_slope.py          from the folder that holds runs/
    pvpython paraview/jointed_slope.py                   the same without a window, into a picture

RIPRAP_RUN      the run folder; without it runs/demo/slope, where the demo writes
RIPRAP_PICTURE  write the scene at RIPRAP_TIME [s] (without it the last time) into this PNG file
"""
import os
import xml.etree.ElementTree

from paraview.simple import *

RUN = os.environ.get("RIPRAP_RUN", "runs/demo/slope")


def frames():
    """Files of a run. Each carries its time in the field array TimeValue."""
    collection = xml.etree.ElementTree.parse(os.path.join(RUN, "out.pvd")).getroot()
    return [os.path.join(RUN, one.get("file")) for one in collection.iter("DataSet")]


def colour(display, where, array, map_name, title, limits, position):
    """Colours by an array of cells or points, with a legend; the same colour means the same at every time."""
    ColorBy(display, (where, array), separate=True)
    display.UseSeparateColorMap = True
    table = GetColorTransferFunction(array, display, separate=True)
    display.LookupTable = table
    table.ApplyPreset(map_name, True)
    table.RescaleTransferFunction(*limits)
    legend = GetScalarBar(table, view)
    legend.Title, legend.ComponentTitle = title, ""
    legend.Orientation, legend.WindowLocation, legend.Position = "Vertical", "Any Location", position
    legend.ScalarBarLength = 0.3
    display.SetScalarBarVisibility(view, True)


LoadPalette("WhiteBackground")
view = GetActiveViewOrCreate("RenderView")
bodies = XMLPolyDataReader(registrationName="bodies", FileName=frames(), TimeArray="TimeValue")

blocks = Threshold(registrationName="blocks", Input=bodies, Scalars=["CELLS", "is_free"], LowerThreshold=0.5,
                   UpperThreshold=1.5)
shown = Show(blocks, view)
shown.Representation = "Surface With Edges"
shown.EdgeColor = [0.7, 0.7, 0.7]
colour(shown, "CELLS", "speed", "Plasma (matplotlib)", "Blocks: speed [m/s]", (0.0, 1.0), [0.9, 0.55])

platform = Threshold(registrationName="platform", Input=bodies, Scalars=["CELLS", "is_free"], LowerThreshold=-0.5,
                     UpperThreshold=0.5)
shown = Show(platform, view)
ColorBy(shown, ("POINTS", ""))  # by nothing
shown.DiffuseColor = [0.6, 0.6, 0.6]

clock = AnnotateTimeFilter(registrationName="time", Input=bodies, Format="t = {time:.3f} s")
Show(clock, view)

scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
times = list(bodies.TimestepValues)
scene.AnimationTime = min(times, key=lambda t: abs(t - float(os.environ.get("RIPRAP_TIME", times[-1]))))
view.ViewSize = [1280, 720]
view.CameraFocalPoint = [0.4, 0.0, 0.25]
view.CameraPosition = [0.9, -1.8, 0.7]
view.CameraViewUp = [0.0, 0.0, 1.0]
Render()
if "RIPRAP_PICTURE" in os.environ:
    SaveScreenshot(os.environ["RIPRAP_PICTURE"], view)
