#include <specbake/core/error.h>
#include <specbake/image/output_file.h>

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace specbake;
namespace fs = std::filesystem;

namespace {

/// A folder of its own, removed at the end.
class Folder {
  public:
    Folder() {
        std::string name = (fs::temp_directory_path() / "specbake-files-XXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    ~Folder() { fs::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    fs::path operator/(const std::string& name) const { return path_ / name; }

    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const auto& entry : fs::directory_iterator(path_)) {
            all.push_back(entry.path().filename().string());
        }
        std::sort(all.begin(), all.end());
        return all;
    }

  private:
    fs::path path_;
};

using Names = std::vector<std::string>;

void put(const fs::path& path, const std::string& text) {
    std::ofstream(path) << text;
}

std::string textOf(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

mode_t modeOf(const fs::path& path) {
    struct stat status {};
    stat(path.c_str(), &status);
    return status.st_mode & 07777;
}

/// As those of this host begin, with dots and the like in its name as underscores.
std::string temporaryName(const std::string& process) {
    std::array<char, 256> host{};
    gethostname(host.data(), host.size() - 1);
    std::string name = host.data();
    for (char& c : name) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-') c = '_';
    }
    return ".specbake-" + name.substr(0, 64) + "-" + process + ".tmp";
}

std::string refusalOf(const fs::path& path) {
    try {
        const OutputFile file(path);
    } catch (const FileError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_SUITE_BEGIN("durability");

TEST_CASE("a file appears whole, or not at all") {
    const Folder folder;
    {
        const OutputFile file(folder / "a");
        put(file.temporaryPath(), "new");
        CHECK(folder.names().size() == 1);
        CHECK(!fs::exists(folder / "a"));
    }
    CHECK(folder.names().empty());
    for (const bool sync : {false, true}) {
        OutputFile file(folder / "a", sync);
        put(file.temporaryPath(), "new");
        file.commit();
    }
    CHECK(textOf(folder / "a") == "new");
    writeWhole(folder / "a", "newer");
    CHECK(textOf(folder / "a") == "newer");
    CHECK(folder.names() == Names{"a"});
}

TEST_CASE("the new file has the permissions of the old one") {
    const Folder folder;
    for (const mode_t mode : {0600U, 0640U, 0755U, 0664U}) {
        put(folder / "a", "old");
        chmod((folder / "a").c_str(), mode);
        {
            const OutputFile file(folder / "a");
            if (mode == 0600U) CHECK(modeOf(file.temporaryPath()) == 0600U);
        }
        writeWhole(folder / "a", "new");
        CHECK(modeOf(folder / "a") == mode);
    }
    const mode_t mask = umask(027);
    writeWhole(folder / "b", "new");
    umask(mask);
    CHECK(modeOf(folder / "b") == 0640U);
}

TEST_CASE("links are followed, and one to nothing is refused, as cp does") {
    const Folder folder;
    fs::create_directory(folder / "far");
    put(folder / "far/a", "old");
    fs::create_symlink("far/a", folder / "link");
    fs::create_symlink("link", folder / "linklink");
    writeWhole(folder / "linklink", "new");
    CHECK(textOf(folder / "far/a") == "new");
    CHECK(fs::is_symlink(folder / "link"));
    fs::create_symlink("absent", folder / "dangling");
    CHECK(refusalOf(folder / "dangling").find("a link to a file that is not there") !=
          std::string::npos);
    CHECK(fs::is_symlink(folder / "dangling"));
    fs::create_symlink("loop", folder / "loop");
    CHECK(refusalOf(folder / "loop").starts_with((folder / "loop").string() + ": "));
    CHECK(refusalOf(folder / "far/") != "");
    CHECK(refusalOf(folder / "absent/a").find("No such file") != std::string::npos);
}

TEST_CASE("a name may be as long as the system lets names be") {
    const Folder folder;
    writeWhole(folder / std::string(255, 'n'), "new");
    CHECK(folder.names() == Names{std::string(255, 'n')});
    CHECK(refusalOf(folder / std::string(256, 'n')).find("too long") != std::string::npos);
}

TEST_CASE("what dead processes of this host left is removed, what lives is not") {
    const Folder folder;
    const std::string dead = temporaryName("999999-0");
    const std::string living = temporaryName("999998-0");
    const std::string elsewhere = ".specbake-another.host-999999-0.tmp";
    for (const auto& name : {dead, living, elsewhere}) put(folder / name, "half");
    const int file = open((folder / living).c_str(), O_RDONLY | O_CLOEXEC);
    REQUIRE(flock(file, LOCK_EX) == 0);
    writeWhole(folder / "a", "new");
    Names left = {elsewhere, living, "a"};
    std::sort(left.begin(), left.end());
    CHECK(folder.names() == left);
    close(file);
}

TEST_CASE("a process with our number, in another container, is in nobody's way") {
    const Folder folder;
    std::vector<int> files;
    for (int i = 0; i < 64; ++i) {
        const std::string name = temporaryName(std::to_string(getpid()) + "-" + std::to_string(i));
        put(folder / name, "theirs");
        files.push_back(open((folder / name).c_str(), O_RDONLY | O_CLOEXEC));
        REQUIRE(flock(files.back(), LOCK_EX) == 0);
    }
    writeWhole(folder / "a", "new");
    CHECK(folder.names().size() == 65);
    CHECK(textOf(folder / temporaryName(std::to_string(getpid()) + "-0")) == "theirs");
    for (const int file : files) close(file);
}

TEST_SUITE_END();
