// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::trajectory {

/// A file in an archive.
struct ZipEntry {
  std::string name;
  std::string bytes;
};

/// Returns the CRC-32 used by ZIP (ISO 3309, polynomial 0xEDB88320 reflected).
std::uint32_t crc32(std::string_view bytes);

/// Returns a ZIP archive without compression (APPNOTE 6.3). Entries are dated 1980-01-01, so the
/// same content gives identical bytes. Returns BadValue for more than 4 GiB or more than 65,535
/// entries.
Result<std::string> uncompressedZip(const std::vector<ZipEntry>& entries);

} // namespace dewpoint::trajectory
