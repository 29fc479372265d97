// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

namespace dewpoint::session {
struct ReplayComparison;
struct TakeStatus;
} // namespace dewpoint::session

namespace dewpoint::ui {

/// Returns one line: number of the take, its duration, dropped images, and the disk space left.
QString takeLine(const TakeStatus& take);
/// Returns one line for each camera: images, rate and dropped images.
QString takeDetails(const TakeStatus& take);
/// Returns how much was recorded before the start of a take, and whether memory limited it; empty
/// if nothing was.
QString preRollText(const TakeStatus& take);
/// Returns the sentences that tell how a take compares with the live run (describeReplay()).
QString replayText(const ReplayComparison& comparison);
/// Returns the first problem of a take as a sentence; empty if there is none.
QString takeProblem(const TakeStatus& take);
/// Returns a duration as minutes and seconds, or hours, minutes and seconds: "0:07", "1:02:03".
QString clockText(double seconds);

} // namespace dewpoint::ui
