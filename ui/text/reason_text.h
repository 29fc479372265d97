// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"
#include "ui/style/theme.h"

#include <QString>
#include <QStringList>

namespace dewpoint::ui {

/// The state a view shows for a target's status.
HoldState holdState(TargetStatus status);
/// The same, and where boxes are followed whether it is hidden or has no box yet.
HoldState holdState(const TargetSnapshot& target, TargetsFrom targets);
/// The worst of all targets: lost, searching, held; nothing to say without targets or images.
HoldState holdState(const TrackSnapshot& snapshot);
/// The same of one camera: a box is followed in the camera of the box only.
HoldState holdState(const TrackSnapshot& snapshot, int camera);
/// Why one camera does not confirm a target, in a few words ("hidden"); empty when it does.
QString troubleText(const CameraReport& report);
/// All cameras in one sentence: "left: hidden · right: 3 px beside a look-alike"; empty when none
/// has any trouble.
QString reasonText(const std::vector<CameraReport>& reports, const QStringList& cameraNames);
/// Names of a snapshot's cameras, "camera 2" where there is none.
QStringList cameraNames(const TrackSnapshot& snapshot);
/// The target whose reasons are worth saying: `preferred` if it exists, else the first that is not
/// held, else the first; null without any.
const TargetSnapshot* targetToExplain(const TrackSnapshot& snapshot, int preferred);

} // namespace dewpoint::ui
