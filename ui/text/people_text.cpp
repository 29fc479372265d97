// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/people_text.h"

#include "core/session/snapshot/snapshot_state.h"
#include "ui/text/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

namespace {

const PeopleCameraState* stateOf(const TrackSnapshot& snapshot, int camera) {
  const auto index = static_cast<std::size_t>(camera);
  const bool known = camera >= 0 && index < snapshot.peopleCameras.size();
  return known ? &snapshot.peopleCameras[index] : nullptr;
}

} // namespace

std::optional<double> learnedBackgroundShare(const TrackSnapshot& snapshot, int camera) {
  const PeopleCameraState* state = stateOf(snapshot, camera);
  return state != nullptr && state->learningProgress < 1.0 ? std::optional(state->learningProgress)
                                                           : std::nullopt;
}

QString backgroundLearningText(double share) {
  return QCoreApplication::translate("People", "learning background: %1 % · keep the scene empty")
      .arg(percentNumber(share));
}

QString shortBackgroundLearningText(double share) {
  return QCoreApplication::translate("People", "learning: %1 %").arg(percentNumber(share));
}

QString peopleObstacleText(const TrackSnapshot& snapshot, int camera) {
  if (const auto share = learnedBackgroundShare(snapshot, camera)) {
    return backgroundLearningText(*share);
  }
  const PeopleCameraState* state = stateOf(snapshot, camera);
  if (state == nullptr || state->isUsable || state->foregroundFraction <= 0.0) {
    return {};
  }
  return QCoreApplication::translate("People", "image ignored: %1 % of it is moving")
      .arg(percentNumber(state->foregroundFraction));
}

int peopleCount(const TrackSnapshot& snapshot) {
  return static_cast<int>(peopleIn(snapshot).size());
}

} // namespace dewpoint::ui
