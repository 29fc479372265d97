// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameras/device_question.h"

#include "core/project/project.h"
#include "core/setup/connected_cameras.h"
#include "core/setup/new_project/project_devices.h"
#include "ui/cameras/camera_device_text.h"
#include "ui/cameras/camera_edits.h"
#include "ui/cameras/device_watch.h"
#include "ui/document/camera_list_model.h"
#include "ui/document/document.h"
#include "ui/widgets/message_bar.h"

#include <QAction>
#include <QMainWindow>

#include <algorithm>
#include <utility>
#include <vector>

namespace dewpoint::ui {

namespace {

/// More answers do not fit in the message; the dialog shows all devices.
constexpr std::size_t kMostAnswers = 3;

bool hasDevices(const Project& project) {
  return std::ranges::any_of(project.cameras, [](const ProjectCamera& camera) {
    return camera.source == SourceKind::Device;
  });
}

} // namespace

DeviceQuestion::DeviceQuestion(const Workbench& bench, DeviceWatch& watch, CameraEdits& edits)
    : QObject(&bench.window), bench_(bench), watch_(watch), edits_(edits) {
  connect(&bench_.document, &Document::projectReplaced, this, [this] {
    asked_.clear();
    missing_.clear();
    isFirst_ = true;
    withdraw();
    if (hasDevices(bench_.document.project())) {
      watch_.start();
    }
    update();
  });
  connect(&bench_.document, &Document::sourcesChanged, this, &DeviceQuestion::update);
  connect(&watch_, &DeviceWatch::changed, this, &DeviceQuestion::update);
}

void DeviceQuestion::update() {
  const Project& project = bench_.document.project();
  if (!watch_.areDevicesListed() || !hasDevices(project)) {
    withdraw();
    return;
  }
  const auto matches = matchProjectDevices(project, watch_.devices());
  const bool isFirst = std::exchange(isFirst_, false);
  for (std::size_t k = 0; isFirst && k < matches.size(); ++k) {
    if (matches[k].isMissing()) {
      missing_.insert(project.cameras[k].camera.name);
    }
  }
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const ProjectCamera& camera = project.cameras[k];
    if (camera.source != SourceKind::Device) {
      continue;
    }
    if (matches[k].deviceIndex) {
      if (camera.camera.name == camera_) {
        withdraw();
      }
      continue;
    }
    // A device that is unplugged later is expected back.
    const bool isDue = matches[k].isAmbiguous() || missing_.contains(camera.camera.name);
    if (isDue && !camera.device.identity.isEmpty() && question_.isEmpty() &&
        !asked_.contains(camera.camera.name)) {
      ask(static_cast<int>(k), matches[k]);
    }
  }
}

void DeviceQuestion::ask(int camera, const capture::DeviceMatch& match) {
  const Project& project = bench_.document.project();
  const ProjectCamera& asked = project.cameras[static_cast<std::size_t>(camera)];
  const capture::CameraDevices& devices = watch_.devices();
  std::vector<std::size_t> candidates = match.candidateIndices;
  if (candidates.empty()) {
    for (std::size_t k = 0; k < devices.size(); ++k) {
      const auto all = matchProjectDevices(project, devices);
      const bool isUsed =
          std::ranges::any_of(all, [k](const auto& other) { return other.deviceIndex == k; });
      if (!isUsed && devices[k].problem.empty()) {
        candidates.push_back(k);
      }
    }
  }
  std::vector<MessageBar::Answer> answers;
  for (std::size_t k = 0; k < std::min(candidates.size(), kMostAnswers); ++k) {
    const capture::CameraDevice& device = devices[candidates[k]];
    answers.push_back({tr("Use %1").arg(QString::fromStdString(describe(device.identity))),
                       [this, name = asked.camera.name, source = sourceOf(device)] {
                         question_.clear();
                         const auto& all = bench_.document.project().cameras;
                         const auto found =
                             std::ranges::find_if(all, [&](const ProjectCamera& one) {
                               return one.camera.name == name;
                             });
                         if (found != all.end()) {
                           edits_.replace(static_cast<int>(found - all.begin()), source);
                         }
                       }});
  }
  answers.push_back({tr("Cameras…"), [this] {
                       question_.clear();
                       bench_.action("actionCameras")->trigger();
                     }});
  const QString device = QString::fromStdString(describe(asked.device.identity));
  const QString name = bench_.cameras.nameOf(camera);
  asked_.insert(asked.camera.name);
  camera_ = asked.camera.name;
  question_ =
      match.isAmbiguous()
          ? tr("Several devices may be the camera %1 (%2). Which one is it?").arg(name, device)
          : tr("The device of the camera %1 is not connected: %2. Plug it in, or choose "
               "another one.")
                .arg(name, device);
  bench_.messages.showLastingQuestion(question_, answers);
}

void DeviceQuestion::withdraw() {
  if (!question_.isEmpty()) {
    bench_.messages.withdrawQuestion(std::exchange(question_, {}));
    camera_.clear();
  }
}

} // namespace dewpoint::ui
