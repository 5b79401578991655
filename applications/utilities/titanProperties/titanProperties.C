// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Application
    titanProperties

Description
    Properties of Titan's lakes and of its air, or of any mixture of nitrogen,
    methane, ethane and propane, as a readable table, as CSV, or as an OpenFOAM
    dictionary.

    Usage:
    \verbatim
        titanProperties Kraken
        titanProperties -composition '(N2 0.05 CH4 0.25 C2H6 0.70)' -T 94
        titanProperties -states in.csv -format csv
    \endverbatim

    What was asked for goes to standard output or to the file of -output,
    warnings and errors to standard error. Exit status 1: nothing was written.
    A batch or a range goes on where a state is refused.

    Needs no case, and writes nothing but what is asked for.
\*---------------------------------------------------------------------------*/

#include "argList.H"

#include "commandText.H"
#include "namedFluid.H"
#include "phaseEquilibrium.H"
#include "propertyWriters.H"
#include "stateFile.H"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>

#include <limits.h>
#include <unistd.h>

using Foam::argList;
namespace titan = Foam::titan;
using titan::thermoError;
using namespace Foam::titanCommand;

namespace
{

//- Titan's surface [Pa]
const char* const surfacePressure = "1.467e5";

const double none = std::numeric_limits<double>::quiet_NaN();
const titan::composition::fractions noFractions{{none, none, none, none}};

[[noreturn]] void refuse(const std::string& message)
{
    throw thermoError(thermoError::reason::badEntry, message);
}


void warn(const std::string& message)
{
    std::cerr << "titanProperties: warning: " << message << std::endl;
}


void addOptions()
{
    argList::noBanner();
    argList::noJobInfo();
    argList::noParallel();
    argList::noMandatoryArgs();
    for (const char* other : {"case", "noFunctionObjects", "fileHandler", "lib"})
    {
        argList::removeOption(other);
    }

    argList::addArgument
    (
        "fluid",
        "A lake or an air by its name (-list shows them), at its surface or at -T and -p"
    );
    argList::addBoolOption("list", "List the fluids that have a name");
    argList::addOption
    (
        "composition",
        "(species fraction ...)",
        "Mole fractions of a mixture of N2, CH4, C2H6, C3H8, such as '(N2 0.05 CH4 0.25 C2H6 0.70)'."
        " A sum that is off by up to 1e-3 is normalised"
    );
    argList::addOption
    (
        "saturate",
        "(species amount ...)",
        "Alkanes in any amounts, such as 'CH4 0.25 C2H6 0.75', that have dissolved as much nitrogen as they can"
        " at each T and p"
    );
    argList::addOption
    (
        "states",
        "file",
        "Batch: the states of a CSV file ('-': standard input) whose header has the columns "
      + joined(stateColumns, ",") + ", in any order. Writes CSV: those columns, the properties, a message."
        " Where a state is refused the cells are empty and the message says why"
    );
    argList::addOption("T", "K", "Temperature, or a range '(start end step)'");
    argList::addOption
    (
        "p",
        "Pa",
        std::string("Pressure, or a range '(start end step)'; default: ") + surfacePressure
      + ", at the surface of Titan"
    );
    argList::addOption("phase", "liquid|gas", "Phase of a -composition; default: liquid");
    argList::addBoolOption
    (
        "resaturate",
        "A lake by its name: dissolve nitrogen anew at each T and p, instead of the composition of its surface"
    );
    argList::addBoolOption
    (
        "bubble",
        "Also the bubble pressure of the liquid, and the nitrogen that its alkanes can dissolve at T and p"
    );
    argList::addOption
    (
        "format",
        "table|csv|foam",
        "A readable table (default), CSV, or a dictionary for #include in transportProperties (of one state)"
    );
    argList::addBoolOption
    (
        "noWarnings",
        "Leave out the checks whether a state is stable (boiling, freezing, two liquids): faster batches"
    );
    argList::addOption("output", "file", "Write to a file instead of to standard output");

    for
    (
        const char* line :
        {
            "Properties of Titan's lakes and air, with uncertainties (95 %), warnings and sources.",
            "",
            "Examples:",
            "    titanProperties Kraken",
            "    titanProperties Ontario -T '(90 96 1)' -resaturate",
            "    titanProperties -composition '(N2 0.05 CH4 0.25 C2H6 0.70)' -T 94",
            "    titanProperties -saturate 'CH4 1 C2H6 3' -T 94 -p 1.467e5 -bubble",
            "    titanProperties Ligeia -format foam -output constant/liquid",
            "    titanProperties -states in.csv -format csv -output out.csv",
            "",
            "Errors go to standard error, with exit status 1."
        }
    )
    {
        argList::addNote(line);
    }
}


//- Unknown options, and those without their value: OpenFOAM would say so on standard output
void checkOptions(int argc, char* argv[])
{
    for (int i = 1; i < argc; ++i)
    {
        const std::string argument = argv[i];
        if (argument.size() < 2 || argument[0] != '-')
        {
            continue;
        }
        const std::string option = argument.substr(1);
        if (option.compare(0, 4, "help") == 0 || option.compare(0, 3, "doc") == 0)
        {
            continue;
        }
        if (!argList::validOptions.found(option))
        {
            refuse("unknown option '" + argument + "': see titanProperties -help");
        }
        if (argList::validOptions[option].empty())
        {
            continue;
        }
        ++i;
        if (i == argc || (argv[i][0] == '-' && argList::validOptions.found(argv[i] + 1)))
        {
            refuse("option '" + argument + "' has no value: expected " + argList::validOptions[option]);
        }
    }
}


std::string optionOr(const argList& args, const char* name, const std::string& otherwise)
{
    return args.found(name) ? std::string(args[name]) : otherwise;
}


//- Only these options go with what is asked for
void checkTogether(const argList& args, const std::string& asked, const std::vector<std::string>& allowed)
{
    for (const Foam::word& option : args.options().sortedToc())
    {
        if
        (
            "-" + option != asked
         && std::find(allowed.begin(), allowed.end(), option) == allowed.end()
        )
        {
            refuse("-" + option + " does not go with " + asked);
        }
    }
}


//- What is asked for: a fluid's name or the option that describes it
std::string askedFor(const argList& args)
{
    std::vector<std::string> asked;
    for (Foam::label i = 1; i < args.size(); ++i)
    {
        asked.push_back(args[i]);
    }
    for (const char* option : {"list", "composition", "saturate", "states"})
    {
        if (args.found(option))
        {
            asked.push_back(std::string("-") + option);
        }
    }
    if (asked.size() != 1)
    {
        refuse
        (
            (asked.empty() ? "nothing is asked for" : "asked for " + joined(asked, " and ") + " at the same time")
          + std::string
            (
                ": expected the name of a fluid, -composition, -saturate, -states or -list;"
                " see titanProperties -help"
            )
        );
    }
    return asked[0];
}


void checkFormat(const std::string& format, const std::string& asked)
{
    std::vector<std::string> formats = {"table", "csv", "foam"};
    if (asked == "-list")
    {
        formats = {"table", "csv"};
    }
    else if (asked == "-states")
    {
        formats = {"csv"};
    }
    if (std::find(formats.begin(), formats.end(), format) == formats.end())
    {
        refuse("-format '" + format + "' of " + asked + ": expected " + joined(formats, ", "));
    }
}


// * * * * * * * * * * * * * * What is written * * * * * * * * * * * * * * * //

void writeList(std::ostream& os, const std::string& format)
{
    using titan::property;

    const bool csv = format == "csv";
    if (csv)
    {
        os << "name," << joined(stateColumns, ",") << ",description\n";
    }
    else
    {
        os  << "name           phase     T [K]   p [Pa]  density [kg/m3]  viscosity [uPa s]\n";
    }
    for (const std::string& name : titan::namedFluid::names())
    {
        const titan::namedFluid fluid = titan::namedFluid::lookup(name);
        if (csv)
        {
            os << csvCell(name) << ',';
            for (const double fraction : fluid.x.x())
            {
                os << (fluid.isConstant ? "" : csvCell(fraction)) << ',';
            }
            os  << titan::phaseName(fluid.ph) << ',' << csvCell(fluid.T) << ',' << csvCell(fluid.p) << ','
                << csvCell(fluid.description) << '\n';
        }
        else
        {
            os  << std::left << std::setw(15) << name << std::setw(8) << titan::phaseName(fluid.ph) << std::right
                << std::setw(7) << written(fluid.T, 5) << std::setw(9) << written(fluid.p, 7)
                << std::setw(17) << written(fluid.properties[property::density], 5)
                << std::setw(19) << written(1e6*fluid.properties[property::viscosity], 4)
                << "\n    " << fluid.description << (fluid.isConstant ? "" : ": " + fluid.x.name()) << '\n';
        }
    }
}


//- T and p that are asked for
struct grid
{
    std::vector<double> temperatures;
    std::vector<double> pressures;

    grid(const argList& args, const std::string& T, const std::string& p)
    :
        temperatures(readRange(optionOr(args, "T", T), "-T")),
        pressures(readRange(optionOr(args, "p", p), "-p"))
    {}

    //- T outside, p inside
    template<class Function>
    std::vector<propertyState> map(const Function& stateAt) const
    {
        std::vector<propertyState> states;
        for (const double T : temperatures)
        {
            for (const double p : pressures)
            {
                states.push_back(stateAt(T, p));
            }
        }
        return states;
    }
};


//- States of the same alkanes with as much nitrogen as they dissolve at each T and p
std::vector<propertyState> saturatedStates
(
    const titan::composition::fractions& alkanes,
    const grid& at,
    bool withWarnings
)
{
    return at.map
    (
        [&](double T, double p)
        {
            try
            {
                const titan::composition x = titan::saturateWithNitrogen
                (
                    alkanes[titan::CH4], alkanes[titan::C2H6], alkanes[titan::C3H8], T, p
                ).liquid;
                const auto model = titan::directFluid(x, titan::phase::liquid);
                return propertyState::ofMixture(*model, x, titan::phase::liquid, T, p, withWarnings);
            }
            catch (const thermoError& why)
            {
                return propertyState::refused(noFractions, titan::phase::liquid, T, p, why.what());
            }
        }
    );
}


std::vector<propertyState> mixtureStates
(
    const titan::composition& x,
    titan::phase ph,
    const grid& at,
    bool withWarnings
)
{
    const auto model = titan::directFluid(x, ph);
    return at.map
    (
        [&](double T, double p) { return propertyState::ofMixture(*model, x, ph, T, p, withWarnings); }
    );
}


std::vector<propertyState> namedStates(const argList& args, const std::string& name, subject& about)
{
    const titan::namedFluid fluid = titan::namedFluid::lookup(name);
    about.title = fluid.name;
    about.description = fluid.description;
    about.source = fluid.source;
    about.isConstant = fluid.isConstant;

    if (fluid.isConstant)
    {
        checkTogether(args, name, {"format", "output", "noWarnings"});
        return {propertyState::ofConstants(fluid.properties, fluid.ph)};
    }
    checkTogether(args, name, {"T", "p", "resaturate", "bubble", "noWarnings", "format", "output"});
    const grid at(args, written(fluid.T, 17), written(fluid.p, 17));
    const bool withWarnings = !args.found("noWarnings");
    if (!args.found("resaturate"))
    {
        return mixtureStates(fluid.x, fluid.ph, at, withWarnings);
    }
    if (fluid.ph == titan::phase::gas)
    {
        refuse("-resaturate: " + name + " is a gas: expected a lake");
    }
    about.description += ", anew at each T and p";
    return saturatedStates(fluid.x.x(), at, withWarnings);
}


//- States of what is asked for; what is to be said of all of them goes to about
std::vector<propertyState> statesOf(const argList& args, const std::string& asked, subject& about)
{
    if (asked[0] != '-')
    {
        return namedStates(args, asked, about);
    }
    if (!args.found("T"))
    {
        refuse("-T is missing: expected the temperature that belongs to " + asked);
    }

    const bool withWarnings = !args.found("noWarnings");
    const grid at(args, "", surfacePressure);
    if (asked == "-composition")
    {
        checkTogether(args, asked, {"T", "p", "phase", "bubble", "noWarnings", "format", "output"});
        about.title = "Mixture";
        return mixtureStates
        (
            titan::composition(readAmounts(args["composition"], asked)),
            titan::phaseNamed(optionOr(args, "phase", "liquid")),
            at,
            withWarnings
        );
    }

    checkTogether(args, asked, {"T", "p", "bubble", "noWarnings", "format", "output"});
    const titan::composition::fractions alkanes = readAmounts(args["saturate"], asked);
    if (alkanes[titan::N2] != 0)
    {
        refuse("-saturate: nitrogen is what the alkanes dissolve: expected amounts of CH4, C2H6, C3H8 alone");
    }
    about.title = "Saturated with nitrogen";
    return saturatedStates(alkanes, at, withWarnings);
}


void writeStates(std::ostream& os, const argList& args, const std::string& asked, const std::string& format)
{
    subject about;
    about.withBubblePoint = args.found("bubble");
    std::vector<propertyState> states = statesOf(args, asked, about);

    int nRefused = 0;
    for (propertyState& state : states)
    {
        nRefused += !state.refusal.empty();
        if (about.withBubblePoint && state.ph == titan::phase::gas)
        {
            refuse("-bubble: " + asked + " is a gas: expected a liquid");
        }
        if
        (
            (about.withBubblePoint || format == "foam")
         && state.ph == titan::phase::liquid && state.hasComposition() && state.refusal.empty()
        )
        {
            state.findBubblePoint();
        }
    }
    if (nRefused == int(states.size()))
    {
        refuse(states[0].refusal);
    }

    if (format == "table")
    {
        writeTable(os, about, states);
    }
    else if (format == "csv")
    {
        writeCsv(os, about, states);
    }
    else if (states.size() > 1)
    {
        refuse("-format foam: expected one state, and there are " + std::to_string(states.size()));
    }
    else
    {
        writeFoam(os, about, states[0]);
        for (const std::string& warning : states[0].warnings)
        {
            warn(warning);
        }
    }
    if (nRefused)
    {
        warn(std::to_string(nRefused) + " of " + std::to_string(states.size()) + " states refused");
    }
}


void writeStateFile(std::ostream& os, const argList& args)
{
    checkTogether(args, "-states", {"noWarnings", "format", "output"});
    const batchCount count = writeBatch(os, args["states"], !args.found("noWarnings"));
    if (count.refused)
    {
        warn
        (
            std::to_string(count.refused) + " of " + std::to_string(count.states)
          + " states refused: the column message says why"
        );
    }
}


//- Only whole: nothing where there was an error
void publish(const argList& args, const std::string& text)
{
    if (!args.found("output"))
    {
        std::cout << text << std::flush;
        if (!std::cout)
        {
            refuse("standard output: cannot be written");
        }
        return;
    }
    const std::string& name = args["output"];
    std::ofstream file(name, std::ios::binary);
    file << text << std::flush;
    if (!file)
    {
        refuse("-output '" + name + "': cannot be written: expected a file in a directory that exists");
    }
}

void answer(const argList& args)
{
    const std::string asked = askedFor(args);
    const std::string format = optionOr(args, "format", asked == "-states" ? "csv" : "table");
    checkFormat(format, asked);

    std::ostringstream text;
    if (asked == "-list")
    {
        checkTogether(args, asked, {"format", "output"});
        writeList(text, format);
    }
    else if (asked == "-states")
    {
        writeStateFile(text, args);
    }
    else
    {
        writeStates(text, args, asked, format);
    }
    publish(args, text.str());
}


[[noreturn]] void fail(const std::exception& error)
{
    std::cerr << "titanProperties: error: " << error.what() << std::endl;

    // Not by return: argList's destructor ends the program with status 0.
    std::exit(1);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    // Where PWD is not the current directory, as in a program started by another, OpenFOAM would warn of it on
    // standard output.
    char directory[PATH_MAX];
    if (getcwd(directory, sizeof(directory)))
    {
        setenv("PWD", directory, 1);
    }

    addOptions();
    try
    {
        checkOptions(argc, argv);
    }
    catch (const std::exception& error)
    {
        fail(error);
    }

    // Not initialised: no trap of floating-point exceptions may end a batch, and no case is looked for.
    const argList args(argc, argv, false, false, false);
    try
    {
        answer(args);
    }
    catch (const std::exception& error)
    {
        fail(error);
    }
    return 0;
}
