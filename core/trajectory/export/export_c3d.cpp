// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/csv_text.h"
#include "core/trajectory/export/binary_text.h"
#include "core/trajectory/export/export_encoders.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace dewpoint::trajectory::encoders {
namespace {

constexpr std::size_t kBlock = 512;
constexpr std::size_t kMostInByte = 255;
/// The header has 16 bits for a frame's number; larger ones are in LONG_FRAMES and TRIAL.
constexpr std::size_t kMostInHeader = 65535;
/// A residual counts in steps of this many millimeters; it has seven bits here.
constexpr double kResidualStep = 0.1;
constexpr double kMostResidual = 127.0;
constexpr int kMostCameras = 7;

void padToBlock(std::string& bytes) {
  bytes.resize((bytes.size() + kBlock - 1) / kBlock * kBlock, '\0');
}

/// The parameter section: groups of named values.
class Parameters {
public:
  void group(const std::string& name) {
    --group_;
    record(name, static_cast<std::int8_t>(group_), "");
  }
  void text(const std::string& name, const std::string& value) {
    text(name, std::vector{value}, false);
  }
  void texts(const std::string& name, const std::vector<std::string>& values) {
    text(name, values, true);
  }
  void word(const std::string& name, std::uint32_t value) { words(name, {value}); }
  void words(const std::string& name, std::initializer_list<std::uint32_t> values) {
    std::string data = head(2, values.size());
    for (const std::uint32_t value : values) {
      putLittleEndian(data, static_cast<std::uint16_t>(value));
    }
    record(name, static_cast<std::int8_t>(-group_), data);
  }
  void real(const std::string& name, double value) {
    std::string data = head(4, 1);
    putLittleEndian(data, static_cast<float>(value));
    record(name, static_cast<std::int8_t>(-group_), data);
  }

  /// The section with its own head of four bytes.
  std::string section() const {
    std::string bytes = "\x01\x50";
    bytes += '\0';   // the number of blocks, below
    bytes += '\x54'; // Intel's order of bytes
    bytes += records_;
    bytes.append(2, '\0'); // no name: the end
    padToBlock(bytes);
    bytes[2] = static_cast<char>(bytes.size() / kBlock);
    return bytes;
  }

private:
  /// Type (-1 text, 2 word, 4 real) and dimensions; one value has none.
  static std::string head(std::int8_t type, std::size_t count) {
    std::string data(1, static_cast<char>(type));
    data += count == 1 ? '\0' : '\1';
    if (count != 1) {
      data += static_cast<char>(count);
    }
    return data;
  }

  void text(const std::string& name, const std::vector<std::string>& values, bool list) {
    std::size_t length = 1;
    for (const std::string& value : values) {
      length = std::max(length, value.size());
    }
    std::string data(1, static_cast<char>(-1));
    data += list ? '\2' : '\1';
    data += static_cast<char>(length);
    if (list) {
      data += static_cast<char>(values.size());
    }
    for (std::string value : values) {
      value.resize(length, ' ');
      data += value;
    }
    record(name, static_cast<std::int8_t>(-group_), data);
  }

  /// Name, group, way to the next record, data, and an empty description.
  void record(const std::string& name, std::int8_t group, const std::string& data) {
    records_ += static_cast<char>(name.size());
    records_ += static_cast<char>(group);
    records_ += name;
    putLittleEndian(records_, static_cast<std::uint16_t>(2 + data.size() + 1));
    records_ += data;
    records_ += '\0';
  }

  int group_ = 0;
  std::string records_;
};

/// Labels are not longer than a byte can say.
std::vector<std::string> labels(const ExportTable& table) {
  std::vector<std::string> result;
  for (const std::string& target : table.targets) {
    result.push_back(withoutLineBreaks(target).substr(0, kMostInByte));
  }
  return result;
}

std::string parameterSection(const ExportTable& table, double scale, std::size_t dataBlock) {
  const auto frames = static_cast<std::uint32_t>(table.rowCount());
  const std::uint32_t most = kMostInHeader;
  Parameters parameters;
  parameters.group("POINT");
  parameters.word("USED", static_cast<std::uint32_t>(table.targets.size()));
  parameters.word("FRAMES", std::min(frames, most));
  parameters.word("DATA_START", static_cast<std::uint32_t>(dataBlock));
  parameters.real("SCALE", scale);
  parameters.real("RATE", table.rowsPerSecond);
  if (frames > most) {
    parameters.real("LONG_FRAMES", frames);
  }
  parameters.texts("LABELS", labels(table));
  parameters.texts("DESCRIPTIONS", std::vector<std::string>(table.targets.size(), "target"));
  parameters.text("UNITS", table.unitName());
  parameters.text("X_SCREEN", "+X");
  parameters.text("Y_SCREEN", table.axes == WorldAxes::YUp ? "+Y" : "+Z");
  parameters.group("ANALOG");
  parameters.word("USED", 0);
  parameters.real("GEN_SCALE", 1.0);
  parameters.real("RATE", table.rowsPerSecond);
  parameters.group("TRIAL");
  parameters.real("CAMERA_RATE", table.rowsPerSecond);
  // 32 bits in two words, the low one first.
  parameters.words("ACTUAL_START_FIELD", {1, 0});
  parameters.words("ACTUAL_END_FIELD", {frames & 0xFFFFU, frames >> 16U});
  parameters.group("MANUFACTURER");
  parameters.text("COMPANY", "Dewpoint");
  parameters.text("SOFTWARE", "dewpoint");
  parameters.text("VERSION", DEWPOINT_VERSION);
  return parameters.section();
}

std::string headerSection(const ExportTable& table, double scale, std::size_t dataBlock) {
  std::string bytes = "\x02\x50"; // parameters begin in block 2
  const auto word = [&](std::size_t value) {
    putLittleEndian(bytes, static_cast<std::uint16_t>(value));
  };
  word(table.targets.size());
  word(0); // analog values per frame
  word(1); // first frame
  word(std::min(table.rowCount(), kMostInHeader));
  word(0); // longest gap that was interpolated, unknown
  putLittleEndian(bytes, static_cast<float>(scale));
  word(dataBlock);
  word(0); // analog samples per frame
  putLittleEndian(bytes, static_cast<float>(table.rowsPerSecond));
  padToBlock(bytes);
  return bytes;
}

/// The fourth word of a point: which cameras saw it and its residual; -1 for a gap, residual 0 for
/// what was not seen but filled. Which cameras it were is not known, only how many.
float fourthWord(const ExportCell& cell, double scale) {
  if (!cell.hasPosition) {
    return -1.0F;
  }
  if (cell.isFilled) {
    return 0.0F;
  }
  const double sigma =
      cell.covariance ? std::sqrt(std::max(0.0, cell.covariance->trace() / 3.0)) : 0.0;
  const double residual = std::clamp(std::round(sigma / -scale), 1.0, kMostResidual);
  const int cameras = (1 << std::clamp(cell.cameraCount, 0, kMostCameras)) - 1;
  return static_cast<float>(cameras * 256 + static_cast<int>(residual));
}

} // namespace

EncodedFiles encodeC3d(const ExportTable& table, const std::string& /*name*/) {
  if (table.targets.size() > kMostInByte) {
    return failure(
        ErrorCode::BadValue, "", "targets",
        fmt::format("C3D holds {} points here, not {}", kMostInByte, table.targets.size()));
  }
  // Negative: the points are floating-point numbers.
  const double scale = -kResidualStep * (table.unit == LengthUnit::Millimeter ? 1.0 : 0.001);
  // The parameters' size does not depend on where the data begin.
  const std::size_t dataBlock = 2 + parameterSection(table, scale, 0).size() / kBlock;
  if (dataBlock - 2 > kMostInByte) {
    return failure(ErrorCode::BadValue, "", "targets", "their names are too long for C3D");
  }
  std::string bytes = headerSection(table, scale, dataBlock);
  bytes += parameterSection(table, scale, dataBlock);
  for (std::size_t row = 0; row < table.rowCount(); ++row) {
    for (const auto& column : table.cells) {
      const ExportCell& cell = column[row];
      for (int axis = 0; axis < 3; ++axis) {
        putLittleEndian(bytes, static_cast<float>(cell.position[axis]));
      }
      putLittleEndian(bytes, fourthWord(cell, scale));
    }
  }
  padToBlock(bytes);
  return std::vector{ExportFile{"", std::move(bytes)}};
}

} // namespace dewpoint::trajectory::encoders
