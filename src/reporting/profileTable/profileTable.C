// SPDX-License-Identifier: GPL-3.0-or-later

#include "profileTable.H"
#include "dictionary.H"
#include "IOmanip.H"
#include "profiling.H"
#include "SortableList.H"
#include "StringStream.H"

void Foam::printProfile(Ostream& os, const label nSteps, const label nCells)
{
    OStringStream text;
    if (!profiling::print(text))
    {
        return;
    }

    // A description can stand under several parents
    HashTable<label, string> calls;
    HashTable<scalar, string> time;
    scalar total = 0;
    const dictionary triggers(IStringStream(text.str())());
    for (const entry& e : triggers.subDict("profiling"))
    {
        const dictionary& trigger = e.dict();
        const string name(trigger.get<string>("description"));
        const scalar own =
            trigger.get<scalar>("totalTime") - trigger.get<scalar>("childTime");
        calls(name, 0) += trigger.get<label>("calls");
        time(name, 0) += own;
        total += own;
    }

    const List<string> names(time.sortedToc());
    SortableList<scalar> order(names.size());
    forAll(names, i)
    {
        order[i] = -time[names[i]];
    }
    order.sort();

    os  << nl << "Profile over " << nSteps << " time steps, " << nCells
        << " cells; of each part the time outside the parts it calls" << nl
        << "     calls    time [s]     %   per step [ms]   per step, cell [us]"
        << nl;
    os.precision(4);
    const scalar perStep = 1.0/max(label(1), nSteps);
    const auto line = [&](const label n, const scalar t, const char* name)
    {
        os  << setw(10) << n
            << setw(12) << t
            << setw(6) << label(100*t/total + 0.5)
            << setw(16) << 1e3*t*perStep
            << setw(22) << 1e6*t*perStep/max(label(1), nCells)
            << "   " << name << nl;
    };
    label nOther = 0;
    scalar other = 0;
    for (const label i : order.indices())
    {
        const scalar t = time[names[i]];
        if (t > 0.002*total)
        {
            line(calls[names[i]], t, names[i].c_str());
        }
        else
        {
            nOther += calls[names[i]];
            other += t;
        }
    }
    line(nOther, other, "all others");
    line(nSteps, total, "total");
    os  << endl;
}

// ************************************************************************* //
