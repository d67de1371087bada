#include "help/help_texts.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace specbake::tool {
namespace {

using Group = std::pair<std::string, std::vector<std::string>>;

/// Options of one name mean much the same in all commands, and stand in one group.
const std::vector<Group>& groups() {
    static const std::vector<Group> all = {
        {"What is read",
         {"--xyz", "--rgb", "--space", "--primaries", "--transfer", "--colorconfig", "--channels",
          "--part", "--orient"}},
        {"Colours and spectra",
         {"--illuminant", "--observer", "--adapt", "--method", "--samples", "--material",
          "--material-map", "--second", "--outside", "--per-texel", "--grid", "--max-deviation",
          "--quadrature", "--wavelengths"}},
        {"What is written",
         {"--output", "--bits", "--max-de", "--data-type", "--compression", "--tile", "--mipmap",
          "--wrap", "--attrib", "--sync"}},
        {"How it is done",
         {"--threads", "--max-pixels", "--max-memory", "--isolate", "--shard", "--quick", "--stats",
          "--report", "--update", "--verbose", "--quiet", "--help"}}};
    return all;
}

/// Two of each command, and what they do.
const std::map<std::string, std::string>& examples() {
    static const std::map<std::string, std::string> all = {
        {"bake",
         "  specbake bake wood.png -o wood.exr\n"
         "      one texture, with the defaults\n"
         "  specbake bake textures -o spectral -u --tile 64 64 --mipmap\n"
         "      what changed in a folder, for a renderer that fetches tiles and mip levels\n"},
        {"verify",
         "  specbake verify wood.exr wood.png\n"
         "      whether the bands have the colours of the texture\n"
         "  specbake verify wood.exr --spectra reference.exr --max-band 0.01\n"
         "      whether they are those of another spectral image\n"},
        {"relight",
         "  specbake relight wood.exr -o lamps.png --illuminant D65,A,F11\n"
         "      under three lamps, side by side, as an eye that is used to each sees it\n"
         "  specbake relight wood.exr -o wood-A.exr --illuminant A --no-adapt\n"
         "      with the light's tint, as linear floats\n"},
        {"inspect",
         "  specbake inspect wood.exr\n"
         "      what the file holds\n"
         "  specbake inspect wood.exr --at 10 20 --plot texel.svg\n"
         "      the spectrum of one texel, as numbers and drawn\n"},
        {"solve",
         "  specbake solve --rgb 0.8 0.3 0.1\n"
         "      the spectrum of a linear Rec.709 colour\n"
         "  specbake solve --rgb 0.8 0.3 0.1 --space srgb --json\n"
         "      of an sRGB colour, with how it was solved\n"},
        {"region",
         "  specbake region --illuminant D65\n"
         "      white, volume and faces of the solid of object colours\n"
         "  specbake region --illuminant D65 --obj solid.obj\n"
         "      its surface, for a viewer of meshes\n"},
        {"status",
         "  specbake status @list.txt -o spectral --tile 64 64 --mipmap\n"
         "      what of a list is baked so, by the exit code, too\n"
         "  specbake status @list.txt -o spectral --json --quick\n"
         "      for a script, of headers alone\n"},
        {"table",
         "  specbake table -o srgb.spectab\n"
         "      for linear Rec.709 colours\n"
         "  specbake table -o acescg.spectab --space acescg --grid 33\n"
         "      for ACEScg, finer\n"}};
    return all;
}

/// Groups that are not known come first.
std::ptrdiff_t rankOf(const std::string& name) {
    const auto group = std::find_if(groups().begin(), groups().end(),
                                    [&](const Group& known) { return known.first == name; });
    return group == groups().end() ? -1 : group - groups().begin();
}

void sortIntoGroups(CLI::App& command) {
    for (const auto& [group, names] : groups()) {
        for (const std::string& name : names) {
            if (CLI::Option* option = command.get_option_no_throw(name)) option->group(group);
        }
    }
}

}  // namespace

std::vector<std::string> groupsOf(const CLI::App& command) {
    std::vector<std::string> names = command.get_groups();
    std::erase_if(names, [](const std::string& name) { return name.empty(); });
    std::stable_sort(names.begin(), names.end(),
                     [](const auto& a, const auto& b) { return rankOf(a) < rankOf(b); });
    return names;
}

void addHelpTexts(CLI::App& program) {
    for (CLI::App* command : program.get_subcommands({})) {
        sortIntoGroups(*command);
        const auto example = examples().find(command->get_name());
        if (example == examples().end()) continue;
        const std::string before = command->get_footer();
        command->footer((before.empty() ? "" : before + "\n\n") + "Examples:\n" + example->second);
    }
}

}  // namespace specbake::tool
