// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "riprap/scene/keys/check_counts.hpp"
#include "riprap/scene/text/limits.hpp"

namespace riprap::scene {

namespace {

constexpr std::int64_t too_many = std::int64_t{1} << 60;

/// a b without overflow: stays at `too_many`.
std::int64_t times(std::int64_t a, std::int64_t b) { return a > 0 && b > too_many / a ? too_many : a * b; }

std::int64_t product(const Value& counts) {
    std::int64_t result = 1;
    for (const Value& count : counts.items) {
        result = times(result, count.integer);
    }
    return result;
}

/// Convex parts of one body, as far as the case says without reading files.
std::int64_t part_count(const Value* shape) {
    const Value* list = shape != nullptr ? shape->find("union") : nullptr;
    if (list == nullptr) {
        return 1;
    }
    std::int64_t count = 0;
    for (const Value& part : list->items) {
        count = std::min(too_many, count + part_count(part.find("shape")));
    }
    return count;
}

struct Request {
    const Value* at;
    std::int64_t bodies, parts;
};

Request requested(const Value& entry) {
    if (const Value* repeat = entry.find("repeat"); repeat != nullptr && repeat->find("counts") != nullptr) {
        const std::int64_t bodies = product(get(*repeat, "counts"));
        return {repeat, bodies, times(bodies, part_count(entry.find("shape")))};
    }
    if (const Value* lattice = entry.find("lattice"); lattice != nullptr && lattice->find("counts") != nullptr) {
        std::int64_t bodies = product(get(*lattice, "counts"));
        if (const Value* total = lattice->find("total")) {
            bodies = std::min(bodies, total->integer);
        }
        std::int64_t parts = 1;
        if (const Value* mix = lattice->find("mix")) {
            for (const Value& kind : mix->items) {
                parts = std::max(parts, part_count(kind.find("shape")));
            }
        }
        return {lattice, bodies, times(bodies, parts)};
    }
    if (const Value* voronoi = entry.find("voronoi"); voronoi != nullptr && voronoi->find("count") != nullptr) {
        return {voronoi, get_integer(*voronoi, "count"), get_integer(*voronoi, "count")};
    }
    return {&entry, 1, part_count(entry.find("shape"))};
}

}  // namespace

bool check_counts(const Value& root, std::vector<Diagnostic>& problems) {
    std::int64_t bodies = 0, parts = 0;
    for (const std::string_view section : {"body", "pack", "rock_mass"}) {
        const Value* list = root.find(section);
        if (list == nullptr) {
            continue;
        }
        for (const Value& entry : list->items) {
            const Request request = requested(entry);
            bodies += request.bodies;
            parts += request.parts;
            if (bodies > limits::bodies) {
                problems.push_back({request.at->place,
                                    fmt::format("{} bodies asked for here, {} so far", request.bodies, bodies),
                                    fmt::format("a scene has at most {} bodies", limits::bodies)});
                return false;
            }
            if (parts > limits::parts) {
                problems.push_back({request.at->place,
                                    fmt::format("{} convex parts asked for here, {} so far", request.parts, parts),
                                    fmt::format("a scene has at most {} parts", limits::parts)});
                return false;
            }
        }
    }
    return true;
}

}  // namespace riprap::scene
