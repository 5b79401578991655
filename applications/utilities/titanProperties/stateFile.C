// SPDX-License-Identifier: GPL-3.0-or-later

#include "stateFile.H"
#include "commandText.H"
#include "propertyWriters.H"

#include <array>
#include <limits>
#include <map>
#include <memory>
#include <ostream>
#include <utility>

using Foam::titan::thermoError;

namespace Foam
{
namespace titanCommand
{
namespace
{

constexpr int nColumns = 7;
constexpr int phaseColumn = 4;
typedef std::array<std::string, nColumns> stateCells;

//- Models of the compositions met last
class models
{
    typedef std::pair<titan::composition::fractions, titan::phase> key;

    static constexpr std::size_t most = 500;

    std::map<key, std::unique_ptr<titan::fluidModel>> models_;

public:

    const titan::fluidModel& of(const titan::composition& x, titan::phase ph)
    {
        if (models_.size() > most)
        {
            models_.clear();
        }
        std::unique_ptr<titan::fluidModel>& model = models_[key(x.x(), ph)];
        if (!model)
        {
            model = titan::directFluid(x, ph);
        }
        return *model;
    }
};


//- Where each of the columns stands
std::array<int, nColumns> columnsOf(const csvReader& file, const std::vector<std::string>& header)
{
    std::array<int, nColumns> columns;
    for (int i = 0; i < nColumns; ++i)
    {
        columns[i] = -1;
        for (std::size_t column = 0; column < header.size(); ++column)
        {
            if (trimmed(header[column]) != stateColumns[i])
            {
                continue;
            }
            if (columns[i] >= 0)
            {
                throw thermoError
                (
                    thermoError::reason::badEntry,
                    file.where(stateColumns[i]) + ": there are two columns of this name"
                );
            }
            columns[i] = column;
        }
        if (columns[i] < 0)
        {
            throw thermoError
            (
                thermoError::reason::badEntry,
                file.where(stateColumns[i]) + ": missing: expected a header with the columns "
              + joined(stateColumns, ",") + ", and found " + joined(header, ",")
            );
        }
    }
    return columns;
}


//- The seven cells of a row; those that it lacks are empty
stateCells cellsOf(const std::vector<std::string>& row, const std::array<int, nColumns>& columns)
{
    stateCells cells;
    for (int i = 0; i < nColumns; ++i)
    {
        if (columns[i] < int(row.size()))
        {
            cells[i] = row[columns[i]];
        }
    }
    return cells;
}


propertyState evaluate(const csvReader& file, const stateCells& cells, models& known, bool withWarnings)
{
    std::array<double, nColumns> numbers{};
    for (int i = 0; i < nColumns; ++i)
    {
        if (i != phaseColumn)
        {
            numbers[i] = readNumber(cells[i], file.where(stateColumns[i]));
        }
    }
    if (trimmed(cells[phaseColumn]).empty())
    {
        throw thermoError
        (
            thermoError::reason::badEntry,
            file.where(stateColumns[phaseColumn]) + ": missing: expected liquid or gas"
        );
    }
    const titan::phase ph = titan::phaseNamed(trimmed(cells[phaseColumn]));
    const titan::composition x(numbers[0], numbers[1], numbers[2], numbers[3]);
    return propertyState::ofMixture(known.of(x, ph), x, ph, numbers[5], numbers[6], withWarnings);
}


//- More cells than columns: a comma too many, and cells that stand under the wrong names
void checkLength(const csvReader& file, const std::vector<std::string>& row, std::size_t expected)
{
    for (std::size_t i = expected; i < row.size(); ++i)
    {
        if (!trimmed(row[i]).empty())
        {
            throw thermoError
            (
                thermoError::reason::badEntry,
                file.where() + ": " + std::to_string(row.size()) + " cells under a header of "
              + std::to_string(expected) + ": expected quotation marks around cells that hold commas"
            );
        }
    }
}


} // End anonymous namespace
} // End namespace titanCommand
} // End namespace Foam


Foam::titanCommand::batchCount Foam::titanCommand::writeBatch
(
    std::ostream& os,
    const std::string& fileName,
    bool withWarnings
)
{
    csvReader file(fileName);
    std::vector<std::string> header;
    if (!file.next(header))
    {
        throw thermoError
        (
            thermoError::reason::badEntry,
            (fileName == "-" ? "standard input" : fileName) + ": empty: expected a header with the columns "
          + joined(stateColumns, ",")
        );
    }
    const std::array<int, nColumns> columns = columnsOf(file, header);

    os << joined(stateColumns, ",");
    for (const titan::property q : batchProperties)
    {
        os << ',' << titan::propertyColumn(q);
    }
    os << ",message\n";

    batchCount count;
    models known;
    std::vector<std::string> row;
    while (true)
    {
        stateCells cells;
        std::array<double, titan::nProperties> values;
        values.fill(std::numeric_limits<double>::quiet_NaN());
        std::string message;
        try
        {
            row.clear();
            if (!file.next(row))
            {
                break;
            }
            cells = cellsOf(row, columns);
            checkLength(file, row, header.size());
            const propertyState state = evaluate(file, cells, known, withWarnings);
            values = state.properties.values;
            message = state.message();
            count.refused += !state.refusal.empty();
        }
        catch (const thermoError& why)
        {
            message = why.what();
            ++count.refused;
        }
        ++count.states;

        for (const std::string& cell : cells)
        {
            os << csvCell(cell) << ',';
        }
        for (const titan::property q : batchProperties)
        {
            os << csvCell(values[static_cast<int>(q)]) << ',';
        }
        os << csvCell(message) << '\n';
    }
    return count;
}
