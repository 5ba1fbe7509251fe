// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <tuple>

#include "riprap/geometry/polyhedra/polyhedron.hpp"
#include "riprap/geometry/surface/surface_mesh.hpp"

namespace riprap::geometry {

namespace {

struct HalfEdge {
    std::int32_t low, high;  ///< ends, low < high
    bool is_forward;         ///< from low to high
    std::int32_t body, face, number;
};

using Group = std::span<const HalfEdge>;

class ShellFinder {
 public:
    ShellFinder(SurfaceMesh& mesh, ProblemList& problems) : mesh_(mesh), problems_(problems) {}

    /// Pairs half-edges of which an edge has just two, at most two of a body; the rest wait in `wedges_`.
    void pair_faces(bool is_reporting) {
        number_half_edges();
        set_.twin.assign(set_.half_edge_face.size(), -1);
        wedges_.clear();
        for (auto begin = edges_.cbegin(); begin != edges_.cend();) {
            const auto end = std::find_if(
                begin, edges_.cend(), [&](const HalfEdge& e) { return e.low != begin->low || e.high != begin->high; });
            const Group group(begin, end);
            if (group.size() == 1) {
                if (is_reporting) {
                    report(group, "open edge", "closed surfaces; fill the hole beside this face");
                }
            } else if (group.size() == 2 || is_paired_by_body(group)) {
                for (std::size_t i = 0; i < group.size(); i += 2) {
                    join(group[i].number, group[i + 1].number);
                }
            } else if (group.size() % 2 == 1) {
                if (is_reporting) {
                    report(group, fmt::format("non-manifold edge of {} faces", group.size()),
                           "two faces at every edge, or two for each solid that touches there");
                }
            } else {
                wedges_.push_back(group);
            }
            begin = end;
        }
    }

    /// Finds faces that wind against their neighbours or inwards; reports them, or turns them round if `is_fixing`.
    /// Returns how many were turned.
    std::size_t orient(bool is_fixing) {
        std::vector<int> turn(mesh_.faces.size(), -1);  // 1 = winds against the first face of its patch
        std::size_t turned = 0;
        for (std::size_t seed = 0; seed < mesh_.faces.size(); ++seed) {
            if (turn[seed] < 0) {
                turned += orient_patch(seed, turn, is_fixing);
            }
        }
        return turned;
    }

    /// Pairs the faces around edges where several solids touch: going round the edge, each face that opens a solid
    /// wedge is paired with the next one, which must close it.
    void pair_across_wedges() {
        for (const Group& group : wedges_) {
            std::vector<std::pair<double, const HalfEdge*>> around;
            for (const HalfEdge& edge : group) {
                around.emplace_back(angle_about(group.front(), edge), &edge);
            }
            sort_around(around);
            const auto opener =
                std::find_if(around.begin(), around.end(), [](const auto& entry) { return !entry.second->is_forward; });
            std::rotate(around.begin(), opener, around.end());
            bool alternates = true;
            for (std::size_t i = 0; i < around.size(); ++i) {
                alternates = alternates && around[i].second->is_forward == (i % 2 == 1);
            }
            if (!alternates) {
                report(group, fmt::format("the {} faces at this edge do not bound separate solids", group.size()),
                       "solids that touch from outside, all wound outward");
                continue;
            }
            for (std::size_t i = 0; i < around.size(); i += 2) {
                join(around[i].second->number, around[i + 1].second->number);
            }
        }
    }

    /// Faces connected over paired edges, in the order of their first face; reports shells that wind inwards.
    ShellSet collect_shells() {
        std::vector<char> is_taken(mesh_.faces.size(), 0);
        for (std::size_t seed = 0; seed < mesh_.faces.size(); ++seed) {
            if (is_taken[seed] != 0) {
                continue;
            }
            std::vector<std::int32_t> shell{static_cast<std::int32_t>(seed)};
            is_taken[seed] = 1;
            for (std::size_t i = 0; i < shell.size(); ++i) {
                for_each_neighbour(static_cast<std::size_t>(shell[i]),
                                   [&](std::size_t other, std::int32_t, std::int32_t) {
                                       if (is_taken[other] == 0) {
                                           is_taken[other] = 1;
                                           shell.push_back(static_cast<std::int32_t>(other));
                                       }
                                   });
            }
            std::sort(shell.begin(), shell.end());
            set_.shells.push_back(std::move(shell));
        }
        return std::move(set_);
    }

 private:
    void number_half_edges() {
        edges_.clear();
        set_.half_edge_start.clear();
        set_.half_edge_face.clear();
        for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
            const auto& loop = mesh_.faces[f];
            set_.half_edge_start.push_back(static_cast<std::int32_t>(set_.half_edge_face.size()));
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const std::int32_t a = loop[k], b = loop[(k + 1) % loop.size()];
                edges_.push_back({std::min(a, b), std::max(a, b), a < b, mesh_.body_of(f), static_cast<std::int32_t>(f),
                                  static_cast<std::int32_t>(set_.half_edge_face.size())});
                set_.half_edge_face.push_back(static_cast<std::int32_t>(f));
            }
        }
        set_.half_edge_start.push_back(static_cast<std::int32_t>(set_.half_edge_face.size()));
        std::sort(edges_.begin(), edges_.end(), [](const HalfEdge& a, const HalfEdge& b) {
            return std::tie(a.low, a.high, a.body, a.number) < std::tie(b.low, b.high, b.body, b.number);
        });
        is_forward_.assign(edges_.size(), 0);
        for (const HalfEdge& edge : edges_) {
            is_forward_[static_cast<std::size_t>(edge.number)] = edge.is_forward ? 1 : 0;
        }
    }

    static bool is_paired_by_body(const Group& group) {
        bool is_paired = group.size() % 2 == 0;
        for (std::size_t i = 0; i < group.size() && is_paired; i += 2) {
            is_paired = group[i].body == group[i + 1].body && (i == 0 || group[i].body != group[i - 1].body);
        }
        return is_paired;
    }

    void join(std::int32_t a, std::int32_t b) {
        set_.twin[static_cast<std::size_t>(a)] = b;
        set_.twin[static_cast<std::size_t>(b)] = a;
    }

    /// visit(face on the other side, half-edge, its twin) for every paired half-edge of a face.
    template <class Visit>
    void for_each_neighbour(std::size_t f, const Visit& visit) const {
        for (std::int32_t h = set_.half_edge_start[f]; h < set_.half_edge_start[f + 1]; ++h) {
            const std::int32_t t = set_.twin[static_cast<std::size_t>(h)];
            if (t >= 0) {
                visit(static_cast<std::size_t>(set_.half_edge_face[static_cast<std::size_t>(t)]), h, t);
            }
        }
    }

    void report(const Group& group, const std::string& what, const char* allowed) {
        const HalfEdge& edge = group.front();
        const auto f = static_cast<std::size_t>(edge.face);
        problems_.add(mesh_.place_of(f),
                      fmt::format("{} from {} to {}, at {}", what, coordinates(mesh_.point(edge.low)),
                                  coordinates(mesh_.point(edge.high)), mesh_.name_of(f)),
                      allowed);
    }

    std::size_t orient_patch(std::size_t seed, std::vector<int>& turn, bool is_fixing) {
        std::vector<std::size_t> patch{seed};
        turn[seed] = 0;
        bool is_closed = true, is_one_sided = false;
        for (std::size_t i = 0; i < patch.size(); ++i) {
            const std::size_t f = patch[i];
            std::int32_t paired = 0;
            for_each_neighbour(f, [&](std::size_t other, std::int32_t h, std::int32_t t) {
                ++paired;
                const bool is_against =
                    is_forward_[static_cast<std::size_t>(h)] == is_forward_[static_cast<std::size_t>(t)];
                const int expected = turn[f] ^ (is_against ? 1 : 0);
                if (turn[other] < 0) {
                    turn[other] = expected;
                    patch.push_back(other);
                }
                is_one_sided = is_one_sided || turn[other] != expected;
            });
            is_closed = is_closed && paired == set_.half_edge_start[f + 1] - set_.half_edge_start[f];
        }
        if (is_one_sided) {
            problems_.add(mesh_.place_of(seed), "the surface at " + mesh_.name_of(seed) + " has only one side",
                          "surfaces with an inner and an outer side");
            return 0;
        }
        return turn_round(patch, turn, is_closed, is_fixing);
    }

    std::size_t turn_round(const std::vector<std::size_t>& patch, const std::vector<int>& turn, bool is_closed,
                           bool is_fixing) {
        // Volume if every face wound like the first; it tells outside from inside where the patch is closed. Where it
        // is not, the side of the majority counts.
        double volume = 0.0, area = 0.0;
        std::size_t against = 0;
        const Vec3 o = mesh_.point(mesh_.faces[patch.front()].front());
        for (const std::size_t f : patch) {
            const Vec3 a = vector_area(mesh_.points, mesh_.faces[f]);
            volume += (turn[f] == 1 ? -1.0 : 1.0) * dot(a, mesh_.point(mesh_.faces[f].front()) - o) / 3.0;
            area += norm(a);
            against += turn[f] == 1 ? 1 : 0;
        }
        const bool has_volume = is_closed && std::abs(volume) > mesh_.tolerance * area;
        const int wrong = (has_volume ? volume < 0.0 : 2 * against > patch.size()) ? 0 : 1;
        const std::size_t wrong_count = wrong == 1 ? against : patch.size() - against;
        if (wrong_count == 0) {
            return 0;
        }
        if (is_fixing) {
            for (const std::size_t f : patch) {
                if (turn[f] == wrong) {
                    std::reverse(mesh_.faces[f].begin(), mesh_.faces[f].end());
                }
            }
            return wrong_count;
        }
        const std::string remedy = "faces wound counter-clockwise seen from outside; turn them, or repair = true does";
        if (wrong_count == patch.size()) {
            problems_.add(mesh_.place_of(patch.front()),
                          fmt::format("the shell of {} faces that begins with {} is inside out (volume {:.6g} m^3)",
                                      patch.size(), mesh_.name_of(patch.front()), -std::abs(volume)),
                          remedy + "; hollow bodies are stated as several convex shells");
            return 0;
        }
        for (const std::size_t f : patch) {
            if (turn[f] == wrong) {
                problems_.add(mesh_.place_of(f),
                              fmt::format("{} at {} winds the wrong way round", mesh_.name_of(f),
                                          coordinates(mesh_.point(mesh_.faces[f].front()))),
                              remedy);
            }
        }
        return 0;
    }

    /// Angle of a face about the edge from low to high, right-handed, counted from the first face.
    double angle_about(const HalfEdge& first, const HalfEdge& edge) const {
        const auto inwards = [&](const HalfEdge& e) {  // in the face, away from the edge
            const Vec3 along = mesh_.point(e.high) - mesh_.point(e.low);
            const Vec3 area = vector_area(mesh_.points, mesh_.faces[static_cast<std::size_t>(e.face)]);
            return normalized(cross(area, e.is_forward ? along : -along));
        };
        const Vec3 axis = normalized(mesh_.point(edge.high) - mesh_.point(edge.low));
        const Vec3 zero = inwards(first), here = inwards(edge);
        const double angle = std::atan2(dot(axis, cross(zero, here)), dot(zero, here));
        return angle < -same_angle ? angle + 2.0 * std::numbers::pi : angle;
    }

    /// Ascending angle; at the same angle a face that closes a wedge (of one solid) before one that opens the next.
    static void sort_around(std::vector<std::pair<double, const HalfEdge*>>& around) {
        std::sort(around.begin(), around.end(), [](const auto& a, const auto& b) {
            return std::tie(a.first, a.second->number) < std::tie(b.first, b.second->number);
        });
        for (auto begin = around.begin(); begin != around.end();) {
            auto end = begin + 1;
            while (end != around.end() && end->first - (end - 1)->first <= same_angle) {
                ++end;
            }
            std::stable_sort(
                begin, end, [](const auto& a, const auto& b) { return a.second->is_forward && !b.second->is_forward; });
            begin = end;
        }
    }

    /// Faces of two solids at one edge count as coincident within this angle [rad]; no wedge of a solid is as sharp.
    static constexpr double same_angle = 1e-3;

    SurfaceMesh& mesh_;
    ProblemList& problems_;
    ShellSet set_;
    std::vector<HalfEdge> edges_;
    std::vector<char> is_forward_;
    std::vector<Group> wedges_;
};

}  // namespace

ShellSet find_shells(SurfaceMesh& mesh, const SurfaceAuditOptions& options, ProblemList& problems,
                     std::vector<Diagnostic>& notes) {
    ShellFinder finder(mesh, problems);
    if (options.fix_orientation) {
        finder.pair_faces(false);
        if (const std::size_t turned = finder.orient(true); turned > 0) {
            Diagnostic& note = notes.emplace_back();
            note.place.file = mesh.source->file;
            note.message = fmt::format("{} faces that wound inwards were turned round", turned);
        }
    }
    finder.pair_faces(true);
    finder.orient(false);
    if (problems.is_empty()) {
        finder.pair_across_wedges();
    }
    return problems.is_empty() ? finder.collect_shells() : ShellSet{};
}

}  // namespace riprap::geometry
