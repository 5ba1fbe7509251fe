// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "command_line_parts.hpp"
#include "riprap/core/error.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/drive/find_case.hpp"

namespace riprap {

namespace {

constexpr std::string_view dry_case =
    R"(# Run it with `riprap run {name}`; `riprap check {name}` says what it would take. All keys: `riprap schema --keys`.
format  = 1
title   = "{name}"
gravity = [0.0, 0.0, -9.81]                # [m/s^2]
end     = 2.0                              # [s]

[material.rock]
density            = 2600.0                # [kg/m^3]
normal_stiffness   = "20 MPa"              # of contacts: softer is faster, and sinks in deeper
friction_angle_deg = 30.0
damping_ratio      = 0.2                   # of contacts, of critical damping

[[body]]
name     = "ground"
shape    = {{ half_space = {{ normal = [0.0, 0.0, 1.0] }} }}  # or terrain = {{ file = "heights.asc" }}
material = "rock"
fixed    = true

[[body]]
name        = "block"
shape       = {{ box = [1.0, 1.0, 0.5] }}    # [m]
position    = [0.0, 0.0, 1.0]
orientation = {{ axis_angle = {{ axis = [1.0, 0.0, 0.0], angle_deg = 20.0 }} }}
material    = "rock"

[[output.probe]]                           # a column of probes.csv
body     = "block"
quantity = "position"

[[expect]]                                 # what the run has to come to
name      = "the block lies on the ground"
quantity  = "block.position.z"
value     = 0.25                           # [m]
tolerance = 0.01
citation  = "half its height"
)";

constexpr std::string_view wet_case =
    R"(# Run it with `riprap run {name}`; `riprap check {name}` says what it would take. All keys: `riprap schema --keys`.
format    = 1
title     = "{name}"
dimension = 2                              # a slice in x and y; leave it out for three dimensions
gravity   = [0.0, -9.81]                   # [m/s^2]
end       = 3.0                            # [s]

[material.concrete]
density              = 2400.0              # [kg/m^3]
normal_stiffness     = "10 MPa"
friction_coefficient = 0.6
damping_ratio        = 0.2

[fluid]
spacing = 0.02                             # [m], of the particles: half of it takes about eight times as long
domain  = {{ low = [0.0, -0.1], high = [2.0, 2.0] }}   # high enough for what splashes up

[[fluid.region]]                           # a column of water that falls
box = {{ low = [0.0, 0.0], high = [0.5, 0.5] }}

[[body]]
name     = "floor"
shape    = {{ half_space = {{ normal = [0.0, 1.0] }} }}
material = "concrete"
fixed    = true

[[body]]
name     = "left"
shape    = {{ half_space = {{ normal = [1.0, 0.0] }} }}
material = "concrete"
fixed    = true

[[body]]
name     = "right"
shape    = {{ half_space = {{ normal = [-1.0, 0.0] }} }}
position = [2.0, 0.0]
material = "concrete"
fixed    = true

[[body]]
name     = "block"                         # in the way of the wave
shape    = {{ box = [0.2, 0.2] }}
position = [1.2, 0.1]
material = "concrete"

[[output.probe]]
body     = "block"
quantity = "displacement"

[[output.gauge]]
name  = "level"                            # before the block
kind  = "level"
point = [1.0, 0.0]
)";

constexpr std::string_view sphere_case =
    R"(# Run it with `riprap run {name}`; `riprap check {name}` says what it would take. All keys: `riprap schema --keys`.
format  = 1
title   = "{name}"
gravity = [0.0, 0.0, -9.81]                # [m/s^2]
end     = 1.5                              # [s]

[material.glass]
density              = 2500.0              # [kg/m^3]
youngs_modulus       = "5 MPa"             # softer than glass, so that a step may be a hundred times as long
poisson_ratio        = 0.25
restitution          = 0.7
friction_coefficient = 0.5

[solid]
method           = "sphere_dem"            # Hertz with this restitution, Mindlin with history
rolling          = "spring"                # resistance to rolling, without which a heap runs flat
rolling_friction = 0.2

[[body]]
name     = "floor"
shape    = {{ half_space = {{ normal = [0.0, 0.0, 1.0] }} }}
material = "glass"
fixed    = true

[[body]]
name     = "post"                          # bodies that cannot move keep their faces; surfaces from files do, too
shape    = {{ box = [0.04, 0.04, 0.1] }}     # [m]
position = [0.0, 0.0, 0.05]
material = "glass"
fixed    = true

[[body]]
name     = "ball"
shape    = {{ sphere = 0.01 }}               # [m]
position = [-0.0525, -0.0525, 0.16]
material = "glass"
repeat   = {{ counts = [6, 6, 8], pitch = [0.021, 0.021, 0.022], stagger = 0.004 }}

[[body]]
name     = "stone"                         # many spheres that move as one, here a shell of 5 x 5 x 5
shape    = {{ box = [0.06, 0.06, 0.06] }}
position = [0.12, 0.0, 0.03]
spheres  = {{ shell = 5 }}
material = "glass"

[[output.probe]]                           # a column of probes.csv
body     = "stone"
quantity = "displacement"

[[output.probe]]
quantity = "solid.kinetic"

[[expect]]                                 # what the run has to come to
name      = "the heap lies still"
quantity  = "solid.kinetic"
value     = 0.0                            # [J]
tolerance = 0.06
citation  = "1 % of the fall"
)";

void refuse_existing(const std::filesystem::path& folder) {
    if (std::filesystem::exists(folder)) {
        throw FileError(fmt::format("'{}' exists already; choose another name", folder.string()));
    }
}

/// Copies a known case with the files that lie beside it.
int copy_case(const std::string& name, const std::string& known) {
    const std::filesystem::path folder(name), from = run::find_case(known);
    refuse_existing(folder);
    std::error_code problem;
    if (from.filename() == "case.toml") {
        std::filesystem::create_directories(folder.has_parent_path() ? folder.parent_path() : ".");
        std::filesystem::copy(from.parent_path(), folder, std::filesystem::copy_options::recursive, problem);
    } else {
        std::filesystem::create_directories(folder);
        std::filesystem::copy_file(from, folder / "case.toml", problem);
    }
    if (problem) {
        throw FileError(fmt::format("'{}' cannot be copied to '{}': {}", from.string(), name, problem.message()));
    }
    fmt::print("{}\n", (folder / "case.toml").string());
    return 0;
}

int write_case(const std::string& name, std::string_view text) {
    const std::filesystem::path folder(name), file = folder / "case.toml";
    refuse_existing(folder);
    const std::string title = folder.filename().string();
    if (title.empty() || title.find_first_of("\"\\\n") != std::string::npos) {
        throw FileError(fmt::format("'{}' cannot be the name of a case; letters, digits, '_' and '-' can", name));
    }
    std::filesystem::create_directories(folder);
    io::write_file(file, fmt::format(fmt::runtime(text), fmt::arg("name", title)));
    fmt::print("{}\n", file.string());
    return 0;
}

}  // namespace

void add_new(CLI::App& app, Action& action) {
    struct Options {
        std::string name, from;
        bool is_wet{false}, has_spheres{false};
    };
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("new", "Write a small commented case to start from");
    command->add_option("NAME", options->name, "The folder to make")->required();
    CLI::Option* water = command->add_flag("--water", options->is_wet, "With water");
    CLI::Option* spheres =
        command->add_flag("--spheres", options->has_spheres, "Of spheres and of a stone of many spheres")
            ->excludes(water);
    command->add_option("--from", options->from, "A copy of a case, a published one too (riprap list --published)")
        ->type_name("CASE")
        ->excludes(water)
        ->excludes(spheres);
    command->footer(
        "Example:\n  riprap new my_slope && riprap run my_slope && riprap view runs/my_slope\n"
        "  riprap new my_arch --from dda/planar_arch_falls");
    command->callback([&action, options] {
        action = [options] {
            if (!options->from.empty()) {
                return copy_case(options->name, options->from);
            }
            return write_case(options->name, options->has_spheres ? sphere_case
                                             : options->is_wet    ? wet_case
                                                                  : dry_case);
        };
    });
}

}  // namespace riprap
