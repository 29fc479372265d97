// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/yaml_reader.h"

#include "core/base/limits.h"
#include "core/calibration/formats/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace dewpoint::calibration {
namespace {

/// Of one mapping, each of which is looked through for every key: one per camera, and some more.
constexpr std::size_t kMostKeys = 2 * limits::kMaxCameras;

} // namespace

Result<YAML::Node> parseYaml(const std::string& text, const std::string& file) {
  std::string body = text;
  if (body.starts_with("%YAML:")) {
    body.replace(0, 1, "#"); // keeps the numbers of the lines
  }
  if (body.size() > limits::kMaxCalibrationBytes) {
    return failure(ErrorCode::NotParsed, file, "", "too large for a calibration");
  }
  try {
    YAML::Node node = YAML::Load(body);
    if (!node.IsMap() && !node.IsSequence()) {
      return failure(ErrorCode::NotParsed, file, "line 1", "a YAML mapping is expected");
    }
    return node;
  } catch (const YAML::Exception& error) {
    return failure(ErrorCode::NotParsed, file, fmt::format("line {}", error.mark.line + 1),
                   error.msg);
  }
}

YamlReader::YamlReader(const YAML::Node& node, std::string file, std::string prefix)
    : node_(node), file_(std::move(file)), prefix_(std::move(prefix)),
      error_(std::make_shared<std::optional<Error>>()) {
  if (node_.IsDefined() && node_.IsMap() && node_.size() > kMostKeys) {
    *error_ = Error{ErrorCode::BadValue, file_, fieldPath(fmt::format("key {}", kMostKeys + 1)),
                    fmt::format("at most {} keys are possible", kMostKeys)};
    node_ = YAML::Node(YAML::NodeType::Undefined);
  }
}

YAML::Node YamlReader::find(const std::string& key) const {
  if (!node_.IsDefined() || !node_.IsMap()) {
    return YAML::Node(YAML::NodeType::Undefined);
  }
  for (const auto& item : node_) {
    if (item.first.IsScalar() && item.first.Scalar() == key) {
      return item.second;
    }
  }
  return YAML::Node(YAML::NodeType::Undefined);
}

bool YamlReader::has(const char* key) const {
  return find(key).IsDefined();
}

YamlReader YamlReader::child(const std::string& key) const {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) {
    fail(ErrorCode::MissingKey, key, "");
  } else if (!node.IsMap()) {
    fail(ErrorCode::WrongType, key, "a mapping is expected");
  }
  YamlReader below(node, file_, prefix_ + key + ".");
  below.error_ = error_;
  return below;
}

std::vector<std::string> YamlReader::keys() const {
  std::vector<std::string> names;
  if (!node_.IsDefined()) {
    return names;
  }
  for (const auto& item : node_) {
    if (names.size() == limits::kMaxCameras) {
      fail(ErrorCode::BadValue, fmt::format("camera {}", names.size() + 1),
           fmt::format("at most {} cameras are possible", limits::kMaxCameras));
      break;
    }
    if (item.first.IsDefined() && item.first.IsScalar()) {
      names.push_back(item.first.Scalar());
    }
  }
  return names;
}

std::string YamlReader::text(const char* key, const std::string& unless) const {
  const YAML::Node node = find(key);
  return node.IsDefined() && node.IsScalar() ? node.Scalar() : unless;
}

double YamlReader::number(const char* key) const {
  return numbers(key, {1}).front();
}

namespace {

/// Of a node. The pictures of a board, which OpenCV writes beside a calibration, have some 10,000.
constexpr std::size_t kMostNumbers = 100'000;
/// A matrix of rows has two levels of sequences.
constexpr int kMostLevels = 4;

/// Takes the numbers of a node. An alias may stand for a node that holds it, or for one that stands
/// in many places: what is looked at is counted, not what the text is long.
class NumberCollector {
public:
  /// False when something in there is no number, or is too much.
  bool collect(const YAML::Node& node, int level = 0) {
    if (++seen_ > kMostNumbers || level > kMostLevels) {
      return false;
    }
    if (node.IsSequence()) {
      return std::all_of(node.begin(), node.end(),
                         [&](const YAML::Node& item) { return collect(item, level + 1); });
    }
    const auto value = node.IsScalar() ? parseNumber(node.Scalar()) : std::nullopt;
    values_.push_back(value.value_or(0.0));
    return value.has_value();
  }
  std::vector<double> take() { return std::move(values_); }

private:
  std::size_t seen_ = 0;
  std::vector<double> values_;
};

} // namespace

std::vector<double> YamlReader::numbers(const char* key,
                                        std::initializer_list<std::size_t> counts) const {
  YAML::Node node = find(key);
  if (node.IsDefined() && node.IsMap()) {
    for (const auto& item : node) {
      if (item.first.Scalar() == "data") {
        node.reset(item.second);
        break;
      }
    }
  }
  NumberCollector numbers;
  const bool areNumbers = node.IsDefined() && numbers.collect(node);
  std::vector<double> values = numbers.take();
  if (!node.IsDefined()) {
    fail(ErrorCode::MissingKey, key, "");
  } else if (!areNumbers) {
    fail(ErrorCode::WrongType, key, "numbers are expected");
  } else if (counts.size() > 0 && std::ranges::find(counts, values.size()) == counts.end()) {
    fail(
        ErrorCode::WrongType, key,
        fmt::format("{} numbers are expected, found {}", fmt::join(counts, " or "), values.size()));
  }
  if (counts.size() > 0 && std::ranges::find(counts, values.size()) == counts.end()) {
    values.assign(*counts.begin(), 0.0);
  }
  return values;
}

Eigen::MatrixXd YamlReader::matrix(const char* key, int rows, int columns) const {
  const auto values = numbers(key, {std::size_t(rows) * std::size_t(columns)});
  return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      values.data(), rows, columns);
}

void YamlReader::fail(ErrorCode code, const std::string& key, std::string detail) const {
  if (*error_) {
    return;
  }
  const YAML::Node node = find(key);
  const YAML::Mark mark = node.IsDefined() ? node.Mark() : YAML::Mark::null_mark();
  if (mark.line >= 0) {
    detail += fmt::format("{}line {}", detail.empty() ? "" : ", ", mark.line + 1);
  }
  *error_ = Error{code, file_, prefix_ + key, std::move(detail)};
}

} // namespace dewpoint::calibration
