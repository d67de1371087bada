#include "solve/samples/distinct_samples.h"

#include "solve/natural/place.h"

#include <algorithm>

namespace specbake::internal {
namespace {

struct Group {
    Imath::V3d place;
    std::vector<const MeasuredSample*> members;
    Spectrum mean{};
};

std::vector<Group> grouped(const Observer& observer, const std::vector<MeasuredSample>& samples) {
    std::vector<Group> groups;
    for (const MeasuredSample& sample : samples) {
        const Imath::V3d place = placeOf(observer.color(sample.reflectance), observer.white());
        const auto near = std::ranges::find_if(groups, [&](const Group& group) {
            return (group.place - place).length() <= kOneColor;
        });
        if (near == groups.end()) {
            groups.push_back({place, {&sample}, {}});
        } else {
            near->members.push_back(&sample);
        }
    }
    return groups;
}

Spectrum meanOf(const std::vector<const MeasuredSample*>& members) {
    Spectrum mean{};
    for (std::size_t m = 0; m < mean.size(); ++m) {
        for (const MeasuredSample* member : members) mean[m] += member->reflectance[m];
        mean[m] /= double(members.size());
    }
    return mean;
}

/// How far apart the spectra of a group are: the largest difference from their mean.
double spread(const Group& group) {
    double largest = 0;
    for (const MeasuredSample* member : group.members) {
        largest = std::max(largest, maxDifference(member->reflectance, group.mean));
    }
    return largest;
}

/// "2 groups of samples have one colour each, and were averaged: 'a', 'b' (apart by …)".
std::string describe(const std::vector<Group>& groups, std::size_t count) {
    const auto apart = [](const Group& a, const Group& b) { return spread(a) < spread(b); };
    const Group& worst = *std::ranges::max_element(groups, apart);
    std::string names;
    for (const MeasuredSample* member : worst.members) {
        names += (names.empty() ? "'" : ", '") + member->name + "'";
        if (names.size() < 100) continue;
        names += ", ...";
        break;
    }
    const std::string percent = std::to_string(int(100 * spread(worst) + 0.5));
    return "samples of one colour were averaged at " + std::to_string(count) +
           " colours; those of " + names + " differ most, by " + percent +
           " % reflectance from their mean";
}

}  // namespace

DistinctSamples distinctSamples(const Observer& observer,
                                const std::vector<MeasuredSample>& samples) {
    DistinctSamples distinct;
    std::vector<Group> groups = grouped(observer, samples);
    std::size_t averaged = 0;
    for (Group& group : groups) {
        group.mean = meanOf(group.members);
        averaged += std::size_t(group.members.size() > 1);
        distinct.samples.push_back(*group.members.front());
        if (group.members.size() > 1) distinct.samples.back().reflectance = group.mean;
    }
    if (averaged > 0) distinct.notes.push_back(describe(groups, averaged));
    return distinct;
}

}  // namespace specbake::internal
