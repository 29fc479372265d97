// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>
#include <string_view>

namespace dewpoint::capture {

/// Returns the location of a camera without secrets, for display, logs and results. In network
/// addresses and GStreamer pipelines, three asterisks replace passwords (`rtsp://user:***@host/`)
/// and the values of options whose names suggest a secret (`token`, `passphrase`, `user-pw`, ...).
/// Paths and device numbers are unchanged.
std::string redactedLocation(std::string_view location);

} // namespace dewpoint::capture
