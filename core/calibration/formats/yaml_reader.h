// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <Eigen/Core>

#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <vector>
#include <yaml-cpp/yaml.h>

namespace dewpoint::calibration {

/// Parses YAML; also what OpenCV's FileStorage writes, whose first line is no YAML, and a Python
/// dictionary of numbers and texts. NotParsed with the line. yaml-cpp's exceptions stop here.
Result<YAML::Node> parseYaml(const std::string& text, const std::string& file);

/// Takes values out of one YAML mapping and keeps the first error in it, with its
/// line. Keys that are not requested are ignored: other tools write more than we need.
class YamlReader {
public:
  YamlReader(const YAML::Node& node, std::string file, std::string prefix = "");

  bool has(const char* key) const;
  /// The mapping below a key; empty, with an error kept, when it is none.
  YamlReader child(const std::string& key) const;

  /// Its keys, in the order of the file.
  std::vector<std::string> keys() const;

  std::string text(const char* key, const std::string& unless = "") const;
  /// One number; an error when it is absent or none.
  double number(const char* key) const;
  /// The numbers of a sequence, of nested ones row by row, or of `data` in a matrix. An error when
  /// their count is not among `counts`; any count when that is empty.
  std::vector<double> numbers(const char* key, std::initializer_list<std::size_t> counts) const;
  /// Row by row.
  Eigen::MatrixXd matrix(const char* key, int rows, int columns) const;

  void fail(ErrorCode code, const std::string& key, std::string detail) const;
  const std::optional<Error>& error() const { return *error_; }
  std::string field(const std::string& key) const { return prefix_ + key; }

private:
  YAML::Node find(const std::string& key) const;

  YAML::Node node_;
  std::string file_;
  std::string prefix_;
  std::shared_ptr<std::optional<Error>> error_; ///< shared with the children
};

} // namespace dewpoint::calibration
