// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidField.H"

#include "inputChecks.H"
#include "Pair.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::titan::fluidField::evaluationType>
Foam::titan::fluidField::evaluationTypeNames
({
    { evaluationType::constant, "constant" },
    { evaluationType::tabulated, "tabulated" },
    { evaluationType::direct, "direct" },
});


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Relative, of the tabulated properties
constexpr Foam::scalar tableError = 1e-6;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::titan::fluidField::makeModel(const std::vector<property>& asked)
{
    if (evaluation_ == evaluationType::constant)
    {
        return;
    }
    if (fluid_.isConstant())
    {
        refuseEntry
        (
            dict_,
            "evaluation",
            text("is ", evaluationTypeNames[evaluation_], ", but ", fluid_.name(), " is a set of constants"),
            "constant."
        );
    }

    if (evaluation_ == evaluationType::direct)
    {
        model_ = directFluid(fluid_.x(), fluid_.ph());
        return;
    }

    const Pair<scalar> T
    (
        dict_.lookupOrDefault
        (
            "TRange",
            Pair<scalar>
            (
                max(fluid_.T() - 5, range::Tmin),
                min(fluid_.T() + 5, range::Tmax)
            )
        )
    );
    if (!(T.first() <= fluid_.T() && fluid_.T() <= T.second()))
    {
        refuseEntry
        (
            dict_,
            "TRange",
            text("is ", T),
            text("two temperatures about that of the fluid, ", fluid_.T(), " K.")
        );
    }

    // Only the temperature varies, but a table is of two dimensions
    const tableLimits limits
    {
        T.first(), T.second(), 0.99*fluid_.p(), 1.01*fluid_.p(), tableError
    };
    model_ = orRefuse
    (
        dict_,
        "TRange",
        [&]
        {
            return
                tabulatedFluid(fluid_.x(), fluid_.ph(), limits, asked);
        }
    );
}


void Foam::titan::fluidField::makeProfile()
{
    if (!dict_.found("stratification"))
    {
        return;
    }
    if (evaluation_ != evaluationType::constant)
    {
        refuseEntry
        (
            dict_,
            "evaluation",
            text("is ", evaluationTypeNames[evaluation_], ", but the fluid is stratified"),
            "constant, or a fluid that is not stratified."
        );
    }
    profile_.reset(new lakeProfile(dict_.subDict("stratification"), mesh_));
}


const Foam::volScalarField* Foam::titan::fluidField::temperature() const
{
    const volScalarField* T = mesh_.findObject<volScalarField>(TName_);

    // A function object that solves for it makes it after the flow is read
    if (!T && mesh_.time().timeIndex() > mesh_.time().startTimeIndex())
    {
        refuseEntry
        (
            dict_,
            "evaluation",
            text("is ", evaluationTypeNames[evaluation_], ", but there is no temperature field ", TName_),
            "a case with this field, its name in entry TField, or evaluation constant."
        );
    }
    return T;
}


void Foam::titan::fluidField::evaluate
(
    const property q,
    const scalarField& T,
    const vectorField& points,
    scalarField& result
) const
{
    if (profile_.valid())
    {
        profile_->evaluate(q, points, result);
        return;
    }

    const scalarField p(T.size(), fluid_.p());
    orRefuse
    (
        dict_,
        "evaluation",
        [&]
        {
            model_->evaluate
            (
                q,
                T.size(),
                T.cdata(),
                p.cdata(),
                result.data()
            );
        }
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::titan::fluidField::fluidField
(
    const dictionary& dict,
    const fvMesh& mesh,
    const std::vector<property>& asked
)
:
    dict_(dict),
    mesh_(mesh),
    fluid_(dict),
    evaluation_
    (
        readChoice(evaluationTypeNames, dict, "evaluation", evaluationType::constant)
    ),
    TName_(dict.lookupOrDefault<word>("TField", "T"))
{
    makeModel(asked);
    makeProfile();
}


Foam::wordHashSet Foam::titan::fluidField::keywords()
{
    return
        fluidSelection::keywords
      | wordHashSet({"evaluation", "TField", "TRange"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::titan::fluidField::steady() const
{
    return !model_ && !(profile_.valid() && mesh_.moving());
}


void Foam::titan::fluidField::evaluate
(
    const property q,
    const scalar divisor,
    volScalarField& result
) const
{
    const volScalarField* T = model_ ? temperature() : nullptr;
    if (!T && !profile_.valid())
    {
        result == dimensionedScalar
        (
            propertyName(q),
            result.dimensions(),
            fluid_.value(q, dict_)/divisor
        );
        return;
    }

    scalarField& cells = result.primitiveFieldRef();
    evaluate
    (
        q,
        T ? T->primitiveField() : scalarField::null(),
        mesh_.C().primitiveField(),
        cells
    );
    cells /= divisor;

    forAll(result.boundaryField(), patchi)
    {
        scalarField values(result.boundaryField()[patchi].size());
        evaluate
        (
            q,
            T ? T->boundaryField()[patchi] : scalarField::null(),
            mesh_.C().boundaryField()[patchi],
            values
        );
        result.boundaryFieldRef()[patchi] == values/divisor;
    }
}


void Foam::titan::fluidField::print
(
    Ostream& os,
    const std::vector<property>& printed
) const
{
    fluid_.print(os, printed);
    if (profile_.valid())
    {
        profile_->print(os);
    }
    if (model_)
    {
        os  << "    Follows the temperature field " << TName_ << ", "
            << model_->type() << nl << flush;
    }
}


void Foam::titan::fluidField::printInFull
(
    Ostream& os,
    const std::vector<std::pair<const char*, scalar>>& namesAndValues
)
{
    const int precision = os.precision(17);
    os  << "    In full:";
    for (const auto& nameAndValue : namesAndValues)
    {
        os  << ' ' << nameAndValue.first << ' ' << nameAndValue.second << ';';
    }
    os  << endl;
    os.precision(precision);
}

// ************************************************************************* //
