// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

class QPainter;
class QRectF;

namespace dewpoint::ui {

/// Says in the lower right corner of an image how large its pixels are shown, in widget units;
/// returns where it stands.
QRectF paintZoomLabel(QPainter& painter, const QRectF& area, double scale);

} // namespace dewpoint::ui
