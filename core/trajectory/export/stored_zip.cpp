// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/export/stored_zip.h"

#include "core/trajectory/export/binary_text.h"

#include <array>
#include <limits>

namespace dewpoint::trajectory {
namespace {

constexpr std::uint16_t kVersion = 20;
constexpr std::uint16_t kFirstDate = 0x0021; // 1980-01-01

std::array<std::uint32_t, 256> crcTable() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < table.size(); ++byte) {
    std::uint32_t value = byte;
    for (int bit = 0; bit < 8; ++bit) {
      value = (value & 1U) != 0U ? 0xEDB88320U ^ (value >> 1U) : value >> 1U;
    }
    table[byte] = value;
  }
  return table;
}

std::uint32_t sizeOf(std::string_view bytes) {
  return static_cast<std::uint32_t>(bytes.size());
}

/// What the local header and the central directory say alike of an entry.
void putCommon(std::string& archive, const ZipEntry& entry) {
  putLittleEndian(archive, kVersion);
  putLittleEndian(archive, std::uint16_t{0}); // flags
  putLittleEndian(archive, std::uint16_t{0}); // method: stored
  putLittleEndian(archive, std::uint16_t{0}); // time
  putLittleEndian(archive, kFirstDate);
  putLittleEndian(archive, crc32(entry.bytes));
  putLittleEndian(archive, sizeOf(entry.bytes)); // compressed
  putLittleEndian(archive, sizeOf(entry.bytes));
  putLittleEndian(archive, static_cast<std::uint16_t>(entry.name.size()));
  putLittleEndian(archive, std::uint16_t{0}); // extra field
}

} // namespace

std::uint32_t crc32(std::string_view bytes) {
  static const std::array<std::uint32_t, 256> table = crcTable();
  std::uint32_t value = 0xFFFFFFFFU;
  for (const char c : bytes) {
    value = table[(value ^ static_cast<unsigned char>(c)) & 0xFFU] ^ (value >> 8U);
  }
  return value ^ 0xFFFFFFFFU;
}

Result<std::string> uncompressedZip(const std::vector<ZipEntry>& entries) {
  std::size_t total = 0;
  for (const ZipEntry& entry : entries) {
    total += entry.bytes.size() + 2 * entry.name.size() + 128;
  }
  if (total > std::numeric_limits<std::uint32_t>::max() || entries.size() > 0xFFFFU) {
    return failure(ErrorCode::BadValue, "", "span", "more than 4 GiB do not fit into one file");
  }
  std::string archive;
  archive.reserve(total);
  std::string directory;
  for (const ZipEntry& entry : entries) {
    putLittleEndian(directory, std::uint32_t{0x02014B50});
    putLittleEndian(directory, kVersion); // made by
    putCommon(directory, entry);
    putLittleEndian(directory, std::uint16_t{0}); // comment
    putLittleEndian(directory, std::uint16_t{0}); // disk
    putLittleEndian(directory, std::uint16_t{0}); // internal attributes
    putLittleEndian(directory, std::uint32_t{0}); // external attributes
    putLittleEndian(directory, sizeOf(archive));  // where it begins
    directory += entry.name;
    putLittleEndian(archive, std::uint32_t{0x04034B50});
    putCommon(archive, entry);
    archive += entry.name;
    archive += entry.bytes;
  }
  const std::uint32_t begin = sizeOf(archive);
  archive += directory;
  putLittleEndian(archive, std::uint32_t{0x06054B50});
  putLittleEndian(archive, std::uint32_t{0}); // disks
  putLittleEndian(archive, static_cast<std::uint16_t>(entries.size()));
  putLittleEndian(archive, static_cast<std::uint16_t>(entries.size()));
  putLittleEndian(archive, sizeOf(directory));
  putLittleEndian(archive, begin);
  putLittleEndian(archive, std::uint16_t{0}); // comment
  return archive;
}

} // namespace dewpoint::trajectory
