// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"

#include <QString>

#include <optional>

namespace dewpoint::ui {

/// How much of the background a camera has learned, 0 to 1; nothing when it is not learning.
std::optional<double> learningOf(const TrackSnapshot& snapshot, int camera);
/// "learning the empty room: 60 % · keep out of view".
QString learningText(double share);
/// The same where there is little room: "learning: 60 %".
QString shortLearningText(double share);
/// What keeps a camera from detecting people: learning, or too much moves; empty: nothing.
QString peopleObstacleText(const TrackSnapshot& snapshot, int camera);
/// How many people are there in the frame shown.
int peopleThere(const TrackSnapshot& snapshot);

} // namespace dewpoint::ui
