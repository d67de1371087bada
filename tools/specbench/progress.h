#pragma once

#include <cstddef>
#include <string>

namespace specbake::bench {

/// "[3/22] what" on standard error, rewritten in place, where that is a terminal; nothing in a
/// pipe.
class Progress {
  public:
    explicit Progress(std::size_t steps);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void next(const std::string& what);

  private:
    std::size_t steps_, done_ = 0;
    bool visible_;
};

}  // namespace specbake::bench
