// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>
#include <string_view>

namespace dewpoint::capture {

/// Location of a camera without its secrets, to be shown, logged and written into results. Three
/// stars replace the password of a network address (`rtsp://user:***@host/`) and the values of
/// options whose names suggest a secret (`token`, `passphrase`, `user-pw`, ...), also within a
/// GStreamer pipeline. Paths and device numbers are unchanged.
std::string shownLocation(std::string_view location);

} // namespace dewpoint::capture
