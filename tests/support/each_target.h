#pragma once

#include <doctest/doctest.h>
#include <hwy/highway.h>

/// Calls `test` once for each instruction set that was compiled in and that this processor has.
template <class Test>
void onEachTarget(const Test& test) {
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        CAPTURE(hwy::TargetName(target));
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().DeInit();
        test();
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().DeInit();
}
