// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Whether a name comes before another one as people sort them: numbers by their value ("camera 2"
/// before "camera 10"), letters whatever their case and accent (of Latin-1, in UTF-8), other
/// characters before digits before letters. Equal ones by their bytes. For lists that people read;
/// the frames of a folder of images have an order of their own, see naturallyBefore().
bool comesBefore(const std::string& name, const std::string& other);

/// Files by their names (without the folder), see comesBefore(): which one was chosen first means
/// nothing, but cameras of a calibration may be taken in the order of their files.
std::vector<std::string> inNaturalOrder(std::vector<std::string> files);

/// Whether a file can be what a camera recorded, a video or an image: by its ending, and where that
/// says nothing, by what it begins with. Whether it can be read shows when it is opened.
bool isFootage(const std::filesystem::path& file);

/// Whether a file or folder can be a camera: footage, a folder with at least one file called as
/// images are, a device, or what does not exist (an address; what is missing is reported when it is
/// opened).
bool showsImages(const std::string& location);

/// What may be a camera in a folder: videos and folders of images, in natural order; not what lies
/// deeper. Empty when it cannot be read.
std::vector<std::string> footageIn(const std::filesystem::path& folder);

/// The video devices of this computer, "/dev/video0", by name; not tried.
std::vector<std::string> connectedCameras();

} // namespace dewpoint::setup
