// SPDX-License-Identifier: GPL-3.0-or-later
// The equations of state Murnaghan and Tait in the thermophysical models that OpenFOAM's solvers select.

#include "barotropicLiquid.H"

#include "makeThermo.H"
#include "rhoThermo.H"

#include "specie.H"
#include "thermo.H"
#include "hConstThermo.H"
#include "eConstThermo.H"
#include "sensibleEnthalpy.H"
#include "sensibleInternalEnergy.H"
#include "constTransport.H"

#include "heRhoThermo.H"
#include "pureMixture.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{

template<class Specie>
using Murnaghan = barotropicLiquid<titan::MurnaghanLaw, Specie>;

template<class Specie>
using Tait = barotropicLiquid<titan::TaitLaw, Specie>;

#define makeBarotropicThermos(Energy, Thermo, EquationOfState)                 \
    makeThermos                                                                \
    (                                                                          \
        rhoThermo,                                                             \
        heRhoThermo,                                                           \
        pureMixture,                                                           \
        constTransport,                                                        \
        Energy,                                                                \
        Thermo,                                                                \
        EquationOfState,                                                       \
        specie                                                                 \
    )

makeBarotropicThermos(sensibleEnthalpy, hConstThermo, Murnaghan);
makeBarotropicThermos(sensibleInternalEnergy, hConstThermo, Murnaghan);
makeBarotropicThermos(sensibleEnthalpy, eConstThermo, Murnaghan);
makeBarotropicThermos(sensibleInternalEnergy, eConstThermo, Murnaghan);

makeBarotropicThermos(sensibleEnthalpy, hConstThermo, Tait);
makeBarotropicThermos(sensibleInternalEnergy, hConstThermo, Tait);
makeBarotropicThermos(sensibleEnthalpy, eConstThermo, Tait);
makeBarotropicThermos(sensibleInternalEnergy, eConstThermo, Tait);

} // End namespace Foam

// ************************************************************************* //
