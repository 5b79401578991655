// SPDX-License-Identifier: GPL-3.0-or-later

#include "particleCheckpoint.H"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam::smoothedParticles;

[[noreturn]] void refuse(const std::string& file, const std::string& message)
{
    throw std::runtime_error(file + ": " + message);
}


[[noreturn]] void refuseSystem(const std::string& file)
{
    refuse(file, std::strerror(errno));
}


//- Calls what(array) for each array of a state, in the order of the file
template<class State, class What>
void forArrays(State& state, const What& what)
{
    what(state.x);
    what(state.v);
    what(state.acceleration);
    what(state.density);
    what(state.mass);
    what(state.pressure);
    what(state.wall);
    what(state.energy);
    what(state.heat);
    what(state.bodies);
    what(state.felt);
}


template<int dim>
std::string header(const particleState<dim>& state, double spacing, double rho0)
{
    std::ostringstream os;
    os  << std::setprecision(17)
        << "plungeSPH particles: x v a [float64 dimensions], density - rho0, mass, pressure [float64], wall [int32, -1 fluid],"
        << " energy, heat, bodies, felt [float64]\n"
        << "dimensions " << dim << "\nparticles " << state.size() << "\nenergies " << !state.energy.empty()
        << "\nbodies " << state.bodies.size() << "\nfelt " << state.felt.size()
        << "\nspacing " << spacing << "\nrho0 " << rho0 << "\ntime " << state.time << "\n\n";
    return os.str();
}


//- The value of an entry of the header
template<class Type>
Type value(const std::string& file, const std::string& header, const std::string& entry)
{
    const std::size_t at = header.find("\n" + entry + " ");
    Type result;
    if (at == std::string::npos || !(std::istringstream(header.substr(at + entry.size() + 2)) >> result))
    {
        refuse(file, "no " + entry + " in its header: expected a file that plungeSPH has written");
    }
    return result;
}


template<class Type>
void checkAgrees(const std::string& file, const char* entry, Type found, Type expected)
{
    if (found != expected)
    {
        std::ostringstream os;
        os  << entry << " " << found << ", but the case has " << expected << ": expected the two to agree";
        refuse(file, os.str());
    }
}


//- Until it is on the disk
void flush(const std::string& file)
{
    const int descriptor = ::open(file.c_str(), O_RDONLY);
    if (descriptor < 0 || ::fsync(descriptor) != 0 || ::close(descriptor) != 0)
    {
        refuseSystem(file);
    }
}


void rename(const std::string& from, const std::string& to)
{
    if (std::rename(from.c_str(), to.c_str()) != 0)
    {
        refuseSystem(to);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

template<int dim>
void Foam::smoothedParticles::writeCheckpoint
(
    const std::string& directory,
    const particleState<dim>& state,
    const double spacing,
    const double rho0
)
{
    const std::string whole(directory + "/particles");
    // Not a number, so that nobody takes it for a time
    const std::string part(directory + ".part");
    const std::string file(part + "/particles");

    if (::mkdir(part.c_str(), 0777) != 0 && errno != EEXIST)
    {
        refuseSystem(part);
    }
    std::ofstream os(file, std::ios::binary);
    const std::string text(header<dim>(state, spacing, rho0));
    os.write(text.data(), text.size());
    forArrays
    (
        state,
        [&](const auto& array)
        {
            os.write(reinterpret_cast<const char*>(array.data()), array.size()*sizeof(array[0]));
        }
    );
    os.close();
    if (!os)
    {
        refuseSystem(file);
    }
    flush(file);

    struct stat unused;
    if (::stat(directory.c_str(), &unused) == 0)
    {
        rename(file, whole);
        ::rmdir(part.c_str());
    }
    else
    {
        rename(part, directory);
    }
}


template<int dim>
Foam::smoothedParticles::particleState<dim> Foam::smoothedParticles::readCheckpoint
(
    const std::string& file,
    const double spacing,
    const double rho0
)
{
    std::ifstream is(file, std::ios::binary);
    if (!is)
    {
        refuseSystem(file);
    }
    std::string text;
    for (std::string line; std::getline(is, line) && !line.empty(); )
    {
        text += line + "\n";
    }
    checkAgrees(file, "dimensions", value<int>(file, text, "dimensions"), dim);
    checkAgrees(file, "spacing", value<double>(file, text, "spacing"), spacing);
    checkAgrees(file, "rho0", value<double>(file, text, "rho0"), rho0);

    particleState<dim> state;
    state.time = value<double>(file, text, "time");
    const std::size_t n = value<std::size_t>(file, text, "particles");
    const std::size_t nBodies = value<std::size_t>(file, text, "bodies");
    const std::size_t nEnergies = n*value<bool>(file, text, "energies");
    const std::size_t nMoving = value<std::size_t>(file, text, "felt");
    const std::streamoff start = is.tellg();
    is.seekg(0, std::ios::end);
    const std::streamoff bytes =
        n*((3*dim + 3)*sizeof(double) + sizeof(std::int32_t)) + (2*nEnergies + nBodies + 6*nMoving)*sizeof(double);
    if (is.tellg() - start != bytes)
    {
        std::ostringstream os;
        os  << is.tellg() - start << " bytes after its header: expected " << bytes << ", for " << n << " particles";
        refuse(file, os.str());
    }
    is.seekg(start);
    forArrays
    (
        state,
        [&](auto& array)
        {
            const void* const one = &array;
            array.resize
            (
                one == &state.bodies ? nBodies
              : one == &state.felt ? nMoving
              : one == &state.energy || one == &state.heat ? nEnergies
              : n
            );
            is.read(reinterpret_cast<char*>(array.data()), array.size()*sizeof(array[0]));
        }
    );
    if (!is)
    {
        refuseSystem(file);
    }
    return state;
}


template void Foam::smoothedParticles::writeCheckpoint<2>(const std::string&, const particleState<2>&, double, double);
template void Foam::smoothedParticles::writeCheckpoint<3>(const std::string&, const particleState<3>&, double, double);
template Foam::smoothedParticles::particleState<2> Foam::smoothedParticles::readCheckpoint<2>(const std::string&, double, double);
template Foam::smoothedParticles::particleState<3> Foam::smoothedParticles::readCheckpoint<3>(const std::string&, double, double);

// ************************************************************************* //
