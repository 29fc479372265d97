// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

namespace dewpoint::session {
struct ReplayComparison;
struct TakeStatus;
} // namespace dewpoint::session

namespace dewpoint::ui {

/// Returns one line about a take (a recording of all cameras): its number, its duration, the
/// dropped images, and the free disk space.
QString takeSummaryText(const TakeStatus& take);
/// Returns one line for each camera of a take (a recording of all cameras): recorded images, frame
/// rate and dropped images.
QString takeDetailsText(const TakeStatus& take);
/// Returns a text about how much was recorded from before the start of a take (a recording of all
/// cameras), and whether memory limited this; empty if nothing was recorded.
QString preRollText(const TakeStatus& take);
/// Returns sentences about whether tracking a recording again gives the same results as the live
/// run did.
QString replayText(const ReplayComparison& comparison);
/// Returns a sentence about the first problem that occurred during a recording; empty if there was
/// none.
QString takeProblemText(const TakeStatus& take);

} // namespace dewpoint::ui
