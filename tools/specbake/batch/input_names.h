#pragma once

#include <string>
#include <vector>

namespace specbake::tool {

/// A texture to be baked.
struct Input {
    std::string path;
    std::string tree;    ///< its folder below the one that was named; empty without one
    std::string number;  ///< what stands for <UDIM>, #### and so on; empty without one
    bool found = false;  ///< in a folder or by a pattern: it was not named itself
};

struct Inputs {
    std::vector<Input> all;  ///< each file once, in the order of the words
    bool single = false;     ///< one word, that names one file
};

/// What the words of a command line come to:
///
///     wood.png            that file, whether it is there or not
///     FOLDER              the images in it and in its folders, except hidden ones
///     'tex/*.png'         what matches, by the rules of glob(7) and with {a,b}
///     'wood.<UDIM>.png'   the tiles or frames that there are (number_token.h)
///     @list.txt           the words in that file, one a line, or with @- those of standard input;
///                         empty lines and such that begin with # are passed over
///
/// A name that is there is never taken for a pattern. Throws ArgumentError for a folder or a
/// pattern that yields nothing, FileError for a list that cannot be read.
Inputs expandInputs(const std::vector<std::string>& words);

}  // namespace specbake::tool
