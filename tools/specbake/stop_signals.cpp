#include "stop_signals.h"

#include <pthread.h>

namespace specbake::tool {
namespace {

constexpr int kWakeUp = SIGUSR1;  ///< ends the waiter

}  // namespace

StopSignals::StopSignals() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    sigaddset(&signals_, SIGTERM);
    sigaddset(&signals_, kWakeUp);
    pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
    waiter_ = std::thread([this] {
        int signal = 0;
        sigwait(&signals_, &signal);
        if (signal == kWakeUp) return;
        received_ = signal;
        source_.request_stop();
    });
}

StopSignals::~StopSignals() {
    if (received_ == 0) pthread_kill(waiter_.native_handle(), kWakeUp);
    waiter_.join();
    pthread_sigmask(SIG_UNBLOCK, &signals_, nullptr);
}

void StopSignals::passOn() const {
    if (received_ == 0) return;
    sigset_t mine = signals_;
    std::signal(received_, SIG_DFL);
    pthread_sigmask(SIG_UNBLOCK, &mine, nullptr);
    std::raise(received_);
}

}  // namespace specbake::tool
