// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/output/output_kinds.hpp"

#include <random>

#include "riprap/fluid/shown_water.hpp"
#include "riprap/io/fluid_frame.hpp"
#include "riprap/io/scene_frame.hpp"
#include "riprap/sim/quantity.hpp"
#include "riprap/sim/shown.hpp"

namespace riprap::io {

namespace {

/// Water as it will be: a lattice at rest is packed into much less than particles that have moved.
fluid::ParticleState stirred(const fluid::ParticleSettings& settings, fluid::ParticleState water) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> share(-1, 1);
    for (std::size_t i = 0; i < water.position.size(); ++i) {
        for (int axis = 0; axis < settings.domain.dimension; ++axis) {
            water.position[i][axis] += 0.2 * settings.spacing * share(random);
            water.velocity[i][axis] = 0.1 * settings.sound_speed * share(random);
        }
        water.density[i] = settings.rest_density * (1 + 0.01 * share(random));
    }
    return water;
}

PolyData bodies_at(const sim::Moment& moment, std::span<const DrawnPlane> planes) {
    const std::vector<Vec3> no_force;
    return draw_bodies(moment.model, moment.initial, moment.state, planes,
                       moment.scratch != nullptr ? moment.scratch->contact_force() : no_force);
}

PolyData contacts_at(const sim::Moment& moment) {
    return draw_contacts(moment.scratch != nullptr ? shown_contacts(moment.model, moment.state, *moment.scratch)
                                                   : std::vector<contact::ShownContact>());
}

class Frames : public Output {
 public:
    Frames(const FrameFiles& chosen, const OutputRun& run)
        : chosen_(chosen), folder_(run.folder), frames_(run.frames()), planes_(draw_planes(run.model, run.initial)) {
        if (run.model.particles() != nullptr) {
            kinds_ = {"bodies", "water"};
        } else if (sim::draws_fluid(run.model)) {
            kinds_ = {"bodies", "water", "surface"};
        }
        for (const char* kind : {"bodies", "contacts", "water", "surface"}) {
            std::error_code ignored;
            std::filesystem::remove(path_of(kind, "end"), ignored);
        }
    }
    void write_frame(const sim::Moment& moment, const std::string& tag) override {
        const sim::State& state = moment.state;
        write_vtp(path_of("bodies", tag), bodies_at(moment, planes_), state.time);
        if (const auto* particles = moment.model.particles()) {
            write_fluid(path_of("water", tag), particles->settings(), state.fluid, state.time);
        } else if (const auto water = sim::shown_fluid(moment.model, state)) {
            write_field(path_of("water", tag), *water, state.time);
            write_vtp(path_of("surface", tag), draw_surface(*water), state.time);
        }
        if (chosen_.contacts) {
            write_vtp(path_of("contacts", tag), contacts_at(moment), state.time);
        }
    }
    void list_frames(std::span<const WrittenFrame> frames) override {
        write_list(FrameFiles::files[0], frames, kinds_);
        if (chosen_.contacts) {
            write_list(FrameFiles::files[1], frames, {"contacts"});
        }
    }

 private:
    std::filesystem::path path_of(std::string_view kind, const std::string& tag) const {
        return frames_ / (std::string(kind) + '_' + tag + ".vtp");
    }
    void write_list(std::string_view file, std::span<const WrittenFrame> frames,
                    const std::vector<std::string>& kinds) const {
        std::vector<PvdFrame> parts;
        for (const WrittenFrame& frame : frames) {
            for (std::size_t part = 0; part < kinds.size(); ++part) {
                parts.push_back(
                    {frame.time, "frames/" + kinds[part] + "_" + frame.tag + ".vtp", static_cast<int>(part)});
            }
        }
        write_pvd(folder_ / file, parts);
    }

    FrameFiles chosen_;
    std::filesystem::path folder_, frames_;
    std::vector<DrawnPlane> planes_;
    std::vector<std::string> kinds_{"bodies"};  ///< of files that out.pvd lists
};

}  // namespace

KeyList<FrameFiles> FrameFiles::keys() {
    return {key::boolean(&FrameFiles::vtk, "vtk", "Write frames for ParaView."),
            key::boolean(&FrameFiles::contacts, "contacts", "Write contact points and forces with each frame.")};
}

double FrameFiles::frame_bytes(const sim::Moment& moment) const {
    if (!vtk) {
        return 0;
    }
    auto bytes =
        static_cast<double>(encode_vtp(bodies_at(moment, draw_planes(moment.model, moment.initial)), 0).size());
    if (const auto* particles = moment.model.particles()) {
        put_fluid([&bytes](std::string_view piece) { bytes += static_cast<double>(piece.size()); },
                  particles->settings(), stirred(particles->settings(), moment.state.fluid), 0);
    }
    return bytes + (contacts ? static_cast<double>(encode_vtp(contacts_at(moment), 0).size()) : 0);
}

std::unique_ptr<Output> FrameFiles::open(const OutputRun& run) const {
    return vtk ? std::make_unique<Frames>(*this, run) : nullptr;
}

}  // namespace riprap::io
