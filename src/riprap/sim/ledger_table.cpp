// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/ledger_table.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "riprap/sim/methods.hpp"

namespace riprap::sim {

namespace {

struct SolidLine {
    std::string_view name;
    Balance entry;
    double Ledger::*value;
    std::string_view help;
};
struct FluidLine {
    std::string_view name;
    Balance entry;
    double FluidLedger::*value;
    std::string_view help;
};

constexpr std::array of_every_solid{
    SolidLine{"solid.kinetic", Balance::stored, &Ledger::kinetic, "kinetic, of free bodies"},
    SolidLine{"solid.potential", Balance::stored, &Ledger::potential, "of free bodies in gravity"},
    SolidLine{"solid.elastic", Balance::stored, &Ledger::elastic, "stored in overlaps"},
    SolidLine{"solid.shear", Balance::stored, &Ledger::shear, "stored in tangential and torsional springs"},
    SolidLine{"solid.friction", Balance::lost, &Ledger::friction, "lost by friction since time 0"},
    SolidLine{"solid.contact_damping", Balance::lost, &Ledger::contact_damping,
              "lost by contact dashpots since time 0"},
    SolidLine{"solid.damping", Balance::lost, &Ledger::damping, "lost by local and mass damping since time 0"},
    SolidLine{"solid.driven", Balance::gained, &Ledger::driven,
              "work of driven bodies on other bodies since time 0; on water: fluid.work_on_solids"},
    SolidLine{"solid.external", Balance::gained, &Ledger::external, "work of loads other than contacts since time 0"},
    SolidLine{"solid.gravity_change", Balance::gained, &Ledger::gravity_change,
              "work of a changing gravity since time 0"},
    SolidLine{"solid.released", Balance::gained, &Ledger::released,
              "kinetic and potential energy that released bodies brought along"},
};

constexpr std::array of_every_fluid{
    FluidLine{"fluid.kinetic", Balance::stored, &FluidLedger::kinetic, "kinetic, of the fluid"},
    FluidLine{"fluid.potential", Balance::stored, &FluidLedger::potential, "of the fluid in gravity"},
    FluidLine{"fluid.internal", Balance::stored, &FluidLedger::internal, "of compression"},
    FluidLine{"fluid.work_on_solids", Balance::given, &FluidLedger::work_on_solids,
              "work on bodies, driven ones too, since time 0: negative where a paddle makes waves"},
    FluidLine{
        "fluid.external", Balance::gained, &FluidLedger::work_external,
        "work of gravity along periodic axes, of what changes gravity, of penalty walls and of water in joints, since "
        "time 0"},
    FluidLine{"fluid.transported", Balance::gained, &FluidLedger::transported,
              "energy of fluid that came in less that of fluid that left, since time 0"},
};

void add_own(std::string_view side, std::span<const Account> accounts, std::vector<LedgerLine>& lines) {
    for (const Account& account : accounts) {
        std::string name = std::string(side) + std::string(account.name);
        const auto is_same = [&name](const LedgerLine& line) { return line.name == name; };
        if (std::none_of(lines.begin(), lines.end(), is_same)) {
            lines.push_back({std::move(name), account.entry, account.help, account.is_artificial, nullptr, nullptr,
                             side == "fluid.", account.unit});
        }
    }
}

/// Position of a line among the own accounts of a method, or their number.
std::size_t place_of(const LedgerLine& line, std::span<const Account> accounts) {
    const std::string_view name = std::string_view(line.name).substr(line.name.find('.') + 1);
    const auto is_it = [name](const Account& account) { return account.name == name; };
    return static_cast<std::size_t>(std::find_if(accounts.begin(), accounts.end(), is_it) - accounts.begin());
}

}  // namespace

Accounts accounts_of(const Model& model) {
    return {Solids::visit(model.solid,
                          []<class Solid>(const typename Solid::Settings&) { return Solid::traits.accounts(); }),
            Fluids::visit(model.fluid,
                          []<class Fluid>(const typename Fluid::Settings&) { return Fluid::traits.accounts(); })};
}

const std::vector<LedgerLine>& ledger_lines() {
    static const std::vector<LedgerLine> all = [] {
        std::vector<LedgerLine> lines;
        for (const SolidLine& line : of_every_solid) {
            lines.push_back({std::string(line.name), line.entry, line.help, false, line.value, nullptr, false});
        }
        Solids::for_each([&lines]<class Solid>() { add_own("solid.", Solid::traits.accounts(), lines); });
        for (const FluidLine& line : of_every_fluid) {
            lines.push_back({std::string(line.name), line.entry, line.help, false, nullptr, line.value, true});
        }
        Fluids::for_each([&lines]<class Fluid>() { add_own("fluid.", Fluid::traits.accounts(), lines); });
        return lines;
    }();
    return all;
}

bool has_line(const Model& model, const LedgerLine& line) {
    if (line.is_of_fluid && !model.has_fluid()) {
        return false;
    }
    const Accounts accounts = accounts_of(model);
    const std::span<const Account> own = line.is_of_fluid ? accounts.fluid : accounts.solid;
    return line.of_solid != nullptr || line.of_fluid != nullptr || place_of(line, own) < own.size();
}

double value_of(const LedgerLine& line, const Model& model, const Ledger& ledger) {
    if (line.of_solid != nullptr) {
        const bool is_unmeasured = line.of_solid == &Ledger::elastic && !ledger.has_energy;
        return is_unmeasured ? std::numeric_limits<double>::quiet_NaN() : ledger.*line.of_solid;
    }
    if (line.of_fluid != nullptr) {
        return ledger.fluid.*line.of_fluid;
    }
    const Accounts accounts = accounts_of(model);
    const std::size_t place = place_of(line, line.is_of_fluid ? accounts.fluid : accounts.solid);
    const std::vector<double>& values = line.is_of_fluid ? ledger.fluid.own : ledger.own;
    return place < values.size() ? values[place] : std::numeric_limits<double>::quiet_NaN();
}

double value_of(std::string_view name, const Model& model, const Ledger& ledger) {
    for (const LedgerLine& line : ledger_lines()) {
        if (line.name == name) {
            return value_of(line, model, ledger);
        }
    }
    return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace riprap::sim
