# SPDX-License-Identifier: Apache-2.0
"""ParaView's view of any run: water by pressure or as a surface, blocks by speed, over time.

    paraview --script=paraview/riprap_run.py             with RIPRAP_RUN in the environment
    pvpython paraview/riprap_run.py RUN [PICTURE.png]    without a window; the last time, or RIPRAP_TIME [s]

RIPRAP_RUN      the run folder, where it is not given as an argument
RIPRAP_TIME     the time that is shown at first [s]; without it the last one
RIPRAP_WATER    pressure (without it) or speed: what particles are coloured by; surface: what `riprap surface RUN` wrote

Sizes, ranges of colours, gravity and what there is are taken from the files of the run.
"""
import os
import sys
import xml.etree.ElementTree

from paraview import servermanager
from paraview.simple import *

ARGUMENTS = sys.argv[1:]
RUN = ARGUMENTS[0] if ARGUMENTS else os.environ.get("RIPRAP_RUN", "")
PICTURE = ARGUMENTS[1] if len(ARGUMENTS) > 1 else os.environ.get("RIPRAP_PICTURE", "")
WATER = os.environ.get("RIPRAP_WATER", "pressure")
if not os.path.isfile(os.path.join(RUN, "out.pvd")):
    sys.exit(f"there is no run in '{RUN}': give the folder that `riprap run` wrote, or set RIPRAP_RUN")
if sys.platform == "linux" and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY") or
                                    os.environ.get("RIPRAP_OFFSCREEN")):
    # A ParaView that draws through X ends with a crash here; one built for EGL or OSMesa would not.
    sys.exit("there is no display: run `xvfb-run -a pvpython paraview/riprap_run.py RUN PICTURE.png` (Debian's package xvfb), "
             "or set RIPRAP_OFFSCREEN=1 for a ParaView that draws without one")


def frames(listing, kind):
    """Files of a listing whose names begin with a kind. Each carries its time in the field array TimeValue."""
    path = os.path.join(RUN, listing)
    if not os.path.isfile(path):
        return []
    folder = os.path.dirname(path)
    files = [one.get("file") for one in xml.etree.ElementTree.parse(path).getroot().iter("DataSet")]
    return [os.path.join(folder, file) for file in files if os.path.basename(file).startswith(kind + "_")]


def read(name, files):
    return XMLPolyDataReader(registrationName=name, FileName=files, TimeArray="TimeValue") if files else None


def range_of(source, where, array):
    """Bounds of an array over a few times: the same colour means the same at every time."""
    low, high = float("inf"), float("-inf")
    times = list(source.TimestepValues) or [0.0]
    for time in {times[0], times[len(times) // 2], times[-1]}:
        source.UpdatePipeline(time)
        information = source.GetCellDataInformation() if where == "CELLS" else source.GetPointDataInformation()
        found = information.GetArray(array)
        if found:
            bounds = found.GetRange(0)
            low, high = min(low, bounds[0]), max(high, bounds[1])
    return (low, high) if high > low else (low - 0.5, low + 0.5) if high == low else None


def colour(display, source, where, array, map_name, title, position):
    """Colours by an array of cells or points, with a legend."""
    limits = range_of(source, where, array)
    if limits is None:
        return
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


def spacing_of(source):
    """Spacing of the particles, which frames of particles carry as a field [m]."""
    data = servermanager.Fetch(source)
    array = data.GetFieldData().GetArray("spacing")
    return array.GetTuple1(0) if array else 0.0


def gravity():
    """Gravity at full strength, from resolved.toml; down along z where it is not known."""
    try:
        import tomllib

        with open(os.path.join(RUN, "resolved.toml"), "rb") as file:
            value = tomllib.load(file).get("gravity", [0.0, 0.0, -1.0])
        value = value["value"] if isinstance(value, dict) else value
        return (list(value) + [0.0])[:3]
    except (ImportError, OSError, ValueError):
        return [0.0, 0.0, -1.0]


LoadPalette("WhiteBackground")
view = GetActiveViewOrCreate("RenderView")
bodies = read("bodies", frames("out.pvd", "bodies"))
water = read("water", frames("out.pvd", "water"))
surface = read("surface", frames(os.path.join("surface", "surface.pvd"), "water") or frames("out.pvd", "surface"))
shown = []

if bodies:
    blocks = Threshold(registrationName="blocks", Input=bodies, Scalars=["CELLS", "is_free"], LowerThreshold=0.5,
                       UpperThreshold=1.5)
    display = Show(blocks, view)
    display.Representation = "Surface With Edges"
    display.EdgeColor = [0.7, 0.7, 0.7]
    colour(display, bodies, "CELLS", "speed", "Plasma (matplotlib)", "Blocks: speed [m/s]", [0.9, 0.55])
    fixed = Threshold(registrationName="fixed or driven", Input=bodies, Scalars=["CELLS", "is_free"],
                      LowerThreshold=-0.5, UpperThreshold=0.5)
    display = Show(fixed, view)
    ColorBy(display, ("POINTS", ""))  # by nothing
    display.DiffuseColor, display.Opacity = [0.6, 0.6, 0.6], 0.25
    shown.append(blocks)
if surface and (WATER == "surface" or not water):
    display = Show(surface, view)
    ColorBy(display, ("POINTS", ""))
    display.DiffuseColor, display.Opacity, display.Specular = [0.2, 0.5, 0.75], 0.75, 0.6
    shown.append(surface)
elif water:
    display = Show(water, view, "GeometryRepresentation")
    display.Representation = "Point Gaussian"
    display.GaussianRadius = 0.5 * spacing_of(water)
    display.ShaderPreset = "Sphere"
    quantity, unit = ("speed", "m/s") if WATER == "speed" else ("pressure", "Pa")
    colour(display, water, "POINTS", quantity, "Viridis (matplotlib)", f"Water: {quantity} [{unit}]", [0.9, 0.1])
    shown.append(water)
first = bodies or water or surface
if not first:
    sys.exit(f"the run in '{RUN}' has no frames")
clock = AnnotateTimeFilter(registrationName="time", Input=first, Format="t = {time:.4g} s")
Show(clock, view)

scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
times = list(first.TimestepValues) or [0.0]
scene.AnimationTime = min(times, key=lambda t: abs(t - float(os.environ.get("RIPRAP_TIME", times[-1]))))
view.ViewSize = [1280, 720]
g = gravity()
axis = max(range(3), key=lambda k: abs(g[k]))
up = [0.0, 0.0, 0.0]
up[axis] = -1.0 if g[axis] > 0 else 1.0
box = [1e300, -1e300] * 3
for one in shown or [first]:
    one.UpdatePipeline(scene.AnimationTime)
    bounds = one.GetDataInformation().GetBounds()
    if bounds[0] <= bounds[1]:
        box = [(min if k % 2 == 0 else max)(box[k], bounds[k]) for k in range(6)]
center = [(box[2 * k] + box[2 * k + 1]) / 2 for k in range(3)]
size = sum((box[2 * k + 1] - box[2 * k]) ** 2 for k in range(3)) ** 0.5 or 1.0
is_planar = axis == 1
away = [0.0, 0.0, 1.0] if is_planar else [0.55 * (axis != 0), -0.83 * (axis != 1), 0.5]
view.CameraFocalPoint = center
view.CameraPosition = [center[k] + 1.9 * size * away[k] for k in range(3)]
view.CameraViewUp = up
Render()
if PICTURE:
    SaveScreenshot(PICTURE, view)
