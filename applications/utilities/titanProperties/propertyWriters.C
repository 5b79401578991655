// SPDX-License-Identifier: GPL-3.0-or-later

#include "propertyWriters.H"
#include "commandText.H"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

using Foam::titan::property;

namespace Foam
{
namespace titanCommand
{
namespace
{

//- A property as people read it
struct quantity
{
    property q;
    const char* name;
    const char* shortName;
    const char* unit;
    double perSI;
};

const quantity quantities[] =
{
    {property::density, "density", "density", "kg/m3", 1},
    {property::soundSpeed, "speed of sound", "sound", "m/s", 1},
    {property::cp, "heat capacity cp", "cp", "J/(kg K)", 1},
    {property::viscosity, "viscosity", "viscosity", "uPa s", 1e6},
    {property::conductivity, "thermal conductivity", "conduct.", "W/(m K)", 1},
    {property::surfaceTension, "surface tension", "tension", "mN/m", 1e3},
    {property::cv, "heat capacity cv", "cv", "J/(kg K)", 1},
    {property::isothermalBulkModulus, "isothermal bulk modulus", "K_T", "MPa", 1e-6},
    {property::isentropicBulkModulus, "isentropic bulk modulus", "K_s", "MPa", 1e-6},
    {property::expansivity, "thermal expansivity", "expans.", "1/K", 1}
};

//- The first of these are the columns of a table of several states
constexpr int nTableColumns = 6;

const char* const equationSources[] =
{
    "Density, sound speed, heat capacities: Kunz and Wagner 2012 (GERG-2008 mixing) over Span et al. 2000 (N2),"
    " Setzmann and Wagner 1991 (CH4), Buecker and Wagner 2006 (C2H6), Lemmon et al. 2009 (C3H8).",
    "Viscosity: Lemmon and Jacobsen 2004 (N2), Quinones-Cisneros and Deiters 2006 (CH4), Herrmann et al. 2018 (C2H6),"
    " Vogel et al. 1998 (C3H8); liquids mixed by Grunberg and Nissan 1949 with constants from the table of"
    " Steckloff et al. 2020, gases by Wilke 1950.",
    "Thermal conductivity: Lemmon and Jacobsen 2004 (N2), Friend et al. 1989 (CH4), Friend et al. 1991 (C2H6),"
    " Marsh et al. 2002 (C3H8); liquids mixed by Li 1976, gases by Mason and Saxena 1958.",
    "Surface tension: Mulero et al. 2012, mixed by Weinaug and Katz 1943."
};

//- Paragraph with a hanging indent; each line begins with prefix
void writeWrapped(std::ostream& os, const std::string& prefix, const std::string& text)
{
    const std::string::size_type width = 100;
    std::istringstream words(text);
    std::string line = prefix;
    std::string word;
    for (bool first = true; words >> word; first = false)
    {
        if (!first && line.size() + 1 + word.size() > width)
        {
            os << line << '\n';
            line = prefix + "  " + word;
        }
        else
        {
            line += (first ? "" : " ") + word;
        }
    }
    os << line << '\n';
}


std::string stateName(const propertyState& state)
{
    return std::string(titan::phaseName(state.ph)) + " at " + written(state.T, 7) + " K and "
        + written(state.p, 7) + " Pa";
}


std::string compositionName(const propertyState& state)
{
    std::vector<std::string> parts;
    for (int i = 0; i < titan::nSpecies; ++i)
    {
        if (state.x[i] > 0)
        {
            parts.push_back(written(state.x[i], 5) + " " + titan::speciesName(i));
        }
    }
    return joined(parts, ", ");
}


std::string percent(double uncertainty)
{
    return std::isnan(uncertainty) ? "-" : written(100*uncertainty, 2);
}


void writeSources(std::ostream& os, const subject& about)
{
    os << "\nSources\n";
    if (!about.source.empty())
    {
        writeWrapped(os, "    ", about.source + ".");
    }
    if (!about.isConstant)
    {
        for (const char* source : equationSources)
        {
            writeWrapped(os, "    ", source);
        }
    }
}


void writeLine(std::ostream& os, const std::string& name, const std::string& value, const std::string& rest)
{
    os  << "    " << std::left << std::setw(34) << name << std::right << std::setw(11) << value
        << "  " << rest << '\n';
}


void writeOneState(std::ostream& os, const subject& about, const propertyState& state)
{
    os << "    " << stateName(state) << '\n';
    if (state.hasComposition())
    {
        os << "    mole fractions: " << compositionName(state) << '\n';
    }
    os << '\n';

    for (const quantity& each : quantities)
    {
        const double value = state.properties[each.q];
        if (std::isnan(value))
        {
            continue;
        }
        std::ostringstream rest;
        rest << std::left << std::setw(8) << each.unit;
        const double uncertainty = state.properties.uncertainty(each.q);
        if (!std::isnan(uncertainty))
        {
            rest << "  +- " << percent(uncertainty) << " %";
        }
        writeLine(os, each.name, written(value*each.perSI, 6), rest.str());

        const double density = state.properties[property::density];
        if (each.q == property::viscosity && !std::isnan(density))
        {
            writeLine(os, "kinematic viscosity", written(value/density, 6), "m2/s");
        }
    }
    if (about.withBubblePoint)
    {
        os << '\n';
        if (!std::isnan(state.bubblePressure))
        {
            writeLine(os, "bubble pressure at this T", written(state.bubblePressure, 6), "Pa");
        }
        if (!std::isnan(state.dissolvedNitrogen))
        {
            writeLine(os, "nitrogen its alkanes can dissolve", written(state.dissolvedNitrogen, 5), "mole fraction");
        }
    }
}


void writeStates(std::ostream& os, const subject& about, const std::vector<propertyState>& states)
{
    const propertyState& first = states.front();
    bool sameComposition = true;
    for (const propertyState& state : states)
    {
        sameComposition = sameComposition && (state.x == first.x || !state.hasComposition());
    }
    os << "    " << titan::phaseName(first.ph);
    if (first.hasComposition() && sameComposition)
    {
        os << ", mole fractions: " << compositionName(first);
    }
    os << "\n\n";

    const int width = 11;
    const auto cell = [&](const std::string& text) { os << std::right << std::setw(width) << text; };
    const auto number = [&](double value, int digits) { cell(std::isnan(value) ? "-" : written(value, digits)); };

    std::vector<std::string> names = {"T", "p"};
    std::vector<std::string> units = {"K", "Pa"};
    if (!sameComposition)
    {
        for (int i = 0; i < titan::nSpecies; ++i)
        {
            names.push_back(std::string("x ") + titan::speciesName(i));
            units.push_back("-");
        }
    }
    for (int i = 0; i < nTableColumns; ++i)
    {
        names.push_back(quantities[i].shortName);
        units.push_back(quantities[i].unit);
    }
    if (about.withBubblePoint)
    {
        names.insert(names.end(), {"bubble p", "dissolved"});
        units.insert(units.end(), {"Pa", "x N2"});
    }
    for (const std::vector<std::string>& line : {names, units})
    {
        for (const std::string& text : line)
        {
            cell(text);
        }
        os << '\n';
    }

    std::array<double, nTableColumns> uncertainties{};
    for (const propertyState& state : states)
    {
        number(state.T, 7);
        number(state.p, 7);
        for (int i = 0; !sameComposition && i < titan::nSpecies; ++i)
        {
            number(state.x[i], 5);
        }
        for (int i = 0; i < nTableColumns; ++i)
        {
            const property q = quantities[i].q;
            number(state.properties[q]*quantities[i].perSI, 6);
            uncertainties[i] = std::fmax(uncertainties[i], state.properties.uncertainty(q));
        }
        if (about.withBubblePoint)
        {
            number(state.bubblePressure, 6);
            number(state.dissolvedNitrogen, 5);
        }
        os << '\n';
    }
    os << std::left << std::setw(width*(sameComposition ? 2 : 2 + titan::nSpecies)) << "    +- % (largest)";
    for (const double uncertainty : uncertainties)
    {
        cell(uncertainty > 0 ? percent(uncertainty) : "-");
    }
    os << '\n';
}


//- Each sentence once, with the states that it is said of
void writeWarnings(std::ostream& os, const std::vector<propertyState>& states)
{
    std::vector<std::pair<std::string, std::vector<const propertyState*>>> sentences;
    for (const propertyState& state : states)
    {
        std::vector<std::string> said = state.warnings;
        if (!state.refusal.empty())
        {
            said.push_back("Refused: " + state.refusal);
        }
        for (const std::string& sentence : said)
        {
            auto found = std::find_if
            (
                sentences.begin(), sentences.end(),
                [&](const auto& other) { return other.first == sentence; }
            );
            if (found == sentences.end())
            {
                found = sentences.insert(found, {sentence, {}});
            }
            found->second.push_back(&state);
        }
    }
    if (sentences.empty())
    {
        return;
    }

    os << "\nWarnings\n";
    const std::size_t most = 30;
    for (std::size_t i = 0; i < std::min(most, sentences.size()); ++i)
    {
        const std::vector<const propertyState*>& of = sentences[i].second;
        std::string about;
        if (states.size() > 1 && of.size() == states.size())
        {
            about = "All states: ";
        }
        else if (states.size() > 1)
        {
            about = written(of.front()->T, 7) + " K, " + written(of.front()->p, 7) + " Pa";
            if (of.size() > 1)
            {
                about += " and " + std::to_string(of.size() - 1) + " more";
            }
            about += ": ";
        }
        writeWrapped(os, "    ", about + sentences[i].first);
    }
    if (sentences.size() > most)
    {
        os << "    " << sentences.size() - most << " more: -format csv shows them all\n";
    }
}

} // End anonymous namespace
} // End namespace titanCommand
} // End namespace Foam


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

const std::vector<std::string> Foam::titanCommand::stateColumns =
    {"x_N2", "x_CH4", "x_C2H6", "x_C3H8", "phase", "T_K", "p_Pa"};

const std::vector<Foam::titan::property> Foam::titanCommand::batchProperties =
    {
        property::density, property::soundSpeed, property::cp,
        property::viscosity, property::conductivity, property::surfaceTension
    };


void Foam::titanCommand::writeTable
(
    std::ostream& os,
    const subject& about,
    const std::vector<propertyState>& states
)
{
    writeWrapped(os, "", about.title + (about.description.empty() ? "" : ": " + about.description));
    if (states.size() == 1)
    {
        writeOneState(os, about, states.front());
    }
    else
    {
        writeStates(os, about, states);
    }
    writeWarnings(os, states);
    writeSources(os, about);
}


void Foam::titanCommand::writeCsv
(
    std::ostream& os,
    const subject& about,
    const std::vector<propertyState>& states
)
{
    std::vector<property> properties = batchProperties;
    for (const quantity& each : quantities)
    {
        if (std::find(properties.begin(), properties.end(), each.q) == properties.end())
        {
            properties.push_back(each.q);
        }
    }

    os << joined(stateColumns, ",");
    for (const property q : properties)
    {
        os << ',' << titan::propertyColumn(q);
    }
    if (about.withBubblePoint)
    {
        os << ",bubble_pressure_Pa,dissolvable_x_N2";
    }
    for (const property q : batchProperties)
    {
        os << ",u_" << titan::propertyName(q) << "_percent";
    }
    os << ",message\n";

    for (const propertyState& state : states)
    {
        for (const double fraction : state.x)
        {
            os << csvCell(fraction) << ',';
        }
        os << titan::phaseName(state.ph) << ',' << csvCell(state.T) << ',' << csvCell(state.p) << ',';
        for (const property q : properties)
        {
            os << csvCell(state.properties[q]) << ',';
        }
        if (about.withBubblePoint)
        {
            os << csvCell(state.bubblePressure) << ',' << csvCell(state.dissolvedNitrogen) << ',';
        }
        for (const property q : batchProperties)
        {
            os << csvCell(100*state.properties.uncertainty(q)) << ',';
        }
        os << csvCell(state.message()) << '\n';
    }
}


void Foam::titanCommand::writeFoam(std::ostream& os, const subject& about, const propertyState& state)
{
    struct entry
    {
        const char* keyword;
        double value;
        const char* unit;
        double uncertainty;
    };
    const titan::fluidProperties& values = state.properties;
    const auto entryOf = [&](const char* keyword, property q, const char* unit)
    {
        return entry{keyword, values[q], unit, values.uncertainty(q)};
    };
    const double nothing = std::nan("");
    const entry entries[] =
    {
        {
            "nu", values[property::viscosity]/values[property::density], "m2/s",
            std::hypot(values.uncertainty(property::viscosity), values.uncertainty(property::density))
        },
        entryOf("rho", property::density, "kg/m3"),
        entryOf("sigma", property::surfaceTension, "N/m"),
        entryOf("soundSpeed", property::soundSpeed, "m/s"),
        {"vapourPressure", state.bubblePressure, "Pa", nothing},
        entryOf("mu", property::viscosity, "Pa s"),
        entryOf("Cp", property::cp, "J/(kg K)"),
        entryOf("kappa", property::conductivity, "W/(m K)"),
        entryOf("expansivity", property::expansivity, "1/K"),
        entryOf("bulkModulus", property::isentropicBulkModulus, "Pa, isentropic")
    };

    const std::string phaseWord = titan::phaseName(state.ph);
    writeWrapped(os, "// ", about.title + (about.description.empty() ? "" : ": " + about.description));
    writeWrapped(os, "// ", stateName(state));
    if (state.hasComposition())
    {
        writeWrapped(os, "// ", "mole fractions: " + compositionName(state));
    }
    if (!about.source.empty())
    {
        writeWrapped(os, "// ", "source: " + about.source);
    }
    for (const std::string& warning : state.warnings)
    {
        writeWrapped(os, "// ", "WARNING: " + warning);
    }
    os  << "//\n"
        << "// Written by titanProperties. In constant/transportProperties, this file beside it:\n"
        << "//     " << phaseWord << "\n//     {\n//         #include \"thisFile\"\n//     }\n";
    if (state.ph == titan::phase::liquid)
    {
        os << "//     sigma $" << phaseWord << ".sigma;\n";
    }
    os << "\ntransportModel  Newtonian;\n";

    for (const entry& each : entries)
    {
        if (std::isnan(each.value))
        {
            continue;
        }
        os  << std::left << std::setw(16) << each.keyword << std::setw(18) << written(each.value, 10) + ";"
            << "// " << each.unit;
        if (!std::isnan(each.uncertainty))
        {
            os << ", +- " << percent(each.uncertainty) << " %";
        }
        os << '\n';
    }
}
