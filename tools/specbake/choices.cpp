#include "choices.h"

#include <specbake/core/observer.h>

namespace specbake::tool {

std::vector<std::string> spaceChoices() {
    std::vector<std::string> names = {"auto"};
    for (const ColorSpace& space : colorSpaces()) names.push_back(space.name);
    return names;
}

std::vector<std::string> illuminantChoices() {
    std::vector<std::string> names = illuminantNames();
    names.insert(names.begin(), "auto");
    return names;
}

std::optional<std::string> unlessAuto(const std::string& name) {
    if (name == "auto") return {};
    return name;
}

const std::map<std::string, Method>& methodChoices() {
    static const std::map<std::string, Method> choices = {{"smooth", Method::smooth},
                                                          {"descent", Method::descent}};
    return choices;
}

const std::map<std::string, Outside>& outsideChoices() {
    static const std::map<std::string, Outside> choices = {
        {"nearest", Outside::nearest}, {"scale", Outside::scale}, {"error", Outside::error}};
    return choices;
}

}  // namespace specbake::tool
