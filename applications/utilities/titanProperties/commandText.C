// SPDX-License-Identifier: GPL-3.0-or-later

#include "commandText.H"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

using Foam::titan::thermoError;

namespace
{

const char* const whiteSpace = " \t\r\n\v\f";

[[noreturn]] void refuse(const std::string& message)
{
    throw thermoError(thermoError::reason::badEntry, message);
}

//- The words of text; parentheses around them and quotation marks count as space
std::vector<std::string> wordsOf(const std::string& text, const std::string& where)
{
    std::string bare = Foam::titanCommand::trimmed(text);
    if (!bare.empty() && (bare.front() == '(' || bare.back() == ')'))
    {
        if (bare.size() < 2 || bare.front() != '(' || bare.back() != ')')
        {
            refuse(where + ": '" + text + "' has a parenthesis without its partner");
        }
        bare = bare.substr(1, bare.size() - 2);
    }
    for (char& c : bare)
    {
        // The shell's '( a b )', as three words, reaches us as ("a""b").
        if (c == '"')
        {
            c = ' ';
        }
    }
    std::istringstream stream(bare);
    return {std::istream_iterator<std::string>(stream), std::istream_iterator<std::string>()};
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Reading * * * * * * * * * * * * * * * * * * * //

std::string Foam::titanCommand::trimmed(const std::string& text)
{
    const auto first = text.find_first_not_of(whiteSpace);
    if (first == std::string::npos)
    {
        return std::string();
    }
    return text.substr(first, text.find_last_not_of(whiteSpace) - first + 1);
}


std::string Foam::titanCommand::joined(const std::vector<std::string>& words, const std::string& separator)
{
    std::string result;
    for (const std::string& word : words)
    {
        result += (result.empty() ? "" : separator) + word;
    }
    return result;
}


double Foam::titanCommand::readNumber(const std::string& text, const std::string& where)
{
    const std::string bare = trimmed(text);
    if (bare.empty())
    {
        refuse(where + ": missing: expected a number");
    }
    char* end = nullptr;
    const double value = std::strtod(bare.c_str(), &end);

    // strtod also reads "nan", "infinity" and 0x1p-3, none of which is a figure.
    if (end != bare.c_str() + bare.size() || !std::isfinite(value) || bare.find_first_of("xX") != std::string::npos)
    {
        throw thermoError
        (
            std::isfinite(value) ? thermoError::reason::badEntry : thermoError::reason::notANumber,
            where + ": '" + text + "': expected a number, such as 94 or 1.467e5"
        );
    }
    return value;
}


std::vector<double> Foam::titanCommand::readRange(const std::string& text, const std::string& where)
{
    const std::string expected = ": expected a number, or a range '(start end step)', such as '(90 96 1)'";
    const std::vector<std::string> words = wordsOf(text, where);
    if (words.size() == 1)
    {
        return {readNumber(words[0], where)};
    }
    if (words.size() != 3)
    {
        refuse(where + ": '" + text + "'" + expected);
    }

    const double start = readNumber(words[0], where);
    const double end = readNumber(words[1], where);
    const double step = readNumber(words[2], where);
    const double steps = (end - start)/step;
    if (step == 0 || !(steps >= 0))
    {
        refuse(where + ": '" + text + "': steps of " + words[2] + " do not lead from " + words[0] + " to " + words[1]);
    }
    const double most = 1e6;
    if (steps >= most)
    {
        refuse(where + ": '" + text + "': expected at most a million steps, and there are " + written(steps, 6));
    }

    // The end belongs to the range even where (end - start)/step is rounded down.
    const int last = static_cast<int>(steps*(1 + 1e-12) + 1e-9);
    std::vector<double> values(last + 1);
    for (int i = 0; i <= last; ++i)
    {
        values[i] = start + i*step;
    }
    if (std::abs(values[last] - end) < 1e-9*std::abs(step))
    {
        values[last] = end;
    }
    return values;
}


Foam::titan::composition::fractions Foam::titanCommand::readAmounts(const std::string& text, const std::string& where)
{
    const std::vector<std::string> words = wordsOf(text, where);
    if (words.empty() || words.size() % 2)
    {
        refuse(where + ": '" + text + "': expected species and amounts in turn, such as 'CH4 0.25 C2H6 0.75'");
    }

    titan::composition::fractions amounts{};
    std::array<bool, titan::nSpecies> given{};
    for (std::size_t word = 0; word < words.size(); word += 2)
    {
        int i = 0;
        std::vector<std::string> names;
        while
        (
            i < titan::nSpecies
         && words[word] != titan::speciesName(i) && words[word] != titan::speciesLongName(i)
        )
        {
            names.push_back(titan::speciesName(i++));
        }
        if (i == titan::nSpecies)
        {
            refuse(where + ": unknown species '" + words[word] + "': expected one of " + joined(names, ", "));
        }
        if (given[i])
        {
            refuse(where + ": '" + text + "' names " + words[word] + " twice");
        }
        given[i] = true;
        amounts[i] = readNumber(words[word + 1], where + ", " + words[word]);
    }
    return amounts;
}


// * * * * * * * * * * * * * * Writing * * * * * * * * * * * * * * * * * * * //

std::string Foam::titanCommand::written(double value, int digits)
{
    char buffer[40];
    std::snprintf(buffer, sizeof(buffer), "%.*g", digits, value);
    return buffer;
}


std::string Foam::titanCommand::csvCell(const std::string& text)
{
    if (text.find_first_of(",\"\r\n") == std::string::npos)
    {
        return text;
    }
    std::string cell = "\"";
    for (const char c : text)
    {
        cell += (c == '"' ? "\"\"" : std::string(1, c));
    }
    return cell + '"';
}


std::string Foam::titanCommand::csvCell(double value)
{
    return std::isnan(value) ? std::string() : written(value, 10);
}


// * * * * * * * * * * * * * * csvReader * * * * * * * * * * * * * * * * * * //

Foam::titanCommand::csvReader::csvReader(const std::string& fileName)
:
    name_(fileName == "-" ? "standard input" : fileName)
{
    std::ostringstream content;
    if (fileName == "-")
    {
        content << std::cin.rdbuf();
    }
    else
    {
        std::ifstream file(fileName, std::ios::binary);
        if (!file)
        {
            refuse(name_ + ": cannot be opened: expected a file of comma-separated values");
        }
        // A directory can be opened; only reading it fails.
        if (file.peek() != std::ifstream::traits_type::eof())
        {
            content << file.rdbuf();
        }
        else if (!file.eof() || file.bad())
        {
            refuse(name_ + ": cannot be read: expected a file of comma-separated values");
        }
    }
    text_ = content.str();

    // Byte order mark of spreadsheets
    if (text_.compare(0, 3, "\xEF\xBB\xBF") == 0)
    {
        position_ = 3;
    }
}


bool Foam::titanCommand::csvReader::next(std::vector<std::string>& cells)
{
    while (position_ < text_.size())
    {
        const auto start = position_;
        rowLine_ = line_;
        cells.assign(1, std::string());
        bool quoted = false;
        bool anyQuote = false;
        for (; position_ < text_.size(); ++position_)
        {
            const char c = text_[position_];
            line_ += (c == '\n');
            if (quoted)
            {
                if (c != '"')
                {
                    cells.back() += c;
                }
                else if (position_ + 1 < text_.size() && text_[position_ + 1] == '"')
                {
                    cells.back() += c;
                    ++position_;
                }
                else
                {
                    quoted = false;
                }
            }
            else if (c == '"' && trimmed(cells.back()).empty())
            {
                cells.back().clear();
                quoted = anyQuote = true;
            }
            else if (c == ',')
            {
                cells.emplace_back();
            }
            else if (c == '\n')
            {
                ++position_;
                break;
            }
            else
            {
                cells.back() += c;
            }
        }
        if (quoted)
        {
            // Go on with the next line: the others may be sound.
            position_ = std::min(text_.find('\n', start), text_.size() - 1) + 1;
            line_ = rowLine_ + 1;
            refuse
            (
                where() + ": the quotation mark of cell " + std::to_string(cells.size()) + " is not closed"
            );
        }
        if (!cells.back().empty() && cells.back().back() == '\r')
        {
            cells.back().pop_back();
        }
        if (cells.size() > 1 || anyQuote || !trimmed(cells[0]).empty())
        {
            return true;
        }
    }
    return false;
}


std::string Foam::titanCommand::csvReader::where() const
{
    return name_ + ", line " + std::to_string(rowLine_);
}


std::string Foam::titanCommand::csvReader::where(const std::string& column) const
{
    return where() + ", column " + column;
}
