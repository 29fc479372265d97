// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot_state.h"

#include <QString>
#include <QStringList>

namespace dewpoint::ui {

/// Why one camera does not confirm a target, in a few words ("hidden"); empty when it does.
QString cameraReasonText(const CameraReport& report);
/// The same where it stands with the image of that camera ("hidden here").
QString cameraReasonHereText(const CameraReport& report);
/// Whether a camera with this reason does not see the target at all, though it has an image.
bool isBlind(const CameraReport& report);
/// What such a camera's image says in place of the target's state: "◌ hidden here".
QString cameraBlindText(const CameraReport& report);
/// All cameras in one sentence: "left: hidden · right: 3 px beside a look-alike"; empty when none
/// has any trouble.
QString reasonText(const std::vector<CameraReport>& reports, const QStringList& cameraNames);
/// Names of a snapshot's cameras, see cameraName().
QStringList cameraNames(const TrackSnapshot& snapshot);

} // namespace dewpoint::ui
