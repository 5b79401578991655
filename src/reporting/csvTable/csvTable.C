// SPDX-License-Identifier: GPL-3.0-or-later

#include "csvTable.H"
#include "OSspecific.H"
#include "Pstream.H"

Foam::csvTable::csvTable
(
    const Time& time,
    const word& functionObject,
    const word& table,
    const char* header
)
:
    file_(),
    begun_(false)
{
    if (Pstream::master())
    {
        const fileName dir
        (
            time.globalPath()/"postProcessing"/functionObject
           /time.timeName(time.startTime().value())
        );
        mkDir(dir);
        file_.reset(new OFstream(dir/(table + ".csv")));
        file_->precision(12);
        *file_ << header << endl;
    }
}


Foam::csvTable& Foam::csvTable::operator<<(const scalar value)
{
    if (file_)
    {
        if (begun_)
        {
            *file_ << ',';
        }
        *file_ << value;
        begun_ = true;
    }
    return *this;
}


Foam::csvTable& Foam::csvTable::operator<<(const vector& value)
{
    return *this << value.x() << value.y() << value.z();
}


void Foam::csvTable::endLine()
{
    if (file_)
    {
        *file_ << endl;
    }
    begun_ = false;
}

// ************************************************************************* //
