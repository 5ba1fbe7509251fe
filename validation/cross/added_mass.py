#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Added mass of a body in a tank of water at rest, for the exact answers of the wet scenes.

    validation/cross/added_mass.py            prints the numbers that the scenes cite

A body that begins to move with the acceleration e (of size 1) in an ideal fluid at rest makes the pressure p = -rho phi with

    laplace(phi) = 0 in the water,  d phi/dn = e . n on the body,  d phi/dn = 0 on floor and walls,  phi = 0 at the surface,

and its added mass along e is m_a = rho * integral of phi (e . n) over the body, n out of the water. The first acceleration of a free
body of mass m that displaces m_w of water is then g (m_w - m)/(m + m_a), up, where it moves along e alone by symmetry.

Solved by boundary elements of constant phi and d phi/dn (collocation at their middles): in a plane with the exact integrals of
log r over straight elements, in space with panels of four corners, one point for far panels and 6 x 6 points for near ones. Halving the elements
changes C_a of round bodies by less than 1 %; that of bodies with edges falls by 2 to 4 % more (the cube: 0.751, 0.733 with panels of half the size,
towards 0.72, which its scene cites), and an acceleration moves by 1 to 2 %, for bands of 15 %.
"""
import numpy as np


def polyline(points, size):
    """Elements along straight lines from point to point, none longer than size."""
    ends = []
    for a, b in zip(points[:-1], points[1:]):
        a, b = np.array(a, float), np.array(b, float)
        count = max(1, int(np.ceil(np.linalg.norm(b - a) / size)))
        t = np.linspace(0, 1, count + 1)
        ends += [(a + s * (b - a), a + e * (b - a)) for s, e in zip(t[:-1], t[1:])]
    return ends


def integrals_2d(x, a, b):
    """Integrals over the elements a to b of G = -log r/(2 pi) and of dG/dn, n to the right of a to b, seen from the points x."""
    d = b - a
    length = np.linalg.norm(d, axis=1)
    t = d / length[:, None]
    n = np.stack([t[:, 1], -t[:, 0]], axis=1)
    r = x[:, None, :] - a[None]
    along, off = np.einsum("ijk,jk->ij", r, t), np.einsum("ijk,jk->ij", r, n)
    u1, u2 = -along, length[None] - along
    r1, r2 = u1**2 + off**2, u2**2 + off**2
    angle = np.arctan2(u2, off) - np.arctan2(u1, off)
    angle = (angle + np.pi) % (2 * np.pi) - np.pi
    on_line = np.abs(off) < 1e-12 * length[None]
    half_log = 0.5 * (u2 * np.log(r2 + 1e-300) - u1 * np.log(r1 + 1e-300)) - (u2 - u1)
    g = -(half_log + np.where(on_line, 0, off * angle)) / (2 * np.pi)
    h = np.where(on_line, 0, angle) / (2 * np.pi)
    return g, h, n, length


def added_mass_2d(body, fixed, surface, direction, size, rho=1000.0):
    """Added mass per metre of width [kg/m]. Outlines go round the water counter-clockwise, so that it lies to their left."""
    parts = [polyline(line, size) for line in (body, *fixed, *surface)]
    ends = [e for part in parts for e in part]
    a, b = np.array([e[0] for e in ends]), np.array([e[1] for e in ends])
    kind = np.concatenate([[0] * len(parts[0]), *[[1] * len(p) for p in parts[1:1 + len(fixed)]],
                           *[[2] * len(p) for p in parts[1 + len(fixed):]]]).astype(int)
    middle = 0.5 * (a + b)
    g, h, n, length = integrals_2d(middle, a, b)
    np.fill_diagonal(h, 0.0)
    h += 0.5 * np.eye(len(h))
    # h phi = g q; unknown is q at the surface, phi elsewhere
    is_surface = kind == 2
    q = np.where(kind == 0, n @ np.array(direction, float), 0.0)
    matrix = np.where(is_surface[None], -g, h)
    right = g[:, ~is_surface] @ q[~is_surface]
    found = np.linalg.solve(matrix, right)
    phi = np.where(is_surface, 0, found)
    return rho * np.sum((phi * q * length)[kind == 0])


def tank(width, depth):
    walls = [[(0, depth), (0, 0), (width, 0), (width, depth)]]
    surface = [[(width, depth), (0, depth)]]
    return walls, surface


def hole(points):
    """Outline of a body inside the water: clockwise, so that the water lies to its left."""
    points = list(points)
    area = sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(points, points[1:] + points[:1]))
    points = points if area < 0 else points[::-1]
    return points + points[:1]


def circle(x, y, radius, count=96):
    angle = 2 * np.pi * np.arange(count) / count
    return hole(zip(x + radius * np.cos(angle), y + radius * np.sin(angle)))


def box(x, y, w, h, turn=0.0):
    c, s = np.cos(turn), np.sin(turn)
    corners = [(-w / 2, -h / 2), (w / 2, -h / 2), (w / 2, h / 2), (-w / 2, h / 2)]
    return hole([(x + c * u - s * v, y + s * u + c * v) for u, v in corners])


def panels_of_box(low, high, size, inward):
    """Panels (four corners each) on the six faces of a box by axis and side; their normals point inwards or outwards."""
    low, high = np.array(low, float), np.array(high, float)
    faces = {}
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, 1):
            nu, nv = (max(2, int(round((high[k] - low[k]) / size))) for k in (u, v))
            us, vs = np.linspace(low[u], high[u], nu + 1), np.linspace(low[v], high[v], nv + 1)
            quads = []
            for i in range(nu):
                for j in range(nv):
                    quad = np.zeros((4, 3))
                    quad[:, axis] = (low, high)[side][axis]
                    quad[:, u], quad[:, v] = us[[i, i + 1, i + 1, i]], vs[[j, j, j + 1, j + 1]]
                    quads.append(quad if (side == 1) != inward else quad[::-1])
            faces[(axis, side)] = np.array(quads)
    return faces


def panels_of_ball(centre, radius, count):
    """Panels of a cube blown up to a ball; normals point inwards, out of the water."""
    cube = panels_of_box([-1, -1, -1], [1, 1, 1], 2.0 / count, inward=True)
    quads = np.concatenate(list(cube.values()))
    angle = np.tan(quads * np.pi / 4)
    unit = angle / np.linalg.norm(angle, axis=2, keepdims=True)
    return np.array(centre) + radius * unit


def added_mass_3d(body, fixed, surface, direction, rho=1000.0):
    """Added mass [kg]; panels with normals out of the water."""
    quads = np.concatenate([body, fixed, surface])
    kind = np.array([0] * len(body) + [1] * len(fixed) + [2] * len(surface))
    middle = quads.mean(axis=1)
    cross = 0.5 * np.cross(quads[:, 2] - quads[:, 0], quads[:, 3] - quads[:, 1])
    area = np.linalg.norm(cross, axis=1)
    n = cross / area[:, None]
    r = middle[:, None] - middle[None]
    distance = np.linalg.norm(r, axis=2)
    np.fill_diagonal(distance, 1.0)
    g = area[None] / (4 * np.pi * distance)
    h = np.einsum("ijk,jk->ij", r, n) * area[None] / (4 * np.pi * distance**3)
    near = distance < 4 * np.sqrt(area)[None]
    count = 6
    s = (np.arange(count) + 0.5) / count
    u, v = (x.ravel() for x in np.meshgrid(s, s))
    weights = np.stack([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v], axis=1)
    points = np.einsum("pk,jkd->jpd", weights, quads)
    for i, j in np.argwhere(near):
        if i == j:
            continue
        d = middle[i] - points[j]
        size = np.linalg.norm(d, axis=1)
        g[i, j] = area[j] / count**2 * np.sum(1 / size) / (4 * np.pi)
        h[i, j] = area[j] / count**2 * np.sum(d @ n[j] / size**3) / (4 * np.pi)
    # over a panel seen from its own middle: that of a square, 4 a log(1 + sqrt 2)/(4 pi) of side a
    np.fill_diagonal(g, np.sqrt(area) * 4 * np.log(1 + np.sqrt(2)) / (4 * np.pi))
    np.fill_diagonal(h, 0.0)
    # G = 1/(4 pi r): dG/dn at the panel, n out of the water, is +r.n/(4 pi r^3) with r from panel to point.
    # 1/2 phi + sum phi dG/dn = sum G q, and the row sum of a closed surface is -1/2.
    np.fill_diagonal(h, -h.sum(axis=1))  # constant phi has q = 0
    is_surface = kind == 2
    q = np.where(kind == 0, n @ np.array(direction, float), 0.0)
    matrix = np.where(is_surface[None], -g, h)
    found = np.linalg.solve(matrix, g[:, ~is_surface] @ q[~is_surface])
    phi = np.where(is_surface, 0, found)
    return rho * np.sum((phi * q * area)[kind == 0])


def first_acceleration(mass, water, added, g=9.81):
    return g * (water - mass) / (mass + added)


def scenes_in_a_plane(size=0.02):
    walls, surface = tank(1.6, 1.2)
    hexagon = [(0.8 + 0.18 * np.cos(np.pi * k / 3), 0.6 + 0.18 * np.sin(np.pi * k / 3)) for k in range(6)]
    shapes = {
        "disc": (circle(0.8, 0.6, 0.16), np.pi * 0.16**2),
        "box": (box(0.8, 0.6, 0.32, 0.24), 0.32 * 0.24),
        "box on its corner": (box(0.8, 0.6, 0.28, 0.28, np.pi / 4), 0.28**2),
        "hexagon": (hole(hexagon), 1.5 * np.sqrt(3) * 0.18**2),
    }
    for name, (outline, area) in shapes.items():
        added = added_mass_2d(outline, walls, surface, (0, 1), size)
        print(f"{name}: added mass {added:.2f} kg/m, C_a {added / (1000 * area):.4f}; first acceleration",
              ", ".join(f"{s}: {first_acceleration(1000 * s * area, 1000 * area, added):.5f}" for s in (0.7, 1.5, 2.5)))
    # a block of 0.4 x 0.2 m on the floor: the water ends at its sides
    body = [(0.6, 0.0), (0.6, 0.2), (1.0, 0.2), (1.0, 0.0)]
    floor = [[(0, 1.2), (0, 0), (0.6, 0)], [(1.0, 0), (1.6, 0), (1.6, 1.2)]]
    added = added_mass_2d(body, floor, surface, (1, 0), size)
    print(f"block on the floor, along it: added mass {added:.2f} kg/m, C_a {added / 80:.4f}")


def open_tank(sides, size):
    """Panels of floor and walls, and of the surface, of a tank full to its top."""
    faces = panels_of_box((0, 0, 0), sides, size, inward=False)
    surface = faces.pop((2, 1))
    return np.concatenate(list(faces.values())), surface


def scenes_in_space(size=0.1, count=8):
    fixed, surface = open_tank((0.8, 0.8, 0.8), size)
    volume = 4 / 3 * np.pi * 0.16**3
    added = added_mass_3d(panels_of_ball((0.4, 0.4, 0.4), 0.16, count), fixed, surface, (0, 0, 1))
    print(f"ball: added mass {added:.4f} kg, C_a {added / (1000 * volume):.4f}; first acceleration",
          ", ".join(f"{s}: {first_acceleration(1000 * s * volume, 1000 * volume, added):.5f}" for s in (0.7, 1.5, 2.5)))
    cube = np.concatenate(list(panels_of_box((0.26, 0.26, 0.26), (0.54, 0.54, 0.54), 0.28 / count, inward=True).values()))
    volume = 0.28**3
    added = added_mass_3d(cube, fixed, surface, (0, 0, 1))
    print(f"cube: added mass {added:.4f} kg, C_a {added / (1000 * volume):.4f}; first acceleration",
          ", ".join(f"{s}: {first_acceleration(1000 * s * volume, 1000 * volume, added):.5f}" for s in (0.7, 1.5, 2.5)))
    # a cube of 0.3 m on the floor: the water ends at its sides
    fixed, surface = open_tank((0.8, 0.8, 0.8), 0.05)
    is_free = np.any(np.abs(fixed.mean(axis=1) - (0.4, 0.4, 0.0)) > (0.15, 0.15, 1e-9), axis=1)
    faces = panels_of_box((0.25, 0.25, 0.0), (0.55, 0.55, 0.3), 0.05, inward=True)
    faces.pop((2, 0))
    cube = np.concatenate(list(faces.values()))
    added = added_mass_3d(cube, fixed[is_free], surface, (1, 0, 0))
    print(f"cube on the floor, along it: added mass {added:.4f} kg, C_a {added / 27:.4f}")


if __name__ == "__main__":
    scenes_in_a_plane()
    scenes_in_space()
