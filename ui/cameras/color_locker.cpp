// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameras/color_locker.h"

#include "core/project/project.h"
#include "core/setup/connected_cameras.h"
#include "core/setup/new_project/project_devices.h"
#include "ui/cameras/camera_device_text.h"
#include "ui/cameras/camera_edits.h"
#include "ui/cameras/device_watch.h"
#include "ui/document/camera_list_model.h"
#include "ui/document/document.h"
#include "ui/text/error_sentence.h"
#include "ui/widgets/message_bar.h"

#include <QMainWindow>
#include <QUndoStack>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

namespace dewpoint::ui {

namespace {

std::size_t sampleCount(const Project& project) {
  std::size_t count = 0;
  for (const Target& target : project.targets) {
    count += target.samples.size();
  }
  return count;
}

/// What happened to one camera whose colors were locked.
struct LockOutcome {
  int camera = 0;
  QString name;
  std::string path;
  std::vector<capture::DeviceControl> before; ///< its controls
  Result<capture::ColorLock> lock;
};

/// What a camera does not do, as a sentence; empty if it does all.
QString complaintAbout(const LockOutcome& outcome) {
  std::vector<capture::ColorAutomatic> refused;
  for (const auto& refusal : outcome.lock->refusals) {
    if (std::ranges::find(refused, refusal.adjustment) == refused.end()) {
      refused.push_back(refusal.adjustment);
    }
  }
  QString text;
  if (!refused.empty()) {
    text = ColorLocker::tr("These settings of %1 cannot be locked: %2.")
               .arg(outcome.name, colorAutomaticsText(refused));
  }
  if (!outcome.lock->missingControls.empty()) {
    text += (text.isEmpty() ? QString() : QStringLiteral(" ")) +
            ColorLocker::tr(
                "%1 has no control for these settings and may change them automatically: %2.")
                .arg(outcome.name, colorAutomaticsText(outcome.lock->missingControls));
  }
  return text;
}

} // namespace

ColorLocker::ColorLocker(const Workbench& bench, DeviceWatch& watch, CameraEdits& edits)
    : QObject(&bench.window), bench_(bench), watch_(watch), edits_(edits),
      job_(new BackgroundJob(this)), question_(new BackgroundJob(this)) {
  connect(job_, &BackgroundJob::started, this, &ColorLocker::busyChanged);
  connect(job_, &BackgroundJob::ended, this, &ColorLocker::busyChanged);
  connect(&bench_.document, &Document::projectReplaced, this, [this] {
    samples_ = sampleCount(bench_.document.project());
    offered_ = false;
  });
  connect(&bench_.document, &Document::targetsChanged, this, [this] {
    const std::size_t before = std::exchange(samples_, sampleCount(bench_.document.project()));
    const QUndoStack* steps = bench_.document.undoStack();
    if (samples_ > before && steps->index() == steps->count()) { // learned, not redone
      considerOffer();
    }
  });
}

std::vector<ColorLocker::ProjectDevice> ColorLocker::devices(int camera) const {
  std::vector<ProjectDevice> found;
  const auto matches = matchProjectDevices(bench_.document.project(), watch_.devices());
  for (int k = 0; k < static_cast<int>(matches.size()); ++k) {
    const auto& device = matches[static_cast<std::size_t>(k)].deviceIndex;
    if (device && (camera < 0 || camera == k)) {
      found.push_back({k, bench_.cameras.nameOf(k), watch_.devices()[*device].path});
    }
  }
  return found;
}

void ColorLocker::lockColors(int camera) {
  const auto chosen = devices(camera);
  if (chosen.empty()) {
    Q_EMIT failed(tr("Only cameras that are connected to this computer can be locked. For network "
                     "cameras, use their own settings."));
    return;
  }
  job_->start([this, chosen, access = watch_.deviceAccess(),
               project = bench_.document.sharedProject()](const BackgroundJob::Progress&) {
    auto outcomes = std::make_shared<std::vector<LockOutcome>>();
    for (const ProjectDevice& one : chosen) {
      auto before = access->readControls(one.devicePath);
      outcomes->push_back({one.camera, one.cameraName, one.devicePath,
                           before ? std::move(*before) : std::vector<capture::DeviceControl>(),
                           capture::lockColors(*access, one.devicePath)});
    }
    return [this, outcomes, project] {
      if (bench_.document.project().cameras.size() != project->cameras.size()) {
        return; // other cameras by now
      }
      std::map<int, capture::ControlValues> values;
      QStringList names;
      QStringList complaints;
      for (const LockOutcome& outcome : *outcomes) {
        if (!outcome.lock) {
          complaints << errorText(outcome.lock.error());
          continue;
        }
        Q_EMIT lockingStarted(outcome.path, outcome.before);
        values[outcome.camera] = outcome.lock->values;
        names << outcome.name;
        if (const QString complaint = complaintAbout(outcome); !complaint.isEmpty()) {
          complaints << complaint;
        }
      }
      edits_.lockColors(values);
      if (names.isEmpty()) {
        Q_EMIT failed(complaints.join(QLatin1Char(' ')));
      } else {
        complaints.prepend(tr("The color settings of these cameras are now locked: %1.")
                               .arg(names.join(QStringLiteral(", "))));
        Q_EMIT completed(complaints.join(QLatin1Char(' ')));
      }
    };
  });
}

void ColorLocker::considerOffer() {
  const auto cameras = devices(-1);
  if (offered_ || cameras.empty()) {
    return;
  }
  question_->start([this, cameras, access = watch_.deviceAccess()](const BackgroundJob::Progress&) {
    QStringList automatic;
    for (const ProjectDevice& one : cameras) {
      const auto controls = access->readControls(one.devicePath);
      if (controls && !automaticsOn(*controls).empty()) {
        automatic << tr("%1 (%2)").arg(one.cameraName,
                                       colorAutomaticsText(automaticsOn(*controls)));
      }
    }
    return [this, automatic] {
      if (!automatic.isEmpty()) {
        offer(automatic.join(QStringLiteral(", ")));
      }
    };
  });
}

void ColorLocker::offer(const QString& cameras) {
  offered_ = true;
  bench_.messages.showLastingQuestion(
      tr("These cameras adjust their colors automatically: %1. The learned color may no longer "
         "fit when the light changes.")
          .arg(cameras),
      {{tr("Lock colors"), [this] { lockColors(-1); }}});
}

} // namespace dewpoint::ui
