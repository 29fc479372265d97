// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QImage>

#include <filesystem>

class QWidget;

namespace dewpoint::ui {

/// A view as it is shown now, in device pixels; the bird's-eye view without its buttons.
QImage pictureOf(QWidget* view);

/// Writes a picture as PNG, beside and renamed. Any thread.
Status writePicture(const QImage& picture, const std::filesystem::path& file);

} // namespace dewpoint::ui
