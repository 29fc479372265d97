// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/color/color_sample.h"
#include "core/project/project.h"

#include <string>

namespace dewpoint::app {

/// The camera meant by a name, or by its number in the project, from 1. BadValue names `option`.
Result<int> cameraNamed(const Project& project, const std::string& text, const char* option);

/// A click "X,Y". BadValue names `option`.
Result<ColorSample> clickFrom(const std::string& text, const char* option);

/// A box "X,Y,WIDTH,HEIGHT". BadValue names `option`.
Result<ColorSample> boxFrom(const std::string& text, const char* option);

/// A click elsewhere "CAMERA:FRAME:X,Y". BadValue names `option`.
Result<ColorSample> sampleFrom(const Project& project, const std::string& text, const char* option);

} // namespace dewpoint::app
