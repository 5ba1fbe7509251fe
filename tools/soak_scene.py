# SPDX-License-Identifier: Apache-2.0
"""Random scenes for tools/soak: a tank or a floor with a few bodies, and features drawn at random around them.

Every scene is small: a step takes a few milliseconds. What a pair of methods lacks is refused by `riprap check`, and
the next scene is drawn; `Scene.features` says what a scene has, so that the soak can count what it tried.
"""

SOLIDS = ["distance_potential_dem", "sphere_dem", "explicit_dda", "implicit_dda", "planar_dda"]
PARTICLES = ["sph", "wcmps", "mps"]
FLUIDS = [None, "sph", "wcmps", "mps", "grid", "hydrostatic"]
WIDTH, HEIGHT, BREADTH, LEVEL = 1.0, 0.8, 0.6, 0.3  # of the tank [m]


def written(value):
    """A value of TOML; strings that begin with { are tables already."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return value if value.startswith("{") else f'"{value}"'
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(written(entry) for entry in value) + "]"
    return f"{value:.6g}"


class Scene:
    def __init__(self, chance):
        self.chance, self.features, self.parts, self.top = chance, [], [], {}
        self.is_planar = chance.random() < 0.65
        self.solid = chance.choice(SOLIDS if self.is_planar else SOLIDS[:-1])
        self.fluid = chance.choice(FLUIDS)
        self.features.append(f"{self.solid} with {self.fluid or 'no fluid'} in {'a plane' if self.is_planar else 'space'}")
        self.spacing = chance.choice([0.02, 0.025] if self.is_planar else [0.05])
        self.is_open = self.fluid in ["sph", "grid"] and self.has(0.25, "openings")
        self.all_stand = self.fluid == "sph" and self.has(0.3, "two clocks")  # which need walls that stand
        self.draw_top()
        self.draw_materials()
        self.draw_solid()
        self.draw_ground()
        self.draw_bodies()
        if self.fluid:
            self.draw_fluid()
        self.draw_output()

    def has(self, probability, *features):
        """Draws whether the scene has a feature, and notes it."""
        drawn = self.chance.random() < probability
        if drawn:
            self.features.extend(features)
        return drawn

    def between(self, low, high):
        return self.chance.uniform(low, high)

    def point(self, x, y, z=None):
        """x along the tank, y across it, z up; without y in a plane."""
        return [x, z] if self.is_planar else [x, y, z]

    def add(self, heading, /, **keys):
        self.parts.append(f"{heading}\n" + "".join(f"{key} = {written(value)}\n" for key, value in keys.items()))

    def draw_top(self):
        end = self.chance.choice([0.02, 0.1, 1.0])
        down = self.point(0.0, 0.0, -9.81)
        self.top = {"dimension": 2 if self.is_planar else 3, "end": end, "seed": self.chance.randint(1, 99)}
        if not self.is_open and self.has(0.15, "turning gravity"):
            axis = [0.0, 0.0, 1.0] if self.is_planar else [0.0, 1.0, 0.0]
            turn = (f"{{ axis = {axis}, time = [0.0, 0.01, {end}], angle = [0.0, 0.1, {self.between(-0.5, 0.5):.4g}] }}"
                    if self.chance.random() < 0.5 else f"{{ axis = {axis}, rate = {self.between(-1, 1):.4g}, start = 0.005 }}")
            self.top["gravity"] = f"{{ value = {down}, ramp = {self.chance.choice([0.0, 0.02])}, rotation = {turn} }}"
        elif not self.is_open and self.has(0.1, "growing gravity"):
            self.top["gravity"] = f"{{ value = {down}, ramp = {self.between(0.005, 0.2):.4g} }}"
        else:
            self.top["gravity"] = down
        if self.fluid not in PARTICLES and self.has(0.25, "settle"):
            self.top["settle"] = self.between(0.002, 0.05)
            if self.has(0.5, "settle_static"):
                self.top["settle_static"] = True
            if self.has(0.3, "settle_friction"):
                self.top["settle_friction"] = self.between(0.0, 2.0)
            if self.has(0.2, "settle_time_step"):
                self.top["settle_time_step"] = 1e-5
        if self.chance.random() < 0.4:
            self.top["time_step_factor"] = self.between(0.2, 1.0)

    @property
    def turns(self):
        return isinstance(self.top["gravity"], str)

    def draw_materials(self):
        soft = self.has(0.25, "soft contacts")
        keys = {"density": self.chance.choice([400.0, 900.0, 1500.0, 2600.0]),
                "normal_stiffness": 10 ** (self.between(3.5, 5) if soft else self.between(5.5, 7.5)),
                "friction_coefficient": self.chance.choice([0.0, 0.3, 0.8])}
        if self.solid != "implicit_dda" and self.chance.random() < 0.5:
            keys["damping_ratio"] = self.between(0.01, 0.5)
        if self.has(0.25, "cohesion"):
            keys["cohesion"] = 10 ** self.between(1, 5)
            if self.solid.endswith("dda") and self.has(0.5, "tensile strength"):
                keys["tensile_strength"] = 10 ** self.between(1, 5)
        if self.solid in ["sphere_dem", "explicit_dda", "planar_dda"] and self.has(0.3, "restitution"):
            keys["restitution"] = self.between(0.2, 1.0)
        self.add("[material.rock]", **keys)
        if self.has(0.3, "two materials"):
            self.add("[material.ground]", **{**keys, "density": 2000.0, "friction_coefficient": 0.5})
            self.add("[contact]", friction_mixing=self.chance.choice(["minimum", "mean", "harmonic"]))
            if self.has(0.5, "a pair of materials"):
                self.add("[[contact.pair]]", materials=["rock", "ground"], friction_coefficient=0.4)
            self.ground = "ground"
        else:
            self.ground = "rock"

    def draw_solid(self):
        choices = {
            "distance_potential_dem": {
                "contact": ["common_plane_soft", "common_plane_penalty"], "corners": ["field"], "tangential_law": ["tanh"],
                "local_damping": [0.3], "mass_damping": [2.0], "max_potential": [0.3]},
            "sphere_dem": {
                "spheres": ["one", "balls"], "normal_law": ["linear"], "tangential_law": ["tanh"], "normals": ["faces"],
                "rolling": ["constant", "spring"], "sharing": ["sum", "divide", "closest"], "kinetic_share": [0.7],
                "allows_pull": [False], "max_overlap": [0.05], "local_damping": [0.3]},
            "explicit_dda": {"form": ["twelve_unknowns"], "contact_stiffness": [1e5, 1e7], "mass_damping": [2.0],
                             "youngs_modulus": [1e7]},
            "implicit_dda": {"solver": ["pcg_cholesky", "sor"], "dynamic_factor": [0.0, 0.9], "open_close": [3],
                             "max_displacement": [0.01], "slide_tolerance": [1e-6], "contact_stiffness": [1e6, 1e8],
                             "step": [2e-4]},
            "planar_dda": {"plane": ["strain"], "normal_contact": ["augmented_lagrange"], "dynamic_factor": [0.0, 0.9],
                           "open_close": [3], "displacement_limit": [0.01], "contact_stiffness": [1e6, 1e8],
                           "step": [2e-4]},
        }[self.solid]
        keys = {"method": self.solid}
        for key in self.chance.sample(sorted(choices), self.chance.choice([0, 0, 1, 2])):
            keys[key] = self.chance.choice(choices[key])
            self.features.append(f"solid.{key}")
        if keys.get("rolling") and "rolling_friction" not in keys:
            keys["rolling_friction"] = 0.1
        self.add("[solid]", **keys)

    def draw_ground(self):
        kind = self.chance.choice(["plane", "box", "two boxes", "terrain"])
        shape = {"plane": f"{{ half_space = {{ normal = {self.point(0.0, 0.0, 1.0)} }} }}",
                 "box": f"{{ box = {self.point(1.2 * WIDTH, BREADTH, 0.2)} }}",
                 "two boxes": f"{{ box = {self.point(0.6, BREADTH, 0.2)} }}",
                 "terrain": "{ terrain = { profile = [[-0.1, 0.05], [0.3, 0.0], [0.6, 0.06], [1.1, 0.0]] } }"}[kind]
        if kind == "terrain" and (self.is_open or not self.is_planar):
            kind, shape = "plane", f"{{ half_space = {{ normal = {self.point(0.0, 0.0, 1.0)} }} }}"
        self.features.append(f"ground: {kind}")
        self.floor = 0.062 if kind == "terrain" else 0.0
        places = {"box": [self.point(0.5, 0.2, -0.1)], "two boxes": [self.point(x, 0.2, -0.1) for x in (0.2, 0.8)]}
        for number, place in enumerate(places.get(kind, [self.point(0.0, 0.0, 0.0)])):
            self.add("[[body]]", name=f"ground_{number}", material=self.ground, shape=shape, position=place, fixed=True)

    def shape(self, size):
        """A random shape about its centre; `size` is its least height."""
        planar = {"box": f"{{ box = [{size * 1.4}, {size}] }}", "disc": f"{{ sphere = {size / 2} }}",
                  "polygon": f"{{ polygon = [[{-size}, {-size / 2}], [{size}, {-size / 2}], [{size / 2}, {size / 2}]] }}",
                  "hexagon": f"{{ prism = {{ sides = 6, circumradius = {size / 2} }} }}",
                  "tetrapod": f"{{ armour = {{ unit = \"tetrapod\", nominal_diameter = {size} }} }}",
                  "union": f"{{ union = [{{ shape = {{ box = [{size}, {size}] }} }}, {{ shape = {{ box = [{size}, {size}] }}, "
                           f"position = [{size}, 0.0] }}] }}"}
        space = {"box": f"{{ box = [{size * 1.4}, {size * 1.2}, {size}] }}", "ball": f"{{ sphere = {size / 2} }}",
                 "tetrahedron": f"{{ tetrahedron = {size * 1.2} }}", "octahedron": f"{{ octahedron = {size * 0.7} }}",
                 "stone": f"{{ random_hull = {{ circumradius = {size / 2}, seed = {self.chance.randint(1, 9)} }} }}",
                 "cube": f"{{ cube = {size} }}"}
        kinds = planar if self.is_planar else space
        if self.solid.endswith("dda"):
            kinds = {name: kinds[name] for name in kinds if name not in ("union", "tetrapod")}
        kind = self.chance.choice(sorted(kinds))
        self.features.append(f"shape: {kind}")
        return kind, kinds[kind]

    def draw_bodies(self):
        size = self.chance.choice([0.08, 0.12])
        count = self.chance.choice([1, 2]) if self.is_open else self.chance.choice([1, 2, 3])
        first = 0.45 if self.is_open else 0.2
        for number in range(count):
            kind, shape = self.shape(size)
            keys = {"name": f"block_{number}", "material": "rock", "shape": shape}
            lift = self.chance.choice([0.0, 1e-4, 0.02]) + (0.0 if kind in ("box", "cube") else 0.3 * size)
            keys["position"] = self.point(first + 0.28 * number, 0.2, self.floor + size / 2 + lift)
            is_driven = number > 0 and not self.all_stand and self.has(0.3, "motion")
            if self.all_stand:
                keys["fixed"] = True
            elif is_driven:
                keys["motion"] = self.motion(keys["position"])
                if self.has(0.2, "release of a driven body"):
                    keys["release_time"] = self.between(0.001, 0.02)
            elif self.solid in ["distance_potential_dem", "sphere_dem"] and self.has(0.2, "locked"):
                keys["locked"] = [self.chance.choice(["x", "rotation_z"])]
            elif self.has(0.1, "release_time"):
                keys["fixed"], keys["release_time"] = True, self.between(0.001, 0.02)
            elif self.chance.random() < 0.3:
                keys["velocity"] = self.point(self.between(-1, 1), self.between(-0.3, 0.3), self.between(-3, 0))
            elif self.chance.random() < 0.2:
                keys["angular_velocity"] = self.between(-3, 3) if self.is_planar else [self.between(-3, 3) for _ in range(3)]
            if not is_driven and not self.all_stand and self.has(0.15, "loads"):
                push = self.point(self.between(-50, 50), 0.0, self.between(-50, 50))
                keys["load"] = ([f"{{ force = {push}, start = 0.003, ramp = 0.01 }}"
                                                    if self.chance.random() < 0.5 else
                                                    f"{{ table = {{ time = [0.0, 0.01, 0.02], force = [{push}, "
                                                    f"{self.point(0.0, 0.0, 0.0)}, {push}] }} }}"])
            if self.solid == "sphere_dem" and kind == "disc" and self.has(0.5, "rings of spheres"):
                keys["spheres"] = f"{{ ring = {self.chance.choice([6, 12])} }}"
            if self.solid == "sphere_dem" and kind in ("box", "cube") and self.has(0.5, "shells of spheres"):
                keys["spheres"] = "{ shell = 3 }"
            self.add("[[body]]", **keys)
            if self.solid.endswith("dda") and self.solid != "explicit_dda" and self.has(0.15, "fixed point"):
                self.add("[[fixed_point]]", body=keys["name"], at=keys["position"])
        if count > 1 and self.solid == "planar_dda" and self.has(0.4, "bolt"):
            ends = [self.point(first + 0.28 * number, 0.2, self.floor + size / 2) for number in (0, 1)]
            self.add("[[bolt]]", bodies=["block_0", "block_1"], ends=ends, stiffness=1e5, pretension=self.chance.choice([0.0, 20.0]))
        if not self.all_stand:
            self.draw_rows(size)

    def draw_rows(self, size):
        """Bodies of one entry: rows, packs, rock cut by joints."""
        high = self.floor + 2.6 * size
        if self.has(0.15, "repeat"):
            shape = f"{{ box = {self.point(0.07, 0.07, 0.07)} }}"
            if self.chance.random() < 0.4 and self.fluid is None:
                shape = "{ sphere = 0.035 }"
                self.features.append("cluster of balls")
            pitch = self.point(0.09, 0.09, 0.09)
            self.add("[[body]]", name="row", material="rock", shape=shape, position=self.point(0.3, 0.15, high),
                     repeat=f"{{ counts = {[3, 2] if self.is_planar else [2, 2, 2]}, pitch = {pitch}, jitter = 0.005 }}")
        elif self.is_planar and self.has(0.15, "section"):
            low, top = high, high + 0.16
            self.add("[[section]]", name="rock", material="rock",
                     outline=[[0.3, low], [0.62, low], [0.62, top], [0.3, top]],
                     joint_set=[f"{{ angle = {self.between(0.1, 1.4):.3g}, spacing = 0.11 }}"])
        elif not self.is_planar and self.has(0.15, "rock mass"):
            self.add("[[rock_mass]]", name="rock", material="rock", region="{ box = [0.3, 0.2, 0.16] }",
                     position=[0.5, 0.2, high + 0.1],
                     joint_set=["{ dip = 0.3, dip_direction = 1.0, spacing = 0.1 }", "{ dip = 1.4, dip_direction = 0.4, spacing = 0.15 }"])
        elif not self.is_planar and self.has(0.2, "pack"):
            self.add("[[pack]]", name="pack", material="rock",
                     voronoi=f"{{ region = {{ box = [0.3, 0.2, 0.16] }}, position = "
                             f"[0.5, 0.2, {high + 0.1:.6g}], count = {self.chance.randint(2, 7)}, gap = 0.002 }}")
            if self.has(0.6, "damage"):
                self.add("[[output.damage]]", name="layer", bodies=["pack"], distance=0.001,
                         width=0.4)

    def motion(self, position):
        small = self.point(0.01, 0.0, 0.005)
        kind = self.chance.choice(["linear", "sinusoidal", "table", "rotation"])
        self.features.append(f"motion: {kind}")
        law = {"linear": f"{{ velocity = {self.point(0.3, 0.0, 0.0)} }}",
               "sinusoidal": f"{{ amplitude = {small}, period = 0.2, ramp = {self.chance.choice([0.0, 0.1])} }}",
               "table": f"{{ time = [0.0, 0.004, 0.03], displacement = [{self.point(0.0, 0.0, 0.0)}, "
                        f"{self.point(0.001, 0.0, 0.0)}, {self.point(0.0, 0.0, 0.002)}] }}",
               "rotation": f"{{ center = {position}, axis = {[0.0, 0.0, 1.0] if self.is_planar else [0.0, 1.0, 0.0]}, rate = 1.0 }}"}
        times = self.chance.choice(["", ", start = 0.005", ", stop = 0.01"])
        return f"{{ {kind} = {law[kind]}{times} }}"

    def draw_fluid(self):
        keys = {}
        low = self.point(0.0, 0.0, -0.2 if self.fluid in PARTICLES else 0.0)
        high = self.point(WIDTH, BREADTH, HEIGHT)
        domain = f"{{ low = {low}, high = {high}"
        if self.fluid in PARTICLES:
            along = not self.is_open and self.has(0.35, "periodic sides")
            periodic = [along, False] if self.is_planar else [along, True, False]
            if not self.is_planar:
                keys["joint_pressure"] = False  # a loose block would meet its own joints across so narrow a tank
            domain += f", periodic = {written(periodic)}"
            if not along and not self.is_open:
                for number, side in enumerate([1.0, -1.0]):
                    if number == 0 and not self.turns and not self.all_stand and self.has(0.35, "wave maker"):
                        continue
                    self.add("[[body]]", name=f"side_{number}", material=self.ground, fixed=True, position=self.point(WIDTH * number, 0.0, 0.0),
                             shape=f"{{ half_space = {{ normal = {self.point(side, 0.0, 0.0)} }} }}")
        domain += " }"
        keys.update(method=self.fluid, spacing=self.spacing, domain=domain)
        choices = {
            "sph": {"viscosity": ["laminar_sps"], "state_equation": ["linear"], "sort_interval": [3], "wall": ["penalty"],
                    "joint_pressure": [False], "jitter": [0.1], "expected_speed": [2.0]},
            "wcmps": {"wall": ["penalty"], "joint_pressure": [False], "jitter": [0.1], "expected_speed": [2.0]},
            "mps": {"wall": ["penalty"], "joint_pressure": [False], "jitter": [0.1], "gradient": ["corrected"], "courant": [0.1]},
            "grid": {"turbulence": ["k_epsilon", "k_epsilon_stable"], "vof": ["compressive"], "outer_corrections": [2],
                     "domain_walls": ["no_slip", "wall_function"], "surface_tension": [0.07], "coupling": ["one_way"],
                     "pressure_corrections": [2], "open_top": [False], "wall_narrowing": [0.3]},
            "hydrostatic": {"uplift": ["linear", "none"]},
        }[self.fluid]
        for key in self.chance.sample(sorted(choices), self.chance.choice([0, 1, 1, 2]) if len(choices) > 1 else 1):
            keys[key] = self.chance.choice(choices[key])
            self.features.append(f"fluid.{key}")
        if self.all_stand:
            keys["sound_steps"] = self.chance.choice([2, 4, 8])
        if self.fluid == "hydrostatic" and self.has(0.5, "levels"):
            keys["levels"] = [[0.0, LEVEL], [0.05, LEVEL - 0.1], [1.0, LEVEL]]
        self.add("[fluid]", **keys)
        self.draw_water()
        self.draw_gauges()

    def draw_water(self):
        inside = self.is_open and self.fluid in PARTICLES  # between the openings
        part = 0.8 if inside else self.chance.choice([0.4, WIDTH])
        low = self.point(0.2 if inside else 0.0, 0.0, 0.0)
        self.add("[[fluid.region]]", box=f"{{ low = {low}, high = {self.point(part, BREADTH, LEVEL)} }}",
                 **({"velocity": self.point(self.between(-0.5, 0.5), 0.0, 0.0)} if self.has(0.3, "moving water") else {}))
        if "wave maker" in self.features:
            absorb = f", absorb = {low}" if self.has(0.4, "absorbing paddle") else ""
            wave = self.chance.choice(["wave = \"regular\", period = 1.0", "wave = \"irregular\", period = 1.0",
                                       "wave = \"solitary\"", "wave = \"second_order\", period = 1.0"])
            self.add("[[body]]", name="paddle", material=self.ground, shape=f"{{ half_space = {{ normal = {self.point(1.0, 0.0, 0.0)} }} }}",
                     motion=f"{{ wave_maker = {{ {wave}, height = 0.04, depth = {LEVEL}{absorb} }} }}")
        if self.fluid == "grid":
            if self.has(0.3, "porous layer"):
                self.add("[[fluid.porous]]", box=f"{{ low = {self.point(0.7, 0.0, 0.0)}, high = {self.point(0.9, BREADTH, 0.2)} }}",
                         porosity=0.4, grain_size=0.02, linear=50.0, quadratic=2.0,
                         closure=self.chance.choice(["ding", "van_gent", "engelund"]))
            if self.is_planar and not self.is_open and not self.turns and self.has(0.3, "waves through a side"):
                wave = self.chance.choice(["solitary", "regular", "irregular"])
                self.add("[[fluid.wave]]", towards="x", wave=wave, height=5.2 * self.spacing, depth=LEVEL,
                         **({} if wave == "solitary" else {"period": 1.0}), absorb=self.chance.random() < 0.5)
        if self.fluid != "hydrostatic":
            if self.has(0.15, "sponge"):
                self.add("[[fluid.sponge]]", low=self.point(0.7, 0.0, 0.0), high=self.point(1.0, BREADTH, 0.5), towards="x")
            if self.is_open:
                self.draw_openings()

    def draw_openings(self):
        first, last = (0.2, 0.8) if self.fluid in PARTICLES else (0.0, WIDTH)
        if self.has(0.7, "inflow"):
            self.add("[[fluid.inflow]]", name="source", low=self.point(first, 0.0, 0.0), high=self.point(first, BREADTH, LEVEL if self.fluid in PARTICLES else 0.2), towards="x",
                     speed=0.4, ramp=self.chance.choice([0.0, 0.02]))
        if self.has(0.7, "outflow"):
            self.add("[[fluid.outflow]]", name="drain", low=self.point(last, 0.0, 0.0), high=self.point(last, BREADTH, HEIGHT), towards="x",
                     **self.chance.choice([{}, {"speed": 0.3}, {"level": 0.2}]))

    def draw_gauges(self):
        if self.fluid == "hydrostatic":
            return
        for number in range(self.chance.choice([0, 1, 2, 3])):
            kind = self.chance.choice(["pressure", "velocity", "level", "volume", "centre", "flow", "run_up"])
            keys = {"name": f"gauge_{number}", "kind": kind, "point": self.point(0.52, 0.2, 0.2)}
            if kind in ("volume", "centre", "flow", "run_up"):
                keys["end"] = self.point(0.52 if kind == "flow" else 0.95, 0.35, 0.7)
            self.features.append(f"gauge: {kind}")
            if self.has(0.4, "gauge with response"):
                keys["response"] = self.between(0.001, 0.1)
            if kind in ("pressure", "velocity", "level") and self.has(0.2, "gauge on a body"):
                keys["body"] = "block_0"
            self.add("[[output.gauge]]", **keys)

    def draw_output(self):
        for body in ["block_0"]:
            quantities = ["position", "velocity", "contact_force", "rotation_vector"] + (["fluid_force"] if self.fluid else [])
            self.add("[[output.probe]]", body=body, quantity=self.chance.choice(quantities))
        for reduce in self.chance.sample(["min", "max", "mean", "extreme", "last", "time_of_max"], 2):
            self.add("[[expect]]", name=f"the {reduce} of it", quantity=self.chance.choice(["solid.kinetic", "block_0.speed", "block_0.position.x"]),
                     reduce=reduce, low=-1e9, high=1e9, citation="followed, not judged")

    def text(self):
        top = "".join(f"{key} = {written(value)}\n" for key, value in self.top.items())
        return top + "\n" + "\n".join(self.parts)
