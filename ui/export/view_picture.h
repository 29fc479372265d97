// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QImage>

#include <filesystem>

class QWidget;

namespace dewpoint::ui {

/// Returns an image of a view as currently shown, in device pixels. The bird's-eye view is drawn
/// without its buttons.
QImage grabView(QWidget* view);

/// Writes an image as PNG, to a temporary file that is then renamed. May be called from any thread.
Status writePng(const QImage& picture, const std::filesystem::path& file);

} // namespace dewpoint::ui
