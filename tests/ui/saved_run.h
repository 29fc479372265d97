// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"
#include "ui/mainwindow/main_window.h"

#include <QTest>

#include <atomic>
#include <filesystem>
#include <memory>

namespace dewpoint::tests::test {

/// Lets the window write its run into a folder and waits for it; whether it went well.
inline bool savesRun(MainWindow& window, const std::filesystem::path& folder) {
  enum Outcome { kOpen, kWritten, kFailed };
  const auto outcome = std::make_shared<std::atomic<Outcome>>(kOpen);
  window.saveRun(folder, [outcome](bool good) { *outcome = good ? kWritten : kFailed; });
  return QTest::qWaitFor([&] { return *outcome != kOpen; }, DEWPOINT_PATIENCE_MS) &&
         *outcome == kWritten;
}

} // namespace dewpoint::tests::test
