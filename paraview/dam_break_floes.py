# SPDX-License-Identifier: Apache-2.0
"""ParaView's view of a run of cases/dam_break_floes: water by pressure, blocks by speed, over time.

    paraview --script=paraview/dam_break_floes.py        from the folder that holds runs/
    pvpython paraview/dam_break_floes.py                 the same without a window, into a picture

RIPRAP_RUN      the run folder; without it runs/demo/water, where the demo writes
RIPRAP_PICTURE  write the scene at RIPRAP_TIME [s] (without it the last time) into this PNG file
RIPRAP_WATER    pressure (without it) or speed: what the water is coloured by
"""
import os
import xml.etree.ElementTree

from paraview.simple import *

RUN = os.environ.get("RIPRAP_RUN", "runs/demo/water")
WATER = os.environ.get("RIPRAP_WATER", "pressure")
# What, of what, title, and the range of the colours: 0.15 m of still water, and the speed of a fall through half of it.
WATERS = {
    "pressure": ("POINTS", "pressure", "Viridis (matplotlib)", "Water: pressure [Pa]", (0.0, 1500.0)),
    "speed": ("POINTS", "speed", "Viridis (matplotlib)", "Water: speed [m/s]", (0.0, 1.2)),
}


def frames(part):
    """Files of one part of the run: 0 = bodies, 1 = water. Each carries its time in the field array TimeValue."""
    collection = xml.etree.ElementTree.parse(os.path.join(RUN, "out.pvd")).getroot()
    return [os.path.join(RUN, one.get("file")) for one in collection.iter("DataSet") if one.get("part") == str(part)]


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
bodies = XMLPolyDataReader(registrationName="bodies", FileName=frames(0), TimeArray="TimeValue")
water = XMLPolyDataReader(registrationName="water", FileName=frames(1), TimeArray="TimeValue")

blocks = Threshold(registrationName="blocks", Input=bodies, Scalars=["CELLS", "is_free"], LowerThreshold=0.5,
                   UpperThreshold=1.5)
shown = Show(blocks, view)
shown.Representation = "Surface With Edges"
shown.EdgeColor = [0.7, 0.7, 0.7]
colour(shown, "CELLS", "speed", "Plasma (matplotlib)", "Blocks: speed [m/s]", (0.0, 1.0), [0.9, 0.55])

# The gate is what moves as it is told; the walls would hide the scene. Bodies are numbered in the order of the case.
gate = Threshold(registrationName="gate", Input=bodies, Scalars=["CELLS", "body"], LowerThreshold=4.5,
                 UpperThreshold=5.5)
shown = Show(gate, view)
shown.Opacity = 0.3
ColorBy(shown, ("POINTS", ""))  # by nothing

drops = Show(water, view, "GeometryRepresentation")
drops.Representation = "Point Gaussian"
drops.GaussianRadius = 0.0024  # [m], half the spacing of particles of the case
drops.ShaderPreset = "Sphere"
colour(drops, *WATERS[WATER], [0.9, 0.1])

clock = AnnotateTimeFilter(registrationName="time", Input=bodies, Format="t = {time:.3f} s")
Show(clock, view)

scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
times = list(bodies.TimestepValues)
scene.AnimationTime = min(times, key=lambda t: abs(t - float(os.environ.get("RIPRAP_TIME", times[-1]))))
view.ViewSize = [1280, 720]
view.CameraFocalPoint = [0.35, 0.075, 0.1]
view.CameraPosition = [0.1, -1.0, 0.5]
view.CameraViewUp = [0.0, 0.0, 1.0]
Render()
if "RIPRAP_PICTURE" in os.environ:
    SaveScreenshot(os.environ["RIPRAP_PICTURE"], view)
