#include "nature/rivals.h"

#include "methods/max_entropy.h"
#include "methods/published/jakob2019.h"
#include "methods/published/mallett2019.h"
#include "methods/solver_method.h"
#include "nature/folded_method.h"
#include "solve/natural/natural.h"
#include "solve/samples/distinct_samples.h"
#include "solve/samples/samples_solver.h"
#include "solve/samples/with_samples.h"
#include "solve/shell.h"

#include <algorithm>

namespace specbake::bench {

using namespace internal;

namespace {

using Samples = std::vector<MeasuredSample>;
using SharedSolver = std::shared_ptr<const Solver>;

void remove(Samples& samples, const Samples& fold) {
    std::erase_if(samples, [&](const MeasuredSample& sample) {
        return std::ranges::any_of(
            fold, [&](const MeasuredSample& f) { return f.reflectance == sample.reflectance; });
    });
}

std::vector<MeasuredSet> votersWithout(const Judged& set, const Samples& fold) {
    std::vector<MeasuredSet> voters = set.voters;
    for (MeasuredSet& voter : voters) remove(voter.samples, fold);
    return voters;
}

/// `smooth`, and what is made on top of it.
struct Family {
    explicit Family(const Frame& itsFrame)
        : frame(itsFrame), smooth(std::make_shared<const ShellSolver>(frame.observer)) {}

    SharedSolver natural(const std::vector<MeasuredSet>& voters) const {
        return std::make_shared<const NaturalSolver>(frame.observer, smooth, voters);
    }
    SharedSolver withSamplesOf(const Judged& set, const SharedSolver& base,
                               const Samples& fold) const {
        Samples others = set.samples;
        remove(others, fold);
        others = distinctSamples(frame.observer, others).samples;
        const FieldShape shape = chooseShape(frame.observer, *base, others).shape;
        return std::make_shared<const SamplesSolver>(frame.observer, base, others, shape);
    }
    SharedSolver ofMaterial(const Judged& set, const Samples& fold) const {
        const std::vector<MeasuredSet> voters = votersWithout(set, fold);
        return withMaterial(frame.observer, natural(voters), voters, set.material);
    }

    Frame frame;
    SharedSolver smooth;
};

using Methods = std::vector<std::unique_ptr<Method>>;

/// Everything that learns has learnt from other sets; `samples`, from the rest of this one too.
void addBySet(Methods& list, const Judged& set, const Family& family) {
    const SharedSolver natural = family.natural(set.voters);
    list.push_back(std::make_unique<SolverMethod>(MethodName{"natural", "set left out"},
                                                  family.frame, natural));
    list.push_back(std::make_unique<FoldedMethod>(
        MethodName{"samples", "ten-fold"}, family.frame, set.samples, set.folds,
        [&](const Samples& fold) { return family.withSamplesOf(set, natural, fold); }));
}

void addByMaterial(Methods& list, const Judged& set, const Family& family) {
    list.push_back(std::make_unique<FoldedMethod>(
        MethodName{"natural", "sample left out"}, family.frame, set.samples, set.folds,
        [&](const Samples& fold) { return family.natural(votersWithout(set, fold)); }));
    list.push_back(std::make_unique<FoldedMethod>(
        MethodName{"material", "sample left out"}, family.frame, set.samples, set.folds,
        [&](const Samples& fold) { return family.ofMaterial(set, fold); }));
}

}  // namespace

std::vector<std::unique_ptr<Method>> rivalsFor(const Judged& set, const Options& options) {
    const Family family(sRGBFrame());
    Methods list;
    list.push_back(
        std::make_unique<SolverMethod>(MethodName{"smooth", ""}, family.frame, family.smooth));
    if (set.material.empty()) {
        addBySet(list, set, family);
    } else {
        addByMaterial(list, set, family);
    }
    list.push_back(std::make_unique<Jakob2019Direct>(family.frame));
    list.push_back(std::make_unique<MaxEntropy>(family.frame));
    list.push_back(std::make_unique<Mallett2019>(family.frame, options.data + "/mallett2019.csv"));
    return list;
}

}  // namespace specbake::bench
