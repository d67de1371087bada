#include "stop_signals.h"

#include <specbake/image/output_file.h>

#include <semaphore.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>

namespace specbake::tool {
namespace {

constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ};
constexpr long kPatience = 400'000'000;  // ns: more than a band of rows takes

// What a handler of signals can reach.
std::atomic<int> received = 0;     ///< the first that came
std::atomic<bool> isOver = false;  ///< the work is done
sem_t wake;                        ///< for each signal, and for the end

std::stop_source& source() {
    static std::stop_source only;
    return only;
}

void onSignal(int signal, siginfo_t* info, void* /*context*/) {
    // A write beyond the limit fails, and tells its thread so.
    if (signal == SIGXFSZ && info->si_pid == getpid()) return;
    const int error = errno;
    int none = 0;
    received.compare_exchange_strong(none, signal);
    sem_post(&wake);
    errno = error;
}

void waitForWake() {
    while (sem_wait(&wake) != 0 && errno == EINTR) {
    }
}

/// False if nothing came in that time.
bool waitAWhile() {
    timespec end{};
    clock_gettime(CLOCK_REALTIME, &end);
    constexpr long second = 1'000'000'000;
    end.tv_nsec += kPatience;
    end.tv_sec += end.tv_nsec / second;
    end.tv_nsec %= second;
    while (sem_timedwait(&wake, &end) != 0) {
        if (errno != EINTR) return false;
    }
    return true;
}

void endBy(int signal) {
    std::signal(signal, SIG_DFL);
    sigset_t one;
    sigemptyset(&one);
    sigaddset(&one, signal);
    pthread_sigmask(SIG_UNBLOCK, &one, nullptr);
    kill(getpid(), signal);
}

/// The thread that lives beside the work.
void waitForSignals() {
    waitForWake();
    if (isOver) return;
    source().request_stop();
    // A second signal is impatient.
    if (waitAWhile() && isOver) return;
    OutputFile::abandonAll();
    endBy(received);
}

}  // namespace

StopSignals::StopSignals() {
    sem_init(&wake, 0, 0);
    struct sigaction action {};
    action.sa_sigaction = onSignal;
    action.sa_flags = SA_SIGINFO | SA_RESTART;
    sigfillset(&action.sa_mask);
    for (const int signal : kSignals) {
        struct sigaction before {};
        sigaction(signal, nullptr, &before);
        const bool isIgnored = (before.sa_flags & SA_SIGINFO) == 0 && before.sa_handler == SIG_IGN;
        if (!isIgnored) sigaction(signal, &action, nullptr);
    }
    waiter_ = std::thread(waitForSignals);
}

StopSignals::~StopSignals() {
    isOver = true;
    sem_post(&wake);
    waiter_.join();
}

std::stop_token StopSignals::token() {
    return source().get_token();
}

void StopSignals::passOn() {
    if (received != 0) endBy(received);
}

}  // namespace specbake::tool
