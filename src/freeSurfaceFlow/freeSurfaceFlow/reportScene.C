// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeSurfaceFlow.H"
#include "inputChecks.H"
#include "surfaceTensionModel.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::freeSurfaceFlow::referenceScales
(
    scalar& length,
    scalar& speed,
    string& origin
) const
{
    // The body, else the domain; the speed of a body at rest is that of a wave
    const boundBox box(body_ ? body_->bounds() : mesh_.bounds());
    const scalar g = buoyancy_ ? mag(buoyancy_->g).value() : 0;

    length = cmptMax(box.span());
    speed = body_ ? mag(body_->velocity()) : gMax(mag(U_.primitiveField()));
    origin = body_ ? "of the body" : "of the domain and the initial flow";
    if
    (
        !body_
     && scene_.boundaryLayer() != scene::boundaryLayerType::unstated
    )
    {
        length = scalesOfWalls().length;
        origin = "of the walls and the initial flow";
    }
    if (speed < Foam::sqrt(g*length))
    {
        speed = Foam::sqrt(g*length);
        origin += ", speed sqrt(g L)";
    }

    if (scene_.dict().found("reference"))
    {
        const dictionary& reference = scene_.dict().subDict("reference");
        length = readPositive(reference, "length", "a positive length [m].");
        speed = readPositive(reference, "speed", "a positive speed [m/s].");
        origin = "from constant/sceneProperties";
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::freeSurfaceFlow::reportScene(Ostream& os) const
{
    const int precision = os.precision(4);

    os  << nl << "Scene" << nl << "    models      : ";
    scene_.print(os);
    os  << nl;

    scalar L, U;
    string origin;
    referenceScales(L, U, origin);
    os  << "    reference   : length " << L << " m, speed " << U << " m/s ("
        << origin.c_str() << ')' << nl;

    if (!(U > SMALL))
    {
        os  << "    no reference speed: no dimensionless numbers" << nl << endl;
        os.precision(precision);
        return;
    }

    const scalar rho1 = mixture_.rho1().value();
    const scalar rho2 = mixture_.rho2().value();
    const scalar g = buoyancy_ ? mag(buoyancy_->g).value() : 0;
    const scalar nu1 = gMax(mixture_.nuModel1().nu()().primitiveField());
    const scalar nu2 = gMax(mixture_.nuModel2().nu()().primitiveField());
    const dictionary& transport = mixture_;
    const word phase1(transport.get<wordList>("phases")[0]);
    const word phase2(transport.get<wordList>("phases")[1]);

    // With the entries that a model adds to those of the case
    const dictionary& properties1 = mixture_.nuModel1().viscosityProperties();
    const dictionary& properties2 = mixture_.nuModel2().viscosityProperties();

    DynamicList<string> remarks;

    // A fluid may be ideal
    const scalar Re = nu1 > 0 ? U*L/nu1 : 0;
    os  << "    Re          : " << (nu1 > 0 ? name(Re) : "infinite") << " in " << phase1 << ", "
        << (nu2 > 0 ? name(U*L/nu2) : "infinite") << " in " << phase2 << nl;
    reportBoundaryLayer(os, remarks, Re, U);

    if (rho2 > rho1)
    {
        remarks.append(phase1 + ", the first of the phases, is lighter than " + phase2);
    }
    if (g > 0)
    {
        // Of the heavier and the lighter fluid, the height of the middle
        const scalarField& V = mesh_.V().field();
        const scalarField height(-(buoyancy_->gh.primitiveField())/g);
        const scalarField heavy((rho1 > rho2 ? mixture_.alpha1() : mixture_.alpha2()).primitiveField()*V);
        const scalarField light(V - heavy);
        const scalar heavyVolume = gSum(heavy), lightVolume = gSum(light);
        if
        (
            rho1 != rho2 && heavyVolume > SMALL*lightVolume && lightVolume > SMALL*heavyVolume
         && gSum(heavy*height)/heavyVolume > gSum(light*height)/lightVolume
        )
        {
            remarks.append
            (
                "The heavier fluid, " + (rho1 > rho2 ? phase1 : phase2) + ", lies above the lighter one at the start: it will fall"
            );
        }
        os  << "    Fr          : " << U/Foam::sqrt(g*L) << nl;
    }
    else if (mag(rho1 - rho2) > SMALL)
    {
        remarks.append("Gravity is off: nothing holds the free surface level");
    }

    scalar sigma = 0;
    const auto* surfaceTension =
        mesh_.findObject<surfaceTensionModel>(surfaceTensionModel::typeName);
    if (surfaceTension)
    {
        sigma = gMax(surfaceTension->sigma()().primitiveField());
    }
    else if (transport.found("sigma") && !transport.isDict("sigma"))
    {
        sigma = dimensionedScalar("sigma", dimMass/sqr(dimTime), transport).value();
    }
    if (sigma > 0)
    {
        const scalar We = rho1*sqr(U)*L/sigma;
        os  << "    We          : " << We << nl;
        if (We < 1e3 && !scene_.surfaceTension())
        {
            remarks.append
            (
                "We = " + name(We) + " but surface tension is off"
            );
        }
        else if (We > 1e6 && scene_.surfaceTension())
        {
            remarks.append
            (
                "We = " + name(We) + ": surface tension shapes droplets only,"
                " not the body's motion; it could be off"
            );
        }
    }

    for (const bool first : {true, false})
    {
        const word& phase = first ? phase1 : phase2;
        const dictionary& properties = first ? properties1 : properties2;
        scalar c = 0;
        if (properties.readIfPresent("soundSpeed", c) && c > 0)
        {
            const scalar Ma = U/c;
            os  << "    Ma          : " << Ma << " in " << phase << nl;
            if (Ma > 0.3)
            {
                remarks.append
                (
                    "Ma = " + name(Ma) + " in " + phase
                  + " but compressibility is off"
                );
            }
        }
        else
        {
            os  << "    Ma          : unknown in " << phase
                << " (no entry soundSpeed for it in"
                << " constant/transportProperties)" << nl;
        }
    }

    os  << "    density     : " << phase2 << '/' << phase1 << ' ' << rho2/rho1
        << nl;
    if (body_)
    {
        const scalar volume = body_->enclosedVolume();
        const scalar displaced = rho1*volume;
        if (displaced > 0)
        {
            os  << "    mass        : body/displaced " << phase1 << ' '
                << body_->mass()/displaced << nl;
        }

        const scalar expected =
            scene_.dict().subOrEmptyDict("reference").lookupOrDefault<scalar>("volume", volume);
        if (mag(volume - expected) > 0.02*expected)
        {
            remarks.append
            (
                "The body in the mesh has " + name(100*volume/expected) + " % of its volume: its faces are coarse, or parts of it thinner than the cells"
                " there. Its mass is that of the whole body"
            );
        }
    }

    scalar pAmbient = 0;
    if (scene_.dict().readIfPresent("ambientPressure", pAmbient))
    {
        const scalar pVapour =
            properties1.lookupOrDefault<scalar>("vapourPressure", 0);
        const scalar Ca = (pAmbient - pVapour)/(0.5*rho1*sqr(U));
        os  << "    cavitation  : " << Ca << " (ambient " << pAmbient
            << " Pa, vapour " << pVapour << " Pa)" << nl;
        if (Ca < 1)
        {
            remarks.append
            (
                "Cavitation number " + name(Ca) + ": the liquid would boil, or"
                " give off dissolved gas, where the flow is faster than "
              + name(U*Foam::sqrt(max(1 + Ca, scalar(0)))) + " m/s against the"
                " body; plungeFoam lets its pressure fall below the vapour's"
                " instead"
            );
        }
    }

    for (const string& remark : remarks)
    {
        os  << "    Note: " << remark.c_str() << '.' << nl;
    }
    os  << endl;
    os.precision(precision);
}

// ************************************************************************* //
