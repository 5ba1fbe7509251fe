// SPDX-License-Identifier: Apache-2.0
// Bodies, water and contacts of a simulation as arrays.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "made_caster.hpp"
#include "riprap/fluid/particle/state_equation.hpp"
#include "riprap/sim/shown.hpp"
#include "simulation.hpp"

namespace riprap::python {

namespace py = pybind11;

namespace {

/// The simulation's bodies or its water; both keep the simulation alive.
struct Bodies {
    py::object owner;
    Simulation& simulation() const { return owner.cast<Simulation&>(); }
    run::Simulation& read() const { return simulation().read(); }
};
struct Fluid : Bodies {};

}  // namespace
}  // namespace riprap::python

template <>
struct pybind11::detail::type_caster<riprap::python::Bodies> : riprap::python::MadeCaster<riprap::python::Bodies> {};
template <>
struct pybind11::detail::type_caster<riprap::python::Fluid> : riprap::python::MadeCaster<riprap::python::Fluid> {};

namespace riprap::python {
namespace {

/// One of the fields that may be shown: read-only, on the memory of the State.
template <class Of, class Field>
py::array field_of(const Of& self, Field field) {
    run::Simulation& simulation = self.read();
    return self.simulation().views().view(field(simulation.storage()), self.owner);
}

/// A copy, from one number or vector per entry.
template <class T>
py::array copied(const std::vector<T>& values) {
    constexpr int components = FieldTraits<T>::components;
    std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(values.size())};
    if (components > 1) {
        shape.push_back(components);
    }
    return {py::dtype::of<double>(), shape, values.data()};
}

template <class T, class Make>
std::vector<T> per_body(const Bodies& self, const Make& make) {
    const run::Simulation& simulation = self.read();
    std::vector<T> values;
    for (std::int32_t i = 0; i < simulation.model().bodies.size(); ++i) {
        values.push_back(make(simulation, BodyId{i}));
    }
    return values;
}

std::vector<std::string> names(const Bodies& self) {
    return per_body<std::string>(self,
                                 [](const run::Simulation& s, BodyId body) { return s.model().bodies.name(body); });
}

std::int32_t index(const Bodies& self, const std::string& name) {
    const BodyId body = sim::find_body(self.read().model().bodies, name);
    if (!body.is_valid()) {
        throw py::key_error("there is no body '" + name + "'");
    }
    return body.value;
}

py::array is_free(const Bodies& self) {
    const auto flags = per_body<double>(self, [](const run::Simulation& s, BodyId body) {
        return body::is_free(s.model().bodies, body, s.state().time) ? 1.0 : 0.0;
    });
    return copied(flags).attr("astype")("bool");
}

py::array angular_velocity(const Bodies& self) {
    return copied(per_body<Vec3>(self, [](const run::Simulation& s, BodyId body) {
        return body::angular_velocity(s.model().bodies, s.state().bodies, body);
    }));
}

py::object contact_force(const Bodies& self) {
    const run::Simulation& simulation = self.read();
    return simulation.has_stepped() ? py::object(copied(simulation.scratch().contact_force())) : py::none();
}

py::dict shown(const Bodies& self) {
    const run::Simulation& simulation = self.read();
    const std::span<const ShownField> fields = sim::shown_fields(simulation.model());
    py::dict values;
    for (std::size_t f = 0; f < fields.size(); ++f) {
        values[py::str(std::string(fields[f].name))] =
            copied(sim::shown_values(simulation.model(), simulation.state(), f));
    }
    return values;
}

py::array pressure(const Fluid& self) {
    const run::Simulation& simulation = self.read();
    std::vector<double> values;
    for (const double density : simulation.state().fluid.density) {
        values.push_back(pressure_of(simulation.model().particles()->settings(), density));
    }
    return copied(values);
}

py::object contacts(const Simulation& self) {
    const run::Simulation& simulation = self.read();
    if (!simulation.has_stepped()) {
        return py::none();
    }
    const std::vector<contact::ShownContact> rows =
        sim::shown_contacts(simulation.model(), simulation.state(), simulation.scratch());
    const auto column = [&](auto make) {
        std::vector<decltype(make(rows[0]))> values;
        for (const contact::ShownContact& row : rows) {
            values.push_back(make(row));
        }
        return copied(values);
    };
    using Row = const contact::ShownContact&;
    py::dict arrays;
    arrays["body_a"] = column([](Row row) { return static_cast<double>(row.a.value); }).attr("astype")("int32");
    arrays["body_b"] = column([](Row row) { return static_cast<double>(row.b.value); }).attr("astype")("int32");
    arrays["point"] = column([](Row row) { return row.point; });
    arrays["force"] = column([](Row row) { return row.force; });
    arrays["normal_force"] = column([](Row row) { return row.normal_force; });
    arrays["shear_force"] = column([](Row row) { return row.shear_force; });
    arrays["overlap"] = column([](Row row) { return row.overlap; });
    arrays["area"] = column([](Row row) { return row.area; });
    arrays["is_sliding"] = column([](Row row) { return row.is_sliding ? 1.0 : 0.0; }).attr("astype")("bool");
    return arrays;
}

void define_bodies(py::module_& module) {
    using namespace py::literals;
    const auto field = [](auto member) {
        return [member](const Bodies& self) {
            return field_of(
                self, [member](sim::State & state) -> auto& { return state.bodies.*member; });
        };
    };
    using body::BodyState;
    py::class_<Bodies>(
        module, "Bodies",
        "All bodies, n of them, in the order of their numbers. `position`, `orientation`, `velocity` and "
        "`angular_momentum` are read-only arrays on the memory of the simulation: no copy. An array that "
        "is still held when the next step is taken keeps showing its moment.")
        .def("__len__", [](const Bodies& self) { return self.read().model().bodies.size(); })
        .def_property_readonly("names", &names, "'block', or 'block[17]' where several share a name (list of n).")
        .def("index", &index, "The number of the body called `name`; KeyError where there is none.", "name"_a)
        .def_property_readonly("position", field(&BodyState::position), "Of the centre of mass [m], (n, 3).")
        .def_property_readonly("orientation", field(&BodyState::orientation),
                               "Quaternion (w, x, y, z) from body to world [-], (n, 4).")
        .def_property_readonly("velocity", field(&BodyState::velocity), "Of the centre of mass [m/s], (n, 3).")
        .def_property_readonly("angular_momentum", field(&BodyState::angular_momentum),
                               "About the centre of mass, world axes [kg m^2/s], (n, 3).")
        .def_property_readonly("angular_velocity", &angular_velocity, "World axes [rad/s], (n, 3); a copy.")
        .def_property_readonly(
            "mass", [](const Bodies& self) { return copied(self.read().model().bodies.mass); },
            "[kg, in planar scenes kg/m], (n,); a copy.")
        .def_property_readonly("shown", &shown,
                               "Fields that the solid method adds, by name, such as 'stress_zz' [Pa] of DDA blocks: "
                               "arrays (n,), copies (dict).")
        .def_property_readonly("is_free", &is_free, "Follows forces, now (bool, (n,)); a copy.")
        .def_property_readonly(
            "contact_force", &contact_force,
            "Sum of the contact forces of the last step [N, in planar scenes N/m], (n, 3); a copy. None "
            "before one.");
}

void define_fluid(py::module_& module) {
    const auto field = [](auto member) {
        return [member](const Fluid& self) {
            return field_of(
                self, [member](sim::State & state) -> auto& { return state.fluid.*member; });
        };
    };
    using fluid::ParticleState;
    py::class_<Fluid>(
        module, "Fluid",
        "The particles of water, m of them. Their order changes from time to time, and their number where "
        "there are openings: `id` tells who is who. `position`, `velocity`, `density` and `id` are "
        "read-only arrays on the memory of the simulation, as those of Bodies.")
        .def("__len__", [](const Fluid& self) { return self.read().state().fluid.size(); })
        .def_property_readonly("position", field(&ParticleState::position), "[m], (m, 3); z = 0 in a planar scene.")
        .def_property_readonly("velocity", field(&ParticleState::velocity), "[m/s], (m, 3).")
        .def_property_readonly("density", field(&ParticleState::density),
                               "[kg/m^3], (m,); half a step behind position and velocity.")
        .def_property_readonly("id", field(&ParticleState::id), "Of the particle for life, from 0 (int32, (m,)).")
        .def_property_readonly("pressure", &pressure, "From the density by the equation of state [Pa], (m,); a copy.")
        .def_property_readonly(
            "particle_mass",
            [](const Fluid& self) { return self.read().model().particles()->settings().particle_mass; },
            "[kg]; in a planar scene per metre of width.")
        .def_property_readonly(
            "spacing", [](const Fluid& self) { return self.read().model().particles()->settings().spacing; }, "[m]");
}

}  // namespace

void define_views(py::module_& module, py::class_<Simulation>& simulation) {
    define_bodies(module);
    define_fluid(module);
    simulation
        .def_property_readonly(
            "bodies", [](const py::object& self) { return Bodies{self}; }, "The bodies (Bodies).")
        .def_property_readonly(
            "fluid",
            [](const py::object& self) {
                const bool has_water = self.cast<Simulation&>().read().model().particles() != nullptr;
                return has_water ? py::cast(Fluid{{self}}) : py::none();
            },
            "The water (Fluid); None without any.")
        .def_property_readonly(
            "contacts", &contacts,
            "The c contacts of the last step as arrays, a copy (dict): body_a, body_b (int32), point [m] and force on "
            "body a (c, 3), normal_force, shear_force [N, in planar scenes N/m], overlap [m], area [m^2], is_sliding "
            "(bool). None before a step was taken.");
}

}  // namespace riprap::python
