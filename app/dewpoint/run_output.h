// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>

namespace dewpoint::ui {
class MainWindow;
} // namespace dewpoint::ui

namespace dewpoint::app {

/// Implements `dewpoint --out DIR`: writes trajectory.csv and run.json into a folder whenever the
/// recording has been tracked to its end, and when the application quits.
class RunOutput {
public:
  RunOutput(MainWindow& window, std::filesystem::path folder);
  /// Waits until all files are written, no matter how long this takes. Destroy this object at the
  /// end of the program, after the window is closed.
  ~RunOutput();
  RunOutput(const RunOutput&) = delete;
  RunOutput& operator=(const RunOutput&) = delete;

private:
  void write(const std::function<void(bool)>& written);

  MainWindow& window_;
  std::filesystem::path folder_;
  std::shared_ptr<std::atomic<int>> pendingWrites_ = std::make_shared<std::atomic<int>>(0);
  bool ended_ = false;
};

} // namespace dewpoint::app
