// SPDX-License-Identifier: Apache-2.0
#include "riprap/core/chosen_keys.hpp"
#include "riprap/core/key.hpp"
#include "riprap/solid/sphere_dem/sphere_dem_settings.hpp"

namespace riprap::solid {

using namespace key;

namespace {

KeyList<sphere_dem::SphereSettings> law_keys() {
    using S = sphere_dem::SphereSettings;
    using contact::NormalLaw, contact::RollingLaw, contact::Sharing;
    const KeyList<S> normal{choice(&S::normal, "normal_law",
                                   {{"hertz", NormalLaw::hertz}, {"linear", NormalLaw::linear}},
                                   "Normal spring of a contact: Hertz, or linear.")};
    const KeyList<S> others{
        choice(&S::normals, "normals",
               {{"centres", contact::SphereNormals::centres}, {"faces", contact::SphereNormals::faces}},
               "Contact normals of multispheres: along the centres, or of the face that a sphere lies in."),
        choice(&S::rolling, "rolling",
               {{"none", RollingLaw::none}, {"constant", RollingLaw::constant}, {"spring", RollingLaw::spring}},
               "Resistance against rolling: none, a constant couple, or an elastic-plastic spring."),
        choice(&S::sharing, "sharing",
               {{"dashpots", Sharing::dashpots},
                {"sum", Sharing::sum},
                {"divide", Sharing::divide},
                {"closest", Sharing::closest}},
               "Simultaneous contacts of one pair of bodies: dashpots by 1/sqrt(N), all in full, all by 1/N, or the "
               "deepest alone."),
        boolean(&S::allows_pull, "allows_pull", "The dashpot may pull at the end of an impact."),
        number(&S::local_damping, "local_damping", dimension::plain, below(0, 1),
               "Cundall's damping for quasi-static runs: a fraction of each force component, opposing the velocity."),
        number(&S::mass_damping, "mass_damping", dimension::frequency, non_negative(),
               "Damping force per mass and velocity."),
        number(&S::max_overlap, "max_overlap", dimension::plain, above(0, 2),
               "An overlap deeper than this fraction of the smaller radius ends the run."),
        number(&S::max_speed, "max_speed", dimension::velocity, positive(), "A faster body ends the run.")};
    return normal + chosen(&S::tangential, "tangential_law", "Tangential law of a contact") + others;
}

/// A number above zero, or "auto", for which the member is 0.
BoundKey<SphereDemSettings> or_of_scene(double SphereDemSettings::*member, std::string_view name,
                                        const Dimension& dimension, std::string_view help) {
    BoundKey<SphereDemSettings> key = number(member, name, dimension, positive(), help);
    key.row.words = {"auto"};
    key.get = [member](const SphereDemSettings& s) { return s.*member > 0 ? KeyValue(s.*member) : KeyValue(); };
    key.set = [member](SphereDemSettings& s, const KeyValue& value) {
        const double* given = std::get_if<double>(&value);
        s.*member = given != nullptr ? *given : 0;
    };
    return key;
}

}  // namespace

MethodKeys<SphereDemSettings> SphereDemSettings::keys() {
    using S = SphereDemSettings;
    const KeyList<S> own{
        choice(
            &S::sampling, "spheres",
            {{"surface", SphereSampling::surface}, {"one", SphereSampling::one}, {"balls", SphereSampling::balls}},
            "Spheres that represent a free body: samples of its surface; one of its volume; or none (balls): faces of "
            "blocks meet spheres, and blocks meet by the distance potential. Balls and discs are always one sphere."),
        number_or_auto(
            &S::sphere_radius, "sphere_radius", dimension::length, positive(),
            "Radius of the samples, at most half of the least extent of a part. \"auto\": a third of the least "
            "inscribed radius.")
            .read_with("spheres", {"surface"}),
        or_of_scene(&S::youngs_modulus, "youngs_modulus", dimension::pressure,
                    "Young's modulus of all bodies. \"auto\": bodies at rest sink in by 1e-4 of the smallest one, in "
                    "the hardest impact by a hundredth of themselves; 1e7 Pa at least.")
            .read_with("normal_law", {"hertz"}),
        number(&S::poisson_ratio, "poisson_ratio", dimension::plain, between(0, 0.5), "Poisson's ratio of all bodies.")
            .read_with("normal_law", {"hertz"}),
        number(&S::restitution, "restitution", dimension::plain, above(0, 1), "Coefficient of restitution.")
            .read_with("contact_ratio", {"auto"}),
        number(&S::rolling_friction, "rolling_friction", dimension::plain, non_negative(),
               "Coefficient of rolling friction mu_r: limit of the couple, over R* F_n.")
            .read_with("rolling", {"constant", "spring"}),
        number_or_auto(
            &S::contact_ratio, "contact_ratio", dimension::plain, non_negative(),
            "Damping ratio of a contact: epsilon of the Hertz dashpot, xi of a linear one. \"auto\": follows from "
            "`restitution`."),
        number(&S::kinetic_share, "kinetic_share", dimension::plain, above(0, 1), "Kinetic over static friction."),
        or_of_scene(&S::spring_stiffness, "spring_stiffness", dimension::stiffness,
                    "Normal stiffness of a contact. \"auto\": as `youngs_modulus`; 1e5 N/m at least.")
            .read_with("normal_law", {"linear"}),
        number(&S::shear_ratio, "shear_ratio", dimension::plain, positive(), "Tangential over normal stiffness.")
            .read_with("normal_law", {"linear"})};
    return {.help = "explicit discrete elements, bodies of spheres", .keys = own + within(&S::laws, law_keys())};
}

}  // namespace riprap::solid
