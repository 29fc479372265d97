// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <QString>
#include <QStringList>

#include <cstddef>
#include <string>

namespace dewpoint::ui {

/// What a camera is called everywhere in the window: its name, or "camera 2" for number 1 where it
/// has none.
QString cameraName(const std::string& name, std::size_t camera);
QString cameraName(const CameraRig& rig, std::size_t camera);
QStringList cameraNames(const CameraRig& rig);

} // namespace dewpoint::ui
