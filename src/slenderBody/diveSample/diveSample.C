// SPDX-License-Identifier: GPL-3.0-or-later

#include "diveSample.H"

#include "inputChecks.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "StringStream.H"
#include "unitConversion.H"

#include <algorithm>
#include <fstream>
#include <limits>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::slenderBody;

constexpr scalar nan = std::numeric_limits<scalar>::quiet_NaN();

//- Of the body's height at the start: the wetted part until which a peak is the impact's
constexpr scalar impactShare = 0.25;

std::vector<std::string> fields(const std::string& line)
{
    std::vector<std::string> result(1);
    int open = 0;
    for (const char c : line)
    {
        open += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (c == ',' && open == 0)
        {
            result.emplace_back();
        }
        else if (c != '\r')
        {
            result.back() += c;
        }
    }
    return result;
}


//- Set an entry by its path, as body/mass
void setEntry(dictionary& dict, const std::string& path, const std::string& value)
{
    const auto slash = path.find('/');
    if (slash != std::string::npos)
    {
        const word outer(path.substr(0, slash));
        if (!dict.isDict(outer))
        {
            dict.add(outer, dictionary());
        }
        setEntry(dict.subDict(outer), path.substr(slash + 1), value);
        return;
    }
    dict.merge(dictionary(IStringStream(path + ' ' + value + ';')()));
}


//- What a dive comes to
struct outcome
{
    scalar immersed = nan, lost = nan, turned = nan, impact = 0, peak = 0, deepest = 0, whenDeepest = 0, depthAfter = nan,
        speedAfter = nan, half = nan, tenth = nan, mostTurned = 0;

    void follow(slenderDive& dive)
    {
        const auto speedNow = [&]{ return mag(dive.now().velocity.linear); };
        const auto axisNow = [&]{ const tensor& Q = dive.now().orientation; return vector(Q.xx(), Q.yx(), Q.zx()); };
        const auto pitchNow = [&]{ return radToDeg(std::asin(max(min(dive.now().up.x(), scalar(1)), scalar(-1)))); };
        const scalar speed0 = speedNow(), pitch0 = pitchNow();
        const vector axis0(axisNow());
        const scalar height = dive.now().wet.highest - dive.now().wet.lowest;
        const bool dry = dive.now().wet.isDry();
        scalar time = 0, depth = -dive.now().wet.lowest, speed = speed0, highest = dive.now().wet.highest, pitch = pitch0;
        while (dive.runs())
        {
            dive.advance();
            const slenderModel::instant& now = dive.now();
            const scalar newDepth = -now.wet.lowest, newSpeed = speedNow(), newPitch = pitchNow();
            const auto between = [&](const scalar share, const scalar a, const scalar b){ return a + share*(b - a); };
            const scalar slow = -(now.acceleration.linear + (now.velocity.angular ^ now.velocity.linear)).x();
            if (!now.wet.isDry())
            {
                peak = max(peak, slow);
                impact = dry && newDepth <= impactShare*height ? max(impact, slow) : impact;
            }
            if (std::isnan(immersed) && highest > 0 && now.wet.highest <= 0)
            {
                const scalar share = highest/(highest - now.wet.highest);
                immersed = between(share, time, dive.time());
                lost = speed0 - between(share, speed, newSpeed);
                turned = between(share, pitch, newPitch) - pitch0;
            }
            if (newDepth > deepest)
            {
                deepest = newDepth;
                whenDeepest = dive.time();
            }
            if (std::isnan(depthAfter) && dive.time() >= 1)
            {
                const scalar share = (1 - time)/(dive.time() - time);
                depthAfter = between(share, depth, newDepth);
                speedAfter = between(share, speed, newSpeed);
            }
            for (auto level : {std::make_pair(0.5, &half), std::make_pair(0.1, &tenth)})
            {
                if (std::isnan(*level.second) && newSpeed < level.first*speed0)
                {
                    *level.second = between((speed - level.first*speed0)/(speed - newSpeed), depth, newDepth);
                }
            }
            mostTurned = max(mostTurned, radToDeg(std::acos(max(min(axisNow() & axis0, scalar(1)), scalar(-1)))));
            time = dive.time();
            depth = newDepth;
            speed = newSpeed;
            highest = now.wet.highest;
            pitch = newPitch;
        }
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::slenderBody::diveSample
(
    const Time& time,
    const dictionary& properties,
    const vector& g,
    const fileName& file,
    const scalar duration
)
{
    std::ifstream in(file);
    std::string line;
    if (!in || !std::getline(in, line))
    {
        FatalErrorInFunction
            << file << " cannot be read" << nl
            << "Expected: a table whose first line names entries of constant/slenderBodyProperties, as body/mass." << exit(FatalError);
    }
    const std::vector<std::string> names(fields(line));
    const std::vector<std::string> events{"", "immersed", "atRest", "leftTheLiquid", "surfaced"};

    mkDir(time.path()/"results");
    OFstream table(time.path()/"results/sample.csv");
    table.precision(12);
    table
        << "line,end,end_s,end_speed_m_s,x_end_m,immersed_s,lost_m_s,turned_deg,impact_m_s2,peak_m_s2,deepest_m,deepest_s,"
        "depth_1s_m,speed_1s_m_s,half_m,tenth_m,most_turned_deg"
        << endl;
    std::unique_ptr<slenderProperties> firstProperties;
    std::unique_ptr<slenderDive> first;
    for (int number = 1; std::getline(in, line); ++number)
    {
        const std::vector<std::string> values(fields(line));
        if (values.size() != names.size())
        {
            FatalErrorInFunction
                << file << ", line " << number + 1 << ": " << label(values.size()) << " values" << nl
                << "Expected: " << label(names.size()) << ", as the first line has names." << exit(FatalError);
        }
        dictionary dict(properties);
        for (std::size_t i = 0; i < names.size(); ++i)
        {
            setEntry(dict, names[i], values[i]);
        }
        const bool sameShape = std::find(names.begin(), names.end(), "body/meridian") == names.end();
        std::unique_ptr<slenderProperties> own
        (
            new slenderProperties(dict, g, time.path(), first && sameShape ? firstProperties->shape : nullptr)
        );
        std::unique_ptr<slenderDive> dive(new slenderDive(*own, duration, first.get()));
        outcome o;
        o.follow(*dive);
        const scalar end = std::find(events.begin(), events.end(), dive->event()) - events.begin();
        table << number;
        for
        (
            const scalar value :
            {
                end, dive->time(), mag(dive->now().velocity.linear), dive->state()[0], o.immersed, o.lost, o.turned, o.impact, o.peak,
                o.deepest, o.whenDeepest, o.depthAfter, o.speedAfter, o.half, o.tenth, o.mostTurned
            }
        )
        {
            table << ',' << value;
        }
        table << endl;
        if (!first)
        {
            firstProperties = std::move(own);
            first = std::move(dive);
        }
    }
}

// ************************************************************************* //
