#pragma once

#include <specbake/core/api.h>

#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace specbake {

/// The base of everything that the libraries throw. what() is one line, fit to be shown to a user.
class SPECBAKE_API Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// An argument outside its documented range.
class SPECBAKE_API ArgumentError : public Error {
  public:
    using Error::Error;
};

/// A file that cannot be read, written or understood: what() is "FILE: REASON".
class SPECBAKE_API FileError : public Error {
  public:
    FileError(std::string file, const std::string& reason)
        : Error(file + ": " + reason), file_(std::move(file)) {}
    const std::string& file() const noexcept { return file_; }

  private:
    std::string file_;
};

/// Work that its caller stopped.
class SPECBAKE_API Cancelled : public Error {
  public:
    Cancelled() : Error("stopped") {}
};

/// What someone probably meant who gave a name that is not there: that of `names` which is fewest
/// edits (one letter more, less, another, or swapped with its neighbour) from the text, if those
/// are at most a third of its letters. Only letters and digits count, in any case.
SPECBAKE_API std::optional<std::string> nearestName(std::string_view text,
                                                    std::span<const std::string> names);

/// To end a message with: "; did you mean 'D65'?", or nothing if no name is near.
SPECBAKE_API std::string suggestion(std::string_view text, std::span<const std::string> names);

}  // namespace specbake
