// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeSurfaceFlow.H"

void Foam::freeSurfaceFlow::reportScene(Ostream& os) const
{
    os  << "Scene: ";
    scene_.print(os);
    os  << nl << endl;
}

// ************************************************************************* //
