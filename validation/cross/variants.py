#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints [[vary]] of a scene turned, moved and scaled, with the answers that follow, to be pasted into its case.toml.

    validation/cross/variants.py SCENE [turn] [map] [thousandth] [thousand]
    validation/cross/variants.py check        exits with 1 where a scene has one of them that no longer follows from it

    turn        the whole scene, gravity with it, by 37 degrees about z
    map         every body at map coordinates, 4e5 and 5e6 m away
    thousandth  lengths times s = 1e-3 or 1e3 under the same gravity and with the same density: times and speeds go with
    thousand    sqrt(s), forces with s^2 in a plane and s^3 in space, stiffness of materials and cohesion with s

An answer in one component is taken to have nothing in the other, unless the scene expects both. A coordinate that changes must be in
the case: give `position` and `velocity` of a body even where they are zero. Scenes of bodies by box, cube, sphere and polygon.
"""
import math
import pathlib
import sys
import tomllib

folder = pathlib.Path(__file__).parent
turn = math.radians(37)
away = (4e5, 5e6, 0.0)
# kinds of quantities, by the factor of their answers
lengths = ("displacement", "distance", "position")
speeds = ("velocity", "speed")
forces = ("contact_force", "contact_force_size")


def turned(vector):
    c, s = math.cos(turn), math.sin(turn)
    return [c * vector[0] - s * vector[1], s * vector[0] + c * vector[1], *vector[2:]]


def numbers(path, value, factor):
    """Paths and values of the numbers other than zero in a value, times a factor other than one."""
    if isinstance(value, list):
        return [pair for i, one in enumerate(value) for pair in numbers(f"{path}.{i}", one, factor)]
    return [(path, value * factor)] if value != 0 and factor != 1 else []


def vector(path, old, new):
    return [(f"{path}.{i}", b) for i, (a, b) in enumerate(zip(old, new)) if a != b]


def gravity_of(case):
    g = case["gravity"]
    return ("gravity.value", g["value"]) if isinstance(g, dict) else ("gravity", g)


def kind_of(quantity):
    return quantity.split(".")[-2] if quantity[-2:] in (".x", ".y", ".z") else quantity.split(".")[-1]


def turned_answers(case):
    """Answers in components along the turned axes."""
    found = {}
    for one in case["expect"]:
        name, axis = one["quantity"][:-2], one["quantity"][-2:]
        if axis in (".x", ".y") and "value" in one:
            same = [e for e in case["expect"] if e["quantity"][:-2] == name and e.get("reduce") == one.get("reduce")]
            values = [next((e["value"] for e in same if e["quantity"][-2:] == a), 0.0) for a in (".x", ".y")]
            found[one["name"]] = turned(values)[".x .y".split().index(axis)]
    return found


def turned_keys(case):
    path, g = gravity_of(case)
    keys = vector(path, g, turned(g))
    for body in case["body"]:
        at = f"body.{body['name']}"
        for name in ("position", "velocity"):
            keys += vector(f"{at}.{name}", body.get(name, [0, 0, 0]), turned(body.get(name, [0, 0, 0])))
        keys.append((f"{at}.orientation.angle", body.get("orientation", {}).get("angle", 0.0) + turn))
        for i, load in enumerate(body.get("load", [])):
            keys += vector(f"{at}.load.{i}.force", load["force"], turned(load["force"]))
    return keys


def moved_keys(case):
    keys = []
    for body in case["body"]:
        old = body["position"]
        keys += vector(f"body.{body['name']}.position", old, [a + b for a, b in zip(old, away)])
    return keys


def scaled_keys(case, s):
    t, force = math.sqrt(s), s ** case.get("dimension", 3)
    keys = [("end", case["end"] * t)]
    if isinstance(case["gravity"], dict) and "ramp" in case["gravity"]:
        keys.append(("gravity.ramp", case["gravity"]["ramp"] * t))
    for name, material in case["material"].items():
        for key in ("normal_stiffness", "cohesion"):
            keys += numbers(f"material.{name}.{key}", material.get(key, []), s)
    for body in case["body"]:
        at = f"body.{body['name']}"
        (shape, size), = body["shape"].items()
        keys += numbers(f"{at}.shape.{shape}", size, s) + numbers(f"{at}.position", body.get("position", []), s)
        keys += numbers(f"{at}.velocity", body.get("velocity", []), t)
        keys += numbers(f"{at}.angular_velocity", body.get("angular_velocity", []), 1 / t)
        keys += numbers(f"{at}.repeat.pitch", body.get("repeat", {}).get("pitch", []), s)
        for i, load in enumerate(body.get("load", [])):
            keys += numbers(f"{at}.load.{i}.force", load["force"], force)
            keys += numbers(f"{at}.load.{i}.at", load.get("at", []), s)
            keys += [(f"{at}.load.{i}.{key}", load[key] * t) for key in ("start", "ramp", "stop") if key in load]
    return keys


def scaled_answers(case, s):
    """Answers, and the keys of the tolerances and windows that go with them."""
    answers, keys, t = {}, [], math.sqrt(s)
    for i, one in enumerate(case["expect"]):
        kind = kind_of(one["quantity"])
        force = s ** case.get("dimension", 3)
        factor = s if kind in lengths else t if kind in speeds else force if kind in forces else 1
        keys += [(f"expect.{i}.{key}", one[key] * t) for key in ("from", "to", "at") if key in one]
        keys += [(f"expect.{i}.{key}", one[key] * factor) for key in ("tolerance", "low", "high") if key in one and factor != 1]
        if "value" in one and factor != 1 and one["value"] != 0:
            answers[one["name"]] = one["value"] * factor
    return answers, keys


def number(value):
    text = f"{value:.10g}" if abs(value) < 1e5 else f"{value:.16g}"  # a coordinate on a map keeps its nanometres
    return text if set(text) & set(".e") else text + ".0"


def block(name, keys, answers):
    lines, line = [], "key  = ["
    for path, _ in keys:
        word = f'"{path}", '
        if len(line) + len(word) > 118:
            lines.append(line.rstrip())
            line = "        "
        line += word
    lines.append(line.rstrip(", ") + "]")
    text = f'\n[[vary]]\nname = "{name}"\n' + "\n".join(lines) + f"\nrows = [[{', '.join(number(v) for _, v in keys)}]]\n"
    for answer, value in answers.items():
        text += f'[[vary.expect]]\nname   = "{answer}"\nvalues = [{number(value)}]\n'
    return text


names = {"turn": "turned by 37 degrees", "map": "at map coordinates", "thousandth": "a thousandth in size",
         "thousand": "a thousand times in size"}


def variant(case, word):
    if word == "turn":
        return block(names[word], turned_keys(case), turned_answers(case))
    if word == "map":
        return block(names[word], moved_keys(case), {})
    s = {"thousandth": 1e-3, "thousand": 1e3}[word]
    answers, keys = scaled_answers(case, s)
    return block(names[word], scaled_keys(case, s) + keys, answers)


def stale():
    """Variants in the scenes that are not what this program prints."""
    for path in sorted(folder.glob("*/case.toml")):
        text = path.read_text()
        for word, name in names.items():
            if f'\nname = "{name}"\n' in text and variant(tomllib.loads(text), word) not in text + "\n":
                yield f"{path.parent.name}: {name}: not what validation/cross/variants.py {path.parent.name} {word} prints"


def main(arguments):
    if arguments == ["check"]:
        lines = list(stale())
        print(*lines, sep="\n", end="\n" if lines else "", file=sys.stderr)
        return 1 if lines else 0
    if not arguments:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    case = tomllib.loads((folder / arguments[0] / "case.toml").read_text())
    print(*(variant(case, word) for word in arguments[1:] or names), sep="", end="")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
