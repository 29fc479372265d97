// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot_state.h"

#include <QString>
#include <QStringList>

namespace dewpoint::ui {

/// Returns why a camera does not confirm a target, in a few words ("hidden"); empty if it does.
QString cameraReasonText(const CameraReport& report);
/// Returns the reason in the form shown with the image of that camera ("hidden here").
QString cameraReasonHereText(const CameraReport& report);
/// Whether a camera with this reason does not see the target at all, although it has an image.
bool isBlind(const CameraReport& report);
/// Returns the text shown for such a camera instead of the state of the target: "◌ hidden here".
QString cameraBlindText(const CameraReport& report);
/// Returns the reasons of all cameras in one sentence: "left: hidden · right: …"; empty if all
/// cameras confirm the target.
QString reasonText(const std::vector<CameraReport>& reports, const QStringList& cameraNames);
/// Names of the cameras of a snapshot, see cameraName().
QStringList cameraNames(const TrackSnapshot& snapshot);

} // namespace dewpoint::ui
