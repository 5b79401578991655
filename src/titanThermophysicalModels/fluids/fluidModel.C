// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluidModel.H"

// * * * * * * * * * * * * * * * Local Functions  * * * * * * * * * * * * * //

namespace
{

struct names
{
    const char* plain;
    const char* column;
};

// In the order of property
const names propertyNames[Foam::titan::nProperties] =
{
    {"density", "density_kg_m3"},
    {"soundSpeed", "speed_of_sound_m_s"},
    {"cp", "cp_J_kgK"},
    {"cv", "cv_J_kgK"},
    {"viscosity", "viscosity_Pa_s"},
    {"conductivity", "conductivity_W_mK"},
    {"surfaceTension", "surface_tension_N_m"},
    {"isothermalBulkModulus", "isothermal_bulk_modulus_Pa"},
    {"isentropicBulkModulus", "isentropic_bulk_modulus_Pa"},
    {"expansivity", "expansivity_1_K"}
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

const char* Foam::titan::propertyColumn(property q)
{
    return propertyNames[static_cast<int>(q)].column;
}


const char* Foam::titan::propertyName(property q)
{
    return propertyNames[static_cast<int>(q)].plain;
}
