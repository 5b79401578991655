// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeSurfaceFlow.H"
#include "profiling.H"

void Foam::freeSurfaceFlow::advectInterface()
{
    addProfiling(interface, "interface");

    scheme_->advect();

    if (fringeVolume_)
    {
        fringeVolume_->conserve(mixture_.alpha1(), scheme_->alphaPhi());
        mixture_.alpha2() = scalar(1) - mixture_.alpha1();
    }
    else if (!composite_.isOverset())
    {
        // A restart finds them anew where what leaves has its cell's fraction
        mixture_.alpha1().correctBoundaryConditions();
    }

    if (alphaPhiUn_)
    {
        alphaPhiUn_() = scheme_->alphaPhi();
    }

    rho_ ==
        mixture_.alpha1()*mixture_.rho1() + mixture_.alpha2()*mixture_.rho2();

    composite_.mask(rhoPhi_);
    if (backward_)
    {
        backward_->update(rho_);
    }

    mixture_.correct();
    if (interface_)
    {
        interface_->correct();
    }

    const scalarField& alpha = mixture_.alpha1().primitiveField();
    const scalar least = gMin(alpha), most = gMax(alpha);
    Info<< "Phase-1 volume fraction = "
        << gSum(alpha*mesh_.V().field())/gSum(mesh_.V().field())
        << "  Min(" << mixture_.alpha1().name() << ") = " << least
        << "  Max(" << mixture_.alpha1().name() << ") = " << most
        << endl;
    guard_->checkFractions(max(most - 1, -least));
}

// ************************************************************************* //
