// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/export/binary_text.h"
#include "core/trajectory/export/export_encoders.h"
#include "core/trajectory/export/stored_zip.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dewpoint::trajectory::encoders {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The head of an array file, format 1.0: padded so that the data begin at a multiple of 64.
std::string arrayHead(const std::string& type, const std::string& shape) {
  std::string description =
      fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", type, shape);
  constexpr std::size_t kFixed = 10;
  const std::size_t length = (kFixed + description.size() + 1 + 63) / 64 * 64 - kFixed;
  description.resize(length - 1, ' ');
  description += '\n';
  std::string bytes = "\x93NUMPY";
  bytes += '\1';
  bytes += '\0';
  putLittleEndian(bytes, static_cast<std::uint16_t>(description.size()));
  return bytes + description;
}

/// One code point of UTF-8 text from `k` on, which moves behind it; U+FFFD for a wrong byte.
std::uint32_t nextCodePoint(const std::string& text, std::size_t& k) {
  constexpr std::uint32_t kReplacement = 0xFFFD;
  const auto byteAt = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i]));
  };
  const std::uint32_t first = byteAt(k++);
  if (first < 0x80U) {
    return first;
  }
  const int more = first >= 0xF0U && first < 0xF8U ? 3
                   : first >= 0xE0U                ? 2
                   : first >= 0xC0U                ? 1
                                                   : 0;
  if (more == 0 || first >= 0xF8U) {
    return kReplacement;
  }
  std::uint32_t value = first & (0x3FU >> static_cast<unsigned>(more));
  for (int i = 0; i < more; ++i) {
    if (k >= text.size() || (byteAt(k) & 0xC0U) != 0x80U) {
      return kReplacement;
    }
    value = (value << 6U) | (byteAt(k++) & 0x3FU);
  }
  return value;
}

/// NumPy's fixed-width texts are UTF-32.
std::string textArray(const std::vector<std::string>& texts, const std::string& shape) {
  std::vector<std::vector<std::uint32_t>> all;
  std::size_t width = 1;
  for (const std::string& text : texts) {
    auto& points = all.emplace_back();
    for (std::size_t k = 0; k < text.size();) {
      points.push_back(nextCodePoint(text, k));
    }
    width = std::max(width, points.size());
  }
  std::string bytes = arrayHead(fmt::format("<U{}", width), shape);
  for (auto& points : all) {
    points.resize(width, 0);
    for (const std::uint32_t point : points) {
      putLittleEndian(bytes, point);
    }
  }
  return bytes;
}

/// An array with one value per row, or `perCell` per row and target.
template <class T, class Values>
std::string cellArray(const ExportTable& table, const char* type, const std::string& inner,
                      Values values) {
  std::string bytes =
      arrayHead(type, fmt::format("{}, {}{}", table.rowCount(), table.targets.size(), inner));
  for (std::size_t row = 0; row < table.rowCount(); ++row) {
    for (const auto& column : table.cells) {
      for (const T value : values(column[row])) {
        putLittleEndian(bytes, value);
      }
    }
  }
  return bytes;
}

std::array<double, 3> positionOfCell(const ExportCell& cell) {
  if (!cell.hasPosition) {
    return {kNaN, kNaN, kNaN};
  }
  return {cell.position.x(), cell.position.y(), cell.position.z()};
}

std::array<double, 3> bestOf(const ExportCell& cell) {
  const Eigen::Vector3d best = cell.bestParticle.value_or(Eigen::Vector3d::Constant(kNaN));
  return {best.x(), best.y(), best.z()};
}

std::array<double, 9> valuesOf(const std::optional<Eigen::Matrix3d>& symmetric) {
  std::array<double, 9> values{};
  values.fill(kNaN);
  if (symmetric) {
    std::copy_n(symmetric->data(), values.size(), values.begin());
  }
  return values;
}
std::array<double, 9> covarianceOf(const ExportCell& cell) {
  return valuesOf(cell.covariance);
}
std::array<double, 9> extentOf(const ExportCell& cell) {
  return valuesOf(cell.extent);
}

template <class T> std::string rowArray(const char* type, const std::vector<T>& values) {
  std::string bytes = arrayHead(type, fmt::format("{},", values.size()));
  for (const T value : values) {
    putLittleEndian(bytes, value);
  }
  return bytes;
}

} // namespace

EncodedFiles encodeNpz(const ExportTable& table, const std::string& /*name*/) {
  using Flag = std::array<std::uint8_t, 1>;
  std::vector<ZipEntry> entries{
      {"t.npy", rowArray("<f8", table.times)},
      {"frame.npy", rowArray("<i8", table.frames)},
      {"xyz.npy", cellArray<double>(table, "<f8", ", 3", positionOfCell)},
      {"cov.npy", cellArray<double>(table, "<f8", ", 3, 3", covarianceOf)},
      {"filled.npy", cellArray<std::uint8_t>(table, "|b1", "",
                                             [](const ExportCell& c) { return Flag{c.isFilled}; })},
      {"cameras.npy",
       cellArray<std::int32_t>(table, "<i4", "",
                               [](const ExportCell& c) { return std::array{c.cameraCount}; })},
      {"ess.npy",
       cellArray<double>(table, "<f8", "",
                         [](const ExportCell& c) { return std::array{c.effectiveSampleSize}; })},
      {"names.npy", textArray(table.targets, fmt::format("{},", table.targets.size()))},
      {"units.npy", textArray({unitsSentence(table)}, "")},
  };
  if (table.hasBestParticles) {
    entries.push_back({"best.npy", cellArray<double>(table, "<f8", ", 3", bestOf)});
  }
  if (table.hasCorrectedCells) {
    entries.push_back(
        {"corrected.npy", cellArray<std::uint8_t>(table, "|b1", "", [](const ExportCell& c) {
           return Flag{c.isCorrected};
         })});
  }
  if (table.hasAmbiguousCells) {
    entries.push_back(
        {"ambiguous.npy", cellArray<std::uint8_t>(table, "|b1", "", [](const ExportCell& c) {
           return Flag{c.isAmbiguous};
         })});
  }
  if (table.hasExtent) {
    entries.push_back({"extent.npy", cellArray<double>(table, "<f8", ", 3, 3", extentOf)});
  }
  if (table.writesHeader) {
    std::string about;
    for (const auto& [key, value] : table.headerEntries) {
      about += fmt::format("{}: {}\n", key, value);
    }
    entries.push_back({"about.npy", textArray({about}, "")});
  }
  auto archive = uncompressedZip(entries);
  if (!archive) {
    return tl::make_unexpected(archive.error());
  }
  return std::vector{ExportFile{"", std::move(*archive)}};
}

} // namespace dewpoint::trajectory::encoders
