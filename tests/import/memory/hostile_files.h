#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/import/test_files.h"

namespace throng::import::testing {

/// A small file whose import would take hundreds of megabytes.
struct HostileFile {
  std::string name;  ///< of the test: "ImageOfManyPixels"
  std::filesystem::path (*write)(const TemporaryFolder& folder);
  std::string object;  ///< what the refusal names; empty: the file is small once each part is read once
};

const std::vector<HostileFile>& hostile_files();

/// Writes a model with skins of 70,000 joints.
std::filesystem::path write_skins_of_many_joints(const TemporaryFolder& folder);

/// Writes a model that shows as many images, in a file each.
std::filesystem::path write_with_images(const TemporaryFolder& folder, std::size_t count, const std::vector<char>& png);

/// Writes a model that shows an image, called "skin", which it finds in a file of that name.
std::filesystem::path write_with_image(const TemporaryFolder& folder, const char* name, const std::vector<char>& bytes);

}  // namespace throng::import::testing
