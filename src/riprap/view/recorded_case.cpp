// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "riprap/scene/keys/methods.hpp"
#include "riprap/scene/text/toml_reader.hpp"
#include "riprap/view/recorded_parts.hpp"

namespace riprap::view {

namespace {

/// A vector of two or three numbers; nothing else counts.
bool read_vector(const scene::Value* value, Vec3& vector) {
    if (value == nullptr || !value->is_array() || value->items.size() < 2 || value->items.size() > 3 ||
        !std::all_of(value->items.begin(), value->items.end(), [](const scene::Value& v) { return v.is_number(); })) {
        return false;
    }
    const std::vector<scene::Value>& items = value->items;
    vector = {items[0].as_number(), items[1].as_number(), items.size() > 2 ? items[2].as_number() : 0};
    return true;
}

void read_number(const scene::Value& table, const char* key, double& number) {
    if (const scene::Value* value = table.find(key); value != nullptr && value->is_number()) {
        number = value->as_number();
    }
}

/// Numbers of a list; none where it is no list.
std::vector<double> read_numbers(const scene::Value* list) {
    std::vector<double> numbers;
    if (list != nullptr && list->is_array()) {
        for (const scene::Value& item : list->items) {
            numbers.push_back(item.is_number() ? item.as_number() : 0);
        }
    }
    return numbers;
}

void read_gravity(const scene::Value* gravity, body::Gravity& law) {
    if (read_vector(gravity, law.value) || gravity == nullptr || !gravity->is_table()) {
        return;
    }
    read_vector(gravity->find("value"), law.value);
    read_number(*gravity, "ramp", law.ramp);
    const scene::Value* rotation = gravity->find("rotation");
    if (rotation != nullptr && rotation->is_table() && read_vector(rotation->find("axis"), law.axis) &&
        norm(law.axis) > 0) {
        law.axis = law.axis / norm(law.axis);
        read_number(*rotation, "rate", law.rate);
        read_number(*rotation, "start", law.start);
        read_number(*rotation, "stop", law.stop);
        law.times = read_numbers(rotation->find("time"));
        law.angles = read_numbers(rotation->find("angle"));
        law.angles.resize(law.times.size());
    }
}

/// Gauges that stand still; one that names a body moves with it.
void read_gauges(const scene::Value* output, std::vector<GaugePlace>& places) {
    const scene::Value* gauges = output != nullptr && output->is_table() ? output->find("gauge") : nullptr;
    if (gauges == nullptr || !gauges->is_array()) {
        return;
    }
    for (const scene::Value& gauge : gauges->items) {
        const scene::Value* name = gauge.is_table() ? gauge.find("name") : nullptr;
        const scene::Value* kind = gauge.is_table() ? gauge.find("kind") : nullptr;
        GaugePlace place;
        if (name == nullptr || !name->is_text() || gauge.find("body") != nullptr ||
            !read_vector(gauge.find("point"), place.point)) {
            continue;
        }
        place.name = name->text;
        place.kind = kind != nullptr && kind->is_text() ? kind->text : "";
        if (Vec3 end; read_vector(gauge.find("end"), end)) {
            place.end = end;
        }
        places.push_back(std::move(place));
    }
}

std::optional<double> number_at(const scene::Value& table, const char* key) {
    const scene::Value* value = table.find(key);
    return value != nullptr && value->is_number() ? std::optional(value->as_number()) : std::nullopt;
}

/// Tells whether a fluid is given by its levels: then its regions say how high it stands, whatever the method.
bool is_given_by_levels(const scene::Value& method) {
    const std::vector<scene::Method> all = scene::FluidMethods::all();
    return std::ranges::any_of(all, [&method](const scene::Method& one) {
        return method.is_text() && one.word == method.text &&
               std::ranges::find(one.scene_keys, "levels") != one.scene_keys.end();
    });
}

/// Basins and levels of still water. A region without a box is not drawn.
void read_still_water(const scene::Value* fluid, StillWater& water) {
    const scene::Value* method = fluid != nullptr && fluid->is_table() ? fluid->find("method") : nullptr;
    if (method == nullptr || !is_given_by_levels(*method)) {
        return;
    }
    if (const scene::Value* regions = fluid->find("region"); regions != nullptr && regions->is_array()) {
        for (const scene::Value& region : regions->items) {
            const scene::Value* box = region.is_table() ? region.find("box") : nullptr;
            StillWater::Basin basin;
            if (box != nullptr && box->is_table() && read_vector(box->find("low"), basin.low) &&
                read_vector(box->find("high"), basin.high)) {
                basin.level = number_at(region, "level");
                water.basins.push_back(basin);
            }
        }
    }
    if (const scene::Value* levels = fluid->find("levels"); levels != nullptr && levels->is_array()) {
        for (const scene::Value& row : levels->items) {
            if (row.is_array() && row.items.size() == 2 && row.items[0].is_number() && row.items[1].is_number()) {
                water.levels.push_back({row.items[0].as_number(), row.items[1].as_number()});
            }
        }
    }
}

/// Bodies that water goes through; copies of one have a number after its name.
void read_dry_names(const scene::Value* bodies, std::vector<std::string>& names) {
    if (bodies == nullptr || !bodies->is_array()) {
        return;
    }
    for (const scene::Value& body : bodies->items) {
        const scene::Value *wet = body.is_table() ? body.find("wet") : nullptr,
                           *name = body.is_table() ? body.find("name") : nullptr;
        if (wet != nullptr && wet->kind == scene::ValueKind::boolean && !wet->boolean && name != nullptr &&
            name->is_text()) {
            names.push_back(name->text);
        }
    }
}

/// Zones of a planar scene that are polygons where they stand, without a turn.
void read_porous(const scene::Value* fluid, std::vector<PorousZone>& zones) {
    const scene::Value* all = fluid != nullptr && fluid->is_table() ? fluid->find("porous") : nullptr;
    if (all == nullptr || !all->is_array()) {
        return;
    }
    for (const scene::Value& one : all->items) {
        const scene::Value* shape = one.is_table() ? one.find("shape") : nullptr;
        const scene::Value* polygon = shape != nullptr && shape->is_table() ? shape->find("polygon") : nullptr;
        if (polygon == nullptr || !polygon->is_array() || one.find("orientation") != nullptr) {
            continue;
        }
        PorousZone zone;
        zone.porosity = number_at(one, "porosity").value_or(0);
        Vec3 origin{};
        read_vector(one.find("position"), origin);
        for (const scene::Value& item : polygon->items) {
            if (Vec3 corner; read_vector(&item, corner)) {
                zone.corners.push_back(origin + corner);
            }
        }
        if (zone.corners.size() >= 3) {
            zones.push_back(std::move(zone));
        }
    }
}

}  // namespace

void read_resolved(RecordedRun& run, const std::filesystem::path& path) {
    run.resolved_text = io::read_file(path, text_limit);
    std::vector<Diagnostic> problems;
    const scene::Value root = scene::parse_toml(run.resolved_text, path.string(), problems);
    if (!problems.empty()) {
        throw FileError(to_string(problems.front()));
    }
    if (const scene::Value* title = root.find("title"); title != nullptr && title->is_text()) {
        run.title = title->text;
    }
    if (const scene::Value* source = root.find("source"); source != nullptr && source->is_text()) {
        run.source = source->text;
    }
    if (const scene::Value* materials = root.find("material"); materials != nullptr && materials->is_table()) {
        for (const scene::Entry& entry : materials->entries) {
            run.material_names.push_back(entry.key);
        }
    }
    const scene::Value* dimension = root.find("dimension");
    run.is_planar = dimension != nullptr && dimension->is_number() && dimension->as_number() == 2;
    read_gravity(root.find("gravity"), run.gravity_law);
    run.gravity = run.gravity_law.value;
    read_gauges(root.find("output"), run.gauges);
    read_still_water(root.find("fluid"), run.still_water);
    read_dry_names(root.find("body"), run.dry_names);
    if (run.is_planar) {
        read_porous(root.find("fluid"), run.porous);
    }
}

}  // namespace riprap::view
