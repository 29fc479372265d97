// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/color/color_sample.h"
#include "core/project/project.h"

#include <string>

namespace dewpoint::app {

/// Returns the index, counted from 0, of a camera given by its name or by its number in the
/// project, counted from 1. Returns BadValue, which names `option`, if there is no such camera.
Result<int> findCameraIndex(const Project& project, const std::string& text, const char* option);

/// Parses a click "X,Y" (pixels). Returns BadValue, which names `option`, if the text is invalid.
Result<ColorSample> parseClick(const std::string& text, const char* option);

/// Parses a box "X,Y,WIDTH,HEIGHT" (pixels). Returns BadValue, which names `option`, if the text is
/// invalid.
Result<ColorSample> parseBox(const std::string& text, const char* option);

/// Parses a click in an image of any camera and frame, "CAMERA:FRAME:X,Y". Returns BadValue, which
/// names `option`, if the text is invalid.
Result<ColorSample> parseSample(const Project& project, const std::string& text,
                                const char* option);

} // namespace dewpoint::app
