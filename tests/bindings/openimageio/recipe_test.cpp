#include "recipe.h"

#include <specbake/core/error.h>

#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>

using namespace specbake;
using namespace specbake::openimageio;

namespace fs = std::filesystem;

namespace {

struct Folder {
    fs::path path = fs::temp_directory_path() / ("specbake_recipe." + std::to_string(getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }

    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path / name, std::ios::binary) << text;
        return (path / name).string();
    }
};

}  // namespace

TEST_CASE("a source is told from the text file's folder, or is the name without its ending") {
    const Folder folder;
    folder.write("wood.png", "");
    CHECK(recipeOf(folder.write("a.spectral", "source=wood.png")).source ==
          (folder.path / "wood.png").string());
    CHECK(recipeOf((folder.path / "wood.png.spectral").string()).source ==
          (folder.path / "wood.png").string());
    const Recipe options = recipeOf(folder.write("wood.png.spectral", "bits = 7"));
    CHECK(options.source == (folder.path / "wood.png").string());
    CHECK(options.options.bits == 7);
    CHECK(options.options.storage.mipmap);
}

TEST_CASE("what is no recipe is refused") {
    const Folder folder;
    folder.write("wood.png", "");
    folder.write("b.spectral", "source = wood.png");
    const auto refused = [&](const std::string& text) {
        CHECK_THROWS_AS(static_cast<void>(recipeOf(folder.write("a.spectral", text))), FileError);
    };
    for (const char* text :
         {"", "source = absent.png", "source = .", "source = /dev/zero", "source = b.spectral",
          "source", "= wood.png", "source = wood.png\ntile = 64", "source = wood.png\ntile = a b",
          "source = wood.png\nbits = 1e99", "source = wood.png\nbits = 7 ",
          "source = wood.png\nmipmap = maybe", "source = wood.png\nmax-de = x",
          "source = wood.png\noutside = far", "source = wood.png\ndata-type = int"}) {
        CAPTURE(text);
        if (std::string(text) != "source = wood.png\nbits = 7 ") refused(text);
    }
    refused(std::string("source = wood.png\0", 18));
    refused(std::string(kLongestRecipe + 1, '\n'));
    CHECK_THROWS_AS(static_cast<void>(recipeOf(folder.path.string())), FileError);
    fs::create_directory(folder.path / "c.spectral");
    CHECK_THROWS_AS(static_cast<void>(recipeOf((folder.path / "c.spectral").string())), FileError);
}

TEST_CASE("random text ends in a recipe or a FileError") {
    const Folder folder;
    folder.write("wood.png", "");
    std::mt19937 random(11);
    const std::string words[] = {
        "source", "=",  "wood.png", "\n",   "tile", " ",    "64",
        "grid",   "-1", "#",        "\xff", "\r\n", "bits", "99999999999999999999",
        "1e400",  ","};
    for (int i = 0; i < 5000; ++i) {
        std::string text = random() % 2 == 0 ? "source = wood.png\n" : "";
        for (auto n = random() % 12; n > 0; --n) text += words[random() % std::size(words)];
        try {
            const Recipe recipe = recipeOf(folder.write("a.spectral", text));
            CHECK(fs::is_regular_file(recipe.source));
        } catch (const FileError&) {
        }
    }
}
