#pragma once

#include "choices.h"

#include <specbake/bake/bake.h>

#include <string>
#include <utility>
#include <vector>

namespace specbake::tool {

/// How textures are baked, as words of the command line: all that the bytes of a result depend on.
struct BakeArguments {
    ReadArguments read;
    ColorArguments color;
    ModelArguments model;
    std::string materialMap;  ///< an image, "" for none
    std::string second;       ///< LIGHT=IMAGE, "" for none
    int grid = kDefaultGridNodes;
    bool perTexel = false;
    std::string sampleType{sampleTypeName(StorageOptions().sampleType)};
    std::string compression{compressionName(StorageOptions().compression)};
    std::vector<int> tile;  ///< none, or width and height
    std::vector<std::pair<std::string, std::string>> attributes;
    std::string wrap;  ///< "" or one of two of a wrap mode
    BakeOptions rest;  ///< all else

    /// `notes`: what there is to tell of the files that options name. Throws ArgumentError,
    /// FileError.
    BakeOptions options(std::vector<std::string>& notes) const;
};

/// The textures of a bake, and where the results go.
void addInputsAndOutput(CLI::App& command, std::vector<std::string>& inputs, std::string& output);

/// All options of BakeArguments, threads too.
void addBakeOptions(CLI::App& command, BakeArguments& arguments);

}  // namespace specbake::tool
