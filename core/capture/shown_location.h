// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>
#include <string_view>

namespace dewpoint::capture {

/// The location of a camera as it may be shown, logged and written into results: the password of a
/// network address (`rtsp://user:***@host/`) and the values of options that are secrets by their
/// name (`token`, `passphrase`, `user-pw`, ...) are replaced by three stars, also within a
/// GStreamer pipeline. Paths and device numbers stay as they are.
std::string shownLocation(std::string_view location);

} // namespace dewpoint::capture
