// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "command_line_parts.hpp"
#include "riprap/core/error.hpp"
#include "riprap/io/atomic_file.hpp"

namespace riprap {

namespace {

constexpr std::string_view dry_case =
    R"(# Run it with `riprap run {name}`; `riprap check {name}` says what it would take. All keys: `riprap schema --keys`.
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

int write_case(const std::string& name, bool is_wet) {
    const std::filesystem::path folder(name), file = folder / "case.toml";
    if (std::filesystem::exists(folder)) {
        throw FileError(fmt::format("'{}' exists already; choose another name", name));
    }
    const std::string title = folder.filename().string();
    if (title.empty() || title.find_first_of("\"\\\n") != std::string::npos) {
        throw FileError(fmt::format("'{}' cannot be the name of a case; letters, digits, '_' and '-' can", name));
    }
    std::filesystem::create_directories(folder);
    io::write_file(file, fmt::format(fmt::runtime(is_wet ? wet_case : dry_case), fmt::arg("name", title)));
    fmt::print("{}\n", file.string());
    return 0;
}

}  // namespace

void add_new(CLI::App& app, Action& action) {
    struct Options {
        std::string name;
        bool is_wet{false};
    };
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("new", "Write a small commented case to start from");
    command->add_option("NAME", options->name, "The folder to make")->required();
    command->add_flag("--water", options->is_wet, "With water");
    command->footer("Example:\n  riprap new my_slope && riprap run my_slope && riprap view runs/my_slope");
    command->callback(
        [&action, options] { action = [options] { return write_case(options->name, options->is_wet); }; });
}

}  // namespace riprap
