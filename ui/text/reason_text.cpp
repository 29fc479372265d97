// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/reason_text.h"

#include "core/tracking/catalog/method_catalog.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

namespace {

QString say(const char* text) {
  return QCoreApplication::translate("Reason", text);
}

} // namespace

HoldState holdState(TargetStatus status) {
  return status == TargetStatus::Held   ? HoldState::Held
         : status == TargetStatus::Lost ? HoldState::Lost
         : status == TargetStatus::Gone ? HoldState::Gone
                                        : HoldState::Searching;
}

HoldState holdState(const TargetSnapshot& target, TargetsFrom targets) {
  if (targets != TargetsFrom::Box) {
    return holdState(target.status);
  }
  if (target.box() == nullptr) {
    return HoldState::NoBox;
  }
  return target.status == TargetStatus::Searching ? HoldState::Hidden : holdState(target.status);
}

namespace {

HoldState stateOfPeople(const TrackSnapshot& snapshot) {
  if (std::ranges::any_of(snapshot.peopleCameras,
                          [](const auto& camera) { return camera.learned < 1.0; })) {
    return HoldState::Learning;
  }
  HoldState state = HoldState::Nobody;
  for (const TargetSnapshot& target : snapshot.targets) {
    if (target.status == TargetStatus::Searching) {
      return HoldState::Searching;
    }
    state = target.status == TargetStatus::Held ? HoldState::Held : state;
  }
  return state;
}

/// Of the targets that count; without any of them there is no box.
template <class Counts> HoldState worstState(const TrackSnapshot& snapshot, const Counts& counts) {
  if (!snapshot.frames) {
    return HoldState::NoImages;
  }
  if (snapshot.targets.empty() && !snapshot.family.findsTargets()) {
    return HoldState::NoTarget;
  }
  if (snapshot.past && !snapshot.tracked) {
    return HoldState::NotTracked;
  }
  if (snapshot.family.findsTargets()) {
    return stateOfPeople(snapshot);
  }
  for (const HoldState state :
       {HoldState::Lost, HoldState::Searching, HoldState::Hidden, HoldState::Held}) {
    if (std::ranges::any_of(snapshot.targets, [&](const TargetSnapshot& target) {
          return counts(target) && holdState(target, snapshot.family.targets) == state;
        })) {
      return state;
    }
  }
  return HoldState::NoBox;
}

} // namespace

HoldState holdState(const TrackSnapshot& snapshot) {
  return worstState(snapshot, [](const TargetSnapshot&) { return true; });
}

HoldState holdState(const TrackSnapshot& snapshot, int camera) {
  if (snapshot.family.targets != TargetsFrom::Box) {
    return holdState(snapshot);
  }
  return worstState(snapshot, [camera](const TargetSnapshot& target) {
    const BoxEstimate* box = target.box();
    return box != nullptr ? box->camera == camera
                          : target.target.box && target.target.box()->camera == camera;
  });
}

QString troubleText(const CameraReport& report) {
  const int pixels = std::max(1, static_cast<int>(std::lround(report.pixels)));
  switch (report.trouble) {
  case CameraStatus::None:
    break;
  case CameraStatus::NoImage:
    return say(QT_TRANSLATE_NOOP("Reason", "no image"));
  case CameraStatus::Covered:
    return say(QT_TRANSLATE_NOOP("Reason", "covered or moved"));
  case CameraStatus::Dark:
    return say(QT_TRANSLATE_NOOP("Reason", "too dark"));
  case CameraStatus::OutOfView:
    return say(QT_TRANSLATE_NOOP("Reason", "out of view"));
  case CameraStatus::PartlyHidden:
    return say(QT_TRANSLATE_NOOP("Reason", "partly hidden"));
  case CameraStatus::Hidden:
    return say(QT_TRANSLATE_NOOP("Reason", "hidden"));
  case CameraStatus::LookAlike:
    return report.pixels < 1.0
               ? say(QT_TRANSLATE_NOOP("Reason", "at a look-alike"))
               : say(QT_TRANSLATE_NOOP("Reason", "%1 px beside a look-alike")).arg(pixels);
  case CameraStatus::NoColor:
    return say(QT_TRANSLATE_NOOP("Reason", "no color matches"));
  case CameraStatus::Elsewhere:
    return say(QT_TRANSLATE_NOOP("Reason", "its color is %1 px away")).arg(pixels);
  case CameraStatus::Unclear:
    return say(QT_TRANSLATE_NOOP("Reason", "its color, but not its shape"));
  }
  return {};
}

QString reasonText(const std::vector<CameraReport>& reports, const QStringList& cameraNames) {
  QStringList parts;
  for (std::size_t k = 0; k < reports.size(); ++k) {
    const QString trouble = troubleText(reports[k]);
    if (!trouble.isEmpty()) {
      parts.append(QStringLiteral("%1: %2").arg(cameraNames.value(static_cast<int>(k)), trouble));
    }
  }
  return parts.join(QStringLiteral(" · "));
}

QStringList cameraNames(const TrackSnapshot& snapshot) {
  QStringList names;
  for (std::size_t k = 0; snapshot.rig && k < snapshot.rig->size(); ++k) {
    const QString name = QString::fromStdString((*snapshot.rig)[k].name);
    names.append(name.isEmpty() ? say(QT_TRANSLATE_NOOP("Reason", "camera %1")).arg(k + 1) : name);
  }
  return names;
}

const TargetSnapshot* targetToExplain(const TrackSnapshot& snapshot, int preferred) {
  const auto& targets = snapshot.targets;
  if (targets.empty()) {
    return nullptr;
  }
  if (preferred >= 0 && preferred < static_cast<int>(targets.size())) {
    return &targets[static_cast<std::size_t>(preferred)];
  }
  const auto lost = std::ranges::find_if(targets, [](const auto& target) {
    return target.status != TargetStatus::Held && target.status != TargetStatus::Gone;
  });
  const auto held = std::ranges::find(targets, TargetStatus::Held, &TargetSnapshot::status);
  return lost != targets.end() ? &*lost : held != targets.end() ? &*held : &targets.front();
}

} // namespace dewpoint::ui
