#include "cli/stop_signal.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

namespace fluidymation::cli {
namespace {

// In processes of their own: what happens to a signal belongs to the whole process.

TEST(StopSignal, TheFirstIsRememberedTheSecondEndsTheProcess) {
  for (const auto& [first, second] :
       {std::pair{SIGINT, SIGINT}, {SIGTERM, SIGTERM}, {SIGINT, SIGTERM}, {SIGTERM, SIGINT}}) {
    const int once = first;
    const int again = second;
    EXPECT_EXIT(
        {
          std::signal(SIGINT, SIG_DFL);
          std::signal(SIGTERM, SIG_DFL);
          listenForStopSignals();
          if (receivedStopSignal() != 0) _exit(1);
          std::raise(once);
          if (receivedStopSignal() != once) _exit(2);
          std::raise(again);
          _exit(3);
        },
        ::testing::KilledBySignal(again), "");
  }
}

TEST(StopSignal, AClosedTerminalIsToldOfTwice) {
  EXPECT_EXIT(
      {
        std::signal(SIGHUP, SIG_DFL);
        listenForStopSignals();
        std::raise(SIGHUP);
        std::raise(SIGHUP);
        _exit(receivedStopSignal() == SIGHUP ? 0 : 1);
      },
      ::testing::ExitedWithCode(0), "");
}

TEST(StopSignal, WhatIsIgnoredStaysIgnored) {
  EXPECT_EXIT(
      {
        std::signal(SIGINT, SIG_IGN);
        listenForStopSignals();
        std::raise(SIGINT);
        _exit(receivedStopSignal() == 0 ? 0 : 1);
      },
      ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace fluidymation::cli
