// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeSurfaceFlow.H"

void Foam::freeSurfaceFlow::renewAfterWrite()
{
    if (!time_.writeTime())
    {
        return;
    }
    if (addedMass_)
    {
        addedMass_->forgetPressures();
    }
    if (interface_ && mesh_.dynamic())
    {
        // First free the names of its fields
        interface_.clear();
        interface_.reset
        (
            new interfaceProperties(mixture_.alpha1(), U_, mixture_)
        );
    }
}

// ************************************************************************* //
