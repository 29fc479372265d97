// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <array>
#include <cstdint>
#include <utility>

namespace dewpoint::project {

/// Version of the project file format that this program writes.
inline constexpr std::int64_t kProjectFormat = 2;

/// Key in the project file for each kind of camera source.
inline constexpr std::array<std::pair<const char*, SourceKind>, 4> kSourceKeys{{
    {"video", SourceKind::Video},
    {"images", SourceKind::Images},
    {"device", SourceKind::Device},
    {"stream", SourceKind::Stream},
}};

/// Largest allowed absolute value of a camera's delay, in seconds.
inline constexpr double kMaxDelay = 3600.0;

/// Largest allowed target radius, in meters.
inline constexpr double kLargestRadius = 1000.0;

} // namespace dewpoint::project
