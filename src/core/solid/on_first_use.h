#pragma once

#include <mutex>

namespace specbake::internal {

/// A value that is made when it is first asked for, once, whichever thread asks.
template <class T>
class OnFirstUse {
  public:
    template <class Make>
    const T& get(const Make& make) const {
        std::call_once(made_, [&] { value_ = make(); });
        return value_;
    }

  private:
    mutable std::once_flag made_;
    mutable T value_;
};

}  // namespace specbake::internal
