// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"

#include <QString>

#include <optional>

namespace dewpoint::ui {

/// Share of the background that a camera has learned, 0 to 1; nothing if it is not learning.
std::optional<double> learningOf(const TrackSnapshot& snapshot, int camera);
/// Returns the learning progress in percent and the request to keep out of view.
QString learningText(double share);
/// Returns the short form: "learning: 60 %".
QString shortLearningText(double share);
/// Returns what keeps a camera from detecting people (it is learning, or too much moves); empty:
/// nothing.
QString peopleObstacleText(const TrackSnapshot& snapshot, int camera);
/// Number of people present in the frame shown.
int peopleThere(const TrackSnapshot& snapshot);

} // namespace dewpoint::ui
