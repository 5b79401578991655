// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallStreamlines.H"
#include "boundBox.H"
#include "edgeHashes.H"
#include "SortableList.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallStreamlines::wallStreamlines(const faceList& faces)
:
    neighbours_(faces.size())
{
    // More than two faces meet in an edge of a fin without thickness
    EdgeMap<labelList> atEdge(4*faces.size());
    forAll(faces, facei)
    {
        for (const edge& e : faces[facei].edges())
        {
            atEdge(e).append(facei);
        }
    }
    forAllConstIters(atEdge, iter)
    {
        for (const label a : iter.val())
        {
            for (const label b : iter.val())
            {
                if (a != b)
                {
                    neighbours_[a].append(b);
                }
            }
        }
    }
    for (labelList& n : neighbours_)
    {
        Foam::sort(n);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::wallStreamlines::lengths
(
    const vectorField& centres,
    const vectorField& velocities
) const
{
    auto tlengths = tmp<scalarField>::New(centres.size(), Zero);
    scalarField& s = tlengths.ref();

    // Along the mean flow one pass suffices, unless it turns back
    vector mean(Zero);
    for (const vector& u : velocities)
    {
        mean += u/(mag(u) + VSMALL);
    }
    const SortableList<scalar> along(scalarField(centres & mean));

    // Half of a circle's circumference about all
    const scalar longest =
        constant::mathematical::piByTwo*boundBox(centres, false).mag();

    // Forwards and backwards in turn, for walls with opposite flows
    labelList order(along.indices());
    const label maxPasses = 100;
    scalar lastChange = GREAT;
    for (label pass = 0; pass < maxPasses; ++pass)
    {
        scalar change = 0;
        for (const label facei : order)
        {
            scalar flowIn = 0, flowOut = 0, arrived = 0, ahead = 0;
            for (const label nei : neighbours_[facei])
            {
                const vector way(centres[facei] - centres[nei]);
                const vector u(0.5*(velocities[facei] + velocities[nei]));
                const scalar flow = (u & way)/(mag(way) + VSMALL);
                const scalar length = (u & way)/(mag(u) + VSMALL);
                if (flow > 0)
                {
                    flowIn += flow;
                    arrived += flow*(s[nei] + length);
                }
                else
                {
                    flowOut -= flow;
                    ahead += flow*length;
                }
            }

            scalar length = 0;
            if (flowIn > VSMALL)
            {
                length = min(arrived/flowIn, longest);
            }
            else if (flowOut > VSMALL)
            {
                length = 0.5*ahead/flowOut;
            }
            change = max(change, mag(length - s[facei]));
            s[facei] = length;
        }
        if (max(change, lastChange) <= 1e-12*longest)
        {
            break;
        }
        lastChange = change;
        inplaceReverseList(order);
    }
    return tlengths;
}

// ************************************************************************* //
