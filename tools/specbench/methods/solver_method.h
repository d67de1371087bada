#pragma once

#include "method.h"

#include <specbake/core/solver.h>

#include <memory>

namespace specbake::bench {

/// A solver of specbake, asked once a colour.
class SolverMethod : public Method {
  public:
    SolverMethod(MethodName name, Frame frame, std::shared_ptr<const Solver> solver)
        : Method(std::move(name), std::move(frame)), solver_(std::move(solver)) {}
    Reconstruction reconstruct(const XYZ& color) const override;

  private:
    std::shared_ptr<const Solver> solver_;
};

}  // namespace specbake::bench
