// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameras/cameras_installer.h"

#include "core/project/project.h"
#include "ui/cameras/camera_edits.h"
#include "ui/cameras/cameras_dialog.h"
#include "ui/cameras/color_locker.h"
#include "ui/cameras/control_sync.h"
#include "ui/cameras/device_question.h"
#include "ui/cameras/device_watch.h"
#include "ui/document/document.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/workbench.h"

#include <QMainWindow>

#include <algorithm>

namespace dewpoint::ui {

namespace {

/// What is said while the dialog is closed; it says the rest itself.
void sayInWindow(const Workbench& bench, const QString& text, bool isProblem) {
  const auto* dialog = bench.window.findChild<CamerasDialog*>();
  if (dialog == nullptr || !dialog->isVisible()) {
    isProblem ? bench.messages.showError(text) : bench.messages.showNotice(text);
  }
}

} // namespace

void installCameraSources(const Workbench& bench) {
  auto* watch = new DeviceWatch(nullptr, &bench.window);
  auto* edits = new CameraEdits(bench.document, &bench.window);
  auto* controls = new ControlSync(bench.document, *watch, &bench.window);
  auto* locker = new ColorLocker(bench, *watch, *edits);
  new DeviceQuestion(bench, *watch, *edits);
  const CameraParts parts{*watch, *edits, *locker, *controls};
  bench.onTriggered("actionCameras", locker, [bench, parts] {
    auto* dialog = bench.window.findChild<CamerasDialog*>();
    if (dialog == nullptr) {
      dialog = new CamerasDialog(bench, parts);
      dialog->setAttribute(Qt::WA_DeleteOnClose);
    }
    Workbench::presentDialog(dialog);
  });
  bench.requireRun({"actionCameras"});
  bench.onTriggered("actionLockColors", locker, [locker] { locker->lockColors(-1); });
  bench.requireRun({"actionLockColors"}, [document = &bench.document] {
    return std::ranges::any_of(document->project().cameras, [](const ProjectCamera& camera) {
      return camera.source == SourceKind::Device;
    });
  });
  QObject::connect(locker, &ColorLocker::lockingStarted, controls, &ControlSync::rememberControls);
  const auto problem = [bench](const QString& text) { sayInWindow(bench, text, true); };
  QObject::connect(edits, &CameraEdits::failed, locker, problem);
  QObject::connect(controls, &ControlSync::failed, locker, problem);
  QObject::connect(locker, &ColorLocker::failed, locker, problem);
  QObject::connect(locker, &ColorLocker::completed, locker,
                   [bench](const QString& text) { sayInWindow(bench, text, false); });
}

} // namespace dewpoint::ui
