// SPDX-License-Identifier: Apache-2.0
// Reads the tables of [fluid] for fluids that are fields.
#include <fmt/format.h>

#include <utility>

#include "riprap/geometry/polyhedra/shapes.hpp"
#include "riprap/scene/assemble/fluid_tables.hpp"
#include "riprap/scene/case/orientation.hpp"
#include "riprap/scene/case/sea_tables.hpp"
#include "riprap/scene/case/wave_range.hpp"
#include "riprap/scene/keys/flow_tables.hpp"
#include "riprap/scene/keys/sea_words.hpp"
#include "riprap/scene/shapes/shape_library.hpp"
#include "riprap/wave/linear_wave.hpp"

namespace riprap::scene {

namespace {

/// Which side a wave enters through that goes a way, or nothing with a problem.
std::optional<int> side_of(CaseBuild& build, const Value& table) {
    const Way way = get_word(table, "towards", ways());
    if (way.axis == 2 && build.is_planar) {
        build.problem(get(table, "towards").place, "waves that go out of the plane", "\"x\", \"-x\", \"y\" or \"-y\"");
        return std::nullopt;
    }
    return 2 * way.axis + (way.is_towards_high ? 0 : 1);
}

/// Refuses keys that waves of this kind have no use for; false with a problem.
bool check_wave_keys(CaseBuild& build, const Value& table, coupling::WavesAtSide::Kind kind) {
    using Kind = coupling::WavesAtSide::Kind;
    const bool is_sea = kind == Kind::irregular, is_one = kind == Kind::solitary || kind == Kind::boussinesq;
    const bool is_train = kind == Kind::regular || kind == Kind::second_order;
    bool is_good = true;
    for (const auto& [key, is_used] : {std::pair{"height", is_sea || is_one || is_train},
                                       {"period", is_sea || is_train},
                                       {"ramp", is_sea || is_train},
                                       {"crest_time", is_one || is_train}}) {
        if (const Value* value = table.find(key); value != nullptr && !is_used) {
            build.problem(value->place, fmt::format("wave = \"{}\" has no use for '{}'", get_text(table, "wave"), key),
                          fmt::format("leave '{}' out", key));
            is_good = false;
        }
    }
    return is_good;
}

bool read_wave(CaseBuild& build, const Value& table, coupling::WavesAtSide& wave) {
    using Kind = coupling::WavesAtSide::Kind;
    const std::optional<int> side = side_of(build, table);
    if (!side) {
        return false;
    }
    wave.side = *side;
    wave.kind = get_word(table, "wave", side_waves());
    if (!check_wave_keys(build, table, wave.kind)) {
        return false;
    }
    wave.depth = get_number(table, "depth");
    wave.height = get_number_or(table, "height", 0);
    wave.period = get_number_or(table, "period", 0);
    wave.crest_time = get_number_or(table, "crest_time", -1);
    wave.ramp = get_number_or(table, "ramp", 2 * wave.period);
    wave.absorbs = get(table, "absorb").boolean;
    if (wave.kind == Kind::none && !wave.absorbs) {
        build.problem(table.place, "a side that neither makes nor absorbs waves", "absorb = true, or another wave");
        return false;
    }
    if (wave.kind == Kind::irregular) {
        const auto sea = read_sea(build, table);
        if (!sea) {
            return false;
        }
        wave.height = sea->height;
        wave.period = sea->period;
        wave.ramp = get_number_or(table, "ramp", 2 * wave.period);
        wave.gamma = sea->gamma;
        wave.seed = sea->seed;
        wave.spectrum = sea->spectrum;
    } else if (const Value* file = table.find("spectrum_file")) {
        build.problem(file->place, "a spectrum of a wave that is no sea", "wave = \"irregular\"");
        return false;
    }
    if (wave.kind != Kind::none && wave.height == 0) {
        build.problem(table.place, "a wave without 'height'", "the height of the wave, or wave = \"none\"");
        return false;
    }
    const bool has_period = wave.kind == Kind::regular || wave.kind == Kind::second_order;
    if (has_period && wave.period == 0) {
        build.problem(table.place, "a regular wave without 'period'", "the period of the wave");
        return false;
    }
    if (norm(build.model.gravity.value) == 0) {
        build.problem(table.place, "waves without gravity", "gravity that is not zero");
        return false;
    }
    const Value *period = table.find("period"), *file = table.find("spectrum_file");
    const Value& place = period != nullptr ? *period : file != nullptr ? *file : table;
    return wave.period == 0 || check_wave_length(build, place.place, wave.height, wave.period, wave.depth);
}

/// An inflow, or an outflow, on a side of the domain.
bool read_open_side(CaseBuild& build, const Value& table, bool is_inflow, coupling::OpenSide& opening) {
    using Kind = coupling::OpenSide::Kind;
    const std::optional<int> entered = side_of(build, table);
    if (!entered) {
        return false;
    }
    opening.side = is_inflow ? *entered : *entered ^ 1;
    opening.low = get_vector(table, "low");
    opening.high = get_vector(table, "high");
    for (int axis = 0; axis < (build.is_planar ? 2 : 3); ++axis) {
        const bool is_flat = axis == opening.side / 2;
        if (is_flat ? opening.low[axis] != opening.high[axis] : !(opening.low[axis] < opening.high[axis])) {
            build.problem(
                table.place,
                fmt::format("the opening '{}' reaches from {} m to {} m along {}, towards {}", get_text(table, "name"),
                            opening.low[axis], opening.high[axis], "xyz"[axis], get_text(table, "towards")),
                "corners that agree along 'towards', and low below high along the others");
            return false;
        }
    }
    const Value* speed = table.find("speed");
    const Value* level = table.find("level");
    opening.speed = speed != nullptr ? speed->as_number() : 0;
    opening.level = level != nullptr ? level->as_number() : opening.level;
    opening.ramp = is_inflow ? get_number(table, "ramp") : 0;
    opening.kind = is_inflow          ? Kind::inflow
                   : speed != nullptr ? Kind::drawn
                   : level != nullptr ? Kind::level
                                      : Kind::free;
    return true;
}
bool read_inflow(CaseBuild& build, const Value& table, coupling::OpenSide& opening) {
    return read_open_side(build, table, true, opening);
}
bool read_outflow(CaseBuild& build, const Value& table, coupling::OpenSide& opening) {
    return read_open_side(build, table, false, opening);
}

bool read_side(CaseBuild& build, const Value& table, coupling::SideRule& rule) {
    const Way way = get_word(table, "side", ways());
    if (way.axis == 2 && build.is_planar) {
        build.problem(get(table, "side").place, "a side out of the plane", "\"x\", \"-x\", \"y\" or \"-y\"");
        return false;
    }
    rule = {2 * way.axis + (way.is_towards_high ? 1 : 0), get_word(table, "kind", side_kinds()),
            get_vector(table, "velocity")};
    return true;
}

/// Pieces of a zone: what a file holds may be of any form, unlike the convex parts of bodies.
std::optional<std::vector<geometry::Polyhedron>> read_zone(CaseBuild& build, const Value& table) {
    const Value* shape = table.find("shape");
    const Value* stl = shape != nullptr ? shape->find("stl") : nullptr;
    const Value* obj = shape != nullptr ? shape->find("obj") : nullptr;
    if (stl == nullptr && obj == nullptr) {
        return read_pieces(build, table);
    }
    const auto surface = build.shapes.closed_surface(stl != nullptr ? *stl : *obj, stl != nullptr);
    if (!surface) {
        return std::nullopt;
    }
    const Pose pose{get_vector(table, "position"), orientation_of(table.find("orientation"))};
    return std::vector{geometry::moved(*surface, pose)};
}

bool read_stones(CaseBuild& build, const Value& table, coupling::Stones& stones) {
    auto pieces = read_zone(build, table);
    if (!pieces) {
        return false;
    }
    stones.pieces = std::move(*pieces);
    stones.medium = {get_number(table, "porosity"),
                     get_number(table, "grain_size"),
                     get_number(table, "linear"),
                     get_number(table, "quadratic"),
                     get_number(table, "added_mass"),
                     get_number(table, "keulegan_carpenter"),
                     get_word(table, "closure", porous_closures())};
    return true;
}

bool read_calm(CaseBuild& build, const Value& table, coupling::CalmBox& box) {
    const Way way = get_word(table, "towards", ways());
    box.low = get_vector(table, "low");
    box.high = get_vector(table, "high");
    box.axis = way.axis;
    box.is_towards_high = way.is_towards_high;
    const Value& rate = get(table, "rate");
    box.rate = rate.is_text() ? 0 : rate.as_number();
    if (norm(get_vector(table, "velocity")) > 0) {
        build.problem(get(table, "velocity").place,
                      "a current in a sponge of water on a grid, which slows it down to rest", "leave 'velocity' out");
        return false;
    }
    for (int axis = 0; axis < (build.is_planar ? 2 : 3); ++axis) {
        if (!(box.low[axis] < box.high[axis])) {
            build.problem(table.place,
                          fmt::format("the sponge reaches from {} m to {} m along {}", box.low[axis], box.high[axis],
                                      "xyz"[axis]),
                          "low below high");
            return false;
        }
    }
    return true;
}

/// Reads all entries of a list that the table may have.
template <class Said, class Read>
bool read_list(CaseBuild& build, const Value& table, std::string_view name, std::vector<Said>& list, const Read& read) {
    bool is_good = true;
    if (const Value* entries = table.find(name)) {
        for (const Value& entry : entries->items) {
            Said said;
            if (read(build, entry, said)) {
                list.push_back(std::move(said));
            } else {
                is_good = false;
            }
        }
    }
    return is_good;
}

}  // namespace

bool read_field_tables(CaseBuild& build, const Value& table, coupling::FieldScene& scene) {
    scene.flow = read_flow(table);
    const bool has_sides = read_list(build, table, "side", scene.sides, read_side);
    const bool has_waves = read_list(build, table, "wave", scene.waves, read_wave);
    const bool has_inflows = read_list(build, table, "inflow", scene.openings, read_inflow);
    const bool has_outflows = read_list(build, table, "outflow", scene.openings, read_outflow);
    const bool has_stones = read_list(build, table, "porous", scene.stones, read_stones);
    return read_list(build, table, "sponge", scene.calm, read_calm) && has_sides && has_waves && has_stones &&
           has_inflows && has_outflows;
}

}  // namespace riprap::scene
