// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <QString>
#include <QStringList>

#include <cstddef>
#include <string>

namespace dewpoint::ui {

/// Returns the name of a camera as the window shows it: its own name or, if it has none, a numbered
/// name ("camera 2" for index 1).
QString cameraName(const std::string& name, std::size_t camera);
QString cameraName(const CameraRig& rig, std::size_t camera);
/// Returns the names of all cameras in a rig, in rig order.
QStringList cameraNames(const CameraRig& rig);

} // namespace dewpoint::ui
