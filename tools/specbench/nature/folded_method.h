#pragma once

#include "methods/method.h"

#include <specbake/core/measured_sample.h>
#include <specbake/core/solver.h>

#include <functional>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

namespace specbake::bench {

/// Samples that are rebuilt by a solver made of others: each fold of them has a solver of its own,
/// which was made without the fold.
class FoldedMethod : public Method {
  public:
    /// `without(fold)`: a solver that knows nothing of these samples.
    using Without =
        std::function<std::shared_ptr<const Solver>(const std::vector<MeasuredSample>& fold)>;

    /// Sample i is in fold i mod `folds`, or in that of an earlier sample of the same spectrum.
    FoldedMethod(MethodName name, Frame frame, const std::vector<MeasuredSample>& samples,
                 std::size_t folds, const Without& without);

    /// `color` is that of a sample.
    Reconstruction reconstruct(const XYZ& color) const override;

  private:
    using Key = std::tuple<double, double, double>;
    static Key keyOf(const XYZ& color) { return {color.x, color.y, color.z}; }

    std::map<Key, std::size_t> foldOf_;
    std::vector<std::shared_ptr<const Solver>> solvers_;
};

}  // namespace specbake::bench
