// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeSurfaceFlow.H"
#include "profiling.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- What Newton's law may lack [-]
constexpr Foam::scalar tolerance = 0.01;

//- A step is solved this often at most
constexpr Foam::label most = 12;

//- Bodies of more than this density, over the liquid's, are left to one pass: that their acceleration is that of the forces of the
//  step before is an error of the time step, as others are
constexpr Foam::scalar light = 0.9;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::freeSurfaceFlow::breaksNewtonsLaw()
{
    if (body_->isPrescribed())
    {
        return false;
    }
    const scalar heaviest = max(mixture_.rho1(), mixture_.rho2()).value();
    // In the first step no load is known: its error would stay in the velocity
    const bool isFirst = history_ && history_->now().number == 1;
    if (!isFirst && body_->mass() > light*heaviest*mag(body_->enclosedVolume()))
    {
        return false;
    }
    addProfiling(repeat, "body");

    const scalar missing = body_->imbalance(time_.deltaTValue());
    if (missing > 0.8*tolerance && repeats_ && nRepeats_ + 1 < most)
    {
        ++nRepeats_;
        Info<< "Body: the force and the change of momentum differ by " << 100*missing << " %: the step is solved again" << endl;

        // The pressure stays: it is what the next solution starts from
        U_ == U_.oldTime();
        phi_ == phi_.oldTime();
        if (Uf_)
        {
            Uf_() == Uf_().oldTime();
        }
        mixture_.alpha1() == mixture_.alpha1().oldTime();
        mixture_.alpha2() = scalar(1) - mixture_.alpha1();
        rho_ == rho_.oldTime();
        mixture_.correct();
        if (interface_)
        {
            interface_->correct();
        }
        return true;
    }

    nRepeats_ = 0;
    if (missing > tolerance)
    {
        if (nUnbalanced_++ == 0)
        {
            WarningInFunction
                << "The force on the body and the change of its momentum differ by " << 100*missing << " % at "
                << time_.timeName() << " s: "
                << (
                       repeats_
                     ? "they did not agree when the step had been solved again and again. Use a smaller time step."
                     : "solver addedMass in constant/dynamicMeshDict solves such steps again."
                   )
                << " This is said once." << endl;
        }
        if (missing > worstBalance_)
        {
            worstBalance_ = missing;
            worstTime_ = time_.value();
        }
    }
    return false;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::freeSurfaceFlow::repeatStep()
{
    if (body_ && breaksNewtonsLaw())
    {
        return true;
    }
    if (history_)
    {
        body_->endStep(history_(), time_.deltaTValue());
    }
    if (backward_)
    {
        backward_->endStep(phi_, Uf_);
    }
    return false;
}


void Foam::freeSurfaceFlow::reportBalance(Ostream& os) const
{
    if (nUnbalanced_)
    {
        os  << "Note: In " << nUnbalanced_ << " of " << time_.timeIndex() - time_.startTimeIndex()
            << " steps the force on the body and the change of its momentum differ by more than " << 100*tolerance << " %, by "
            << 100*worstBalance_ << " % at most, at " << worstTime_ << " s." << nl << endl;
    }
}

// ************************************************************************* //
