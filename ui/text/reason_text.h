// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot_state.h"

#include <QString>
#include <QStringList>

namespace dewpoint::ui {

/// Returns the reason why a camera does not confirm a target, in a few words ("hidden"), or an
/// empty string if the camera confirms it.
QString cameraReasonText(const CameraReport& report);
/// Returns the reason why a camera does not confirm a target, in the form shown with the image of
/// this camera ("hidden here").
QString cameraReasonTextInImage(const CameraReport& report);
/// Returns whether a camera does not see the target at all although it has an image.
bool isCameraBlind(const CameraReport& report);
/// Returns the text that replaces the target state in the view of a camera for which
/// isCameraBlind() is true: "◌ hidden here".
QString cameraBlindText(const CameraReport& report);
/// Returns the reasons of all cameras in one sentence: "left: hidden · right: …". Returns an empty
/// string if all cameras confirm the target.
QString reasonText(const std::vector<CameraReport>& reports, const QStringList& cameraNames);
/// Returns the names of the cameras in a snapshot as the window shows them; a camera without a name
/// has a numbered name ("camera 2").
QStringList cameraNames(const TrackSnapshot& snapshot);

} // namespace dewpoint::ui
