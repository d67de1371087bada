#pragma once

#include <random>

namespace specbake::testing {

/// 0 to end - 1, each as likely.
template <class Integer>
Integer below(std::mt19937& random, Integer end) {
    return std::uniform_int_distribution<Integer>(0, end - 1)(random);
}

}  // namespace specbake::testing
