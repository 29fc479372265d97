// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"

#include <QString>

#include <optional>

namespace dewpoint::ui {

/// Returns the fraction of the background that a camera has learned (0 to 1), or nothing if it is
/// not learning.
std::optional<double> learnedBackgroundShare(const TrackSnapshot& snapshot, int camera);
/// Returns a text about the progress of learning the background, with a request to stay out of
/// view. `share` is 0 to 1.
QString backgroundLearningText(double share);
/// Returns a short text about the progress of learning the background, for example "learning: 60
/// %". `share` is 0 to 1.
QString shortBackgroundLearningText(double share);
/// Returns the reason why a camera cannot detect people (it is learning, or too much is moving), or
/// an empty string if it can.
QString peopleObstacleText(const TrackSnapshot& snapshot, int camera);
/// Returns the number of people present in the frame shown.
int peopleCount(const TrackSnapshot& snapshot);

} // namespace dewpoint::ui
