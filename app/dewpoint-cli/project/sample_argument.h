// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/color/color_sample.h"
#include "core/project/project.h"

#include <string>

namespace dewpoint::app {

/// Returns the index of a camera given by its name or by its number in the project, counted from 1.
/// The error BadValue names `option`.
Result<int> findCameraIndex(const Project& project, const std::string& text, const char* option);

/// Parses a click "X,Y" (pixels). The error BadValue names `option`.
Result<ColorSample> parseClick(const std::string& text, const char* option);

/// Parses a box "X,Y,WIDTH,HEIGHT" (pixels). The error BadValue names `option`.
Result<ColorSample> parseBox(const std::string& text, const char* option);

/// Parses a click in another image, "CAMERA:FRAME:X,Y". The error BadValue names `option`.
Result<ColorSample> parseSample(const Project& project, const std::string& text,
                                const char* option);

} // namespace dewpoint::app
