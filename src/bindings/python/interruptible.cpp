#include "interruptible.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace py = pybind11;

namespace specbake::python {
namespace {

/// What the two threads share.
class Progress {
  public:
    void set(double done) {
        const std::scoped_lock lock(mutex_);
        done_ = done;
    }
    void end() {
        const std::scoped_lock lock(mutex_);
        ended_ = true;
        changed_.notify_one();
    }
    double done() {
        const std::scoped_lock lock(mutex_);
        return done_;
    }
    /// Whether the work has ended; waits a little for it.
    bool ended() {
        constexpr std::chrono::milliseconds little(50);
        std::unique_lock lock(mutex_);
        return changed_.wait_for(lock, little, [&] { return ended_; });
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    double done_ = 0;
    bool ended_ = false;
};

/// Needs the GIL.
void attend(const py::object& progress, double done) {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!progress.is_none()) progress(done);
}

}  // namespace

void runInterruptibly(const std::function<void(const Watch&)>& work, const py::object& progress) {
    Progress shared;
    std::exception_ptr failure;
    std::exception_ptr pythonError;
    {
        const py::gil_scoped_release released;
        std::stop_source stop;
        const std::jthread worker([&] {
            try {
                work({stop.get_token(), [&](double done) { shared.set(done); }});
            } catch (...) {
                failure = std::current_exception();
            }
            shared.end();
        });
        while (!shared.ended()) {
            if (pythonError) continue;
            const py::gil_scoped_acquire acquired;
            try {
                attend(progress, shared.done());
            } catch (...) {
                pythonError = std::current_exception();
                stop.request_stop();
            }
        }
    }
    if (pythonError) std::rethrow_exception(pythonError);
    if (failure) std::rethrow_exception(failure);
    attend(progress, 1);
}

}  // namespace specbake::python
