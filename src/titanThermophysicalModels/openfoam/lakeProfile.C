// SPDX-License-Identifier: GPL-3.0-or-later

#include "lakeProfile.H"
#include "fluidSelection.H"

#include "fvMesh.H"
#include "gravityMeshObject.H"
#include "inputChecks.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Linear between them: an error below 1e-5 where the viscosity changes by a factor of three between two layers
constexpr int pointsPerLayer = 200;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::titan::lakeProfile::makeTable(const scalar p0)
{
    orRefuse
    (
        dict_,
        "layers",
        [&]
        {
            const stratifiedLake lake(layers_, p0, mag(g_));
            for (std::size_t i = 0; i + 1 < layers_.size(); ++i)
            {
                const scalar upper = layers_[i].depth;
                const scalar lower = layers_[i + 1].depth;
                for (int k = (i == 0 ? 0 : 1); k <= pointsPerLayer; ++k)
                {
                    const scalar s = scalar(k)/pointsPerLayer;
                    depth_.append((1 - s)*upper + s*lower);
                    rho_.append(lake.density(depth_.last()));
                    mu_.append(lake.viscosity(depth_.last()));
                }
            }
        }
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::titan::lakeProfile::lakeProfile
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    dict_(dict),
    g_(meshObjects::gravity::New(mesh.time()).value()),
    surfaceLevel_(dict.get<scalar>("surfaceLevel")),
    layers_(readLayers(dict))
{
    if (mag(g_) < VSMALL)
    {
        refuse
        (
            dict,
            "g is zero in this case: a depth has no direction",
            "gravity, in constant/g, where there is a stratification."
        );
    }
    makeTable(dict.get<scalar>("p"));
}


std::vector<Foam::titan::lakeLayer> Foam::titan::lakeProfile::readLayers
(
    const dictionary& dict
)
{
    checkKeywords(dict, {"surfaceLevel", "p", "layers"});
    const scalar p = dict.get<scalar>("p");

    std::vector<lakeLayer> layers;
    for (const entry& e : dict.subDict("layers"))
    {
        const dictionary& layer = e.dict();
        checkKeywords(layer, {"depth", "T", "composition"});
        const scalar T = layer.get<scalar>("T");
        layers.push_back
        ({
            layer.get<scalar>("depth"),
            T,
            readComposition(layer, T, p)
        });
    }
    if (layers.empty())
    {
        refuse(dict.subDict("layers"), "No layers", "at least two dictionaries with depth, T and composition.");
    }
    return layers;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::titan::lakeProfile::evaluate
(
    const property q,
    const vectorField& points,
    scalarField& result
) const
{
    const DynamicList<scalar>& values = q == property::density ? rho_ : mu_;
    const vector down(g_/mag(g_));

    forAll(points, i)
    {
        // Against round-off where the mesh ends with the last layer
        const scalar depth = max(surfaceLevel_ + (points[i] & down), 0);
        if (depth > depth_.last()*(1 + 1e-9))
        {
            refuse
            (
                dict_,
                text
                (
                    "Entry layers: the mesh reaches ", depth, " m below the surface, at ", points[i],
                    ", and the last layer ", depth_.last(), " m"
                ),
                "layers as deep as the mesh."
            );
        }
        const label lower = min
        (
            max
            (
                label
                (
                    std::upper_bound(depth_.begin(), depth_.end(), depth)
                  - depth_.begin()
                ),
                label(1)
            ),
            depth_.size() - 1
        );
        const scalar s =
            (depth - depth_[lower - 1])/(depth_[lower] - depth_[lower - 1]);
        result[i] = (1 - s)*values[lower - 1] + s*values[lower];
    }
}


void Foam::titan::lakeProfile::print(Ostream& os) const
{
    const int precision = os.precision(6);
    os  << "    Stratified below the surface at " << surfaceLevel_ << " m:"
        << nl;
    for (std::size_t i = 0; i < layers_.size(); ++i)
    {
        const label k = i*pointsPerLayer;
        os  << "    " << layers_[i].depth << " m: " << layers_[i].T << " K, "
            << layers_[i].x.name().c_str() << ", density " << rho_[k]
            << " kg/m3, viscosity " << mu_[k] << " Pa s" << nl;
    }
    os  << flush;
    os.precision(precision);
}

// ************************************************************************* //
