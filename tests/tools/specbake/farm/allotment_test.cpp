#include "farm/allotment.h"

#include "farm/tiles.h"
#include "process.h"

#include <doctest/doctest.h>
#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

using namespace specbake::testing;
using specbake::tool::allottedThreads;
using specbake::tool::processorQuota;
namespace fs = std::filesystem;

namespace {

/// A file system's root with the files that tell of control groups.
struct Root {
    Scratch scratch;

    void write(const std::string& name, const std::string& contents) const {
        const fs::path path = scratch.path(name);
        fs::create_directories(path.parent_path());
        writeFile(path.string(), contents);
    }

    std::optional<double> quota() const { return processorQuota(scratch.path("")); }
};

/// The processors that this process may run on, while this lives only so many of them.
class Affinity {
  public:
    Affinity() { sched_getaffinity(0, sizeof before_, &before_); }
    ~Affinity() { sched_setaffinity(0, sizeof before_, &before_); }
    Affinity(const Affinity&) = delete;
    Affinity& operator=(const Affinity&) = delete;

    int all() const { return CPU_COUNT(&before_); }

    void narrow(int processors) const {
        cpu_set_t some;
        CPU_ZERO(&some);
        for (std::size_t i = 0; i < CPU_SETSIZE && CPU_COUNT(&some) < processors; ++i) {
            if (CPU_ISSET(i, &before_)) CPU_SET(i, &some);
        }
        sched_setaffinity(0, sizeof some, &some);
    }

  private:
    cpu_set_t before_{};
};

/// A control group of version 1 with a quota, where this process may make one.
class Group {
  public:
    explicit Group(int quota) {
        std::error_code error;
        if (!fs::create_directory(path_, error)) return;
        std::ofstream(path_ / "cpu.cfs_period_us") << 100000;
        std::ofstream limit(path_ / "cpu.cfs_quota_us");
        limit << quota;
        limit.close();
        std::ofstream tasks(path_ / "tasks");
        tasks << getpid();
        tasks.close();
        joined_ = !limit.fail() && !tasks.fail();
    }
    ~Group() {
        std::ofstream(path_.parent_path() / "tasks") << getpid();
        std::error_code ignored;
        fs::remove(path_, ignored);
    }
    Group(const Group&) = delete;
    Group& operator=(const Group&) = delete;

    bool joined() const { return joined_; }

  private:
    fs::path path_ = "/sys/fs/cgroup/cpu/specbake-test-" + std::to_string(getpid());
    bool joined_ = false;
};

}  // namespace

TEST_SUITE_BEGIN("allotment");

TEST_CASE("a quota of version 2 holds, and so do those of the groups around") {
    const Root root;
    CHECK(!root.quota());
    root.write("proc/self/cgroup", "0::/system.slice/job/step\n");
    root.write(
        "proc/self/mountinfo",
        "22 1 0:20 / /proc rw - proc proc rw\n"
        "30 22 0:27 / /sys/fs/cgroup rw,relatime shared:4 - cgroup2 cgroup2 rw,nsdelegate\n");
    CHECK(!root.quota());
    root.write("sys/fs/cgroup/system.slice/job/step/cpu.max", "max 100000\n");
    CHECK(!root.quota());
    root.write("sys/fs/cgroup/system.slice/job/cpu.max", "250000 100000\n");
    CHECK(root.quota() == doctest::Approx(2.5));
    root.write("sys/fs/cgroup/system.slice/job/step/cpu.max", "700000 100000\n");
    CHECK(root.quota() == doctest::Approx(2.5));
    root.write("sys/fs/cgroup/system.slice/job/step/cpu.max", "50000 100000\n");
    CHECK(root.quota() == doctest::Approx(0.5));
}

TEST_CASE("in a container the group's path is of the host, or the root") {
    for (const std::string path : {"/", "/docker/4f1e", "/../other"}) {
        CAPTURE(path);
        const Root root;
        root.write("proc/self/cgroup", "0::" + path + "\n");
        root.write("proc/self/mountinfo", "30 22 0:27 " +
                                              std::string(path == "/" ? "/" : "/docker/4f1e") +
                                              " /sys/fs/cgroup ro - cgroup2 cgroup rw\n");
        root.write("sys/fs/cgroup/cpu.max", "150000 100000\n");
        CHECK(root.quota() == doctest::Approx(1.5));
    }
}

TEST_CASE("a quota of version 1 holds, with its controllers together and apart") {
    for (const std::string controllers : {"cpu", "cpu,cpuacct", "cpuacct,cpu"}) {
        CAPTURE(controllers);
        const Root root;
        root.write("proc/self/cgroup",
                   "9:memory:/a\n2:" + controllers + ":/slurm/uid_0/job_7\n0::/x\n");
        root.write("proc/self/mountinfo",
                   "33 30 0:30 / /sys/fs/cgroup/memory rw - cgroup cgroup rw,memory\n"
                   "34 30 0:31 / /sys/fs/cgroup/cpu\\040 rw - cgroup cgroup rw,freezer\n"
                   "31 30 0:28 / /sys/fs/cgroup/" +
                       controllers + " rw - cgroup cgroup rw," + controllers + "\n");
        const std::string group = "sys/fs/cgroup/" + controllers + "/slurm/uid_0/job_7/";
        root.write(group + "cpu.cfs_period_us", "50000\n");
        root.write(group + "cpu.cfs_quota_us", "-1\n");
        CHECK(!root.quota());
        root.write(group + "cpu.cfs_quota_us", "150000\n");
        CHECK(root.quota() == doctest::Approx(3));
    }
}

TEST_CASE("threads follow the processors, and what Slurm grants, whichever is less") {
    const Affinity affinity;
    const int all = allottedThreads();
    CHECK(all >= 1);
    CHECK(all <= affinity.all());
    affinity.narrow(1);
    CHECK(allottedThreads() == 1);
    const SetVariable slurm("SLURM_CPUS_PER_TASK", "64");
    CHECK(allottedThreads() == 1);
}

TEST_CASE("SLURM_CPUS_PER_TASK takes less than there is, and is not taken at a foolish word") {
    const int all = allottedThreads();
    for (const auto& [text, threads] :
         {std::pair{"1", 1}, {"1000", all}, {"", all}, {"x", all}, {"0", all}, {"-3", all}}) {
        CAPTURE(text);
        const SetVariable slurm("SLURM_CPUS_PER_TASK", text);
        CHECK(allottedThreads() == threads);
    }
}

TEST_CASE("a real quota is found, where one can be made") {
    const Group group(50000);
    if (!group.joined()) {
        MESSAGE("this process may make no control group of version 1: not tried");
        return;
    }
    CHECK(processorQuota() == doctest::Approx(0.5));
    CHECK(allottedThreads() == 1);
}

TEST_CASE("a bake takes as many threads as it is allotted, and -j has the last word") {
    const Tiles tiles({{9, 9}, {8, 8}});
    const auto threadsOf = [&](const std::vector<std::string>& options) {
        std::vector<std::string> words = tiles.words("bake");
        words.insert(words.end(), options.begin(), options.end());
        const std::string out = runTool(words).out;
        const std::size_t at = out.find(" on ");
        REQUIRE(at != std::string::npos);
        return std::atoi(out.c_str() + at + 4);
    };
    CHECK(threadsOf({}) == allottedThreads());
    CHECK(threadsOf({"-j", "3"}) == 3);
    const SetVariable slurm("SLURM_CPUS_PER_TASK", "1");
    CHECK(threadsOf({}) == 1);
    CHECK(threadsOf({"-j", "3"}) == 3);
}

TEST_SUITE_END();
