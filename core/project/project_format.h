// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <array>
#include <cstdint>
#include <utility>

namespace dewpoint::project {

/// The version of the project file that this program writes.
inline constexpr std::int64_t kProjectFormat = 2;

/// The key of a camera's source in the project file.
inline constexpr std::array<std::pair<const char*, SourceKind>, 4> kSourceKeys{{
    {"video", SourceKind::Video},
    {"images", SourceKind::Images},
    {"device", SourceKind::Device},
    {"stream", SourceKind::Stream},
}};

/// The largest delay of a camera, seconds.
inline constexpr double kLatest = 3600.0;

} // namespace dewpoint::project
