// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/trajectory_reader.h"

#include "core/base/limits.h"
#include "core/base/table_text.h"
#include "core/base/text_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>

namespace dewpoint::trajectory {
namespace {

using Cells = std::vector<std::string>;

std::string_view trimmed(std::string_view text) {
  const auto isSpace = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && isSpace(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && isSpace(text.back()))
    text.remove_suffix(1);
  return text;
}

/// Reads a quoted text ("" is a quote within) at the start of `text`, and removes it from there.
std::optional<std::string> takeQuoted(std::string_view& text) {
  std::string value;
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i] != '"') {
      value += text[i];
    } else if (i + 1 < text.size() && text[i + 1] == '"') {
      value += text[i++];
    } else {
      text.remove_prefix(i + 1);
      return value;
    }
  }
  return std::nullopt;
}

/// The cells of one line; nothing if a quote never ends. Of more than limits::kMaxColumns only the
/// first are there, and one.
std::optional<Cells> splitLine(std::string_view line) {
  Cells cells;
  while (true) {
    if (!line.empty() && line.front() == '"') {
      auto value = takeQuoted(line);
      if (!value || (!line.empty() && line.front() != ','))
        return std::nullopt;
      cells.push_back(std::move(*value));
    } else {
      const std::size_t end = std::min(line.find(','), line.size());
      cells.emplace_back(trimmed(line.substr(0, end)));
      line.remove_prefix(end);
    }
    if (line.empty() || cells.size() > limits::kMaxColumns)
      return cells;
    line.remove_prefix(1);
  }
}

template <class T> bool parse(std::string_view text, T& value) {
  if (!text.empty() && text.front() == '+')
    text.remove_prefix(1);
  const auto number = toNumber<T>(text);
  value = number.value_or(value);
  return number.has_value();
}

/// `"name" center x y z axis x y z`; anything else is somebody's comment.
std::optional<TrajectoryCamera> parseCamera(std::string_view text) {
  if (text.empty() || text.front() != '"')
    return std::nullopt;
  auto name = takeQuoted(text);
  if (!name)
    return std::nullopt;
  Cells words;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const std::size_t end = std::min(text.find(' '), text.size());
    words.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  if (words.size() != 8 || words[0] != "center" || words[4] != "axis")
    return std::nullopt;
  TrajectoryCamera camera{*name, {}, {}};
  for (std::size_t i = 0; i < 3; ++i)
    if (!parse(words[1 + i], camera.center[static_cast<Eigen::Index>(i)]) ||
        !parse(words[5 + i], camera.opticalAxis[static_cast<Eigen::Index>(i)]))
      return std::nullopt;
  return camera;
}

/// One pass over the text of a file.
class Reader {
public:
  explicit Reader(std::string file) : file_(std::move(file)) {}

  Result<Trajectory> read(std::string_view text) {
    // A line without its end was cut off while it was written.
    for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
      std::string_view line = text.substr(0, end);
      text.remove_prefix(end + 1);
      ++lineNumber_;
      if (line.ends_with('\r'))
        line.remove_suffix(1);
      if (Status status = readLine(line); !status)
        return tl::make_unexpected(status.error());
    }
    if (columns_.empty())
      return failure(ErrorCode::EndedEarly, file_, "", "there is no line of column names");
    return std::move(trajectory_);
  }

private:
  Status readLine(std::string_view line) {
    if (trimmed(line).empty())
      return {};
    if (line.front() == '#')
      return readComment(trimmed(line.substr(1)));
    auto cells = splitLine(line);
    if (!cells)
      return notParsed("a quoted text is not closed");
    if (cells->size() > limits::kMaxColumns)
      return notParsed(fmt::format("more than {} cells", limits::kMaxColumns));
    if (columns_.empty())
      return readColumns(std::move(*cells));
    if (cells->size() != columns_.size())
      return notParsed(fmt::format("{} cells, but {} columns", cells->size(), columns_.size()));
    if (trajectory_.samples.size() == limits::kMaxRows)
      return notParsed(fmt::format("more than {} rows", limits::kMaxRows));
    return readSample(*cells);
  }

  Status readComment(std::string_view text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos)
      return {};
    const TrajectoryHeader& header = trajectory_.header;
    if (header.entries.size() + header.cameras.size() >= limits::kMaxHeaderEntries)
      return notParsed(fmt::format("more than {} comments", limits::kMaxHeaderEntries));
    const std::string_view key = trimmed(text.substr(0, colon));
    const std::string_view value = trimmed(text.substr(colon + 1));
    if (key == "camera") {
      if (auto camera = parseCamera(value))
        trajectory_.header.cameras.push_back(std::move(*camera));
    } else if (key != "units") {
      trajectory_.header.entries.emplace_back(key, value);
    }
    return {};
  }

  Status readColumns(Cells cells) {
    columns_ = std::move(cells);
    trajectory_.header.hasMeasurements = column("seen_x_m").has_value();
    trajectory_.header.hasBestParticles = column("best_x_m").has_value();
    trajectory_.header.hasCorrectedColumn = column("corrected").has_value();
    trajectory_.header.hasAmbiguousColumn = column("ambiguous").has_value();
    trajectory_.header.hasExtent = column("extent_xx_m2").has_value();
    for (const char* name : {"x_m", "y_m", "z_m"})
      if (!column(name))
        return missing(name, "this column is needed");
    if (!column("frame") && !column("time_s"))
      return missing("frame", "a column frame or time_s is needed");
    return {};
  }

  Status readSample(const Cells& cells) {
    TrajectorySample sample;
    sample.time = std::numeric_limits<double>::quiet_NaN();
    sample.frame = kNoFrame;
    int valid = 1;
    int corrected = 0;
    int ambiguous = 0;
    Status status;
    const auto number = [&](const char* name, auto& value) {
      const auto index = column(name);
      if (!status || !index)
        return;
      if constexpr (std::is_floating_point_v<std::remove_reference_t<decltype(value)>>) {
        if (cells[*index].empty()) {
          value = std::numeric_limits<double>::quiet_NaN(); // not known, as in an export with gaps
          return;
        }
      }
      if (!parse(cells[*index], value))
        status = badNumber(name, cells[*index]);
    };
    number("time_s", sample.time);
    number("frame", sample.frame);
    const auto readSymmetric = [&](const std::string& before, Eigen::Matrix3d& c) {
      number((before + "xx_m2").c_str(), c(0, 0));
      number((before + "xy_m2").c_str(), c(0, 1));
      number((before + "xz_m2").c_str(), c(0, 2));
      number((before + "yy_m2").c_str(), c(1, 1));
      number((before + "yz_m2").c_str(), c(1, 2));
      number((before + "zz_m2").c_str(), c(2, 2));
      c = c.selfadjointView<Eigen::Upper>().toDenseMatrix();
    };
    const auto readPosition = [&](const std::string& before, Eigen::Vector3d& p,
                                  Eigen::Matrix3d& c) {
      number((before + "x_m").c_str(), p.x());
      number((before + "y_m").c_str(), p.y());
      number((before + "z_m").c_str(), p.z());
      readSymmetric(before + "cov_", c);
    };
    readPosition("", sample.position, sample.covariance);
    number("ess", sample.effectiveSampleSize);
    number("cameras", sample.cameraCount);
    number("valid", valid);
    number("corrected", corrected);
    number("ambiguous", ambiguous);
    if (const auto index = column("seen_x_m"); index && !cells[*index].empty()) {
      PositionMeasurement& seen = sample.measurement.emplace();
      readPosition("seen_", seen.position, seen.covariance);
    }
    if (const auto index = column("best_x_m"); index && !cells[*index].empty()) {
      Eigen::Vector3d& best = sample.bestParticle.emplace();
      number("best_x_m", best.x());
      number("best_y_m", best.y());
      number("best_z_m", best.z());
    }
    if (const auto index = column("extent_xx_m2"); index && !cells[*index].empty()) {
      readSymmetric("extent_", sample.extent.emplace(Eigen::Matrix3d::Zero()));
    }
    if (!status)
      return status;
    if (sample.frame > limits::kMaxFrames || sample.frame < -limits::kMaxFrames)
      return badNumber("frame", fmt::format("{}", sample.frame));
    sample.isValid = valid != 0;
    sample.isCorrected = corrected != 0;
    sample.isAmbiguous = ambiguous != 0;
    if (const auto index = column("target"))
      sample.target = cells[*index];
    trajectory_.samples.push_back(std::move(sample));
    return {};
  }

  std::optional<std::size_t> column(std::string_view name) const {
    const auto found = std::find(columns_.begin(), columns_.end(), name);
    if (found == columns_.end())
      return std::nullopt;
    return static_cast<std::size_t>(found - columns_.begin());
  }

  tl::unexpected<Error> missing(const char* name, const char* detail) const {
    return failure(ErrorCode::MissingKey, file_, fmt::format("line {}, {}", lineNumber_, name),
                   detail);
  }
  tl::unexpected<Error> badNumber(const char* name, const std::string& text) const {
    return failure(ErrorCode::BadValue, file_, fmt::format("line {}, {}", lineNumber_, name),
                   fmt::format("\"{}\" is not a valid number", text));
  }
  tl::unexpected<Error> notParsed(std::string detail) const {
    return failure(ErrorCode::NotParsed, file_, fmt::format("line {}", lineNumber_),
                   std::move(detail));
  }

  std::string file_;
  std::size_t lineNumber_ = 0;
  Cells columns_;
  Trajectory trajectory_;
};

} // namespace

Result<Trajectory> readTrajectory(const std::filesystem::path& path) {
  return readTableText(path).and_then(
      [&](const std::string& text) { return Reader(path.string()).read(text); });
}

} // namespace dewpoint::trajectory
