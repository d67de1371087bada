#include "nature/folded_method.h"

namespace specbake::bench {

FoldedMethod::FoldedMethod(MethodName name, Frame itsFrame,
                           const std::vector<MeasuredSample>& samples, std::size_t folds,
                           const Without& without)
    : Method(std::move(name), std::move(itsFrame)) {
    std::vector<std::vector<MeasuredSample>> members(folds);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const XYZ color = frame().observer.color(samples[i].reflectance);
        const std::size_t fold = foldOf_.try_emplace(keyOf(color), i % folds).first->second;
        members[fold].push_back(samples[i]);
    }
    for (const std::vector<MeasuredSample>& fold : members) solvers_.push_back(without(fold));
}

Reconstruction FoldedMethod::reconstruct(const XYZ& color) const {
    const Solution solution = solvers_[foldOf_.at(keyOf(color))]->solve(color);
    return {solution.spectrum, solution.solved()};
}

}  // namespace specbake::bench
