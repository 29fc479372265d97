// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/markup.h"
#include "core/trajectory/export/export_encoders.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace dewpoint::trajectory::encoders {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// A point of the drawing: which target in which row.
struct Node {
  std::size_t target = 0;
  std::size_t row = 0;
};

/// Points and what connects them.
struct Drawing {
  std::vector<Node> nodes;
  std::vector<std::vector<std::size_t>> lines; ///< of nodes, two or more
  std::vector<std::size_t> vertices;           ///< nodes that no line has
};

/// XML allows no control characters at all.
std::string escapedXml(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < 0x20; }, ' ');
  return htmlEscaped(text);
}

template <class Value>
std::string nodeArray(const Drawing& drawing, const char* type, const char* name, int components,
                      Value value) {
  std::string text = fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" "
                                 "format=\"ascii\">\n",
                                 type, name, components);
  for (const Node& node : drawing.nodes) {
    text += value(node) + '\n';
  }
  return text + "</DataArray>\n";
}

std::string numberArray(const char* name, const std::vector<std::size_t>& values) {
  std::string text = fmt::format("<DataArray type=\"Int64\" Name=\"{}\" format=\"ascii\">\n", name);
  for (const std::size_t value : values) {
    text += fmt::format("{}\n", value);
  }
  return text + "</DataArray>\n";
}

std::string cells(const char* name, const std::vector<std::vector<std::size_t>>& lists) {
  std::vector<std::size_t> connectivity;
  std::vector<std::size_t> offsets;
  for (const auto& list : lists) {
    connectivity.insert(connectivity.end(), list.begin(), list.end());
    offsets.push_back(connectivity.size());
  }
  return fmt::format("<{0}>\n{1}{2}</{0}>\n", name, numberArray("connectivity", connectivity),
                     numberArray("offsets", offsets));
}

/// VTK writes a text as the codes of its bytes, with a zero behind it.
std::string textArray(const char* name, const std::vector<std::string>& values) {
  std::string text = fmt::format("<Array type=\"String\" Name=\"{}\" NumberOfTuples=\"{}\" "
                                 "format=\"ascii\">\n",
                                 name, values.size());
  for (const std::string& value : values) {
    for (const char c : value) {
      text += fmt::format("{} ", static_cast<unsigned>(static_cast<unsigned char>(c)));
    }
    text += "0\n";
  }
  return text + "</Array>\n";
}

/// Meters (or the unit) per second at a node, from its neighbors in the row before and behind.
double speedAt(const ExportTable& table, const Node& node) {
  const auto& column = table.cells[node.target];
  const std::size_t before =
      node.row > 0 && column[node.row - 1].hasPosition ? node.row - 1 : node.row;
  const std::size_t after =
      node.row + 1 < column.size() && column[node.row + 1].hasPosition ? node.row + 1 : node.row;
  return before == after ? kNoValue
                         : (column[after].position - column[before].position).norm() /
                               (table.times[after] - table.times[before]);
}

/// xx yy zz xy yz xz: VTK's order of a symmetric tensor.
std::string tensorText(const std::optional<Eigen::Matrix3d>& tensor) {
  if (!tensor) {
    return "nan nan nan nan nan nan";
  }
  const Eigen::Matrix3d& c = *tensor;
  return fmt::format("{} {} {} {} {} {}", covarianceText(c(0, 0)), covarianceText(c(1, 1)),
                     covarianceText(c(2, 2)), covarianceText(c(0, 1)), covarianceText(c(1, 2)),
                     covarianceText(c(0, 2)));
}

std::string vectorTuple(const std::optional<Eigen::Vector3d>& p) {
  return p ? fmt::format("{} {} {}", lengthText(p->x()), lengthText(p->y()), lengthText(p->z()))
           : "nan nan nan";
}

std::string fieldData(const ExportTable& table) {
  std::string text = "<FieldData>\n" + textArray("targets", table.targets);
  text += textArray("units", {unitsSentence(table)});
  if (table.writesHeader) {
    for (const auto& [key, value] : table.headerEntries) {
      text += textArray(escapedXml(key).c_str(), {value});
    }
  }
  return text + "</FieldData>\n";
}

std::string pointData(const ExportTable& table, const Drawing& drawing) {
  const auto cellAt = [&](const Node& node) -> const ExportCell& {
    return table.cells[node.target][node.row];
  };
  std::string text = "<PointData Scalars=\"time_s\">\n";
  text += nodeArray(drawing, "Float64", "time_s", 1,
                    [&](const Node& node) { return timeText(table.times[node.row]); });
  text += nodeArray(drawing, "Int64", "frame", 1,
                    [&](const Node& node) { return std::to_string(table.frames[node.row]); });
  text += nodeArray(drawing, "Int32", "target", 1,
                    [](const Node& node) { return std::to_string(node.target); });
  text += nodeArray(drawing, "Float64", "speed", 1,
                    [&](const Node& node) { return covarianceText(speedAt(table, node)); });
  text += nodeArray(drawing, "Float64", "ess", 1, [&](const Node& node) {
    return covarianceText(cellAt(node).effectiveSampleSize);
  });
  text += nodeArray(drawing, "Int32", "cameras", 1,
                    [&](const Node& node) { return std::to_string(cellAt(node).cameraCount); });
  text += nodeArray(drawing, "UInt8", "filled", 1, [&](const Node& node) {
    return std::string(cellAt(node).isFilled ? "1" : "0");
  });
  if (table.hasCovariance) {
    text += nodeArray(drawing, "Float64", "covariance", 6,
                      [&](const Node& node) { return tensorText(cellAt(node).covariance); });
  }
  if (table.hasBestParticles) {
    text += nodeArray(drawing, "Float64", "best", 3,
                      [&](const Node& node) { return vectorTuple(cellAt(node).bestParticle); });
  }
  if (table.hasCorrectedCells) {
    text += nodeArray(drawing, "UInt8", "corrected", 1, [&](const Node& node) {
      return std::string(cellAt(node).isCorrected ? "1" : "0");
    });
  }
  if (table.hasAmbiguousCells) {
    text += nodeArray(drawing, "UInt8", "ambiguous", 1, [&](const Node& node) {
      return std::string(cellAt(node).isAmbiguous ? "1" : "0");
    });
  }
  if (table.hasExtent) {
    text += nodeArray(drawing, "Float64", "extent", 6,
                      [&](const Node& node) { return tensorText(cellAt(node).extent); });
  }
  return text + "</PointData>\n";
}

std::string polyData(const ExportTable& table, const Drawing& drawing, bool fields) {
  std::vector<std::vector<std::size_t>> vertices;
  for (const std::size_t node : drawing.vertices) {
    vertices.push_back({node});
  }
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
                     "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n";
  text += fields ? fieldData(table) : std::string();
  text += fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" "
                      "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n",
                      drawing.nodes.size(), vertices.size(), drawing.lines.size());
  text += pointData(table, drawing) + "<Points>\n";
  text += nodeArray(drawing, "Float64", "Points", 3, [&](const Node& node) {
    const auto& p = table.cells[node.target][node.row].position;
    return fmt::format("{} {} {}", lengthText(p.x()), lengthText(p.y()), lengthText(p.z()));
  });
  text += "</Points>\n" + cells("Verts", vertices) + cells("Lines", drawing.lines);
  return text + "</Piece>\n</PolyData>\n</VTKFile>\n";
}

/// A line for each stretch without gaps.
void addPath(const ExportTable& table, std::size_t target, Drawing& drawing) {
  std::vector<std::size_t> line;
  const auto finish = [&] {
    if (line.size() == 1) {
      drawing.vertices.push_back(line.front());
    } else if (!line.empty()) {
      drawing.lines.push_back(line);
    }
    line.clear();
  };
  for (std::size_t row = 0; row < table.rowCount(); ++row) {
    if (table.cells[target][row].hasPosition) {
      line.push_back(drawing.nodes.size());
      drawing.nodes.push_back({target, row});
    } else {
      finish();
    }
  }
  finish();
}

} // namespace

EncodedFiles encodeVtp(const ExportTable& table, const std::string& /*name*/) {
  Drawing drawing;
  for (std::size_t target = 0; target < table.targets.size(); ++target) {
    addPath(table, target, drawing);
  }
  return std::vector{ExportFile{"", polyData(table, drawing, true)}};
}

EncodedFiles encodePvd(const ExportTable& table, const std::string& name) {
  constexpr std::size_t kMostFiles = 100000;
  if (table.rowCount() > kMostFiles) {
    return failure(ErrorCode::BadValue, "", "span",
                   fmt::format("{} files would be written, {} at most; choose a shorter span or a "
                               "lower rate",
                               table.rowCount(), kMostFiles));
  }
  std::vector<ExportFile> files;
  std::string collection = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
                           "byte_order=\"LittleEndian\">\n<Collection>\n";
  for (std::size_t row = 0; row < table.rowCount(); ++row) {
    Drawing drawing;
    for (std::size_t target = 0; target < table.targets.size(); ++target) {
      if (table.cells[target][row].hasPosition) {
        drawing.vertices.push_back(drawing.nodes.size());
        drawing.nodes.push_back({target, row});
      }
    }
    const std::string end = fmt::format("-frames/{:05}.vtp", row);
    collection += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}{}\"/>\n",
                              timeText(table.times[row]), escapedXml(name), end);
    files.push_back({end, polyData(table, drawing, row == 0)});
  }
  files.push_back({"", collection + "</Collection>\n</VTKFile>\n"});
  return files;
}

} // namespace dewpoint::trajectory::encoders
