// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <QObject>
#include <QString>

#include <set>
#include <string>

namespace dewpoint::capture {
struct DeviceMatch;
} // namespace dewpoint::capture

namespace dewpoint::ui {

class CameraEdits;
class DeviceWatch;

/// Asks the user which device belongs to a camera of the project, if its device is missing when the
/// project is opened or if several devices match. Asks once for each camera. The answer is stored
/// in the project in an undoable step. The question disappears when the missing device is plugged
/// in.
class DeviceQuestion : public QObject {
  Q_OBJECT
public:
  DeviceQuestion(const Workbench& bench, DeviceWatch& watch, CameraEdits& edits);

private:
  void update();
  void ask(int camera, const capture::DeviceMatch& match);
  void withdraw();

  Workbench bench_;
  DeviceWatch& watch_;
  CameraEdits& edits_;
  std::set<std::string> asked_;   ///< names of the cameras
  std::set<std::string> missing_; ///< names of those without a device when the project was opened
  QString question_;              ///< that waits for an answer; empty if none does
  std::string camera_;            ///< that it is about
  bool isFirst_ = true;           ///< the project has just been opened
};

} // namespace dewpoint::ui
